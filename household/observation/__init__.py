"""What robots observe: the field table, its two encodings, the loops that fill it."""

from household.observation.encodings import ENCODINGS, Features, Situations, layout

__all__ = ["ENCODINGS", "Features", "Situations", "layout"]
