"""The plants of the reference motions, and Drake's own velocities and accelerations on them.

Conventions are Drake's. A spatial velocity V_WB = [w_WB; v_WBo] stacks the angular velocity above the
velocity of the body origin Bo; a spatial acceleration A_WB = [alpha_WB; a_WBo] stacks the angular
acceleration above the (classical) acceleration of Bo. Everything is expressed in W.
"""

from __future__ import annotations

import logging
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from workbench.drake.gate import (
    BodyIndex,
    Context,
    FixedOffsetFrame,
    MultibodyPlant,
    Parser,
    PrismaticJoint,
    RevoluteJoint,
    RigidBody,
    RigidTransform,
    RpyFloatingJoint,
    SpatialInertia,
)
from workbench.drake.mjcf import Mjcf, read_mjcf
from workbench.drake.urdf import kinematic_urdf

ROBOT_DATA = "example-robot-data"

DRAKE_ERRORS = (RuntimeError, ValueError, SystemExit)  # SystemExit: a condition that Drake demands fails
NO_ACTUATOR = "A <transmission> has a type that isn't"
REPLACING = ("While parsing inertia matrix", "While re-expressing as central inertia")

#: Coordinates, velocities or components: floats, or a plant's own scalars.
Numbers = Sequence[Any] | np.ndarray


class PlantError(ValueError):
    """A plant that cannot be built, or a body or state that does not fit it."""


@dataclass(frozen=True)
class CylindricalAxis:
    """A cylindrical joint: rotation θ about, and translation d along, the same line. Raises PlantError for
    bad numbers.

    ``direction``: shape (3,), along the line; ``point``: shape (3,), metres, on the line; both in the parent
    body's frame when θ = d = 0. There the two bodies' frames coincide, so that the relative pose is the screw
    displacement exp((θ + εd) ũ) of the chapter's Eqs. (137)-(138).
    """

    direction: tuple[float, float, float]
    point: tuple[float, float, float]

    def __post_init__(self):
        for name in ("direction", "point"):
            values = np.asarray(getattr(self, name))
            if values.shape != (3,) or not np.isfinite(values.astype(float)).all():
                raise PlantError(f"{name}: expected three finite numbers, got {getattr(self, name)}")
        if not np.any(np.asarray(self.direction)):
            raise PlantError("direction: expected non-zero length, got (0, 0, 0)")


def cylindrical_chain(axes: Sequence[CylindricalAxis], body_names: Sequence[str]) -> MultibodyPlant:
    """Returns a serial chain of bodies on cylindrical joints, the first one on the world.

    Each joint is a prismatic and a revolute joint on one axis with a slider between them. The positions are,
    body by body, (d, θ); the joints are called ``<body>_d`` and ``<body>_theta``.
    """
    if len(axes) != len(body_names):
        raise PlantError(f"{len(axes)} axes do not fit {len(body_names)} bodies")
    plant = MultibodyPlant(0.0)
    parent = plant.world_body()
    for axis, name in zip(axes, body_names, strict=True):
        slider = plant.AddRigidBody(f"{name}_slider", _any_inertia())
        body = plant.AddRigidBody(name, _any_inertia())
        X_on_axis = RigidTransform(np.array(axis.point, dtype=float))
        on_parent = plant.AddFrame(FixedOffsetFrame(f"{name}_axis_on_parent", parent.body_frame(), X_on_axis))
        on_body = plant.AddFrame(FixedOffsetFrame(f"{name}_axis_on_body", body.body_frame(), X_on_axis))
        direction = np.array(axis.direction, dtype=float)
        plant.AddJoint(PrismaticJoint(f"{name}_d", on_parent, slider.body_frame(), direction))
        plant.AddJoint(RevoluteJoint(f"{name}_theta", slider.body_frame(), on_body, direction))
        parent = body
    plant.Finalize()
    return plant


def free_body() -> MultibodyPlant:
    """Returns one free body B; positions are roll, pitch, yaw, x, y, z of Bo in W."""
    plant = MultibodyPlant(0.0)
    body = plant.AddRigidBody("B", _any_inertia())
    plant.AddJoint(RpyFloatingJoint("B", plant.world_frame(), body.body_frame()))
    plant.Finalize()
    return plant


def _any_inertia() -> SpatialInertia:
    """Returns a valid inertia, which a plant requires, although kinematics does not depend on it."""
    return SpatialInertia.SolidSphereWithMass(1.0, 0.1)


def load_urdf(path: str | Path, base: str = "fixed") -> MultibodyPlant:
    """Returns the plant of a URDF file; meshes are not read.

    base: "fixed" welds its root to the world; "floating" lets it move, by the positions base_x, base_y,
    base_z, base_qz, base_qy, base_qx (in m; yaw, pitch, roll). Floating joints of the file get such positions
    of their own. A joint that mimics another has a position of its own. Raises PlantError, in one line, if
    the file is missing or Drake cannot read it.

    >>> from importlib.resources import files
    >>> load_urdf(str(files("workbench.guide") / "examples/arm.urdf")).num_positions()
    2
    """
    path = Path(path)
    if not path.is_file():
        raise PlantError(f"no URDF file at {path}")
    plant = MultibodyPlant(0.0)
    try:
        Parser(plant).AddModelsFromString(kinematic_urdf(path, base), "urdf")
        _weld_bases(plant)
        plant.Finalize()
    except DRAKE_ERRORS as error:
        raise PlantError(f"Drake cannot read {path}: {_first_line(error)}") from error
    if plant.num_bodies() == 1:
        raise PlantError(f"{path} holds no body")
    return plant


class Models(NamedTuple):
    """The plant of the models of a file; unweighed: why the masses or inertias of its bodies are not those
    of the file, "" where they are; mjcf: what an MJCF file says beside."""

    plant: MultibodyPlant
    unweighed: str = ""
    mjcf: Mjcf | None = None


def load_models(
    path: str | Path, base: str = "fixed", packages: Mapping[str, str | Path] | None = None
) -> Models:
    """Returns the plant of all models of an SDF, MJCF, URDF or model-directives file, by Drake's parser.

    base: "fixed" welds the root of each model that has no parent to the world; "floating" lets it move.
    packages: folders of the packages that the file names in package:// paths. Of an MJCF file whose meshes
    Drake cannot read the geoms are left out. Raises PlantError, in one line, if the file is missing or Drake
    cannot read it.
    """
    path = Path(path)
    if not path.is_file():
        raise PlantError(f"no file at {path}")
    mjcf, doubt = _mjcf(path)
    text = None if mjcf is None or mjcf.root.get("model") else mjcf.named(path.stem)
    try:
        plant, said = _parsed_models(path, base, packages or {}, text)
    except DRAKE_ERRORS as error:
        if mjcf is None:
            raise PlantError(f"Drake cannot read {path}: {_first_line(error)}") from error
        try:
            plant, said = _parsed_models(path, base, packages or {}, mjcf.without_geoms())
        except DRAKE_ERRORS:
            raise PlantError(f"Drake cannot read {path}: {_first_line(error)}") from error
        said = [*said, (str(path), f"geoms are ignored: {_first_line(error)}")]
    if plant.num_bodies() == 1:
        raise PlantError(f"{path} holds no body")
    return Models(plant, doubt or _unweighed(said, mjcf), mjcf)


def _mjcf(path: Path) -> tuple[Mjcf | None, str]:
    """Returns what is in an MJCF file, None of another; and why armatures in it are not known."""
    try:
        if path.suffix == ".xml":
            return read_mjcf(path), ""
        if path.suffix == ".urdf" or b".xml" not in path.read_bytes():
            return None, ""
    except (OSError, ValueError) as error:
        return None, str(error)
    return None, f"{path}: armatures of an MJCF file in it are not read: load that file itself"


def _parsed_models(
    path: Path, base: str, packages: Mapping[str, str | Path], text: str | None = None
) -> tuple[MultibodyPlant, list[tuple[str, str]]]:
    """Returns the plant and the warnings; text: of an MJCF file, instead of what is in it."""
    plant = MultibodyPlant(0.0)
    parser = Parser(plant)
    for name, folder in packages.items():
        parser.package_map().Add(name, str(folder))
    with _warnings() as said:
        if text is None:
            parser.AddModels(str(path))
        else:
            parser.AddModelsFromString(text, "xml")
    if base == "fixed":
        _weld_bases(plant)
    plant.Finalize()
    return plant, said


def _unweighed(said: Sequence[tuple[str, str]], mjcf: Mjcf | None) -> str:
    """Returns why inertias are not those of the file, of what Drake's parser warned of."""
    for place, text in said:
        if text.startswith(REPLACING):
            return f"{place}: an inertia that no body can have, which Drake replaces"
        file = Path(place.rpartition(":")[0])
        if text.startswith(NO_ACTUATOR) and file.is_file() and b"rotor_inertia" in file.read_bytes():
            return f"{place}: a rotor on a transmission that Drake does not read"
        if mjcf is not None and mjcf.by_geoms is not None and "geom" in text and "ignored" in text:
            return f"{place}: the mass of body {mjcf.by_geoms!r} is that of its geoms, and Drake says: {text}"
    return ""


@contextmanager
def _warnings() -> Iterator[list[tuple[str, str]]]:
    """Collects the places and texts of what Drake's parser warns of, also where its logger is silenced."""
    said: list[tuple[str, str]] = []

    class Handler(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            place, _, text = record.getMessage().partition(": warning: ")
            said.append((place, text))

    handler, logger = Handler(), logging.getLogger("drake")
    level, propagate, disabled = logger.level, logger.propagate, logger.disabled
    if disabled or not logger.isEnabledFor(logging.WARNING):
        logger.propagate = logger.disabled = False
        logger.setLevel(logging.WARNING)
    logger.addHandler(handler)
    try:
        yield said
    finally:
        logger.removeHandler(handler)
        logger.propagate, logger.disabled = propagate, disabled
        logger.setLevel(level)


def _first_line(error: BaseException) -> str:
    return (str(error).strip().splitlines() or [type(error).__name__])[0]


def _weld_bases(plant: MultibodyPlant) -> None:
    children = {plant.get_joint(index).child_body().index() for index in plant.GetJointIndices()}
    for index in map(BodyIndex, range(1, plant.num_bodies())):
        if index not in children:
            plant.WeldFrames(plant.world_frame(), plant.get_body(index).body_frame())


def robot_data_directory() -> Path:
    """Returns the directory of the robots of the optional distribution ``example-robot-data``."""
    try:
        files = metadata.distribution(ROBOT_DATA).files or []
    except metadata.PackageNotFoundError as error:
        raise PlantError(
            f"the robots' URDF files are not installed: pip install {ROBOT_DATA} "
            "(the extra 'robots' of this package)"
        ) from error
    for file in files:
        if file.parts[-3:] == ("share", ROBOT_DATA, "package.xml"):
            return Path(file.locate()).resolve().parent
    raise PlantError(f"the installed {ROBOT_DATA} holds no share/{ROBOT_DATA}/package.xml")


def robot_urdf(name: str) -> Path:
    """Returns the URDF of a robot of ``example-robot-data`` by its file name, e.g. "panda", "ur5_robot"."""
    urdfs = {path.stem: path for path in sorted(robot_data_directory().rglob("*.urdf"))}
    if name not in urdfs:
        raise PlantError(f"no robot {name!r}; {ROBOT_DATA} has {', '.join(sorted(urdfs))}")
    return urdfs[name]


def body_named(plant: MultibodyPlant, name: str) -> RigidBody:
    """Returns the body of that name. Raises PlantError with the existing names."""
    if plant.NumBodiesWithName(name) == 1:
        return plant.GetBodyByName(name)
    names = [plant.get_body(BodyIndex(i)).name() for i in range(plant.num_bodies())]
    problem = "no body" if name not in names else "more than one body"
    raise PlantError(f"{problem} {name!r} in the plant; it has {', '.join(names)}")


@dataclass(frozen=True)
class BodyMotion:
    """A body B at one state, in Drake's doubles, expressed in W and taken at its point Bp.

    ``R_WB`` (3, 3); ``p_WBp`` (3,) m; ``V_WBp`` (6,) = [w_WB rad/s; v_WBp m/s]; ``A_WBp`` (6,) = [alpha_WB
    rad/s²; a_WBp m/s²].
    """

    R_WB: np.ndarray
    p_WBp: np.ndarray
    V_WBp: np.ndarray
    A_WBp: np.ndarray


def body_motion(
    plant: MultibodyPlant,
    body: str,
    q: Numbers,
    v: Numbers,
    vdot: Numbers,
    p_BoBp_B: Numbers = (0.0, 0.0, 0.0),
    context: Context | None = None,
) -> BodyMotion:
    """Returns pose, velocity and acceleration of a body's point Bp, computed by Drake.

    ``q`` (num_positions,), ``v`` and ``vdot`` (num_velocities,): position, velocity and acceleration of the
    joints. ``p_BoBp_B``: Bp from Bo in the body's frame, metres. ``context``: a context of this plant to work
    in, for many states. Works on the plant's own scalars: float, AutoDiffXd or Expression. Raises PlantError
    for an unknown body or a shape that does not fit the plant.
    """
    frame = body_named(plant, body).body_frame()
    context = context or plant.CreateDefaultContext()
    set_state(plant, context, q, v)
    rates = _of_length(vdot, plant.num_velocities(), "vdot")
    X_WB = frame.CalcPoseInWorld(context)
    p_BoBp_W = X_WB.rotation() @ _of_length(p_BoBp_B, 3, "p_BoBp_B")
    V_WBo = frame.CalcSpatialVelocityInWorld(context)
    A_WBo = plant.CalcSpatialAccelerationsFromVdot(context, rates)[int(frame.body().index())]
    return BodyMotion(
        R_WB=X_WB.rotation().matrix(),
        p_WBp=X_WB.translation() + p_BoBp_W,
        V_WBp=V_WBo.Shift(p_BoBp_W).get_coeffs(),
        A_WBp=A_WBo.Shift(p_BoBp_W, V_WBo.rotational()).get_coeffs(),
    )


def set_state(plant: MultibodyPlant, context: Context, q: Numbers, v: Numbers) -> None:
    """Sets joint positions and velocities in the context. Raises PlantError if the counts differ."""
    plant.SetPositions(context, _of_length(q, plant.num_positions(), "q"))
    plant.SetVelocities(context, _of_length(v, plant.num_velocities(), "v"))


def _of_length(values: Numbers, length: int, name: str) -> np.ndarray:
    array = np.asarray(values)
    if array.shape != (length,):
        raise PlantError(f"{name} needs shape ({length},), got {array.shape}")
    return array
