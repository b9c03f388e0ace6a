"""docs/architecture.md tells the rooms, the layers and the flows as they are."""

import re
import tomllib

import pytest

LAYERED = ("household", "learners", "experiments")
FLOWS = (
    "From a step to a touch and a reward",
    "From a touch to a Q-value",
    "From household reproduce to a row of the claims table",
    "From a moment to Rerun, and back",
)


@pytest.fixture(scope="module")
def sections(root):
    """The text of the page, by heading."""
    text = (root / "docs" / "architecture.md").read_text("utf-8")
    parts = re.split(r"^#+ (.+)\n", text, flags=re.MULTILINE)[1:]
    headings = (heading.replace("`", "") for heading in parts[::2])
    return dict(zip(headings, parts[1::2], strict=True))


@pytest.fixture(scope="module")
def layers(root):
    """The rooms of each package, layer by layer, as import-linter holds them."""
    text = (root / "pyproject.toml").read_text("utf-8")
    contracts = tomllib.loads(text)["tool"]["importlinter"]["contracts"]
    return {
        contract["containers"][0]: [set(layer.split(" | ")) for layer in rooms]
        for contract in contracts
        if contract.get("containers") and (rooms := contract["layers"])
    }


@pytest.mark.parametrize("package", LAYERED)
def test_the_table_of_a_package_lists_its_rooms_layer_by_layer(
    sections, layers, package
):
    rows = re.findall(r"^\| (`.+?) \|", sections[package], re.MULTILINE)
    shown = [set(re.findall(r"`(\w+)`", row)) for row in rows]
    assert shown == layers[package]


@pytest.mark.parametrize("flow", FLOWS)
def test_each_stage_of_a_flow_names_where_in_the_code_it_is(sections, flow):
    stages = re.findall(
        r"^\d+\. (.+(?:\n {2,}.+)*)", sections[flow], flags=re.MULTILINE
    )
    assert len(stages) >= 5
    assert [stage for stage in stages if not re.search(r"`\S+\.py: \w", stage)] == []
