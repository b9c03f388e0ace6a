"""Pictures of homes."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from household.config.toml import shipped
from household.errors import HouseholdError
from household.home.floorplan import load_floorplan
from household.view.colors import ACTIVITY_COLORS
from household.view.floorplan_svg import draw, draw_on


@pytest.fixture
def flat():
    return load_floorplan("two_room_flat")


def test_a_picture_names_rooms_activities_regions_and_furniture(flat, tmp_path):
    draw(flat, tmp_path / "flat.svg")
    text = (tmp_path / "flat.svg").read_text()
    for name in ("LIVING ROOM", "sleeping", "study nook", "wardrobe", "2 m"):
        assert name in text


def test_a_picture_holds_no_date_and_no_chance(flat, tmp_path):
    draw(flat, tmp_path / "one.svg")
    draw(flat, tmp_path / "two.svg")
    assert (tmp_path / "one.svg").read_bytes() == (tmp_path / "two.svg").read_bytes()


def test_a_picture_can_be_a_png(flat, tmp_path):
    draw(flat, tmp_path / "flat.png")
    assert (tmp_path / "flat.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("name", ["flat.xyz", "nowhere/flat.svg"])
def test_a_picture_that_cannot_be_written_is_named(flat, tmp_path, name):
    with pytest.raises(HouseholdError, match=name):
        draw(flat, tmp_path / name)


def test_tall_furniture_is_darker_than_low_furniture(flat):
    from matplotlib.figure import Figure

    axes = Figure().add_subplot()
    draw_on(flat, axes)
    boxes = axes.patches[len(flat.rooms) :][: len(flat.furniture)]
    shades = {
        tall: {
            sum(patch.get_facecolor()[:3])
            for box, patch in zip(flat.furniture, boxes, strict=True)
            if box.tall is tall
        }
        for tall in (True, False)
    }
    (dark,), (light,) = shades[True], shades[False]
    assert dark < light


def test_every_activity_has_a_color_of_its_own():
    assert len(set(ACTIVITY_COLORS.values())) == len(ACTIVITY_COLORS) == 7


def test_matplotlib_is_loaded_only_when_something_is_drawn():
    code = (
        "import household.view.floorplan_svg, sys; print('matplotlib' in sys.modules)"
    )
    ran = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert ran.stdout.strip() == "False"


def test_the_documentation_shows_every_shipped_home():
    docs = Path(__file__).parents[3] / "docs"
    text = (docs / "homes.md").read_text(encoding="utf-8")
    for name in shipped("home"):
        assert f"\n## {name}\n" in text
    for picture in re.findall(r"\((pictures/.+?)\)", text):
        assert (docs / picture).is_file(), picture
