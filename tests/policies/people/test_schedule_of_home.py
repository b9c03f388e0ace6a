"""The shipped schedule in homes that have only some of its places."""

import numpy as np
import pytest

from household.home.floorplan import Region
from household.scenario.scenario import PersonSpec
from policies.people.from_scenario import routine_of

SPOTS = ((1.0, 2.5), (7.0, 1.0))


@pytest.mark.parametrize(
    "activities",
    [("calling",), ("calling", "entering"), ("sleeping", "playing"), ("entering",)],
)
def test_somebody_whose_home_leads_nowhere_goes_on_with_what_there_is(
    room, household_of, activities
):
    regions = tuple(
        Region(name=each, activity=each, center=spot, facing=spot)
        for each, spot in zip(activities, SPOTS, strict=False)
    )
    scenario = household_of(
        home=room(regions=regions), people=(PersonSpec(name="ann"),)
    )
    with np.errstate(all="raise"):
        assert routine_of(scenario, 0) is not None
