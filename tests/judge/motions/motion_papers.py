"""Papers about one body, with claims of one's own and what their symbols are on Drake's motions."""

from pathlib import Path
from textwrap import dedent

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.papers import load_paper
from workbench.prover.results.motion_summary import METHOD
from workbench.report.to_json import claim_json

HEAD = r"""
    title = "A body"
    [symbols]
    'R' = { kind = "rotation", weight = 0 }
    'p' = { kind = "vector", weight = 0 }
    'a' = { kind = "vector" }
    'x' = { kind = "vector" }
    [definitions]
    '\omega' = '\operatorname{vect}(\dot{R} R^T)'
    'v' = '\dot{p}'
"""
MOTION = r"""
    [motion]
    'R' = "R_WB"
    'p' = "p_WBo"
    '\omega' = "w_WB"
    'v' = "v_WBo"
"""


def paper(folder: Path, *claims: str, motion: str = MOTION, head: str = HEAD):
    file = folder / "paper.toml"
    text = [dedent(head), dedent(motion)]
    for number, claim in enumerate(claims):
        text.append(f'[[claim]]\nid = "{number}"\n{dedent(claim)}')
    file.write_text("\n".join(text), "utf-8")
    return load_paper(file)


def judged(*arguments, **options):
    loaded = paper(*arguments, **options)
    return [claim_json(result) for result in judge_paper(loaded)]


def motions(form):
    return [e for e in form["evidence"] if e["method"] == METHOD]
