"""Studies beyond the paper: the factorial and the sensitivity table."""
