"""Saving without pickle: values as tagged JSON, stamped with a version and a digest."""

from learners.saving.codec import ATTACHED, DERIVED, encode, saved
from learners.saving.files import VERSION, load, write

__all__ = ["ATTACHED", "DERIVED", "VERSION", "encode", "load", "saved", "write"]
