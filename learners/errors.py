"""What can go wrong in a learner, by name; each message says it in one sentence."""


class LearnerError(ValueError):
    """Any refusal of a learner; what it had learned is unchanged."""


class ExperienceError(LearnerError):
    """An experience or a feedback that cannot have happened, or not in this order."""


class UnknownBehaviorError(LearnerError):
    """A behavior index outside 0 .. n_behaviors - 1."""


class UnknownRobotError(LearnerError):
    """A robot that is not a member of the team."""


class UnknownNameError(LearnerError):
    """A learner or a setting that the catalog does not list."""


class ParameterError(LearnerError):
    """A parameter outside its range."""


class StateError(LearnerError):
    """A state that lacks what an analogy asks of it (see `learners.analogy`)."""


class SavedFileError(LearnerError):
    """A saved learner that is damaged, cut short, of another version or not one."""
