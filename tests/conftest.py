"""Campaigns of minutes run only with --slow, on other random cases each time; all else on the same ones."""

import pytest
from hypothesis import settings


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--slow", action="store_true", help="also run the campaigns marked slow")


def pytest_configure(config: pytest.Config) -> None:
    settings.register_profile("same cases", derandomize=True)
    if not config.getoption("--slow"):
        settings.load_profile("same cases")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if config.getoption("--slow"):
        return
    for item in items:
        if item.get_closest_marker("slow"):
            item.add_marker(pytest.mark.skip(reason="slow: run with --slow"))
