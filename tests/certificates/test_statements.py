"""What the Coq statements say: read back they are the typed terms, and a reader sees the formula in them."""

import pytest
from click.testing import CliRunner

from tests.certificates.emitted import all_certificates, one
from tests.planted import planted
from workbench import check
from workbench.app.commands.commands import main
from workbench.certificates.certified_forms import certificate, forms_of
from workbench.certificates.emission.emitted_nodes import NotCertified
from workbench.certificates.reading import read_back
from workbench.certificates.steps import steps_of
from workbench.certificates.theorem import Theorem, theorem
from workbench.core.verdict import Outcome, Verdict
from workbench.language.definitions import Definitions
from workbench.papers import find_paper
from workbench.prover.results.claim_results import ClaimResult


def test_every_statement_reads_back_as_its_terms():
    theorems = [t for _, made in all_certificates() if not isinstance(made, str) for t in made.theorems]
    assert len(theorems) > 300
    assert [fault for t in theorems for fault in t.read_back_faults()] == []


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("skew omega", "skew v"),
        ("Phi_1 ∘ Phi_1", "Phi_1 + Phi_1"),
        ("D Phi_1", "der 2 Phi_1"),
        ("- square", "square"),
        ("cross", "dot"),
    ],
)
def test_a_changed_text_is_detected(old, new):
    (t,) = one("58.det").theorems
    t.conclusions[:] = [c.replace("×", "·") if old == "cross" else c.replace(old, new) for c in t.conclusions]
    t.emitter.statement[:] = [line.replace(old, new) for line in t.emitter.statement]
    t.emitter.read_back["v"] = next(iter(t.emitter.read_back.values()))
    if old == "skew omega":
        t.emitter.read_back["v"] = t.emitter.read_back["Phi_1"]
    assert t.read_back_faults()


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        (("59", "reading"), "inverse Phi_2", "inverse Phi_1"),
        (("59", "reading"), "reciprocal (square (omega × D omega))", "reciprocal (square omega)"),
        (("24.inverse",), "(cell w)", "(cell (- w))"),
        (("24.inverse",), "rotation R", "constant (K := K) (d := false) (k := Tensor) R"),
        (("58.det",), "let Phi_1 := skew omega in", "let Phi_1 := skew omega in\nomega ≡ omega ->"),
    ],
)
def test_a_changed_premise_is_detected(name, old, new):
    (t,) = one(*name).theorems
    assert t.read_back_faults() == []
    own = t.emitter
    own.binders[:] = [(n, type_.replace(old, new)) for n, type_ in own.binders]
    own.statement[:] = [x for line in own.statement for x in line.replace(old, new, 1).split("\n")]
    assert t.read_back_faults()


@pytest.mark.parametrize("name", ["58.det", "70.div"])  # proved; refuted
def test_a_statement_that_says_something_else_ends_the_run(name, monkeypatch):
    monkeypatch.setattr(Theorem, "read_back_faults", lambda self: ["omega is read as v"])
    done = CliRunner().invoke(main, ["certify", name])
    assert done.exit_code == 3
    assert "omega is read as v" in " ".join(done.output.split())


def test_the_determinant_of_the_acceleration_tensor():
    (t,) = one("58.det").theorems
    assert t.statement == (
        "Theorem claim_58_det_printed (K : diff_ring) (omega : vector K) :\n"
        "  let Phi_1 := skew omega in\n"
        "  let Phi_2 := D Phi_1 + Phi_1 ∘ Phi_1 in\n"
        "  det Phi_2 ≡ - square (omega × D omega)."
    )


def test_a_rotation_is_supposed_to_be_one():
    (t,) = one("3.skew").theorems
    assert "(R : tensor K) (R_rotation : rotation R)" in t.statement


def test_a_recurrence_is_quantified_over_every_n():
    (t,) = one("53.split").theorems
    assert (
        "let Phi := from_one Phi_1 (fun (i : nat) (Phi_n : tensor K) => D Phi_n + Phi_n ∘ Phi_1) in"
        in t.statement
    )
    assert "(n_less_1 : nat)" in t.statement


def test_an_inverse_and_a_quotient_are_premises():
    (t,) = one("59", "reading").theorems
    assert "inverse Phi_2 inverse_Phi_2 ->" in t.statement
    assert "reciprocal (square (omega × D omega)) over ->" in t.statement


def test_a_block_inverse_is_a_premise_with_a_preceding_theorem():
    (t,) = one("24.inverse").theorems
    assert (
        "inverse_matrix 4 (above 3 (beside 3 (cell R) (cell w)) (beside 3 void (cell (number 1))))"
        in t.statement
    )
    assert t.text.startswith("Theorem before_1 (K : diff_ring)")


def test_premises_at_one_instant_give_no_theorem_about_functions():
    with pytest.raises(NotCertified, match="one instant"):
        one("110.A")


def test_most_exact_forms_of_the_chapter_are_written():
    made = [c for _, c in all_certificates()]
    assert sum(not isinstance(c, str) for c in made) >= 200


@pytest.mark.parametrize("text", ["a + ", "a ≡ b", "(a", "a ) b", "$x"])
def test_text_outside_the_emitted_subset_is_rejected(text):
    with pytest.raises(read_back.Unread):
        read_back.expression(text)


def test_a_name_of_coq_is_spelt_otherwise():
    statement = check(r"I \times I = 0", symbols={"I": "vector"}).result.claim.printed.statement
    assert "(I_ : vector K)" in theorem("t", statement, (), Definitions()).statement


@pytest.mark.parametrize(
    ("formula", "symbols", "obstacle"),
    [
        (r"A B = B A", {"A": "matrix 2×2", "B": "matrix 2×2"}, "a block matrix that nothing defines"),
        (r"T T = T", {"T": {"kind": "transform"}}, "a block matrix that nothing defines"),
        (r"T a = a", {"T": {"kind": "tensor", "symmetric": True}, "a": "vector"}, "a symmetric tensor"),
        (r"\dot{x} = t x", {"x": "scalar"}, "the time t"),
        (r"f f = f", {"q": "scalar", "f": {"kind": "scalar", "of": ["q"]}}, "a function of other symbols"),
        (r"q q = q", {"q": {"kind": "scalar", "independent": True}}, "that others are functions of"),
        (r"\|a\| = \frac{d}{dt} \|b\|", {"a": "vector", "b": "vector"}, "the derivative of a norm"),
        (r"a \cdot b \neq 0", {"a": "vector", "b": "vector"}, "an inequation to be proved"),
    ],
)
def test_obstacles_name_the_missing_feature(formula, symbols, obstacle):
    claim = check(formula, symbols=symbols).result.claim
    with pytest.raises(NotCertified, match=obstacle):
        theorem("t", claim.printed.statement, (), claim.notation.definitions)


def test_quaternions_are_named_as_the_obstacle():
    obstacles = set()
    for claim in find_paper("quaternions").claims:
        for form in forms_of(claim):
            try:
                certificate(form, every=False)
            except NotCertified as obstacle:
                obstacles.add(str(obstacle))
    assert "quaternions" in obstacles


@pytest.mark.parametrize("claim_id", ["Theorem5", "78", "74"])
def test_each_step_of_a_theorem_has_a_certificate_or_an_obstacle(claim_id):
    paper = find_paper("chapter")
    (claim,) = [c for c in paper.claims if c.id == claim_id]
    result = ClaimResult(claim, planted(Outcome.PROVED))
    made = steps_of(result, paper.theorems)
    assert all((step.certificate is None) == bool(step.obstacle) for step in made.steps)
    assert [
        f for s in made.steps if s.certificate for f in s.certificate.theorems[0].read_back_faults()
    ] == []
    assert f"of {len(made.steps)}" in made.word
    refused = ClaimResult(claim, Verdict(Outcome.REFUTED))
    assert steps_of(refused, paper.theorems) is None


def test_an_inequation_is_about_an_instant_of_a_real_motion():
    (t,) = one("58.nonsingular").theorems
    assert t.statement.endswith(
        "~ equal_at now (det Phi_2) (zero : scalar K) <-> ~ equal_at now (omega × D omega) (zero : vector K)."
    )
    assert t.read_back_faults() == []


@pytest.mark.parametrize("premise", [r"a = \mathbf{0}", r"\mathbf{0} = a", r"a + b = \mathbf{0}"])
def test_a_premise_at_an_instant_says_nothing_of_derivatives(premise):
    symbols = {"a": "vector", "b": "vector"}
    supposed = check(premise, symbols=symbols).result.claim.printed.statement
    claim = check(r"\dot{a} = \dot{b}", symbols=symbols).result.claim
    with pytest.raises(NotCertified, match="one instant"):
        theorem("t", claim.printed.statement, (supposed,), claim.notation.definitions)
    theorem("t", supposed, (supposed,), claim.notation.definitions)


def test_a_norm_is_a_premise():
    claim = check(r"\|a\| \|a\| = a \cdot a", symbols={"a": "vector"}).result.claim
    made = theorem("t", claim.printed.statement, (), claim.notation.definitions)
    assert "length • length ≡ square a ->" in made.statement
    assert made.read_back_faults() == []
