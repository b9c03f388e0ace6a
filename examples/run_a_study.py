"""Compare learners over several seeds, with an interval around what came out."""

import polars as pl

from experiments import Condition, Study, run_study, run_trial
from experiments.analysis.statistics import mean

LEARNERS = ("random", "q_social", "designated")

study = Study(
    name="late_touches",
    conditions=tuple(
        Condition(
            name=learner,
            scenario="experiment_4",
            learner=learner,
            scenario_overrides={"max_cycles": 600},
        )
        for learner in LEARNERS
    ),
    seeds=tuple(range(5)),
    run=run_trial,
)
# What is stored in the folder already is not run again.
table = run_study(study, "runs")
print(table.columns)

rewards = table.group_by("condition", "seed").agg(pl.col("reward").sum())
found = {}
for learner in LEARNERS:
    of_learner = rewards.filter(pl.col("condition") == learner)
    found[learner] = mean(of_learner.sort("seed")["reward"].to_numpy())
    low, high = found[learner].low, found[learner].high
    print(f"{learner:>10}: {found[learner].value:+.1f} [{low:+.1f}, {high:+.1f}]")
