"""Drake's quaternions, spatial velocities and homogeneous poses as witnesses of what a paper's symbols are."""

import pytest
from motion_papers import judged, motions, paper

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.paper_errors import PaperError

HEAD = r"""
    title = "A body"
    [conventions]
    quaternion = "hamilton, scalar first"
    [symbols]
    'q' = { kind = "quaternion", unit = true }
    'H' = { kind = "transform" }
    'x' = { kind = "vector" }
    [definitions]
    'R' = '\begin{bmatrix} \operatorname{Vec}(q \operatorname{quat}(0, \begin{bmatrix}1\\0\\0\end{bmatrix}) q^*) & \operatorname{Vec}(q \operatorname{quat}(0, \begin{bmatrix}0\\1\\0\end{bmatrix}) q^*) & \operatorname{Vec}(q \operatorname{quat}(0, \begin{bmatrix}0\\0\\1\end{bmatrix}) q^*) \end{bmatrix}'
    '\omega' = '2 \operatorname{Vec}(\dot{q} q^*)'
    '\Omega' = '2 \operatorname{Vec}(q^* \dot{q})'
    'p' = '\begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & 0 \end{bmatrix} H \begin{bmatrix} 0 \\ 0 \\ 0 \\ 1 \end{bmatrix}'
    'V' = '\begin{bmatrix} \omega \\ \dot{p} \end{bmatrix}'
    'A' = '\begin{bmatrix} \dot{\omega} \\ \ddot{p} \end{bmatrix}'
    'B' = '\begin{bmatrix} \Omega \\ R^T \dot{p} \end{bmatrix}'
"""  # fmt: skip
MOTION = r"""
    [motion]
    'q' = "q_WB"
    'R' = "R_WB"
    'H' = "X_WB"
    '\omega' = "w_WB"
    '\Omega' = "w_WB_B"
    'V' = "V_WB"
    'A' = "A_WB"
    'B' = "V_WB_B"
    'x' = "p_BoP_B"
"""
CLAIMS = (
    r"printed = '\dot{q} = \frac{1}{2} \omega q'",
    r"printed = '\dot{q} = \frac{1}{2} q \Omega'",
    r"printed = 'R x = \operatorname{Vec}(q x q^*)'",
    r"printed = 'V = \begin{bmatrix} R & \mathbf{0} \\ \mathbf{0} & R \end{bmatrix} B'",
)


def test_claims_on_quaternions_and_twists_hold_on_motions(tmp_path):
    for claim in judged(tmp_path, *CLAIMS, head=HEAD, motion=MOTION):
        assert claim["verdict"] == "proved", claim
        assert len(motions(claim)) == 1 and claim["motion"]["witness"] == "Drake"


@pytest.mark.parametrize(
    ("binding", "wrong"),
    [
        (r"'\omega' = ", "w_WB_B"),  # the other frame
        (r"'\Omega' = ", "w_WB"),
        ("'q' = ", "q_WA"),
        ("'V' = ", "V_WB_B"),
        ("'B' = ", "V_WB"),
        ("'H' = ", "X_WA"),
    ],
)
def test_a_swapped_frame_is_refused(tmp_path, binding, wrong):
    lines = [line for line in MOTION.splitlines() if not line.strip().startswith(binding)]
    motion = "\n".join([*lines, f'    {binding}"{wrong}"'])
    with pytest.raises(PaperError, match="is off by"):
        judge_paper(paper(tmp_path, CLAIMS[0], head=HEAD, motion=motion))


@pytest.mark.parametrize(
    ("right", "planted"),
    [
        (r"2 \operatorname{Vec}(\dot{q} q^*)", r"-2 \operatorname{Vec}(\dot{q} q^*)"),
        (r"2 \operatorname{Vec}(\dot{q} q^*)", r"\operatorname{Vec}(\dot{q} q^*)"),
        (r"R^T \dot{p}", r"R \dot{p}"),
        (r"\dot{\omega} \\ \ddot{p}", r"\dot{\omega} \\ -\ddot{p}"),
    ],
)
def test_a_planted_error_is_refused(tmp_path, right, planted):
    assert right in HEAD
    with pytest.raises(PaperError, match="is off by"):
        judge_paper(paper(tmp_path, CLAIMS[0], head=HEAD.replace(right, planted), motion=MOTION))


ANGLES = r"""
    title = "Roll, pitch and yaw"
    [symbols]
    '\phi' = "scalar"
    '\theta' = "scalar"
    '\psi' = "scalar"
    [definitions]
    'X' = '\begin{bmatrix} 1 & 0 & 0 \\ 0 & \cos\phi & -\sin\phi \\ 0 & \sin\phi & \cos\phi \end{bmatrix}'
    'Y' = '\begin{bmatrix} \cos\theta & 0 & \sin\theta \\ 0 & 1 & 0 \\ -\sin\theta & 0 & \cos\theta \end{bmatrix}'
    'Z' = '\begin{bmatrix} \cos\psi & -\sin\psi & 0 \\ \sin\psi & \cos\psi & 0 \\ 0 & 0 & 1 \end{bmatrix}'
    'R' = 'Z Y X'
    'P' = 'Z Y X'
    'N' = '\begin{bmatrix} \cos\theta \cos\psi & -\sin\psi & 0 \\ \cos\theta \sin\psi & \cos\psi & 0 \\ -\sin\theta & 0 & 1 \end{bmatrix}'
    'e' = '\begin{bmatrix} \dot{\phi} \\ \dot{\theta} \\ \dot{\psi} \end{bmatrix}'
    '\omega' = 'N e'
"""  # fmt: skip
ON_ANGLES = r"""
    [motion]
    '\phi' = "roll_WB"
    '\theta' = "pitch_WB"
    '\psi' = "yaw_WB"
    'R' = "R_WB"
    'P' = "R_rpy"
    'e' = "rpyDt_WB"
    '\omega' = "w_WB"
"""


def test_roll_pitch_and_yaw_are_those_of_drake(tmp_path):
    claims = (
        r"printed = '\dot{R} R^T = \tilde{\omega}'",
        r"printed = '\omega = \begin{bmatrix} 0 \\ 0 \\ \dot{\psi} \end{bmatrix} + Z \begin{bmatrix} 0 \\ \dot{\theta} \\ 0 \end{bmatrix} + Z Y \begin{bmatrix} \dot{\phi} \\ 0 \\ 0 \end{bmatrix}'",
    )
    for claim in judged(tmp_path, *claims, head=ANGLES, motion=ON_ANGLES):
        assert (claim["verdict"], claim["motion"]["witness"]) == ("proved", "Drake"), claim


@pytest.mark.parametrize(
    ("right", "planted"),
    [
        ("'R' = 'Z Y X'", "'R' = 'X Y Z'"),
        ("'P' = 'Z Y X'", "'P' = 'X Y Z'"),
        (r"\cos\psi & -\sin\psi & 0 \\ \sin\psi", r"\cos\psi & \sin\psi & 0 \\ -\sin\psi"),
        (r"-\sin\theta & 0 & 1 \end{bmatrix}'", r"\sin\theta & 0 & 1 \end{bmatrix}'"),
        (r"\dot{\phi} \\ \dot{\theta} \\ \dot{\psi}", r"\dot{\psi} \\ \dot{\theta} \\ \dot{\phi}"),
    ],
)
def test_another_convention_of_the_angles_is_refused(tmp_path, right, planted):
    assert right in ANGLES
    with pytest.raises(PaperError, match="is off by"):
        judge_paper(
            paper(
                tmp_path,
                "printed = 'R^T R = \\mathbf{I}'",
                head=ANGLES.replace(right, planted),
                motion=ON_ANGLES,
            )
        )


JACOBIAN = r"""
    title = "A Jacobian"
    [symbols]
    'J' = { kind = "matrix 6×6" }
    'q' = { kind = "matrix 6×1" }
    [definitions]
    'V' = 'J q'
    'A' = 'J \dot{q} + \dot{J} q'
"""
ON_JACOBIAN = r"""
    [motion]
    'J' = "J_WB"
    'q' = "qDot"
    'V' = "V_WB"
    'A' = "A_WB"
"""


def test_the_jacobian_of_a_spatial_velocity_is_that_of_drake(tmp_path):
    (claim,) = judged(tmp_path, r"printed = 'A = \dot{V}'", head=JACOBIAN, motion=ON_JACOBIAN)
    assert (claim["verdict"], claim["motion"]["witness"]) == ("proved", "Drake")


@pytest.mark.parametrize(
    ("right", "planted"), [("'J q'", "'J^T q'"), (r"+ \dot{J} q'", "'"), (r"+ \dot{J} q'", r"- \dot{J} q'")]
)
def test_a_wrong_jacobian_is_refused(tmp_path, right, planted):
    head = JACOBIAN.replace(right, planted)
    assert head != JACOBIAN
    with pytest.raises(PaperError, match="is off by"):
        judge_paper(paper(tmp_path, r"printed = 'V = J q'", head=head, motion=ON_JACOBIAN))


TURN = r"""
    title = "Jacobians of rotations"
    [symbols]
    '\phi' = "vector"
    [definitions]
    'K' = '\tilde{\phi}'
    'J_l' = '\mathbf{I} + \frac{1 - \cos\|\phi\|}{\|\phi\|^2} K + \frac{\|\phi\| - \sin\|\phi\|}{\|\phi\|^3} K^2'
    'J_r' = '\mathbf{I} - \frac{1 - \cos\|\phi\|}{\|\phi\|^2} K + \frac{\|\phi\| - \sin\|\phi\|}{\|\phi\|^3} K^2'
    'R' = '\exp(K)'
    '\omega' = 'J_l \dot{\phi}'
    '\Omega' = 'J_r \dot{\phi}'
"""
ON_TURN = r"""
    [motion]
    '\phi' = "rotvec_WB"
    'R' = "R_WB"
    '\omega' = "w_WB"
    '\Omega' = "w_WB_B"
"""


def test_the_jacobians_of_a_rotation_vector_are_those_of_drake(tmp_path):
    claims = (
        r"printed = 'R^T J_l = J_r'",
        r"printed = 'J_l^T = J_r'",
        r"printed = '\dot{R} = \tilde{\omega} R'",
        r"printed = '\dot{R} = R \tilde{\Omega}'",
    )
    for claim in judged(tmp_path, *claims, head=TURN, motion=ON_TURN):
        assert claim["verdict"] in ("proved", "conditional"), claim
        assert claim["motion"]["witness"] == "Drake" and motions(claim)


@pytest.mark.parametrize(
    ("right", "planted"),
    [
        ("'J_l \\dot{\\phi}'", "'J_r \\dot{\\phi}'"),
        ("'J_r \\dot{\\phi}'", "'J_l \\dot{\\phi}'"),
        ("'\\exp(K)'", "'\\exp(-K)'"),
        (r"- \frac{1 - \cos", r"- \frac{1 + \cos"),
        (r"\|\phi\| - \sin", r"\|\phi\| + \sin"),
    ],
)
def test_a_wrong_jacobian_of_a_rotation_is_refused(tmp_path, right, planted):
    assert right in TURN
    with pytest.raises(PaperError, match="is off by"):
        judge_paper(
            paper(tmp_path, r"printed = 'J_l^T = J_r'", head=TURN.replace(right, planted), motion=ON_TURN)
        )
