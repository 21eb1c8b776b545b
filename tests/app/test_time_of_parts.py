"""A part of a judgement ends in its processor time, also where Python ignores the exception that ends it."""

from __future__ import annotations

import sys
import time
import weakref

import pytest

from workbench.runtime.limits import within

LIMIT = 0.05


class Held:
    """An object that a weak reference may hold."""


def spin(seconds: float) -> bool:
    """Uses up processor time; true if nothing ended it."""
    end = time.process_time() + seconds
    while time.process_time() < end:
        pass
    return True


@pytest.fixture
def told(monkeypatch: pytest.MonkeyPatch) -> list[type[BaseException]]:
    """The exceptions that Python ignores, and tells."""
    found: list[type[BaseException]] = []
    monkeypatch.setattr(sys, "unraisablehook", lambda each: found.append(each.exc_type))
    return found


def test_limit_within_the_callback_of_a_weak_reference(told: list[type[BaseException]]) -> None:
    held, went_on = Held(), False
    watched = weakref.ref(held, lambda _: spin(4 * LIMIT))
    with within(LIMIT):
        del held
        went_on = spin(5)
    assert watched() is None and not went_on and not told


def test_other_ignored_exceptions_are_told(told: list[type[BaseException]]) -> None:
    held = Held()
    watched = weakref.ref(held, lambda _: 1 / 0)
    with within(5):
        del held
    assert watched() is None and told == [ZeroDivisionError]
