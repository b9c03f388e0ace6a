"""The project's records as plain values; the one place that knows their fields."""


def of_situation(situation):
    """Who plays what and who attends to whom, by name."""
    return sorted(situation.plays), sorted(situation.attends)


def of_touch(touch):
    """A touch as the robot feels it."""
    return (
        touch.giver,
        touch.kind,
        touch.strength,
        touch.time,
        touch.mood,
        touch.attending,
        touch.approach_began,
        touch.attention_began,
    )


def of_cause(cause):
    """What a touch is really about."""
    return cause.robot, cause.decision, cause.behavior, cause.time


def of_credit(credit):
    """What a learner believes a touch to be about."""
    felt, meant = credit.reward, credit.designated
    shares = [of_share(*share) for share in credit.shares]
    designated = meant and next(of_share(*s) for s in credit.shares if s[0] is meant)
    return felt.giver, felt.time, felt.value, shares, designated


def of_share(entry, weight):
    """What one past pair gets of a touch."""
    return of_situation(entry.state), entry.action, entry.time, weight
