"""Reader of a robot's joints and inertias from a URDF file; other elements are ignored.

Besides URDF's own joint types it supports Drake's (`<drake:joint>`): ball, screw, universal, planar. It
shares no code with Drake's parser, so that both can be compared.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import isclose, pi
from pathlib import Path

import numpy as np

from workbench.drake.plain_xml import parse_plain
from workbench.kinematics.robot.balls import rotation_of_rpy
from workbench.kinematics.robot.dynamics import NO_INERTIAS, Inertia
from workbench.kinematics.robot.joints import Limits, Mimic, TreeJoint

KINDS = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": "fixed",
    "floating": "floating",
    "planar": "planar",
    "ball": "ball_rpy",
    "screw": "helical",
    "universal": "universal",
}
DRAKE = "drake:"
WORLD = "world"
XACRO = "the file is a xacro that is not expanded: run `xacro FILE > robot.urdf` and take robot.urdf"


class UrdfError(ValueError):
    """A file that no robot can be made of; the message is one line."""


@dataclass(frozen=True)
class Urdf:
    """What a URDF says of a robot: its name, its links and the joints between them, as in the file, and the
    inertias of the links that have one; if one of these is wrong none, and `no_inertias` says why."""

    name: str
    links: tuple[str, ...]
    joints: tuple[TreeJoint, ...]
    inertias: Mapping[str, Inertia]
    no_inertias: str

    @property
    def root(self) -> str:
        """The one link that no joint leads to."""
        children = {joint.child for joint in self.joints}
        return next(link for link in self.links if link not in children)


def read_urdf(path: str | Path) -> Urdf:
    """Returns the robot in a URDF file. Raises UrdfError, which says what was expected and where."""
    path = Path(path)
    try:
        if not path.is_file():
            raise UrdfError(f"no URDF file at {path}")
        text = path.read_bytes()
    except (OSError, ValueError) as error:
        if isinstance(error, UrdfError):
            raise
        reason = getattr(error, "strerror", None) or error
        raise UrdfError(f"{path}: cannot be read: {reason}") from None
    try:
        return parse_urdf(text)
    except UrdfError as error:
        raise UrdfError(f"{path}: {error}") from None


def parse_urdf(text: bytes | str) -> Urdf:
    """Returns the robot in the text of a URDF file; errors as `read_urdf`.

    Elements that are unknown, with whatever prefix, are not read. `world` is the world even where no link has
    that name.
    """
    try:
        robot = parse_plain(text.encode() if isinstance(text, str) else text)
    except ValueError as error:
        raise UrdfError(str(error)) from None
    if robot.tag != "robot":
        raise UrdfError(f"expected a URDF, whose outermost tag is <robot>, got <{robot.tag}>")
    links = tuple(_attribute(link, "name", "a link") for link in robot.findall("link"))
    elements = [element for element in robot if element.tag in ("joint", f"{DRAKE}joint")]
    if needs_xacro(robot):
        raise UrdfError(XACRO)
    if not links:
        raise UrdfError("expected a <robot> with at least one <link>, got none")
    for link, count in Counter(links).items():
        if count > 1:
            raise UrdfError(f"link {link!r} is there {count} times: expected one of each name")
    joints = tuple(_joint(element) for element in elements)
    if WORLD not in links and any(joint.parent == WORLD for joint in joints):
        links = (WORLD, *links)
    _require_tree(links, joints)
    try:
        inertias, armatures, why = _inertias(robot), _armatures(robot, elements), NO_INERTIAS
        joints = tuple(replace(joint, armature=armatures.get(joint.name, 0.0)) for joint in joints)
    except UrdfError as error:  # kinematics needs none
        inertias, why = {}, str(error)
    return Urdf(robot.get("name") or "robot", links, joints, inertias, why)


def needs_xacro(robot: ET.Element) -> bool:
    """True if links or joints are still to come from xacro's commands, or from its expressions.

    Commands that are left over in a file that was expanded concern neither.
    """
    commands = [element for element in robot.iter() if element.tag.startswith("xacro:")]
    if any(part.tag in ("link", "joint") for command in commands for part in command.iter()):
        return True
    own = [element for element in robot if element.tag in ("link", "joint", f"{DRAKE}joint")]
    texts = [value for element in own for value in element.attrib.values()]
    texts += [
        value
        for element in own
        for tag in ("origin", "axis", "parent", "child", "limit", "mimic")
        for part in element.findall(tag)
        for value in part.attrib.values()
    ]
    if any("${" in text or "$(" in text for text in texts):
        return True
    tags = {command.tag.removeprefix("xacro:") for command in commands}
    calls = tags - {"include", "property", "arg", "macro", "if", "unless", "insert_block"}
    joints = [element for element in own if element.tag != "link"]
    return bool(tags) and (not joints or ("include" in tags and bool(calls)))


def _joint(element: ET.Element) -> TreeJoint:
    name = _attribute(element, "name", "joint")
    what = f"joint {name!r}"
    kind = _attribute(element, "type", what)
    if kind not in KINDS:
        raise UrdfError(f"{what}: expected a type among {', '.join(KINDS)}, got {kind!r}")
    axis = _numbers(element.find("axis"), "xyz", (1.0, 0.0, 0.0), f"{what}: axis")
    X_PF, X_MC = _origin(element.find("origin"), what), np.eye(4)
    if kind == "planar":  # x and y of the plane are those of the joint's frame turned so that z is the axis
        tilt = _tilt(axis, what)
        X_PF, X_MC = X_PF @ tilt, tilt.T
    pitch = element.find(f"{DRAKE}screw_thread_pitch")
    try:
        return TreeJoint(
            name,
            KINDS[kind],
            _attribute(_child(element, "parent", what), "link", f"{what}: parent"),
            _attribute(_child(element, "child", what), "link", f"{what}: child"),
            X_PF,
            X_MC,
            np.array(axis),
            0.0 if pitch is None else _numbers(pitch, "value", (0.0,), f"{what}: pitch")[0] / (2 * pi),
            _limits(element.find("limit"), kind, what),
            _mimic(element.find("mimic"), kind, what),
        )
    except ValueError as error:
        raise UrdfError(str(error)) from None


def _limits(element: ET.Element | None, kind: str, what: str) -> Limits:
    if element is None:
        return Limits()
    bounds = {name: _bound(element, name, f"{what}: limit") for name in Limits._fields}
    if kind == "continuous":
        bounds |= {"lower": np.nan, "upper": np.nan}
    return Limits(**bounds)


def _bound(element: ET.Element, name: str, what: str) -> float:
    """Returns a limit; NaN where there is none, or one that is infinite."""
    if (element.get(name) or "").strip().lstrip("+-").lower() in ("inf", "infinity", "nan", ".inf"):
        return np.nan
    return _numbers(element, name, (np.nan,), what)[0]


def _mimic(element: ET.Element | None, kind: str, what: str) -> Mimic | None:
    if element is None or kind == "fixed":  # a fixed joint has nothing that could follow
        return None
    return Mimic(
        _attribute(element, "joint", f"{what}: mimic"),
        _numbers(element, "multiplier", (1.0,), f"{what}: mimic")[0],
        _numbers(element, "offset", (0.0,), f"{what}: mimic")[0],
    )


def _inertias(robot: ET.Element) -> dict[str, Inertia]:
    """Returns the inertias as the file has them, whether a body can have them or not."""
    found = {}
    for link in robot.findall("link"):
        element, name = link.find("inertial"), link.get("name", "")
        if element is None or name == WORLD:
            continue
        what = f"link {name!r}: inertial"
        mass, matrix = _child(element, "mass", what), _child(element, "inertia", what)
        _attribute(mass, "value", f"{what}: mass")
        kilograms = _numbers(mass, "value", (0.0,), what)[0]
        if kilograms < 0:
            raise UrdfError(f"{what}: expected a mass >= 0 in kg, got {kilograms}")
        xx, xy, xz, yy, yz, zz = (
            _numbers(matrix, f"i{axes}", (0.0,), what)[0] for axes in ("xx", "xy", "xz", "yy", "yz", "zz")
        )
        X = _origin(element.find("origin"), what)
        R = X[:3, :3]
        about_com = R @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ R.T
        found[name] = Inertia(kilograms, X[:3, 3], about_com)
    return found


def _armatures(robot: ET.Element, joints: list[ET.Element]) -> dict[str, float]:
    """Returns (rotor inertia) · (gear ratio)² of the joints with an actuator for which Drake's elements tell
    it. As in Drake a joint whose limit of effort is 0 has no actuator."""
    idle = {
        joint.get("name")
        for joint in joints
        for limit in joint.findall("limit")
        if (limit.get("effort") or "").strip() and _bound(limit, "effort", "limit") == 0
    }
    found: dict[str, float] = {}
    for transmission in robot.findall("transmission"):
        for actuator in transmission.findall("actuator"):
            rotor = actuator.find(f"{DRAKE}rotor_inertia")
            if rotor is None:
                continue
            what = f"transmission {transmission.get('name', '')!r}"
            named = [_attribute(joint, "name", f"{what}: joint") for joint in transmission.findall("joint")]
            kind = transmission.get("type") or getattr(transmission.find("type"), "text", None) or ""
            if len(named) != 1 or "SimpleTransmission" not in kind:
                raise UrdfError(
                    f"{what} with a rotor: expected a SimpleTransmission of one joint, "
                    f"got {kind!r} of {len(named)}"
                )
            ratio = _numbers(actuator.find(f"{DRAKE}gear_ratio"), "value", (1.0,), f"{what}: gear_ratio")[0]
            inertia = _numbers(rotor, "value", (0.0,), f"{what}: rotor_inertia")[0] * ratio**2
            if inertia < 0 or not isclose(found.setdefault(named[0], inertia), inertia):
                raise UrdfError(f"{what}: expected one rotor of inertia >= 0 for joint {named[0]!r}")
    return {name: inertia for name, inertia in found.items() if name not in idle}


def _origin(element: ET.Element | None, what: str) -> np.ndarray:
    X = np.eye(4)
    X[:3, :3] = rotation_of_rpy(np.array(_numbers(element, "rpy", (0.0, 0.0, 0.0), f"{what}: origin")))
    X[:3, 3] = _numbers(element, "xyz", (0.0, 0.0, 0.0), f"{what}: origin")
    return X


def _tilt(axis: tuple[float, ...], what: str) -> np.ndarray:
    """Returns the least rotation, (4, 4), that takes z to the axis."""
    length = np.linalg.norm(axis)
    if length == 0:
        raise UrdfError(f"{what}: expected an axis of non-zero length, got {axis}")
    x, y, z = np.asarray(axis) / length
    X = np.eye(4)
    if z < -1 + 1e-12:
        X[:3, :3] = np.diag([1.0, -1.0, -1.0])
    else:
        a, b, c = x * x / (1 + z), y * y / (1 + z), x * y / (1 + z)
        X[:3, :3] = [[1 - a, -c, x], [-c, 1 - b, y], [-x, -y, z]]
    return X


def _numbers(
    element: ET.Element | None, name: str, default: tuple[float, ...], what: str
) -> tuple[float, ...]:
    text = None if element is None else element.get(name)
    if text is None:
        return default
    try:
        values = tuple(float(part) for part in text.split())
    except ValueError:
        values = ()
    if len(values) != len(default) or not np.isfinite(values).all():
        count = "a finite number" if len(default) == 1 else f"{len(default)} finite numbers"
        raise UrdfError(f"{what}: expected {count} for {name}, got {text!r}")
    return values


def _child(element: ET.Element, tag: str, what: str) -> ET.Element:
    found = element.find(tag)
    if found is None:
        raise UrdfError(f"{what}: expected a <{tag}>, got none")
    return found


def _attribute(element: ET.Element, name: str, what: str) -> str:
    value = element.get(name)
    if not value:
        raise UrdfError(f"{what}: expected an attribute {name!r}, got none")
    return value


def _require_tree(links: tuple[str, ...], joints: tuple[TreeJoint, ...]) -> None:
    inboard: dict[str, TreeJoint] = {}
    known, names = set(links), set()
    for joint in joints:
        for end in (joint.parent, joint.child):
            if end not in known:
                raise UrdfError(f"joint {joint.name!r}: no link {end!r} in the file")
        if joint.name in names:
            raise UrdfError(f"joint {joint.name!r} is there twice: expected one of each name")
        if joint.child == WORLD:
            raise UrdfError(
                f"joint {joint.name!r} moves the link {WORLD!r}: that name is the world's own, which does "
                "not move; expected another name"
            )
        if joint.child in inboard:
            other = inboard[joint.child].name
            raise UrdfError(
                f"link {joint.child!r}: joints {other!r} and {joint.name!r} lead to it, expected one"
            )
        names.add(joint.name)
        inboard[joint.child] = joint
    roots = [link for link in links if link not in inboard]
    if len(roots) > 1:
        raise UrdfError(
            f"expected one root link, got {len(roots)} links that no joint leads to: {', '.join(roots)}"
        )
    reached = set(roots)
    for link in links:
        path: dict[str, TreeJoint] = {}
        while link not in reached:
            if link in path:
                raise UrdfError(f"joints {', '.join(joint.name for joint in path.values())} form a circle")
            path[link] = inboard[link]
            link = inboard[link].parent
        reached.update(path)
