"""The files of a report with every verdict, and of one whose texts would do harm if they were markup."""

import pytest
from sample_report import claim, report_of, sample

from workbench.report import render

NASTY = (
    "<script>alert(1)</script> & \"quotes' $x_1$ #1 100% a_b ~ ^ "
    "\\input{/etc/passwd} `code` *b* | [l](u) éçØł ω ⃛ ω̇ ₄ ℝ ą đ"
)


@pytest.fixture(scope="module")
def texts():
    return render.render(*sample())


@pytest.fixture(scope="module")
def nasty():
    claims = [
        claim(
            NASTY, NASTY, NASTY, "refuted", statement=NASTY, printed=NASTY, read_back=NASTY, scope=NASTY,
            hypothesis=NASTY, note=NASTY + r" $\input{x}$ $\end{document}$ $", inherits=[NASTY, NASTY + "2"],
            corrected={"latex": r"a\\&b", "verdict": "proved"},
            counterexample={"values": {NASTY: ["1", "not a number"]}, "lhs": [NASTY], "rhs": ["1/0"]},
            evidence=[{"method": NASTY, "outcome": NASTY, NASTY: NASTY, "list": [1, {"a": None}]}],
        )
    ]  # fmt: skip
    return render.render(*report_of(claims, NASTY, NASTY))
