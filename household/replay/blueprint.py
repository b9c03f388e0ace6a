"""The blueprint that a recording brings along: what the viewer shows where."""

from typing import TYPE_CHECKING, Any

from household.replay import views
from household.scenario.scenario import Scenario

if TYPE_CHECKING:
    import rerun.blueprint as rrb

FEW_ROBOTS, FEW_PEOPLE = 2, 6
"""Up to so many, everything is side by side; of more, groups are folded into tabs."""


def blueprint(scenario: Scenario, learns: bool, live: bool) -> "rrb.Blueprint":
    """The plan and the robots' reasons above, what happened over time below.

    Args:
        scenario: The household.
        learns: Whether there are learners whose beliefs can be shown.
        live: Whether the viewer shows the newest moment as it comes in.
    """
    import rerun.blueprint as rrb

    few = len(scenario.robots) <= FEW_ROBOTS and len(scenario.people) <= FEW_PEOPLE
    return rrb.Blueprint(
        rrb.Vertical(
            _above(scenario, learns, few), _below(scenario, learns), row_shares=[5, 2.7]
        ),
        time_panel(scenario, "following" if live else "paused"),
        rrb.BlueprintPanel(state="collapsed"),
        rrb.SelectionPanel(state="collapsed"),
        auto_views=False,
    )


def time_panel(scenario: Scenario, play_state: str) -> "rrb.TimePanel":
    """The panel below all views, ten times as fast as life.

    Args:
        scenario: The household.
        play_state: "paused" or "following".
    """
    import rerun.blueprint as rrb

    state: Any = play_state
    return rrb.TimePanel(
        timeline="decision",
        state="collapsed",
        play_state=state,
        fps=10.0 / scenario.decision_period,
    )


def _above(scenario: Scenario, learns: bool, few: bool) -> Any:  # noqa: ANN401 - Rerun's
    import rerun.blueprint as rrb

    plan = views.plan(scenario)
    if not few:
        plan = rrb.Tabs(
            plan, views.doings(scenario), views.moods(), views.attention(scenario)
        )
    if not learns:
        right = rrb.Vertical(views.situations(), views.events(), row_shares=[1, 2])
        return rrb.Horizontal(plan, right, column_shares=[5, 3])
    whys = [views.why(robot) for robot in scenario.robot_names]
    if few:
        shares = [5.6, *(3.1 for _ in whys)]
        return rrb.Horizontal(plan, *whys, column_shares=shares)
    right = rrb.Vertical(rrb.Tabs(*whys), views.situations(), row_shares=[3, 1])
    return rrb.Horizontal(plan, right, column_shares=[5, 3])


def _below(scenario: Scenario, learns: bool) -> Any:  # noqa: ANN401
    import rerun.blueprint as rrb

    over_time = [views.doings(scenario), *views.rewards()]
    if learns:
        over_time += [views.values(robot) for robot in scenario.robot_names]
    about = [views.events(), views.attention(scenario), views.moods()]
    if learns:
        about.insert(1, views.firsts())
    else:
        about.append(about.pop(0))  # it is above already
    return rrb.Horizontal(
        rrb.Tabs(*over_time),
        views.credit(scenario),
        rrb.Tabs(*about),
        column_shares=[4, 5, 4.4],
    )
