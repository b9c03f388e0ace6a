"""Homes: floor plans and the paths through them."""
