"""Tastes that change: what people want, at each moment of an episode."""

import copy

import numpy as np
import pytest

from household import household_v0
from household.activity import Activity
from household.people.person import everyone_of
from household.people.preferences import Preferences
from household.scenario.change import Change
from household.scenario.norms import Norm
from household.scenario.persona import Persona
from household.scenario.population import Population
from household.scenario.scenario import PersonSpec, RobotSpec, ScriptStep

BARK, SLEEP = 0, 1
CALLING = int(Activity.CALLING)
MINDED = {"calling": Norm(absorbed={"bark": -1.0, "sleep": 0.2})}
LIKED = {"calling": Norm(absorbed={"bark": 0.6})}
ON_THE_PHONE = (ScriptStep(place="phone", duration=(900.0, 900.0)),)
NEAR = (RobotSpec(position=(1.7, 2.5)),)


def eager(name="ann", **changes):
    persona = Persona(
        name="eager", praise=1.0, sanction=1.0, reaction=0.0, habituation=0.0, **changes
    )
    return PersonSpec(name=name, persona=persona, script=ON_THE_PHONE)


@pytest.fixture
def home(household_of):
    """A household that minds barks; changes are to be named."""

    def make(*changes, **more):
        usual = {"norms": MINDED, "people": (eager(),), "robots": NEAR}
        return household_of(**(usual | more), changes=changes)

    return make


def bark_at(scenario, *times):
    """What everybody thinks of barks on the phone, at each of these times."""
    wanted = Preferences(scenario, everyone_of(scenario))
    found = []
    for time in times:
        wanted.hold_at(time)
        found.append(wanted.values[:, CALLING, 0, BARK].round(6).tolist())
    return found


def test_a_change_with_a_date_holds_from_then_on(home):
    scenario = home(Change(at=30.0, norms=LIKED))
    assert bark_at(scenario, 0.0, 29.9, 30.0, 1e6) == [[-1.0], [-1.0], [0.6], [0.6]]


def test_a_drift_leads_evenly_from_what_was_to_what_is_to_be(home):
    scenario = home(Change(at=10.0, over=40.0, norms=LIKED))
    found = bark_at(scenario, 10.0, 20.0, 30.0, 50.0, 60.0)
    assert found == [[-1.0], [-0.6], [-0.2], [0.6], [0.6]]


def test_what_a_change_does_not_name_stays(home):
    scenario = home(Change(at=10.0, norms=LIKED))
    wanted = Preferences(scenario, everyone_of(scenario))
    before = wanted.values.copy()
    wanted.hold_at(10.0)
    changed = np.argwhere(before != wanted.values).tolist()
    assert changed == [[0, CALLING, 0, BARK]]


def test_only_those_whom_it_concerns_change(home):
    people = (eager(), eager("bob"))
    scenario = home(Change(at=10.0, people=("bob",), norms=LIKED), people=people)
    assert bark_at(scenario, 9.0, 10.0) == [[-1.0, -1.0], [-1.0, 0.6]]


def test_changes_follow_each_other_in_whatever_order_they_are_written(home):
    back = Change(at=60.0, over=10.0, norms=MINDED)
    there = Change(at=10.0, over=20.0, norms=LIKED)
    expected = [[-0.2], [0.6], [-0.2], [-1.0]]
    for changes in ((there, back), (back, there)):
        assert bark_at(home(*changes), 20.0, 50.0, 65.0, 99.0) == expected


def test_norms_that_change_tell_as_far_as_people_share_them(home):
    """At heterogeneity .25, with a taste of their own of -0.4: .75 * .6 - .25 * .4."""
    taste = {"calling": Norm(absorbed={"bark": -0.4})}
    scenario = home(
        Change(at=10.0, norms=LIKED),
        heterogeneity=0.25,
        people=(eager(preferences=taste),),
    )
    assert bark_at(scenario, 0.0, 10.0) == [[-0.85], [0.35]]


def test_tastes_that_change_tell_as_far_as_people_have_their_own(home):
    taste = {"calling": Norm(absorbed={"bark": 1.0})}
    scenario = home(Change(at=10.0, preferences=taste), heterogeneity=0.25)
    (after,) = bark_at(scenario, 10.0)
    assert after == pytest.approx([0.75 * -1.0 + 0.25 * 1.0])


def test_tastes_drawn_anew_are_those_of_the_population_with_that_seed(home):
    again = home(Change(at=10.0, population_seed=9), heterogeneity=1.0)
    other = home(heterogeneity=1.0, population=Population(seed=9))
    wanted = Preferences(again, everyone_of(again))
    before = wanted.values.copy()
    wanted.hold_at(10.0)
    (person,) = everyone_of(other)
    np.testing.assert_array_equal(wanted.values[0], person.preferences)
    assert not np.array_equal(before, wanted.values)


def test_without_changes_nobody_is_asked_again(home):
    wanted = Preferences(home(), everyone_of(home()))
    assert wanted.until == np.inf
    change = home(Change(at=7.0, over=2.0, norms=LIKED))
    wanted = Preferences(change, everyone_of(change))
    due = [wanted.until]
    for time in (7.0, 8.0, 9.0):
        wanted.hold_at(time)
        due.append(wanted.until)
    assert due == [7.0, 7.0, 8.0, np.inf]


def lives(scenario, actions, env=None):
    """The touches of an episode, by second."""
    env = env or household_v0.parallel_env(scenario)
    env.reset(seed=3)
    felt = {}
    for action in actions:
        env.step({"robot_0": action})
        for touch in env.feedback("robot_0"):
            felt[env.decision] = touch.kind
    return env, felt


BARKS = [BARK, BARK, SLEEP, SLEEP, SLEEP, SLEEP] * 6


def test_a_robot_that_was_tapped_for_something_is_caressed_for_it_after_the_date(home):
    _, felt = lives(home(Change(at=18.0, norms=LIKED)), BARKS)
    kinds = {kind: [t for t, k in felt.items() if k == kind] for kind in felt.values()}
    assert len(kinds["tap"]) == 3
    assert max(kinds["tap"]) < 18 < min(kinds["caress"])


def test_an_episode_begins_with_what_people_wanted_at_first(home):
    env, felt = lives(home(Change(at=18.0, norms=LIKED)), BARKS)
    _, again = lives(None, BARKS, env)
    assert again == felt


def test_what_is_appropriate_changes_with_what_people_want(home):
    env, _ = lives(home(Change(at=4.0, norms=LIKED)), [SLEEP] * 3)

    def barks():
        of_her = env.appropriateness("robot_0")[BARK]
        of_anybody = env.simulation.appropriateness(0, on_average=True)[BARK]
        return of_her, of_anybody

    assert barks() == (-1.0, -1.0)
    env.step({"robot_0": SLEEP})
    assert barks() == pytest.approx((0.6, 0.6))


def test_a_copy_goes_on_with_what_people_want_by_then(home):
    """Taken before the change and after it, whatever the copy lived through."""
    env, _ = lives(home(Change(at=4.0, over=4.0, norms=LIKED)), [SLEEP] * 2)
    checkpoint = env.checkpoint()
    for _ in range(4):
        env.step({"robot_0": SLEEP})
    twin = copy.deepcopy(env)
    assert twin.appropriateness("robot_0").tolist() == (
        env.appropriateness("robot_0").tolist()
    )
    assert -1.0 < env.appropriateness("robot_0")[BARK] < 0.6
    env.restore(checkpoint)
    assert env.appropriateness("robot_0")[BARK] == -1.0
