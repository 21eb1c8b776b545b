"""The command `motion`: kinematics of a robot's body compared with Drake, and trajectories with limits."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from rich.text import Text

from workbench.app.commands.options import Unusable, json_flag, print_json, reports_faults

if TYPE_CHECKING:
    from workbench.kinematics.robot.motion import Motion
    from workbench.kinematics.robot.peaks import Peak, Violation
    from workbench.kinematics.robot.report import MotionReport
    from workbench.kinematics.robot.trajectories.paths import RecordedPath

#: The highest order at which Drake's doubles still have a correct digit.
HIGHEST_ORDER = 20


@click.command()
@click.argument("urdf", type=click.Path(path_type=Path))
@click.option("--body", "--frame", "body", required=True, metavar="B", help="The body B.")
@click.option("--relative-to", metavar="A", help="The body A in which B's motion is measured and expressed.")
@click.option(
    "--order",
    type=click.IntRange(1, HIGHEST_ORDER),
    default=4,
    show_default=True,
    help="1 velocity, 2 acceleration, 3 jerk, ...",
)
@click.option("--point", default="0,0,0", show_default=True, metavar="X,Y,Z", help="p_BoP_B in m.")
@click.option("--at", type=float, help="The time in s; 0, or the middle of the trajectory, if not given.")
@click.option(
    "--joint",
    "joints",
    multiple=True,
    metavar="NAME=C0,C1,...",
    help="The position of a joint as a polynomial: c0 + c1 t + ... (rad or m). Joints not named stay at 0; "
    "if none is named, all follow sines.",
)
@click.option(
    "--trajectory",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Samples of the joints, as CSV: columns t (s) and joints by name (rad or m, or as in NAME (deg)); "
    "their derivatives are estimated up to the snap, with errors.",
)
@click.option(
    "--until", type=float, help="Without a trajectory: the end in s of what --limits and --plot see."
)
@click.option(
    "--limits",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help='TOML: a table [JOINT], ["*"], [point] or [rotation] with velocity, acceleration, jerk, snap, '
    "deceleration, lower, upper.",
)
@click.option("--plot", type=click.Path(path_type=Path), metavar="FILE", help="Draw all orders (.png, .pdf).")
@click.option("--base", type=click.Choice(["fixed", "floating"]), default="fixed", show_default=True)
@json_flag
@reports_faults
def motion(
    urdf: Path,
    body: str,
    relative_to: str | None,
    order: int,
    point: str,
    at: float | None,
    joints: Sequence[str],
    trajectory: Path | None,
    until: float | None,
    limits: Path | None,
    plot: Path | None,
    base: str,
    as_json: bool,
) -> None:
    """Higher-order kinematics of a body of a real robot: acceleration tensors, invariant vectors, centres,
    beside Drake's own numbers; with --limits or --plot the peaks on a whole trajectory too. Exit status 1 if
    Drake disagrees or, with --limits, a limit is exceeded."""
    import numpy as np

    from workbench.app.commands.terminal import console
    from workbench.kinematics.robot.joint_limits import read_limits
    from workbench.kinematics.robot.report import motion_report

    try:
        polynomials = _joint_polynomials(joints)
        path: RecordedPath | None = None
        bounds = None if limits is None else read_limits(limits)
        if trajectory is not None:
            path = _recorded(trajectory, urdf, base)
            at = (path.start + path.end) / 2 if at is None else at
        at = 0.0 if at is None else at
        with np.errstate(all="ignore"):  # an overflow has an error message of its own
            report = motion_report(
                urdf,
                body,
                _numbers(point, "point", 3),
                order,
                at,
                polynomials,
                trajectory=path,
                relative_to=relative_to,
                base=base,
            )
        whole = _whole(report, until, wanted=limits is not None or plot is not None or path is not None)
        peaks = [] if whole is None else whole.peaks(body, report.point, bounds, relative_to)
        violations: list[Violation] = []
        if whole is not None and any(peak.within is False for peak in peaks):
            violations = whole.violations(body, report.point, bounds, relative_to)
        if plot is not None and whole is not None:
            _draw(whole, body, report, bounds, plot)
    except (ValueError, ImportError) as error:
        raise Unusable(str(error)) from None
    data = report.to_dict() | {
        "recording": None if path is None else _recording_dict(report, path),
        "peaks": [_peak_dict(peak) for peak in peaks],
        "violations": [_finite(asdict(violation)) for violation in violations],
    }
    if as_json:
        print_json(data)
    else:
        terminal = console(sys.stdout)
        for line in (*motion_lines(data), *_recording_lines(data), *_peak_lines(peaks, violations)):
            terminal.print(line)
    beyond = limits is not None and any(peak.within is False for peak in peaks)
    sys.exit(0 if report.agrees and not beyond else 1)


def _joint_polynomials(joints: Sequence[str]) -> dict[str, tuple[float, ...]] | None:
    polynomials: dict[str, tuple[float, ...]] = {}
    for text in joints:
        name, equals, coefficients = text.partition("=")
        name = name.strip()
        if not equals or not name:
            raise ValueError(f"joint: expected NAME=C0,C1,..., got {text!r}")
        if name in polynomials:
            raise ValueError(f"joint {name}: expected one polynomial, got two")
        polynomials[name] = _numbers(coefficients, f"joint {name}")
    return polynomials or None


def _numbers(text: str, what: str, count: int | None = None) -> tuple[float, ...]:
    try:
        numbers = tuple(float(part) for part in text.split(","))
    except ValueError:
        numbers = ()
    if not numbers or len(numbers) != (count or len(numbers)) or not all(map(math.isfinite, numbers)):
        wanted = f"{count} finite numbers" if count else "finite numbers"
        raise ValueError(f"{what}: expected {wanted} with commas between, got {text!r}")
    return numbers


def _recorded(trajectory: Path, urdf: Path, base: str) -> RecordedPath:
    from workbench.kinematics.robot import Robot
    from workbench.kinematics.robot.trajectories.paths import RecordedPath, read_samples

    robot = Robot.from_urdf(urdf, base, rotations="rpy")
    t, q = read_samples(trajectory, robot.positions, robot.units)
    try:
        path = robot.path((t, q))
    except ValueError as error:
        raise ValueError(f"{trajectory}: {error}") from None
    assert isinstance(path, RecordedPath)
    return path


def _whole(report: MotionReport, until: float | None, wanted: bool) -> Motion | None:
    """Returns the motion over the time interval of peaks and plots."""
    import numpy as np

    if not wanted:
        return None
    start, end = report.path.start, report.path.end
    if not math.isfinite(end):
        if until is None or not math.isfinite(until) or until <= report.at:
            raise ValueError(f"--limits and --plot: expected --trajectory, or --until after {report.at:g} s")
        start, end = report.at, until
    return report.robot.along(report.path, np.linspace(start, end, 301), report.motion.order)


def _draw(whole: Motion, body: str, report: MotionReport, bounds: Any, file: Path) -> None:
    """Saves the figure, which appears when it is complete."""
    from workbench.kinematics.robot.answers import draft_of

    figure = whole.plot(body, report.point, bounds, report.relative_to)
    with draft_of(file) as draft:
        figure.savefig(draft, dpi=130)


def _peak_dict(peak: Peak) -> dict[str, Any]:
    """Returns a peak as a dict. A number that is not finite becomes None; "unbounded" is True if the peak
    is infinite."""
    keys = (
        "of",
        "order",
        "value",
        "error",
        "at_least",
        "at_most",
        "time",
        "limit",
        "unit",
        "bound",
        "within",
    )
    found = {key: getattr(peak, key) for key in (*keys, "verdict", "reason", "span")}
    return _finite(found) | {"unbounded": peak.value == math.inf}


def _finite(numbers: Mapping[str, Any]) -> dict[str, Any]:
    """Returns the dict with None for numbers that are not finite."""
    return {k: None if isinstance(x, float) and not math.isfinite(x) else x for k, x in numbers.items()}


def _recording_dict(report: MotionReport, path: RecordedPath) -> dict[str, Any]:
    """Returns the errors of a recording.

    The keys are noise (deviation of each coordinate's samples), error (of the position and of each derivative
    at the time) and notes (what was changed in the samples).
    """
    error = path.error(report.at, report.motion.order)
    return {
        "noise": dict(zip(report.joints, path.noise.tolist(), strict=True)),
        "error": {
            name: [x if math.isfinite(x) else None for x in error[:, i].tolist()]
            for i, name in enumerate(report.joints)
        },
        "notes": list(path.notes),
    }


def motion_lines(report: Mapping[str, Any]) -> Iterator[Text]:
    """Yields the motion of a robot's body, order by order, with units."""
    relative = f" relative to {report['relative_to']}" if report["relative_to"] else ""
    yield Text(f"{report['body']}{relative} of {report['urdf']} at t = {report['time']:g} s", style="bold")
    yield _row("p_WP", report["p_WP"], "m")
    for order in report["orders"]:
        n, units = order["order"], order["units"]
        yield Text(f"order {n}", style="bold")
        derivative = "" if n == 1 else f", derivative {n - 1}"
        yield _row(f"w_WB{derivative}", order["w_WB"], units["w_WB"])
        yield _row(f"v_WBo{derivative}", order["v_WBo"], units["v_WBo"])
        for row, values in enumerate(order["Phi"]):
            yield _row(f"Φ_{n}" if row == 0 else "", values, units["Phi"] if row == 0 else "")
        yield _row(f"a_{n}", order["a"], units["a"])
        yield _row(f"det Φ_{n}", [order["det_Phi"]], units["det_Phi"])
        yield _row(f"d^{n} p_WP / dt^{n}", order["point_acceleration"], units["point_acceleration"])
        centre = order["centre"]
        yield _row("centre", centre["point"] or (), "m" if centre["point"] else "", centre["kind"] + " ")
        for direction in centre["directions"]:
            yield _row("along", direction, "")
        drake = order["drake"]
        agreement = "agrees with Drake" if drake["agrees"] else "DISAGREES with Drake"
        sizes = f"residual {_short(drake['residual'])}, error {_short(drake['error'])}"
        figures = f"{sizes}, by {drake['method']}"
        yield Text(f"{'':>22}  {agreement}: {figures}", style="green" if drake["agrees"] else "bold red")


def _row(name: str, values: Sequence[float | None], unit: str, before: str = "") -> Text:
    numbers = " ".join("not finite" if value is None else f"{value:12.6g}" for value in values)
    return Text(f"{name:>22}  {before}{numbers}{f'  {unit}' if unit else ''}")


def _short(value: float | None) -> str:
    return "not finite" if value is None else f"{value:.2g}"


def _recording_lines(data: Mapping[str, Any]) -> Iterator[Text]:
    if data["recording"] is None:
        return
    yield Text("samples: noise, then the error of each derivative at this time", style="bold")
    for name, noise in data["recording"]["noise"].items():
        errors = " ".join(f"{_short(value):>10}" for value in data["recording"]["error"][name])
        yield Text(f"{name:>22}  {noise:9.2g}  {errors}")
    for note in data["recording"]["notes"]:
        yield Text(f"{'':>22}  {note}", style="yellow")


def _peak_lines(peaks: Sequence[Peak], violations: Sequence[Violation]) -> Iterator[Text]:
    if peaks:
        yield Text("peaks", style="bold")
    for peak in peaks:
        style = {None: "", "within": "green", "BEYOND": "bold red", "not determined": "yellow"}[peak.verdict]
        yield Text(f"{'':>22}  {peak}", style=style)
    if violations:
        yield Text("violations of limits", style="bold")
    for violation in violations:
        yield Text(f"{'':>22}  {violation}", style="bold red")
