"""Navigation: finding paths through a home."""
