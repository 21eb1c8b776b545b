"""A plant on a polynomial joint path, with Drake Expressions of time as scalars.

An Expression grows a thousandfold in a few derivatives if it is not expanded. Expanded into its monomials t^k
sin^a(θ₁) cos^b(θ₁) ..., of which there are few, it stays small.

Drake keeps an Expression in the bits of a NaN, for which NumPy reports an invalid value: functions that
compute with arrays of them are decorated with `expressions_are_not_nan`.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from workbench.drake.gate import (
    BodyIndex,
    Expression,
    MultibodyPlant,
    SpatialInertia_,
    UnitInertia_,
    Variable,
)
from workbench.drake.joint_paths import JointPath
from workbench.drake.plants import body_named, set_state

ZERO = Expression(0.0)

expressions_are_not_nan = np.errstate(invalid="ignore")


def _entrywise(function: Callable, array: np.ndarray, dtype: type = object) -> np.ndarray:
    values: np.ndarray = np.empty(array.shape, dtype)
    for index in np.ndindex(array.shape):
        values[index] = function(array[index])
    return values


def expanded(quantity) -> np.ndarray:
    return _entrywise(lambda entry: (ZERO + entry).Expand(), np.asarray(quantity, object))


def rate(quantity: np.ndarray, t: Variable) -> np.ndarray:
    """Returns the time derivative, by Drake."""
    return _entrywise(lambda entry: entry.Differentiate(t).Expand(), quantity)


def evaluated(quantity: np.ndarray, t: Variable, time: float) -> np.ndarray:
    """Returns the quantity's value at a time, in floats."""
    return _entrywise(lambda entry: entry.Evaluate({t: time}), quantity, float)


class Entry:
    """A component along the motion; Drake differentiates and evaluates it at first use."""

    def __init__(self, component: Expression, t: Variable) -> None:
        self.component, self._t = component, t
        self._rates = [component]
        self._values: dict[tuple[int, float], float] = {}

    def value(self, order: int, time: float) -> float:
        key = (order, time)
        if key not in self._values:
            self._values[key] = self._rate(order).Evaluate({self._t: time})
        return self._values[key]

    def _rate(self, order: int) -> Expression:
        """Returns the rate; only expressions that are differentiated further are expanded."""
        while len(self._rates) <= order:
            self._rates.append(self._rates[-1].Expand().Differentiate(self._t))
        return self._rates[order]


class Entries:
    """The components of quantities; equal ones are shared, and differentiated once."""

    def __init__(self, t: Variable) -> None:
        self._t = t
        self._all: list[Entry] = []

    def of(self, quantity: np.ndarray) -> np.ndarray:
        """Returns an array of the quantity's shape, with an Entry for each component."""
        return _entrywise(self._shared, np.asarray(quantity, object))

    def _shared(self, component: Expression | float) -> Entry:
        component = ZERO + component
        known = next((e for e in self._all if e.component.EqualTo(component)), None)
        if known is None:
            known = Entry(component, self._t)
            self._all.append(known)
        return known


class SymbolicMotion:
    """A plant on Expressions, on a joint path q(t) with the corresponding velocities."""

    @expressions_are_not_nan
    def __init__(self, plant: MultibodyPlant, path: JointPath, t: Variable):
        self.numeric_plant, self.path = plant, path
        self.plant = plant.ToSymbolic()
        self.context = self.plant.CreateDefaultContext()
        self._give_every_body_mass()
        self.time = t
        self.q = expanded(path(Expression(t)))
        self.plant.SetPositions(self.context, self.q)
        qdot = self.rate(self.q)
        v = expanded(np.ravel(self.plant.MapQDotToVelocity(self.context, qdot)))
        set_state(self.plant, self.context, self.q, v)
        self._A = self.plant.CalcSpatialAccelerationsFromVdot(self.context, self.rate(v))

    def _give_every_body_mass(self) -> None:
        """Gives every body a mass, because Drake divides by masses, although kinematics does not depend on
        them."""
        one, zero = Expression(1.0), Expression(0.0)
        inertia = UnitInertia_[Expression](one, one, one)
        unit = SpatialInertia_[Expression](one, np.array([zero] * 3), inertia)
        for index in range(1, self.plant.num_bodies()):
            self.plant.get_body(BodyIndex(index)).SetSpatialInertiaInBodyFrame(self.context, unit)

    def rate(self, quantity: np.ndarray) -> np.ndarray:
        return rate(quantity, self.time)

    def frame(self, name: str):
        return self.plant.GetFrameByName(name)

    def pose(self, name: str):
        return self.frame(name).CalcPoseInWorld(self.context)

    def velocity(self, name: str):
        return self.frame(name).CalcSpatialVelocityInWorld(self.context)

    def acceleration(self, name: str):
        return self._A[int(body_named(self.plant, name).index())]

    @expressions_are_not_nan
    def twist(self, name: str, p_BoBp_B: np.ndarray) -> np.ndarray:
        """Returns V_WBp = [w_WB; v_WBp], expressed in W, shape (6,)."""
        p_BoBp_W = self.pose(name).rotation() @ p_BoBp_B
        return expanded(self.velocity(name).Shift(p_BoBp_W).get_coeffs())
