import numpy as np
import pytest

from learners import QLearner, Team, load, make_learner, make_team
from learners.errors import ParameterError, UnknownRobotError
from learners.exploration import Greedy
from learners.tabular.rates import ConstantRate

ROBOTS = ("rex", "ada")


@pytest.fixture
def make(rng):
    def make(sharing, **more):
        members = {
            robot: QLearner(
                2,
                stream,
                gamma=0.0,
                rate=ConstantRate(alpha=0.5),
                exploration=Greedy(),
            )
            for robot, stream in zip(ROBOTS, rng.spawn(2), strict=True)
        }
        return Team(members=members, sharing=sharing, **more)

    return make


@pytest.fixture
def seen(toy):
    """What rex sees, and what ada sees in its place."""
    return toy("ann reads", "ann rex"), toy("ann reads", "ann ada")


def test_independent_robots_learn_nothing_of_each_other(make, entry, touch, seen):
    team = make("independent")
    team.learn("rex", entry(seen[0], 1, 0.0, touch(time=1.0)))
    assert team.q_values("rex", seen[0]).tolist() == [0.0, 0.5]
    assert team.q_values("ada", seen[1]).tolist() == [0.0, 0.0]


def test_a_shared_table_serves_all_robots_as_each_would_see_it(
    make, entry, touch, seen
):
    team = make("shared")
    team.learn("rex", entry(seen[0], 1, 0.0, touch(time=1.0)))
    team.learn("ada", entry(seen[1], 1, 0.0, touch(time=1.0)))
    for robot, state in zip(ROBOTS, seen, strict=True):
        assert team.q_values(robot, state).tolist() == [0.0, 0.75]
        assert team.act(robot, state) == 1


def test_each_robot_of_a_shared_table_has_its_own_history(make, entry):
    team = make("shared")
    team.learn("rex", entry("s", 0, 0.0))
    team.learn("ada", entry("s", 0, 0.5))  # would overlap in one history
    assert len(team.members["rex"].history) == len(team.members["ada"].history) == 1


def test_carried_experience_moves_the_others_by_its_strength(make, entry, touch, seen):
    team = make("carried", strength=0.5)
    team.learn("rex", entry(seen[0], 1, 0.0, touch(time=1.0)))
    assert team.q_values("rex", seen[0]).tolist() == [0.0, 0.5]
    assert team.q_values("ada", seen[1]).tolist() == [0.0, 0.25]
    assert team.q_values("ada", seen[0]).tolist() == [0.0, 0.0]


def test_a_state_that_knows_no_swaps_looks_the_same_to_all(make, entry, touch):
    team = make("carried", strength=1.0)
    team.learn("rex", entry("s", 1, 0.0, touch(time=1.0)))
    assert team.q_values("ada", "s").tolist() == [0.0, 0.5]


@pytest.mark.parametrize("sharing", ["independent", "shared", "carried"])
def test_an_unknown_robot_is_refused_and_nothing_learned(make, entry, touch, sharing):
    team = make(sharing)
    with pytest.raises(UnknownRobotError, match="bit is not one of the team: rex, ada"):
        team.learn("bit", entry("s", 1, 0.0, touch(time=1.0)))
    with pytest.raises(UnknownRobotError):
        team.member("bit")
    assert all(len(member.table) == 0 for member in team.members.values())


def test_a_member_is_a_learner_like_any_other(make, entry, touch):
    team = make("carried")
    rex = team.member("rex")
    rex.learn(entry("s", 1, 0.0, touch(time=1.0)))
    assert (rex.n_behaviors, rex.act("s"), len(rex.credits)) == (2, 1, 1)
    assert rex.q_values("s").tolist() == [0.0, 0.5]
    assert team.q_values("ada", "s")[1] == 0.25
    rex.start_episode()
    rex.learn(entry("s", 1, 0.0))


@pytest.mark.parametrize("sharing", ["independent", "shared", "carried"])
def test_a_loaded_team_goes_on_exactly_as_the_saved_one(sharing, live, tmp_path):
    team = make_team(
        "designated_adaptive", ROBOTS, 3, np.random.default_rng(1), sharing=sharing
    )

    def day(team, seed, start):
        rng = np.random.default_rng(seed)
        return [live(team.member(robot), 100, rng, start) for robot in ROBOTS]

    day(team, 2, 0.0)
    team.member("ada").save(tmp_path / "team.json")
    twin = load(tmp_path / "team.json")
    assert day(team, 3, 1e3) == day(twin, 3, 1e3)


def test_after_loading_a_shared_table_is_still_one(make, entry, tmp_path):
    team = make("shared")
    team.learn("rex", entry("s", 1, 0.0))
    team.save(tmp_path / "team.json")
    twin = load(tmp_path / "team.json")
    assert twin.members["rex"].table is twin.members["ada"].table
    assert twin.members["rex"].network is twin.members["ada"].network


def test_robots_have_random_streams_of_their_own(live):
    team = make_team("random", ROBOTS, 3, np.random.default_rng(1))
    ways = [live(team.member(each), 50, np.random.default_rng(2)) for each in ROBOTS]
    assert ways[0] != ways[1]


@pytest.mark.parametrize("name", ["views", "designated_views"])
def test_views_are_shared_as_each_robot_would_see_them(
    name, rng, entry, touch, toy, tmp_path
):
    team = make_team(name, ROBOTS, 2, rng, sharing="shared")
    for robot in ROBOTS:
        seen = toy("ann reads, bob calls", f"ann {robot}")
        felt = touch(value=1.0, time=1.0, giver="ann")
        team.learn(robot, entry(seen, 1, 0.0, felt))
    values = {
        robot: team.q_values(robot, toy("ann reads", f"ann {robot}")).tolist()
        for robot in ROBOTS
    }
    assert values["rex"] == values["ada"]
    assert values["rex"][1] > 0.0
    team.save(tmp_path / "team.json")
    twin = load(tmp_path / "team.json")
    twin.learn("rex", entry(toy("ann reads", "ann rex"), 1, 1.0, touch(time=2.0)))
    alone = toy("ann reads", "ann ada")
    assert twin.q_values("ada", alone)[1] > team.q_values("ada", alone)[1]


def test_views_are_carried_to_the_same_person_before_another_robot(
    rng, entry, touch, toy
):
    team = make_team("designated_views", ROBOTS, 2, rng, sharing="carried")
    seen = toy("ann reads, bob calls", "ann rex")
    team.learn("rex", entry(seen, 1, 0.0, touch(value=1.0, time=1.0, giver="ann")))
    rows = team.members["ada"].table.rows
    assert {(person, dict(view)["plays"]) for view, person in rows} == {
        ("ann", "reads")
    }
    assert team.q_values("ada", toy("ann reads", "ann ada"))[1] > 0.0


@pytest.mark.parametrize("sharing", ["shared", "carried"])
def test_only_learners_that_can_share_do(rng, sharing):
    with pytest.raises(ParameterError, match="only QLearners"):
        make_team("tamer", ROBOTS, 2, rng, sharing=sharing)


def test_only_learners_of_one_kind_share(rng):
    members = {
        robot: make_learner(name, 2, rng)
        for robot, name in zip(ROBOTS, ("views", "designated"), strict=True)
    }
    with pytest.raises(ParameterError, match="all of one kind"):
        Team(members=members, sharing="shared")


@pytest.mark.parametrize(
    ("parts", "reason"),
    [
        ({"members": {}}, "at least one robot"),
        ({"sharing": "half"}, "no sharing called 'half'"),
        ({"strength": 1.5}, "strength"),
    ],
)
def test_a_team_out_of_range_is_refused(rng, parts, reason):
    with pytest.raises(ParameterError, match=reason):
        Team(**({"members": {"rex": QLearner(2, rng)}} | parts))
