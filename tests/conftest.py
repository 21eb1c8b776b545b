"""The options of the tests.

A run without paths takes one row in ten of each table of tests, so that it ends in minutes. It takes every row
with --every, -k or --lf, and of the files and folders that are named. Campaigns of minutes run only with --slow, on
other random cases each time; all else runs on the same ones.
"""

import gc
import os
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from workbench.runtime import workers

#: Papers that tests judge themselves: what they claim is not all right.
collect_ignore_glob = ["regressions/papers/*.toml", "errata/*/*.toml"]

HERE = Path(__file__).parent

#: What is judged matters there, and not in which process: a fork takes several times as long as most judgements.
JUDGED_HERE = {"context", "judge", "language", "regressions", "texts"}

#: A run without paths takes one row in so many of a table.
ROWS_APART = 10

#: The fewest rows of such a table.
FEWEST_ROWS = 4

#: Tells the processes of a run that it takes a sample of the rows.
SAMPLED = "WORKBENCH_TESTS_SAMPLED"

#: Of processor time; no default test takes a tenth of it. What never ends, ends its process.
SECONDS = 120


@pytest.fixture(autouse=True)
def judged_here(request: pytest.FixtureRequest) -> Iterator[None]:
    if request.path.relative_to(HERE).parts[0] not in JUDGED_HERE:
        yield
        return
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(workers, "get_all_start_methods", list)
        yield from _within_time(request)


def _within_time(request: pytest.FixtureRequest) -> Iterator[None]:
    if "MUTANT_UNDER_TEST" in os.environ or request.node.get_closest_marker("slow"):
        yield  # mutmut counts calls, which takes ten times as long; a mutant's tests have limits of their own
        return
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    yield
    signal.setitimer(signal.ITIMER_PROF, 0)


@pytest.fixture(autouse=True)
def forgotten(request: pytest.FixtureRequest) -> Iterator[None]:
    """What a test with changed code finds is kept for no other test."""
    with pytest.MonkeyPatch.context() as patch:
        if "monkeypatch" in request.fixturenames:
            patch.setenv("WORKBENCH_CACHE", os.devnull)
        yield


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--slow", action="store_true", help="also run the campaigns marked slow")
    parser.addoption(
        "--shared-cache", metavar="DIR", help="let all tests share the verdicts kept in a folder"
    )
    parser.addoption("--every", action="store_true", help="take every row of the tables of tests")
    parser.addoption("--backwards", action="store_true", help="run the last test first")


def pytest_configure(config: pytest.Config) -> None:
    if not hasattr(config, "workerinput"):
        is_whole = config.args_source is pytest.Config.ArgsSource.TESTPATHS
        chosen = ("--every", "--slow", "-k", "--lf")
        os.environ[SAMPLED] = "1" * (is_whole and not any(map(config.getoption, chosen)))
    if shared := config.getoption("--shared-cache"):
        os.environ["WORKBENCH_CACHE"] = str(Path(shared).absolute())
    else:  # tests judge anew: a file that cannot be is no cache
        os.environ.setdefault("WORKBENCH_CACHE", os.devnull)
    if "MUTANT_UNDER_TEST" in os.environ:  # mutmut sees which test calls what in its own process alone
        workers.get_all_start_methods = list
    # A busy machine takes seconds for a case that takes milliseconds: no wall time decides a test.
    settings.register_profile("untimed", deadline=None, suppress_health_check=[HealthCheck.too_slow])
    settings.register_profile("same cases", settings.get_profile("untimed"), derandomize=True)
    settings.load_profile("untimed" if config.getoption("--slow") else "same cases")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if os.environ.get(SAMPLED):
        _take_a_sample(config, items)
    if config.getoption("--backwards"):
        items.reverse()
    if config.getoption("--slow"):
        return
    for item in items:
        if item.get_closest_marker("slow"):
            item.add_marker(pytest.mark.skip(reason="slow: run with --slow"))


def _take_a_sample(config: pytest.Config, items: list[pytest.Item]) -> None:
    tables: dict[str, list[pytest.Item]] = {}
    for item in items:
        tables.setdefault(item.nodeid.partition("[")[0], []).append(item)
    taken = {
        item
        for rows in tables.values()
        for item in (rows[::ROWS_APART] if len(rows) >= FEWEST_ROWS else rows)
    }
    config.hook.pytest_deselected(items=[item for item in items if item not in taken])
    items[:] = [item for item in items if item in taken]


def pytest_collection_finish() -> None:
    gc.freeze()  # what all tests share is looked through for garbage no more


def pytest_sessionfinish() -> None:
    gc.freeze()  # nor what is left, five times by pytest
