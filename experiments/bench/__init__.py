"""`household bench`: how fast everything is, and how that grows, in one run.

Everything that is compared is measured in turn (A B A B), in the processor's time of
this process, so that other work on the machine touches all of it alike.
"""
