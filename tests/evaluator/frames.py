"""What the symbols of [frames] and [points] are worth, by turning components: nothing of the definitions that
the workbench makes of them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING

from evaluator.series import Matrix, added, axial, constant, each, nothing, product, scaled, turned, unit

if TYPE_CHECKING:
    from evaluator.values import World

_KINDS = (
    (r"\{\}\^\{(?P<f>.)\}\\omega\^\{(?P<g>.)\}", "spin"),
    (r"\{\}\^\{(?P<f>.)\}\\alpha\^\{(?P<g>.)\}", "spin rate"),
    (r"\{\}\^\{(?P<f>.)\}R\^\{(?P<g>.)\}|\{\}_\{(?P<g2>.)\}\^\{(?P<f2>.)\}R", "turn"),
    (r"\{\}_\{(?P<g>.)\}\^\{(?P<f>.)\}T", "transform"),
    (r"r\^\{(?P<g>.)/(?P<f>.)\}", "way"),
    (r"\{\}\^\{(?P<f>.)\}v\^\{(?P<g>.)\}", "velocity"),
    (r"\{\}\^\{(?P<f>.)\}a\^\{(?P<g>.)\}", "acceleration"),
    (r"\{\}\^\{(?P<f>.)\}P_\{(?P<g>.)ORG\}", "origin"),
    (r"\{\}\^\{(?P<f>.)\}P", "place"),
)


class Triads:
    """base: the frame that the others move in.   places: point → the symbol that it is, or nothing where it is
    the base's origin."""

    def __init__(self, base: str, places: Mapping[str, str]) -> None:
        self.base, self.places = base, places

    def __call__(self, world: World, name: str) -> Matrix | None:
        """The value of a symbol with that name; None for one that no frame and no point has."""
        for pattern, kind in _KINDS:
            if (found := re.fullmatch(pattern, name.replace(" ", ""))) is not None:
                letters = {key[0]: value for key, value in found.groupdict().items() if value}
                return self._value(world, kind, letters["f"], letters.get("g", "P"))
        return None

    def _value(self, world: World, kind: str, f: str, g: str) -> Matrix:
        if kind == "way":
            return _from(self._point(world, g), self._point(world, f))
        turn = self._axes(world, f)
        own = partial(product, turned(turn))
        match kind:
            case "turn":
                return own(self._axes(world, g))
            case "spin":
                relative = own(self._axes(world, g))
                return product(turn, axial(product(_rate(relative), turned(relative))))
            case "spin rate":
                return self._seen(turn, self._value(world, "spin", f, g))
            case "velocity":
                return self._seen(turn, _from(self._point(world, g), self._origin(world, f)))
            case "acceleration":
                return self._seen(turn, self._value(world, "velocity", f, g))
            case "origin":
                return own(_from(self._origin(world, g), self._origin(world, f)))
            case "place":
                return own(_from(self._point(world, g), self._origin(world, f)))
        relative, shift = own(self._axes(world, g)), self._value(world, "origin", f, g)
        rows = [[*row, s] for row, (s,) in zip(relative, shift, strict=True)]
        return [*rows, [constant(0), constant(0), constant(0), constant(1)]]

    def _seen(self, turn: Matrix, x: Matrix) -> Matrix:
        """What changes of a vector for one who turns with the frame: the rates of its components there."""
        return product(turn, _rate(product(turned(turn), x)))

    def _axes(self, world: World, frame: str) -> Matrix:
        return unit(3) if frame == self.base else world.named(rf"\mathsf{{Q}}_{{{frame}}}")

    def _origin(self, world: World, frame: str) -> Matrix:
        return nothing(3, 1) if frame == self.base else world.named(rf"\mathsf{{o}}_{{{frame}}}")

    def _point(self, world: World, point: str) -> Matrix:
        return world.named(self.places[point]) if self.places[point] else nothing(3, 1)


def _rate(x: Matrix) -> Matrix:
    return each(x, lambda entry: entry.rate())


def _from(one: Matrix, other: Matrix) -> Matrix:
    return added(one, scaled(other, -1))
