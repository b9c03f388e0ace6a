"""Score a policy of your own in homes drawn by seed, beside references."""

from experiments import evaluate
from household.activity import Activity
from household.observation import layout
from household.scenario.family import draw

home = draw("phone", 0)
fields = layout(home)  # the name of each field of an observation -> where it stands
print(*fields, sep=", ")


def quiet_for_callers(observation, agent):
    """Sleeps while anybody is on the phone, and plays otherwise."""
    activities = observation[fields["person_activity"]].reshape(-1, len(Activity))
    on_the_phone = activities[:, Activity.CALLING].any()
    return home.behaviors.index("sleep" if on_the_phone else "play")


evaluation = evaluate(quiet_for_callers, "phone", seeds=2, steps=300)
for family in evaluation.families:
    print(f"{family.family}: {family.demand}")
    for name in ("policy", "random", "best constant", "lookahead"):
        score = family.scores[name]
        print(
            f"{name:>14}: probe {score.probe_greedy.value:+.2f}, "
            f"{score.caresses_per_minute.value:.2f} caresses and "
            f"{score.taps_per_minute.value:.2f} taps a minute"
        )
