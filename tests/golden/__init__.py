"""Golden digests: what histories and learners come to, so that a change shows itself.

`python -m tests.golden` renews them, when behavior has changed on purpose.
"""
