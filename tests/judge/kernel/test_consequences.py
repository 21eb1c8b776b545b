"""What follows from equations: by both engines, in the ideal of the equations, or of a power of what follows."""

from random import Random

import pytest
from judge.test_judge import judged

from workbench import check
from workbench.core.verdict import Outcome
from workbench.engines.jet import consequences
from workbench.prover.decide.zero_sets import Equations

SYMBOLS = (
    dict.fromkeys("abc", "vector")
    | dict.fromkeys("fghk", "scalar")
    | {"T": "tensor", "W": "tensor", "R": "rotation", "Q": "rotation"}
    | {key: {"kind": "vector", "unit": True} for key in "nm"}
)


def outcome(latex):
    return check(latex, symbols=SYMBOLS).outcome


def polynomial(random, degree):
    """A polynomial in f, g, h with small coefficients."""
    addends = [
        f"{random.randint(1, 5)}" + "".join(random.choices("fgh", k=random.randint(1, degree)))
        for _ in range(3)
    ]
    return random.choice([" + ", " - "]).join(addends)


@pytest.mark.parametrize("seed", range(8))
def test_members_of_the_ideal_follow(seed):
    random = Random(seed)
    p, q = (polynomial(random, 2) for _ in range(2))
    x, y = (polynomial(random, 1) for _ in range(2))
    combined = f"({x})({p}) + ({y})({q})"
    assert outcome(rf"{p} = 0 \text{{ and }} {q} = 0 \Rightarrow {combined} = 0") == Outcome.PROVED
    assert outcome(rf"{p} = 0 \text{{ and }} {q} = 0 \Rightarrow {combined} = 1") == Outcome.REFUTED
    assert outcome(rf"{p} = k \text{{ and }} {q} = k^2 \Rightarrow ({p})^2 = {q}") == Outcome.PROVED


@pytest.mark.parametrize(
    "latex",
    [
        r"a = 0 \Rightarrow \exp(\tilde{a}) = 2 \mathbf{I}",
        r"\|a\| = 0 \Rightarrow \exp(\tilde{a}) = 2 \mathbf{I}",
        r"a \cdot a = 0 \Rightarrow \exp(\tilde{a}) b = 2 b",
        r"a = f b \text{ and } f = 0 \Rightarrow \exp(\tilde{a}) = 2 \mathbf{I}",
    ],
)
def test_a_limit_is_not_seen_from_beside_where_an_equation_holds(latex):
    """sin ‖a‖ / ‖a‖ times ‖a‖ is 0 at a = 0, and so is anything else."""
    checked = check(latex, symbols=SYMBOLS)
    assert checked.outcome == Outcome.REFUTED or "is a limit here" in checked.verdict.reason
    assert checked.verdict.evidence


def test_a_consequence_of_one_engine_only_is_unchecked(monkeypatch):
    monkeypatch.setattr(consequences, "recheck", lambda *_: False)
    verdict = judged(r"f a = f b \Rightarrow f (a \cdot c) = f (b \cdot c)")
    assert verdict.outcome == Outcome.UNCHECKED and "the second engine does not see" in verdict.reason
    assert verdict.evidence


#: What is linear in h or in k, by a coefficient that something keeps from 0, and by one that nothing does.
LED = [
    (r"f h = g", "f^2 h^2 = g^2", r"f \neq 0", "h = {} g"),
    (r"f h = f g", "h = g", r"f \neq 0", "h = {} g f"),
    (r"f g h = f k", "g h = k", r"f \neq 0", "g h = {} k f"),
    (r"\frac{h}{f} = \frac{g}{f}", "h^3 = g^3", None, "h = {} g^2"),
    (r"f^2 g h = f g k \text{ and } g k = f^2 g", "h = f", r"f g \neq 0", "h = {} k"),
    (r"(f + g) h = f + g \text{ and } (f + g) k = g h + f", "k^2 = h", r"f + g \neq 0", "k = {} f"),
]


@pytest.mark.parametrize(("premise", "follows", "apart", "does_not"), LED)
def test_an_equation_is_solved_by_what_is_not_0(premise, follows, apart, does_not):
    known = premise if apart is None else rf"{premise} \text{{ and }} {apart}"
    assert outcome(rf"{known} \Rightarrow {follows}") == Outcome.PROVED
    assert outcome(rf"{known} \Rightarrow {does_not.format('')}") == Outcome.REFUTED
    if apart is not None and follows not in ("f^2 h^2 = g^2",):
        assert outcome(rf"{premise} \Rightarrow {follows}") == Outcome.REFUTED


@pytest.mark.parametrize(("premise", "follows", "apart", "does_not"), LED)
def test_the_jet_engine_divides_by_nothing_that_may_be_0(monkeypatch, premise, follows, apart, does_not):
    """What the first engine takes for true is not proved if the second does not see it."""
    monkeypatch.setattr(Equations, "imply", lambda self, residuals: True)
    without = [rf"{premise} \Rightarrow {follows}"] if apart and "^2 h" not in follows else []
    for latex in (*without, rf"{premise} \Rightarrow {does_not.format('-')}"):
        assert outcome(latex) not in (Outcome.PROVED, Outcome.CONDITIONAL)
