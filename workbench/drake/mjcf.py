"""What Drake's parser does not tell of an MJCF file: armatures of joints without actuators, and which bodies
are weighed by their geoms. Meanings of elements, defaults and classes are those of MuJoCo's XML reference.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import dataclass
from pathlib import Path

from workbench.drake.plain_xml import parse_plain

DEEPEST = 32  # of files that include files


@dataclass(frozen=True)
class MjcfJoint:
    """A joint of an MJCF file: the body that it moves, its name ("" if none), its type, and its armature in
    kg m² or kg."""

    body: str
    name: str
    type: str
    armature: float


@dataclass(frozen=True)
class Mjcf:
    """joints: in the order of the file. by_geoms: a body whose mass is that of its geoms, None if there
    is none."""

    root: ET.Element
    joints: tuple[MjcfJoint, ...]
    by_geoms: str | None

    def named(self, model: str) -> str:
        """Returns the text of the file, files that it includes in their places, with a name of the model:
        Drake asks for one, MuJoCo does not."""
        self.root.set("model", model)
        return ET.tostring(self.root, encoding="unicode")

    def without_geoms(self) -> str:
        """Returns the text of the file, files that it includes in their places, without geoms and assets."""
        for parent in [*self.root.iter()]:
            for child in [*parent]:
                if child.tag in ("geom", "asset"):
                    parent.remove(child)
        return ET.tostring(self.root, encoding="unicode")


def read_mjcf(path: Path) -> Mjcf:
    """Returns the joints of an MJCF file. Raises ValueError for a file that cannot be read, and for a joint
    of an unknown class or with an armature that is no number."""
    root = _with_includes(path, path.parent, 0)
    armatures: dict[str, str] = {}
    for element in root.findall("default"):
        _read_defaults(element, "0", armatures)
    joints: list[MjcfJoint] = []
    by_geoms: list[str] = []
    compilers = {c.get("inertiafromgeom") for c in root.findall("compiler")}
    for world in root.findall("worldbody"):
        waiting = [(body, "main") for body in reversed(world.findall("body"))]
        while waiting:
            body, parent_class = waiting.pop()
            name, own_class = body.get("name", ""), body.get("childclass", parent_class)
            joints += [_joint(name, own_class, element, armatures) for element in body.findall("joint")]
            joints += [MjcfJoint(name, "", "free", 0.0) for _ in body.findall("freejoint")]
            if body.find("geom") is not None and (body.find("inertial") is None or "true" in compilers):
                by_geoms.append(name)
            waiting += [(child, own_class) for child in reversed(body.findall("body"))]
    return Mjcf(root, tuple(joints), by_geoms[0] if by_geoms else None)


def _with_includes(path: Path, folder: Path, depth: int) -> ET.Element:
    if depth > DEEPEST:
        raise ValueError(f"{path}: expected at most {DEEPEST} files that include one another")
    try:
        root = parse_plain(path.read_bytes())
    except (OSError, ValueError) as error:
        raise ValueError(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    for parent in [*root.iter()]:
        for include in parent.findall("include"):
            at = [*parent].index(include)
            parent[at : at + 1] = [*_with_includes(folder / include.get("file", ""), folder, depth + 1)]
    return root


def _read_defaults(element: ET.Element, inherited: str, found: dict[str, str]) -> None:
    for joint in element.findall("joint"):
        inherited = joint.get("armature", inherited)
    found[element.get("class", "main")] = inherited
    found.setdefault("main", inherited)
    for child in element.findall("default"):
        _read_defaults(child, inherited, found)


def _joint(body: str, body_class: str, element: ET.Element, armatures: dict[str, str]) -> MjcfJoint:
    name, own_class = element.get("name", ""), element.get("class", body_class)
    if own_class != "main" and own_class not in armatures:
        raise ValueError(f"joint {name!r} of the body {body!r}: no default class {own_class!r}")
    text = element.get("armature", armatures.get(own_class, "0"))
    try:
        armature = float(text)
    except ValueError:
        armature = -1.0
    if not 0 <= armature < float("inf"):
        raise ValueError(f"joint {name!r} of the body {body!r}: expected an armature >= 0, got {text!r}")
    return MjcfJoint(body, name, element.get("type", "hinge"), armature)
