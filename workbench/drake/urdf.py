"""URDF for Drake: links and joints only, and joints of one coordinate each.

Elements that do not concern kinematics are left out: meshes, inertias, friction, transmissions, and mimic
(Drake moves such a joint independently; the user of the plant moves it as the mimic states). A floating
joint, which Drake's parser drops, becomes three prismatic and three revolute ones, `<name>_x`, `_y`, `_z`,
then `_qz`, `_qy`, `_qx` (yaw, pitch, roll), so that velocities are the rates of positions.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterable
from pathlib import Path

from workbench.drake.plain_xml import parse_plain

DRAKE = "drake:"
KEPT = ("parent", "child", "origin", "axis", "limit", f"{DRAKE}screw_thread_pitch")
INERTIA = '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
INERTIAL = f'<inertial><mass value="1"/>{INERTIA}</inertial>'
STEPS = (
    ("x", "prismatic", "1 0 0"),
    ("y", "prismatic", "0 1 0"),
    ("z", "prismatic", "0 0 1"),
    ("qz", "continuous", "0 0 1"),
    ("qy", "continuous", "0 1 0"),
    ("qx", "continuous", "1 0 0"),
)


def kinematic_urdf(path: Path, base: str = "fixed") -> str:
    """Returns the text for Drake's parser, with a floating joint for a floating base. Raises ValueError if it
    is no XML."""
    robot = parse_plain(path.read_bytes())
    kept = ET.Element(robot.tag, {"name": robot.get("name") or "robot"})
    if kept.tag == "robot":
        kept.set("xmlns:drake", "http://drake.mit.edu")
    for element in robot:
        if element.tag == "link":
            kept.append(_link(element.get("name")))
        elif element.tag in ("joint", f"{DRAKE}joint"):
            kept.extend(_joints(element))
    if base == "floating":
        children = {end.get("link") for end in kept.iter("child")}
        for name in [link.get("name") for link in kept.iter("link")]:
            if name is not None and name not in children and name != "world":
                own = base_joint_name(
                    element.get("name", "") for element in robot if element.tag in ("joint", f"{DRAKE}joint")
                )
                floating = ET.Element("joint", {"name": own, "type": "floating"})
                ET.SubElement(floating, "parent", {"link": "world"})
                ET.SubElement(floating, "child", {"link": name})
                kept.extend(_joints(floating))
    elif base != "fixed":
        raise ValueError(f"base: expected fixed or floating, got {base!r}")
    return ET.tostring(kept, encoding="unicode")


def base_joint_name(names: Iterable[str]) -> str:
    """Returns the name of the joint that moves a robot's root: "base", or "floating_base" if the file has a
    joint of that name, with as many "_" appended as necessary."""
    taken, name = set(names), "base"
    while name in taken:
        name = "floating_base" if name == "base" else f"{name}_"
    return name


def _link(name: str | None) -> ET.Element:
    link = ET.Element("link", {} if name is None else {"name": name})
    if name != "world":
        link.append(ET.fromstring(INERTIAL))
    return link


def _joints(joint: ET.Element) -> list[ET.Element]:
    for part in list(joint):
        if part.tag not in KEPT:
            joint.remove(part)
    kind, parent, child = joint.get("type"), joint.find("parent"), joint.find("child")
    if kind not in ("floating", "ball") or parent is None or child is None:
        return [joint]
    steps = STEPS if kind == "floating" else STEPS[3:]
    name, found, at = joint.get("name"), [], parent.get("link", "")
    for number, (suffix, step_kind, axis) in enumerate(steps, start=1):
        step = ET.Element("joint", {"name": f"{name}_{suffix}", "type": step_kind})
        there = child.get("link", "") if number == len(steps) else f"{name}_{suffix}_link"
        ET.SubElement(step, "parent", {"link": at})
        ET.SubElement(step, "child", {"link": there})
        ET.SubElement(step, "axis", {"xyz": axis})
        ET.SubElement(step, "limit", {"effort": "1", "velocity": "1", "lower": "-1e9", "upper": "1e9"})
        if number == 1 and (origin := joint.find("origin")) is not None:
            step.append(origin)
        if number < len(steps):
            found.append(_link(there))
        found.append(step)
        at = there
    return found
