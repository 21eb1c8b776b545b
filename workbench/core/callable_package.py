"""Callable packages: `workbench.report(…)` is a call, although `workbench.report` is also a package."""

from __future__ import annotations

import inspect
import sys
from importlib import import_module
from types import ModuleType
from typing import Any


class CallablePackage(ModuleType):
    """A package that can be called; the call runs the function `_called`, given as "module:function"."""

    _called: str

    @property
    def __signature__(self) -> inspect.Signature:
        return inspect.signature(self.called_function())

    def called_function(self) -> Any:
        """Returns the function that a call of the package runs."""
        module, _, name = self._called.partition(":")
        return getattr(import_module(module), name)

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        return self.called_function()(*arguments, **options)


def make_callable(package: str, called: str) -> None:
    """Makes the imported package callable. `called` is "module:function"; it is imported at the first
    call."""
    module = sys.modules[package]
    module.__class__ = CallablePackage
    module._called = called  # type: ignore[attr-defined]
