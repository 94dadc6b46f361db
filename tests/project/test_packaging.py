"""Installed as a wheel, from the source archive, or editable, `solve` works from any folder."""

import shutil
import subprocess
import sys
import sysconfig
import tarfile
import venv
import zipfile
from pathlib import Path

import pytest

from tests.helpers.small_problems import GOOD

ROOT = Path(__file__).parents[2]
NOT_COPIED = shutil.ignore_patterns(".*cache*", ".venv", ".git", "build", "dist", "__pycache__", ".hypothesis")
LISTED = """
from solver.resources import root
import solver
print(solver.__file__)
for kind in ("templates", "problems"):
    print(len([path for path in root(kind).rglob("*") if path.is_file()]))
"""

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("packaging")]  # one copy of the project serves all


def ran(*words, cwd):
    done = subprocess.run([str(word) for word in words], cwd=cwd, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def checkout(tmp_path_factory):
    """A copy of the project without what was made in it."""
    return Path(shutil.copytree(ROOT, tmp_path_factory.mktemp("copy") / "checkout", ignore=NOT_COPIED))


@pytest.fixture(scope="module")
def archives(checkout, tmp_path_factory):
    """The wheel and the source archive."""
    folder = tmp_path_factory.mktemp("dist")
    ran(sys.executable, "-m", "build", "--no-isolation", "--outdir", folder, checkout, cwd=checkout)
    return {path.suffix: path for path in folder.iterdir()}


@pytest.fixture
def environment(tmp_path):
    """A new environment without the project, which finds the dependencies of this one."""
    folder = tmp_path / "environment"
    venv.create(folder, symlinks=True)
    packages = sysconfig.get_path("purelib", vars={"base": str(folder), "platbase": str(folder)})
    Path(packages, "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n", encoding="utf-8")
    return folder


def installed(environment, *what):
    pip = (sys.executable, "-m", "pip", "--python", environment / "bin" / "python", "install", "--quiet")
    ran(*pip, "--no-deps", "--no-index", "--no-build-isolation", *what, cwd=environment)


def files(kind):
    return len([path for path in (ROOT / kind).rglob("*") if path.is_file() and path.parent.name != "__pycache__"])


def works(environment, home):
    """Whether the command works from a folder of its own, with the files that were installed under `home`."""
    elsewhere = environment.parent / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "good.yaml").write_text(GOOD, encoding="utf-8")
    place, templates, problems = ran(environment / "bin" / "python", "-c", LISTED, cwd=elsewhere).split()
    assert Path(place).is_relative_to(home)
    assert (int(templates), int(problems)) == (files("templates"), files("problems"))
    assert "eigenstructure" in ran(environment / "bin" / "solve", "tasks", cwd=elsewhere)
    ran(environment / "bin" / "solve", "good.yaml", cwd=elsewhere)
    page = (elsewhere / "good.html").read_text(encoding="utf-8")
    return "<math" in page and "data:font/woff2" in page


def test_the_wheel_works(environment, archives):
    installed(environment, archives[".whl"])
    assert works(environment, environment)


def test_the_source_archive_works(environment, archives):
    installed(environment, archives[".gz"])
    assert works(environment, environment)


def test_an_editable_installation_works_and_uses_the_checkouts_own_files(environment, checkout):
    installed(environment, "--editable", checkout)
    assert works(environment, checkout)
    assert not list(environment.rglob("_data"))


def test_the_archives_hold_what_belongs_in_them(archives):
    wheel = zipfile.ZipFile(archives[".whl"]).namelist()
    assert "solver/py.typed" in wheel
    assert "solver/_data/templates/html/page.html.jinja" in wheel
    assert any(name.startswith("solver/_data/problems/") for name in wheel)
    assert not [
        name for name in wheel if name.startswith(("tests/", "docs/", "benchmarks/", "templates/", "problems/"))
    ]
    licences = {Path(name).name for name in wheel if "/licenses/" in name}
    assert licences == {"LICENSE", "OFL.txt"}
    with tarfile.open(archives[".gz"]) as source:
        names = {name.partition("/")[2] for name in source.getnames()}
    assert {"tests/conftest.py", "LICENSE", "README.md", "Makefile", "templates/html/page.html.jinja"} <= names
