"""Learners a reviewer would ask to see beside the paper's, one file each."""
