"""People: their personas, what they think of robots, and what they do about it."""
