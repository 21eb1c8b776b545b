"""Drake's quaternions, spatial velocities and homogeneous poses as witnesses of what a paper's symbols are."""

import pytest
from motion_papers import judged, motions, paper

from workbench.papers.model import PaperError
from workbench.verify.claims import judge_paper

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


def test_claims_about_quaternions_and_twists_hold_on_the_motions_too(tmp_path):
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
