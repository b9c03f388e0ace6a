"""When does politeness carry over, when does analogy harm? One file for each study."""
