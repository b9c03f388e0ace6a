"""The table on interrupting says what the stored runs say."""

from itertools import count

from experiments.docs_tools.interrupting import (
    BEGIN,
    CHOICES,
    END,
    FAMILIES,
    SEEDS,
    lived,
    read,
    table,
)


def row(reward):
    keys = ("caresses", "taps", "bouts", "appropriateness")
    return {"reward": reward, **dict.fromkeys(keys, 1.0)}


def run(family, seed):
    rewards = {"in every step": 0.1 * seed, "held": 0.3}
    return {"family": family, "seed": seed} | {
        name: row(reward) for name, reward in rewards.items()
    }


def test_a_row_has_the_mean_of_all_seeds_and_the_lowest_and_the_highest():
    lines = table([run(f, s) for f in FAMILIES for s in SEEDS]).splitlines()
    assert len(lines) == 2 + len(FAMILIES) * len(CHOICES)
    assert lines[2].startswith("| phone | in every step | 0.10 [0.00, 0.20] |")
    assert lines[3].startswith("|  | held | 0.30 [0.30, 0.30] |")


def test_the_page_has_the_table_of_the_stored_runs(root):
    page = (root / "docs" / "environment.md").read_text("utf-8")
    shown = page.partition(BEGIN)[2].partition(END)[0]
    assert shown.strip() == table(read(root / "docs" / "interrupting")).strip()


def test_a_held_robot_begins_fewer_bouts_than_one_that_always_interrupts():
    turns = count()

    def restless(seen, robot):
        return next(turns) % 3

    often = lived(restless, "phone", 0, held=False)
    held = lived(restless, "phone", 0, held=True)
    assert often["bouts"] > 50.0 > 20.0 > held["bouts"] > 0.0
