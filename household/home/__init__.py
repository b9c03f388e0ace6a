"""Homes: floor plans and the ways through them."""
