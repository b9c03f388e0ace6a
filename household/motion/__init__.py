"""How bodies move: walks, steering, collisions, heads."""
