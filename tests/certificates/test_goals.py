"""Goals as one theorem: the text says what the goal says, and what is changed in it is seen."""

import re
from itertools import pairwise

import pytest
from click.testing import CliRunner

from tests.certificates.emitted import JOINED, OF_FAMILIES, joined
from workbench import check
from workbench.app.commands.commands import main
from workbench.certificates.certified_forms import forms_of
from workbench.certificates.goals.goal_theorem import of_one_instant
from workbench.certificates.goals.instant_rates import spread
from workbench.certificates.reading.read_back import Unread
from workbench.certificates.theorem import theorem
from workbench.certificates.values.trial import holds_whatever_they_are
from workbench.core.construct import apply, relation
from workbench.core.terms import Derivative, Symbol, TimeOperator
from workbench.language.goals.goals import atoms
from workbench.papers import find_paper

#: What can be done to a proposition in one place.
CHANGES = [
    (r"forall", "exists"),
    (r"exists", "forall"),
    (r"~ equal_at", "equal_at"),
    (r"equal_at", "~ equal_at"),
    (r" \+ ", " - "),
    (r" - ", " + "),
    (r" × ", " + "),
    (r" · ", " × "),
    (r"transpose ", ""),
    (r"real_part", "dual_part"),
    (r"rotation (\w+) -> ", ""),
    (r"rotation (\w+) /\\ ", ""),
    (r"constant [^>]*? -> ", ""),
    (r"constant [^/]*? /\\ ", ""),
    (r"unit_vector [^>]*? -> ", ""),
    (r"<->", "->"),
    (r" -> ", r" /\\ "),
    (r" /\\ ", " -> "),
    (r"\(d := true\) now", "now"),
    (r"number 1", "number 2"),
    (r"\((?!zero)(\w+'?) : vector K", r"(\1 : dual_vector K"),  # an ill-typed 0 is for Coq to see
    (r"length now", "square"),
    (r"over now", "length now"),
    (r"\((\d) <= ", "(9 <= "),
    (r"\(\d <= \w+\)%nat -> ", ""),
    (r"<= (\w+)\)%nat", r"<= \1')%nat"),
    (r"forall \w+ : nat", "forall k : nat"),
    (r"forall now : instant, ", ""),
    (r"\(pred (\w+)\)", r"\1"),
    (r"\(S (\w+)\)", r"\1"),
    (r"der ", "der (S "),
    (r"sum_from \d", "sum_from 5"),
    (r"nat_minus", "nat_plus"),
    (r"(\d)%nat\b(?! ->)", r"1\1%nat"),
]

#: What can be done to a definition before it.
CHANGES_OF_FAMILIES = [
    (r"pred", "S"),
    (r" \(S i\)", " i"),
    (r"transpose ", ""),
    (r" @ ", " + "),
    (r"from_zero", "from_one"),
    (r"der i ", "der (S i) "),
    (r" - ", " + "),
]


def some(found, count):
    """At most so many, from everywhere."""
    found = list(found)
    return found[:: max(1, len(found) // count)]


def faults(theorem, text):
    kept, theorem.proposition = theorem.proposition, text
    try:
        return theorem.read_back_faults()
    except (Unread, ValueError, KeyError) as unread:
        return [str(unread)]
    finally:
        theorem.proposition = kept


@pytest.mark.parametrize("name", JOINED)
def test_the_text_says_what_the_goal_says(name):
    assert joined()[name].read_back_faults() == []


@pytest.mark.parametrize("name", sorted({*JOINED} - {"3C.expanded"}))
def test_changes_of_the_text_are_detected(name):
    theorem = joined()[name]
    text = theorem.proposition
    changed = [
        text[: found.start()] + found.expand(new) + text[found.end() :]
        for old, new in CHANGES
        for found in some(re.finditer(old, text), 3)
    ]
    assert changed
    assert [other for other in changed if other != text and not faults(theorem, other)] == []


@pytest.mark.parametrize("name", OF_FAMILIES)
def test_changes_of_a_family_are_detected(name):
    theorem = joined()[name]
    lines = [line for line in theorem.top if "(fun " in line]
    kept, changed = theorem.top, 0
    for line in lines:
        for old, new in CHANGES_OF_FAMILIES:
            theorem.top = [re.sub(old, new, line, count=1) if one == line else one for one in kept]
            changed += theorem.top != kept
            assert theorem.top == kept or faults(theorem, theorem.proposition), (line, old)
    theorem.top = kept
    assert changed >= 2


def test_a_family_is_supposed_to_be_what_is_declared():
    binders = joined()["117"].speaker.binders
    (family, type_), (name, what) = binders
    for wrong in (
        [(family, type_.replace("dual_tensor", "tensor")), (name, what)],
        [(family, type_.replace("nat -> ", "", 1)), (name, what)],
        [(family, type_), (name, what.replace("dual_rotation", "constant"))],
        [(family, type_), (name, what.replace("i0 i1)", "i0 i0)"))],
    ):
        kept, binders[:] = binders[:], wrong
        try:
            assert joined()["117"].read_back_faults()
        finally:
            binders[:] = kept


def test_definitions_of_a_letter_do_not_apply_where_it_is_bound():
    theorem = joined()["Theorem_1"]
    (rho,) = {
        part
        for one in atoms(theorem.goal)
        for part in one.right.walk()
        if isinstance(part, Symbol) and "rho" in str(part.declaration.name)
    }
    kept, theorem.names = theorem.names, {**theorem.names, "rho": rho}
    changed = theorem.proposition.replace("(rho_Q + R @ r)", "rho")
    seen, theorem.names = faults(theorem, changed), kept
    assert "bound anew" in seen[0]


@pytest.mark.parametrize("name", JOINED)
def test_exchanged_letters_are_detected(name):
    theorem = joined()[name]
    text = theorem.proposition
    letters = sorted(set(re.findall(r"\((\w+'?) : ", text)))
    for one, other in pairwise(letters):
        for found in some(re.finditer(rf"(?<![\w'(]){re.escape(one)}(?![\w'])(?! :)", text), 2):
            changed = text[: found.start()] + other + text[found.end() :]
            assert faults(theorem, changed), changed


def test_most_goals_without_operators_and_maps_are_joined():
    assert {*JOINED} <= {*joined()}
    assert sum(" : nat, " in one.proposition for one in joined().values()) >= 8


def test_a_goal_about_every_n_and_its_theorem():
    made = joined()["122.observed"]
    assert made.proposition == (
        "forall m : nat, equal_at (d := true) now (u_w (S m)) (x0_u_w (S m) - x0_u_w m)"
    )
    assert "let u_w := (fun i' => u_Q (pred i') @ u_omega i') in" in made.top
    assert joined()["Remark_3"].proposition.startswith(
        "(forall n : nat, (3 <= n)%nat -> equal_at now (Phi n) "
    )


def test_premises_on_symbols_are_their_declared_properties():
    theorem = joined()["Theorem8"]
    binders = theorem.speaker.binders
    place = next(i for i, (_, type_) in enumerate(binders) if type_.startswith("unit_vector"))
    name, type_ = binders[place]
    try:
        binders[place] = (name, type_.replace("unit_vector", "constant"))
        assert theorem.read_back_faults()
    finally:
        binders[place] = (name, type_)
    kept = theorem.top[:]
    try:
        theorem.top[:] = [line.replace("turn alpha cos_alpha", "turn alpha sin_alpha") for line in kept]
        assert theorem.read_back_faults()
    finally:
        theorem.top[:] = kept


def test_a_goal_and_its_theorem():
    vector = "constant (K := K) (d := true) (k := Vector)"
    tensor = "constant (K := K) (d := true) (k := Tensor)"

    def holds(name):
        letters = f"forall (a : dual_vector K) (b : dual_vector K), {vector} a -> {vector} b -> "
        return f"({letters}equal_at (d := true) now (a · (u_T @ b)) (b · ({name} @ a)))"

    one, other = "S_'", "S'"
    assert joined()["76.definition"].proposition == (
        f"forall (u_T : dual_tensor K), exists ({one} : dual_tensor K), {tensor} {one} /\\ {holds(one)} /\\ "
        f"(forall ({other} : dual_tensor K), {tensor} {other} -> {holds(other)} -> "
        f"equal_at (d := true) now {other} {one})"
    )


def test_the_command_writes_the_goals(tmp_path):
    done = CliRunner().invoke(main, ["certify", "76.definition", "--out", str(tmp_path)])
    assert done.exit_code == 0, done.output
    text = (tmp_path / "claim_76_definition_goal.v").read_text("utf-8")
    assert joined()["76.definition"].statement in text
    assert "Theorem step_1 (K : diff_ring)" in text


@pytest.mark.parametrize(
    "text",
    [
        r"\frac{d^2}{dt^2} (a \times \dot{b} - s c)",
        r"\frac{d}{dt} (\tilde{a} \tilde{b} c)",
        r"\frac{d^3}{dt^3} ((a \cdot b) c + 2 a)",
        r"\mathbf{D} [a \times b] + \mathbf{D} [\mathbf{D} [c]]",
    ],
)
def test_derivatives_of_free_symbols_alone_say_the_same(text):
    symbols = {"a": "vector", "b": "vector", "c": "vector", "s": "scalar"}
    claim = check(f"{text} = c", symbols=symbols).result.claim
    (term, definitions) = claim.printed.statement.left, claim.notation.definitions
    made = spread(term, definitions)
    assert all(isinstance(p.body, Symbol) for p in made.walk() if isinstance(p, Derivative))
    assert not any(isinstance(p, TimeOperator) for p in made.walk())
    assert holds_whatever_they_are(theorem("t", relation("=", term, made), (), definitions))
    false = relation("=", term, apply("neg", made))
    assert not holds_whatever_they_are(theorem("t", false, (), definitions))


def test_premises_at_one_instant_are_stated_for_it():
    (form,) = (f for c in find_paper("chapter").claims if c.id == "110.A" for f in forms_of(c))
    made = of_one_instant(form)
    assert made.misread == ""
    assert "equal_at now rho (zero : vector K) -> equal_at now A_0_1 (D v)." in made.statement
    assert "exists (rho : vector K), equal_at now rho (zero : vector K)." in made.motions.statement
