"""Compiled functions and the arrays that they work on."""
