"""Campaigns of minutes run only with --slow, on other random cases each time; all else on the same ones."""

import os

import pytest
from hypothesis import settings

from workbench.budget import workers

#: Papers that tests judge themselves: what they claim is not all right.
collect_ignore_glob = ["judge/papers/*.toml"]


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--slow", action="store_true", help="also run the campaigns marked slow")


def pytest_configure(config: pytest.Config) -> None:
    os.environ.setdefault(
        "WORKBENCH_CACHE", os.devnull
    )  # tests judge anew: a file that cannot be is no cache
    if "MUTANT_UNDER_TEST" in os.environ:  # mutmut sees which test calls what in its own process alone
        workers.get_all_start_methods = list
    settings.register_profile("same cases", derandomize=True)
    if not config.getoption("--slow"):
        settings.load_profile("same cases")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if config.getoption("--slow"):
        return
    for item in items:
        if item.get_closest_marker("slow"):
            item.add_marker(pytest.mark.skip(reason="slow: run with --slow"))
