"""Replay: every episode as a file that the Rerun viewer plays, and back again.

    from household.replay import RecordEpisodes
    env = RecordEpisodes(household_v0.parallel_env("evening"), "replays")

Rerun is imported when the first episode begins, not before.
"""

from household.replay.wrapper import RecordEpisodes

__all__ = ["RecordEpisodes"]
