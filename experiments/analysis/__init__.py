"""From the tables of trials to measures, statistics and claims."""
