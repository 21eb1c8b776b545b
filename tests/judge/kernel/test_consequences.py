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


TRUE = [
    r"n \times (n \times a) = -a \text{ for } n \cdot a = 0",
    r"R n = n \Rightarrow R^T n = n",
    r"R n = -n \Rightarrow \operatorname{tr} R = -1",
    r"R^2 = \mathbf{I} \Rightarrow R = R^T",
    r"R Q = Q R \Rightarrow R^T Q = Q R^T",
    r"T W = W T \Rightarrow (T W)^2 = T^2 W^2",
    r"T^2 = 0 \Rightarrow \operatorname{tr} T = 0",
    r"T a = f a \text{ and } T^T b = g b \text{ and } f \neq g \Rightarrow a \cdot b = 0",
    r"\det T \neq 0 \text{ and } T a = 0 \Rightarrow a = 0",
    r"n \cdot m = 0 \Rightarrow \|n \times m\| = 1",
    r"a \cdot b = 0 \Rightarrow \|a \times b\| = \|a\| \|b\|",
    r"a \cdot b = 0 \Leftrightarrow \|a + b\| = \|a - b\|",
    r"\|a + b\| = \|a\| + \|b\| \Rightarrow a \times b = 0",
    r"a^2 = f^2 \Rightarrow \|a\| = \|f\|",
    r"\|a\| = f \Rightarrow a^2 = f^2",
    r"a \times b = 0 \Leftrightarrow (a \cdot b)^2 = a^2 b^2",
    r"n = m \Leftrightarrow n \cdot m = 1",
    r"R = Q \Leftrightarrow \operatorname{tr}(R Q^T) = 3",
    r"\sin f = 0 \Rightarrow \cos^2 f = 1",
    r"\tan f = \tan g \Rightarrow \sin(f - g) = 0",
    r"\frac{f}{g} = h \Rightarrow f = g h",
    r"f g = 1 \Rightarrow \frac{1}{f} = g",
]

FALSE = [
    r"n \times (n \times a) = a \text{ for } n \cdot a = 0",
    r"R n = n \Rightarrow R^T n = -n",
    r"R Q = Q R \Rightarrow R = Q",
    r"a^2 = f^2 \Rightarrow \|a\| = f",
    r"\|a\| = f \Rightarrow a^2 = f^3",
    r"a \times b = 0 \Leftrightarrow a \cdot b = \|a\| \|b\|",
    r"n = -m \Leftrightarrow n \cdot m = 1",
    r"\det T = 0 \text{ and } T a = 0 \Rightarrow a = 0",
    r"f a = 0 \Rightarrow a = 0",
    r"\cos f = 1 \Leftrightarrow \sin f = 0",
    r"\cos f = \cos g \Rightarrow \sin f = \sin g",
    r"f g = 1 \Rightarrow \frac{1}{f} = g^2",
]


@pytest.mark.parametrize("latex", TRUE)
def test_textbook_consequences_are_proved(latex):
    assert outcome(latex) == Outcome.PROVED


@pytest.mark.parametrize("latex", FALSE)
def test_false_consequences_are_refuted(latex):
    assert outcome(latex) == Outcome.REFUTED


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
