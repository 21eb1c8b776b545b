"""Dear relations in the rotated frame: the rules by which they are rewritten are proved by both engines, what is
rewritten has the same values at points, and what is false or undefined stays so."""

import re

import pytest
from evaluator.identities import TABLE as BOTH
from judge.test_judge import TABLE, defined, judged

from workbench.core.verdict import Outcome
from workbench.engines.inventory.inventory import take_inventory
from workbench.language.definitions import Definitions
from workbench.language.reader import read
from workbench.prover.counterexamples.rational_points import trials
from workbench.prover.decide import frame_change
from workbench.prover.decide.frame_change import in_rotated_frame

#: The rules, for letters; each is below the degree from which they are used.
RULES = [
    r"R R^T = \mathbf{I}",
    r"R^T R = \mathbf{I}",
    r"R^{-1} = R^T",
    r"R^* = R^T",
    r"\det R = 1",
    r"\det R^T = 1",
    r"(T S)^T = S^T T^T",
    r"(T S)^* = S^* T^*",
    r"\det (T S) = \det T \det S",
    r"\operatorname{trace} (R T R^T) = \operatorname{trace} T",
    r"\operatorname{vect} (R T R^T) = R \operatorname{vect} T",
    r"\widetilde{R a} = R \tilde{a} R^T",
    r"R a \cdot R b = a \cdot b",
    r"R a \times R b = R (a \times b)",
    r"R a \otimes R b = R (a \otimes b) R^T",
    r"(R a, R b, R c) = (a, b, c)",
    r"\operatorname{sym} (R T R^T) = R (\operatorname{sym} T) R^T",
    r"\operatorname{skew} (R T R^T) = R (\operatorname{skew} T) R^T",
]


def dual(latex):
    return re.sub(r"(?<![a-zA-Z\\])([Rab])(?![a-zA-Z])", r"\\underline{\1}", latex)


@pytest.fixture
def always(monkeypatch):
    monkeypatch.setattr(frame_change, "DEAR", 0)


@pytest.fixture
def rules_off(monkeypatch):
    monkeypatch.setattr(frame_change, "DEAR", 10**9)


@pytest.mark.parametrize(
    "rule", [*RULES, *(dual(rule) for rule in RULES if "R" in rule and "c)" not in rule)]
)
def test_each_rule_is_proved_without_it(rules_off, rule):
    verdict = judged(rule)
    assert verdict.outcome == Outcome.PROVED, verdict
    assert not any(e.method == "rotated frame" for e in verdict.evidence)


REWRITTEN = [
    r"(R T R^T)^3 = R T^3 R^T",
    r"(R T R^T)^2 R a = R T^2 a",
    r"\det (R T R^T S) = \det T \det S",
    r"(R T S R^T)^* = R S^* T^* R^T",
    r"\operatorname{trace} (R T S T R^T) = \operatorname{trace} (T S T)",
    r"\operatorname{vect} (R T^3 R^T) = R \operatorname{vect} T^3",
    r"R (f T) R^T R \tilde{a} R^T = f R T \tilde{a} R^T",
    r"\widetilde{R T S b} = R \widetilde{T S b} R^T",
    r"R T a \times R S b = R (T a \times S b)",
    r"(R T a) \cdot (R S b) = (T a) \cdot (S b)",
    r"R T a \otimes R S b = R (T a \otimes S b) R^T",
    r"(R T R^T)^T R S = R T^T S",
    r"\operatorname{sym} (R T^2 S R^T) = R (\operatorname{sym}(T^2 S)) R^T",
    r"-(R T R^T)^3 R = R (-T^3)",
    r"\det(\underline{R} T \underline{R}^T) = \det T",
]


def both(latex):
    (statement,) = read(latex, TABLE)
    return statement, in_rotated_frame(statement, Definitions())


@pytest.mark.parametrize("latex", REWRITTEN)
def test_an_expensive_relation_is_proved_by_a_cheaper_one(always, latex):
    verdict = judged(latex)
    assert verdict.outcome == Outcome.PROVED, verdict
    assert [e.method for e in verdict.evidence].count("rotated frame") == 1
    assert any("Python integers" in e.method for e in verdict.evidence)


@pytest.mark.parametrize("latex", [*REWRITTEN, r"(R T R^T)^{-1} R = R T^{-1}", r"(T^{-1} S)^{-1} = S T^{-1}"])
def test_a_rewritten_relation_differs_by_a_rotation_only(always, latex):
    """At each point the two sides differ by as much, and are undefined together."""
    for false in (latex, latex.replace("=", "+ 0 =").replace("S", "T")):
        statement, cheaper = both(false)
        if cheaper is None:
            continue
        inventory = take_inventory([statement.left, statement.right], Definitions())
        for _, trial in zip(range(15), trials(inventory, Definitions(), lambda point: point), strict=False):
            there, here = trial.differences(statement), trial.differences(cheaper)
            assert (there is None) == (here is None)
            if here is not None:
                assert any(there) == any(here)


@pytest.mark.parametrize(
    "latex",
    [
        r"(R T R^T)^3 = R T^2 R^T",
        r"(R T R^T)^3 = R^T T^3 R",
        r"(R T S R^T)^* = R T^* S^* R^T",
        r"\det (R T R^T S) = \det T + \det S",
        r"\widetilde{R T S b} = R^T \widetilde{T S b} R",
        r"R T a \times R S b = R (T b \times S a)",
        r"(R T R) (R T R^T) = R T T R^T",
    ],
)
def test_a_false_relation_is_refuted(always, latex):
    assert judged(latex).outcome == Outcome.REFUTED


def test_a_possibly_undefined_inverse_is_conditional():
    inverse = r"(\underline{R} T \underline{R}^T)^{-1} = \underline{R} T^{-1} \underline{R}^T"
    verdict = judged(inverse)
    assert verdict.outcome == Outcome.CONDITIONAL
    assert any("R" in name for name in verdict.counterexample.values)  # it is a point of the printed relation
    assert judged(inverse, [r"\det T \neq 0"]).outcome == Outcome.PROVED


def test_no_factor_but_a_rotation_is_cancelled(always):
    assert judged(r"R T T^{-1} R^T T^3 = T^3").outcome == Outcome.CONDITIONAL
    assert judged(r"(T S T^{-1})^3 = T S^3 T^{-1}").outcome == Outcome.CONDITIONAL


BLOCKS = [
    r"\begin{bmatrix} R & 0 \\ \tilde{a} R & R \end{bmatrix}^{-1} = \begin{bmatrix} R^T & 0 \\ -R^T \tilde{a} & R^T \end{bmatrix}",
    r"\begin{bmatrix} R & \tilde{a} R \\ 0 & R \end{bmatrix}^{-1} = \begin{bmatrix} R^T & -R^T \tilde{a} \\ 0 & R^T \end{bmatrix}",
    r"\begin{bmatrix} R & a \\ 0 & 1 \end{bmatrix}^{-1} = \begin{bmatrix} R^T & -R^T a \\ 0 & 1 \end{bmatrix}",
    r"\begin{bmatrix} 1 & 0 \\ a & R \end{bmatrix}^{-1} = \begin{bmatrix} 1 & 0 \\ -R^T a & R^T \end{bmatrix}",
]


@pytest.mark.parametrize("latex", BLOCKS)
def test_the_inverse_of_a_block_triangular_matrix(latex):
    assert judged(latex).outcome == Outcome.PROVED
    assert judged(latex.replace("-R^T", "R^T")).outcome == Outcome.REFUTED


def test_a_singular_block_makes_it_conditional():
    latex = r"\begin{bmatrix} T & 0 \\ S & T \end{bmatrix}^{-1} = \begin{bmatrix} T^{-1} & 0 \\ -T^{-1} S T^{-1} & T^{-1} \end{bmatrix}"
    assert judged(latex).outcome == Outcome.CONDITIONAL
    assert judged(latex, [r"\det T \neq 0"]).outcome == Outcome.PROVED


@pytest.mark.parametrize(
    ("latex", "degree"),
    [
        ("T", 1),
        ("R", 2),
        ("R^T", 2),
        ("R T R^T", 5),
        ("(R T R^T)^3", 15),
        ("R a", 3),
        ("R a + b", 3),
        ("a + R T b", 4),
        (r"\det T", 3),
        (r"\det (R T)", 9),
        ("T^{-1}", 3),
        ("T^*", 2),
        ("(R T)^*", 6),
        (r"\det (\underline{a} \otimes \underline{b})", 12),
        (r"(\underline{a} \otimes \underline{b})^*", 8),
        (r"R a \cdot R b", 6),
        ("f T", 2),
    ],
)
def test_the_degree_of_a_term(latex, degree):
    (claim,) = read(f"{latex} = {latex}", BOTH)
    assert frame_change._Frame(Definitions()).degree(claim.left) == degree


@pytest.mark.parametrize(
    ("latex", "cheaper"),
    [
        ("R T R = R S R", "T = S"),
        ("R R T = R S", "R T = S"),
        ("T R R = S R", "T R = S"),
        ("R^T T R^T = R^T S R^T", "T = S"),
        ("R T = R^T S", None),
        ("T R = S R^T", None),
        ("T R = S T", None),
        ("R T = T S", None),
        ("T S = S S", None),
    ],
)
def test_only_the_same_rotation_is_taken_from_both_sides(always, latex, cheaper):
    assert both(latex)[1] == (both(cheaper)[0] if cheaper else None)


#: A term, and what it is in the rotated frame; None where it is left as it is.
TERMS = [
    (r"R \mathbf{I} R^T S", "S"),
    (r"(R T R^T)^3", "R T T T R^T"),
    (r"(R T R^T)^{-3}", "R T^{-1} T^{-1} T^{-1} R^T"),
    (r"(T R)^2", "T R T R"),
    (r"T^0", None),
    (r"f (R T R^T)", "R (f T) R^T"),
    (r"(R T R^T) f", "R (T f) R^T"),
    (r"f (R a)", "R (f a)"),
    (r"-(R T R)", "R (-T) R"),
    (r"f (R R R^T R T R R)", "R R (f T) R R"),
    (r"(R T S)^T", "S^T T^T R^T"),
    (r"(R T S)^{-1}", "S^{-1} T^{-1} R^T"),
    (r"(R T S)^*", "S^* T^* R^T"),
    (r"R^* R^{-1} (R^T)^T T", "R^T T"),
    (r"\widetilde{R R a}", r"R R \tilde{a} R^T R^T"),
    (r"\widetilde{R^T T a}", r"R^T \widetilde{T a} R"),
    (r"\operatorname{vect}(R T R^T)", r"R \operatorname{vect} T"),
    (r"\operatorname{vect}(R T R)", None),
    (r"\operatorname{sym}(R R T R^T R^T)", r"R R (\operatorname{sym} T) R^T R^T"),
    (r"\operatorname{skew}(R T R^T)", r"R (\operatorname{skew} T) R^T"),
    (r"R a \times R b", r"R (a \times b)"),
    (r"R R a \times R b", r"R (R a \times b)"),
    (r"R a \times R^T b", None),
    (r"T a \times T b", None),
    (r"R a \otimes R b", r"R (a \otimes b) R^T"),
    (r"R a \otimes b", None),
    (r"\det (R T R S)", r"\det T \det S"),
    (r"\det (R R)", "1"),
    (r"\operatorname{trace} (R T S R^T)", r"\operatorname{trace} (T S)"),
    (r"\operatorname{trace} (R R R T R^T R^T R^T)", r"\operatorname{trace} T"),
    (r"\operatorname{trace} (T R R^T)", r"\operatorname{trace} T"),
    (r"R a \cdot R b", r"a \cdot b"),
    (r"R T a \cdot R b", r"T a \cdot b"),
    ("(R a, R b, R c)", "(a, b, c)"),
    ("(R a, R b, c)", None),
    (r"\|R T a\|", r"\|T a\|"),
    (r"\|T a\|", None),
    (r"R (T R^T R + S)", "R (T + S)"),
    (r"\cos(R a \cdot R b)", r"\cos(a \cdot b)"),
]


@pytest.mark.parametrize(("latex", "turned"), TERMS)
def test_each_rule_takes_the_rotations_out(latex, turned):
    (claim, expected) = (read(f"{each} = {each}", TABLE)[0] for each in (latex, turned or latex))
    assert frame_change._Frame(Definitions()).simple(claim.left) == expected.left


@pytest.mark.parametrize(
    ("latex", "turns"),
    [
        ("R", True),
        ("R^T", True),
        (r"\underline{R}", True),
        (r"\underline{R}^T", True),
        ("T", False),
        ("T^T", False),
        ("Q", False),
        ("Q^T", False),
        ("R R", False),
        ("R^*", False),
        ("-R", False),
    ],
)
def test_only_a_free_rotation_and_its_transpose_turn(latex, turns):
    definitions, table = defined(Q="R")
    (claim,) = read(f"{latex} = {latex}", table)
    assert frame_change._Frame(definitions).turns(claim.left) == turns
