"""Replay: every episode as a file that the Rerun viewer plays, and back again.

    from household.replay import RecordEpisodes, read
    env = RecordEpisodes(household_v0.parallel_env("evening"), "replays")
    ...
    read("replays").touches  # a Polars frame

Rerun is imported when the first episode begins, not before.
"""

from household.replay.query import Frames, read
from household.replay.wrapper import RecordEpisodes

__all__ = ["Frames", "RecordEpisodes", "read"]
