"""What the parts of the chapter are made of."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Part:
    """Symbols and definitions, and (equation, formula) in reading order."""

    symbols: Mapping[str, Mapping[str, Any]]
    definitions: Mapping[str, str]
    formulas: tuple[tuple[str, str], ...]
    integers: tuple[str, ...] = ("n", "m", "p")


def vector(weight: int | str | None = None, **more: Any) -> dict[str, Any]:
    return {"kind": "vector", **({} if weight is None else {"weight": weight}), **more}


def tensor(weight: int | str | None = None, **more: Any) -> dict[str, Any]:
    return {**vector(weight, **more), "kind": "tensor"}


def dual(spec: dict[str, Any]) -> dict[str, Any]:
    return {**spec, "kind": f"dual {spec['kind']}"}


ROTATION = {"kind": "rotation", "weight": 0}

TWIST = dual(vector(1))
