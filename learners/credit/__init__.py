"""Credit: which past situation and behavior a touch is about (paper, section 3.1)."""

from learners.credit.rules import CreditRule, Designated, Immediate, Trace

__all__ = ["CreditRule", "Designated", "Immediate", "Trace"]
