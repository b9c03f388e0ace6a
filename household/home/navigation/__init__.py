"""Finding a way through a home."""
