"""Simulated people beside published figures of real ones: `household validate`."""
