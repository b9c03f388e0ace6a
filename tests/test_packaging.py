"""What is installed: exactly the four packages, with all their data."""

import configparser
import importlib
import importlib.metadata
import subprocess
import sys
import tarfile
import venv
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


@pytest.mark.slow
def test_the_wheel_installs_into_a_fresh_environment(wheel, tmp_path):
    venv.create(tmp_path / "fresh", with_pip=True)
    python = tmp_path / "fresh" / "bin" / "python"
    subprocess.run([python, "-m", "pip", "install", "--quiet", str(wheel)], check=True)
    code = (
        "import experiments, household, learners, policies\n"
        "from household import household_v0\n"
        "household_v0.parallel_env('evening').reset(seed=1)\n"
        "print('works')\n"
    )
    assert run(python, code, tmp_path) == "works\n"
    command = tmp_path / "fresh" / "bin" / "household"
    done = subprocess.run([command, "--help"], capture_output=True, check=False)
    assert done.returncode == 0
