"""Robots: what they can do and what they feel."""
