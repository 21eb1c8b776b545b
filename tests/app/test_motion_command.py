"""`workbench motion` as a user runs it."""

import json

import numpy as np
import pytest
from click.testing import CliRunner

from workbench.app.commands.commands import main

INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
JOINT = (
    '<joint name="{}" type="{}"><parent link="{}"/><child link="{}"/><origin xyz="0 0 0.5"/><axis xyz="{}"/>'
    '<limit effort="1" velocity="3" lower="-9" upper="9"/>{}</joint>'
)


@pytest.fixture
def arm(tmp_path):
    joints = (
        ("turn", "revolute", "base", "column", "0 0 1", ""),
        ("lift", "revolute", "column", "hand", "0 1 0", ""),
        ("grip", "prismatic", "hand", "finger", "1 0 0", '<mimic joint="lift" multiplier="0.1"/>'),
    )
    links = "".join(f'<link name="{name}">{INERTIAL}</link>' for name in ("base", "column", "hand", "finger"))
    path = tmp_path / "arm.urdf"
    path.write_text(f'<robot name="arm">{links}{"".join(JOINT.format(*joint) for joint in joints)}</robot>')
    return path


@pytest.fixture
def samples(tmp_path):
    s = np.linspace(0, 1, 101)
    rise = 10 * s**3 - 15 * s**4 + 6 * s**5
    path = tmp_path / "samples.csv"
    path.write_text(
        "t,turn,lift\n" + "".join(f"{2 * t},{x},{-x / 2}\n" for t, x in zip(s, rise, strict=True))
    )
    return path


def run(*arguments):
    return CliRunner().invoke(main, ["motion", *map(str, arguments)])


def test_a_trajectory_beside_limits_with_a_plot(arm, samples, tmp_path):
    limits, plot = tmp_path / "limits.toml", tmp_path / "plot.png"
    limits.write_text('["*"]\njerk = 8\n')
    options = (arm, "--body", "finger", "--trajectory", samples, "--limits", limits, "--plot", plot)
    result = run(*options, "--json")
    assert result.exit_code == 0, result.output
    data = json.loads(result.stdout)
    assert data["time"] == 1.0 and all(order["drake"]["agrees"] for order in data["orders"])
    peaks = {(peak["of"], peak["order"]): peak for peak in data["peaks"]}
    assert peaks["turn", 1]["value"] == pytest.approx(15 / 16, rel=1e-4)  # of the textbook, over 2 s
    assert peaks["turn", 3]["within"] and peaks["turn", 3]["unit"] == "rad/s^3"
    assert data["recording"]["noise"]["turn"] < 1e-6 and not data["recording"]["notes"]
    assert plot.stat().st_size > 10_000
    limits.write_text('["*"]\njerk = 7\n[point]\nacceleration = 100\n')
    result = run(*options)
    assert result.exit_code == 1 and "jerk of turn: 7.5" in result.stdout and "BEYOND" in result.stdout
    assert "violations of limits" in result.stdout
    violations = json.loads(run(*options, "--json").stdout)["violations"]
    assert {one["of"] for one in violations} == {"turn"} and violations[0]["start"] < 0.1


def test_units_stand_in_text_and_json(arm):
    text = run(arm, "--body", "hand", "--order", "3").stdout
    assert "rad/s^3" in text and "m/s^3" in text and "m\n" in text
    data = json.loads(run(arm, "--frame", "hand", "--order", "3", "--json").stdout)
    assert data["orders"][2]["units"]["point_acceleration"] == "m/s^3"


def test_relative_motion_and_a_floating_base(arm, tmp_path):
    limits = tmp_path / "limits.toml"
    limits.write_text("[point]\njerk = 1e-9\n")
    relative = json.loads(run(arm, "--frame", "hand", "--relative-to", "column", "--json").stdout)
    w = np.array([order["w_WB"] for order in relative["orders"]])
    np.testing.assert_allclose(w[:, [0, 2]], 0, atol=1e-14)
    np.testing.assert_allclose(
        w[:, 1], [np.cos(2) / 2, -np.sin(2) / 2, -np.cos(2) / 2, np.sin(2) / 2], atol=1e-12
    )
    still = run(arm, "--frame", "hand", "--relative-to", "hand", "--until", "1", "--limits", limits, "--json")
    peaks = [peak["value"] for peak in json.loads(still.stdout)["peaks"] if peak["of"] == "point"]
    np.testing.assert_allclose(peaks, 0, atol=1e-12)
    assert run(arm, "--frame", "finger", "--base", "floating", "--order", "3").exit_code == 0


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (("--joint", "turn=1", "--joint", "turn=2"), "joint turn: expected one polynomial, got two"),
        (("--joint", "grip=1"), "unknown joint 'grip': expected one of turn, lift"),
        (("--relative-to", "foot"), "no body 'foot'"),
        (("--plot", "x.png"), "expected --trajectory, or --until"),
        (("--trajectory", "no.csv"), "no.csv"),
    ],
)
def test_bad_options_get_one_message(arm, options, says):
    result = run(arm, "--body", "hand", *options)
    assert result.exit_code == 2 and says in result.stderr and "Traceback" not in result.stderr


def test_a_xacro_gets_a_hint(tmp_path):
    path = tmp_path / "arm.urdf.xacro"
    path.write_text('<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:include filename="x"/></robot>')
    result = run(path, "--body", "hand")
    assert result.exit_code == 2 and "run `xacro FILE" in result.stderr


def test_polynomials_have_peaks_until_a_time(arm, tmp_path):
    result = run(
        arm, "--body", "hand", "--joint", "turn=0,0,1", "--until", "2", "--plot", tmp_path / "p.png", "--json"
    )
    assert result.exit_code == 0, result.output
    peaks = {(peak["of"], peak["order"]): peak for peak in json.loads(result.stdout)["peaks"]}
    assert peaks["turn", 1]["value"] == pytest.approx(4) and peaks["turn", 1]["within"] is False
