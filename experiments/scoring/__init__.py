"""Scores that can be trusted: probe, lived and touches, beside reference policies."""
