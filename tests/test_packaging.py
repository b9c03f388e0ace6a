"""What is installed: exactly the four packages, with all their data."""

import configparser
import importlib
import importlib.metadata
import os
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

import household

PACKAGES = ("experiments", "household", "learners", "policies")
ROOT = Path(household.__file__).parent.parent

pytestmark = pytest.mark.skipif(
    not (ROOT / "pyproject.toml").is_file(), reason="needs the project's folder"
)


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """Folder with the wheel and the source distribution, built with what is here."""
    folder = tmp_path_factory.mktemp("built")
    subprocess.run(
        [
            *(sys.executable, "-m", "build", "--wheel", "--sdist", "--no-isolation"),
            *("--outdir", str(folder), str(ROOT)),
        ],
        check=True,
        capture_output=True,
    )
    return folder


@pytest.fixture(scope="module")
def wheel(built):
    (path,) = built.glob("*.whl")
    return path


@pytest.fixture(scope="module")
def metadata(wheel):
    """What the wheel says of itself, field by field."""
    (info,) = importlib.metadata.distributions(
        name="polite-household", path=[str(wheel)]
    )
    return info.metadata


@pytest.fixture(scope="module")
def names(wheel):
    with zipfile.ZipFile(wheel) as archive:
        return archive.namelist()


@pytest.fixture
def unpacked(wheel, tmp_path):
    """The wheel's content in a folder of its own."""
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path / "unpacked")
    return tmp_path / "unpacked"


def run(python, code, folder, **environment):
    done = subprocess.run(
        [str(python), "-c", code],
        cwd=folder,
        env=environment or None,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_the_four_packages_come_from_one_folder():
    """A foreign distribution of the same name would come from another."""
    folders = {
        Path(importlib.import_module(n).__file__).parent.parent for n in PACKAGES
    }
    assert folders == {ROOT}


def test_the_wheel_holds_exactly_the_four_packages(names):
    tops = {name.partition("/")[0] for name in names}
    info = f"polite_household-{household.__version__}.dist-info"
    assert tops == {*PACKAGES, info}


def test_the_wheel_holds_every_file_of_the_packages(names):
    """Homes, personas, scenarios, templates and type markers as well as modules."""
    there = {
        path.relative_to(ROOT).as_posix()
        for package in PACKAGES
        for path in (ROOT / package).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    assert {name for name in names if name.partition("/")[0] in PACKAGES} == there
    assert {f"{package}/py.typed" for package in PACKAGES} <= there
    assert sum(name.endswith(".toml") for name in there) >= 20


def test_the_wheel_names_the_command(wheel):
    info = f"polite_household-{household.__version__}.dist-info"
    with zipfile.ZipFile(wheel) as archive:
        scripts = configparser.ConfigParser()
        scripts.read_string(archive.read(f"{info}/entry_points.txt").decode())
    module, _, function = scripts["console_scripts"]["household"].partition(":")
    assert callable(getattr(importlib.import_module(module), function))


def test_the_wheel_says_version_authors_and_license(metadata, names):
    assert metadata["Version"] == household.__version__
    assert metadata["Author"] == "the Household authors"
    assert metadata["License-Expression"] == "MIT"
    assert any(name.endswith("/licenses/LICENSE") for name in names)


def test_the_source_distribution_holds_all_that_a_checkout_needs(built):
    (path,) = built.glob("*.tar.gz")
    with tarfile.open(path) as archive:
        held = {name.partition("/")[2] for name in archive.getnames()}
    tracked = {
        file.relative_to(ROOT).as_posix()
        for folder in (*PACKAGES, "docs", "tests")
        for file in (ROOT / folder).rglob("*")
        if file.is_file() and "__pycache__" not in file.parts
    }
    assert tracked <= held
    assert {"CITATION.cff", "LICENSE", "Makefile", "README.md"} <= held


def test_the_citation_names_the_version_and_the_license_of_the_package(metadata):
    cited = (ROOT / "CITATION.cff").read_text("utf-8").splitlines()
    assert f"version: {metadata['Version']}" in cited
    assert f"license: {metadata['License-Expression']}" in cited
    assert f'  - name: "{metadata["Author"]}"' in cited


def test_what_the_wheel_holds_runs_from_an_empty_folder(unpacked, tmp_path):
    (tmp_path / "empty").mkdir()
    code = (
        "from household import household_v0\n"
        "from household.config.toml import shipped\n"
        "import household\n"
        "for name in shipped('scenario'):\n"
        "    household_v0.parallel_env(name).reset(seed=1)\n"
        "print(household.__file__)\n"
    )
    told = run(
        sys.executable,
        code,
        tmp_path / "empty",
        PYTHONPATH=str(unpacked),
        NUMBA_DISABLE_JIT="1",
    )
    assert told.strip() == str(unpacked / "household" / "__init__.py")


def interpreter(version):
    """An interpreter of a version that runs here; None if there is none."""
    installed = (Path.home() / ".pyenv" / "versions").glob(f"{version}*/bin/python")
    for python in (f"python{version}", *map(str, sorted(installed))):
        try:
            done = subprocess.run([python, "-c", ""], capture_output=True, check=False)
        except OSError:
            continue
        if done.returncode == 0:
            return python
    return None


EVERYTHING = """
import numpy as np
import experiments, household, learners, policies
from household import household_v0
env = household_v0.parallel_env('evening', max_cycles=5)
env.reset(seed=1)
while env.agents:
    env.step(dict.fromkeys(env.agents, 0))
envs = household.vector.make('evening', homes=2, workers=1, seed=1)
envs.reset()
envs.step(np.zeros(envs.num_envs, int))
envs.close()
print('works')
"""


@pytest.mark.slow
@pytest.mark.parametrize("version", ["3.11", "3.12", "3.13"])
def test_the_wheel_works_in_a_fresh_environment_from_an_empty_folder(
    wheel, tmp_path, version
):
    python = interpreter(version)
    if python is None:
        pytest.skip(f"there is no Python {version} here")
    fresh, empty = tmp_path / "fresh", tmp_path / "empty"
    empty.mkdir()
    subprocess.run([python, "-m", "venv", str(fresh)], check=True)
    own = fresh / "bin" / "python"
    subprocess.run([own, "-m", "pip", "install", "--quiet", str(wheel)], check=True)
    path = {"PATH": os.environ["PATH"], "HOME": str(tmp_path)}
    assert run(own, EVERYTHING, empty, **path) == "works\n"
    command = [fresh / "bin" / "household", "--help"]
    done = subprocess.run(
        command, cwd=empty, env=path, capture_output=True, check=False
    )
    assert done.returncode == 0
    assert list(empty.iterdir()) == []
