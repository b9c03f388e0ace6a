"""The recent past of one robot: the pairs that a touch could be about."""

from bisect import bisect_left, bisect_right
from dataclasses import dataclass, field

from learners.errors import ExperienceError, SavedFileError, check_positive
from learners.experience import Experience
from learners.saving import saved

_ROUNDING = 1e-6  # [s] clocks are sums of periods, which do not add up exactly


def _began(entry: Experience) -> float:
    return entry.time


def _first_kept(entries: list[Experience], oldest_end: float) -> int:
    return next(i for i, entry in enumerate(entries) if entry.next_time >= oldest_end)


def _check_not_older(experience: Experience, first: Experience) -> None:
    for touch in experience.rewards:
        if touch.time < first.time:
            raise ExperienceError(
                f"reward at {touch.time} s is older than the history, which begins "
                f"at {first.time} s"
            )


@saved
@dataclass(kw_only=True, eq=False)
class History:
    """Entries in order of time, oldest first, as far back as the horizon.

    Attributes:
        horizon: [s] how long an entry is kept after its end. 60 s: longer than any
            walk through a home, so that no touch can be about what is forgotten.
        entries: the entries.
        exploratory: for each entry, whether its behavior was chosen against the
            values of the time (Watkins' trace is cut there, and asks for it alone).
    """

    horizon: float = 60.0
    entries: list[Experience] = field(default_factory=list, init=False)
    exploratory: list[bool] = field(default_factory=list, init=False)

    def __post_init__(self) -> None:
        check_positive("horizon", self.horizon)

    def __len__(self) -> int:
        return len(self.entries)

    def check_loaded(self) -> None:
        """Refuse a history that nobody can have lived through.

        Raises:
            SavedFileError: if its lists differ in length, or it is out of order.
        """
        times = [entry.time for entry in self.entries]
        if len(self.exploratory) != len(times) or times != sorted(times):
            raise SavedFileError("the history is out of order")

    def check(self, experience: Experience) -> None:
        """Refuse an entry that cannot follow, or a touch older than all entries.

        Raises:
            ExperienceError: with the reason.
        """
        if self.entries:
            last = self.entries[-1]
            if experience.time < last.next_time - _ROUNDING:
                raise ExperienceError(
                    f"entry at {experience.time} s overlaps the last one, which ended "
                    f"at {last.next_time} s; call start_episode() if the clock began "
                    "anew"
                )
        if experience.rewards:
            kept = [*self.entries, experience]
            first = kept[_first_kept(kept, experience.next_time - self.horizon)]
            _check_not_older(experience, first)

    def append(self, experience: Experience, *, exploratory: bool = False) -> None:
        """Add the newest entry and forget those beyond the horizon."""
        self.entries.append(experience)
        self.exploratory.append(exploratory)
        oldest_end = experience.next_time - self.horizon
        forgotten = _first_kept(self.entries, oldest_end)
        del self.entries[:forgotten]
        del self.exploratory[:forgotten]

    def clear(self) -> None:
        """Forget all entries."""
        self.entries.clear()
        self.exploratory.clear()

    def in_force(self, time: float) -> int:
        """Index of the entry in force at a time [s]; the oldest if all are later.

        Raises:
            ExperienceError: if the history is empty.
        """
        self._check_not_empty()
        return max(bisect_right(self.entries, time, key=_began) - 1, 0)

    def before(self, time: float) -> int:
        """Index of the entry in force just before a time [s]; the oldest if none was.

        Raises:
            ExperienceError: if the history is empty.
        """
        self._check_not_empty()
        return max(bisect_left(self.entries, time, key=_began) - 1, 0)

    def _check_not_empty(self) -> None:
        if not self.entries:
            raise ExperienceError("the history is empty: nothing to credit")
