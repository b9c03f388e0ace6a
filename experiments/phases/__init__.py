"""Trials with phases: train in some households, freeze or adapt, probe in others."""
