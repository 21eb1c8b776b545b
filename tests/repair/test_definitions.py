"""One change of a definition that mends several claims: coefficients, an edit of what is no sum, a recurrence."""

from __future__ import annotations

import pytest

from workbench.context.read_formulas import read_statement
from workbench.papers import find_paper, load_paper
from workbench.prover.decide.decide import Judge
from workbench.prover.results.claim_results import HOLDS
from workbench.repair.propose.definition_repair import repair_definitions

HOPELESS = r"""
title = "What no definition near this one makes true"
[symbols]
'a' = { kind = "vector" }
'b' = { kind = "vector" }
[definitions]
'q' = 'a \times b'
[[claim]]
id = "one"
printed = 'q \cdot a = a^2 + 1'
[[claim]]
id = "other"
printed = 'q^2 = b^2 + 2'
"""

RECURRENCE = r"""
title = "The sign of a recurrence"
[symbols]
'\omega' = { kind = "vector", weight = 1 }
'\Phi_n' = { kind = "tensor", weight = "n" }
[definitions]
'\Phi_1' = '\tilde{\omega}'
'\Phi_{n+1}' = '\dot{\Phi}_n - \Phi_n \Phi_1'
[[claim]]
id = "2"
printed = '\Phi_2 = \dot{\tilde{\omega}} + \tilde{\omega}^2'
[[claim]]
id = "3"
printed = '\Phi_3 = \ddot{\tilde{\omega}} + \tilde{\omega} \dot{\tilde{\omega}} + 2 \dot{\tilde{\omega}} \tilde{\omega} + \tilde{\omega}^3'
[[claim]]
id = "square"
printed = '\Phi_2^2 = (\dot{\tilde{\omega}} + \tilde{\omega}^2)^2'
"""

PRODUCT = r"""
title = "A product that is no sum"
[symbols]
'a' = { kind = "vector" }
'b' = { kind = "vector" }
[definitions]
'q' = 'a \times b'
[[claim]]
id = "vector"
printed = 'q \times a = (a \cdot b) a - a^2 b'
[[claim]]
id = "square"
printed = '(q + b \times a) \cdot (q + b \times a) = 4 a^2 b^2 - 4 (a \cdot b)^2'
"""


def claims_of(tmp_path, text):
    path = tmp_path / "paper.toml"
    path.write_text(text)
    return load_paper(path).claims


def test_an_edit_of_a_product_corrects_nonlinear_claims(tmp_path):
    found = repair_definitions(claims_of(tmp_path, PRODUCT))
    assert {new for r in found for _, _, new in r.changed} == {r"b \times a", r"-a \times b"}
    assert all(r.mended == ("vector", "square") for r in found)


def test_an_edit_of_a_recurrence_mends_all_its_members(tmp_path):
    best = repair_definitions(claims_of(tmp_path, RECURRENCE), least=3)[0]
    ((name, old, new),) = best.changed
    assert (name, old) == (r"\Phi_{n+1}", r"\dot{\Phi}_{n} - \Phi_{n} \Phi_{1}")
    assert new == r"\dot{\Phi}_{n} + \Phi_{n} \Phi_{1}"
    assert best.mended == ("2", "3", "square")


def test_where_no_change_mends_two_claims_there_is_none(tmp_path):
    assert repair_definitions(claims_of(tmp_path, HOPELESS), seconds=5.0) == []


@pytest.mark.slow
def test_under_repaired_definitions_66_holds_of_S_4():
    """(67) repaired from (64); then (66) holds of S₄, whose determinant it gives, in place of Φ₄."""
    chosen = [claim for claim in find_paper().claims if claim.id in ("64.split", "66")]
    best, *_ = repair_definitions(chosen, seconds=0.0)
    assert best.mended == ("64.split",)
    assert [name for name, _, _ in best.changed] == [r"\mathbf{w}", r"\alpha"]
    ((name, edit, latex),) = best.with_edits
    assert name == "66" and r"\mathbf{S}_{4}" in edit
    claim = chosen[1]
    right = claim.printed.latex.replace(r"\Phi_4", r"\mathbf{S}_4")
    for letter in (r"\mathbf{w}", r"\alpha"):
        right, latex = (text.replace(letter, f"{letter}_c") for text in (right, latex))
    judge = Judge(claim.notation.definitions)
    for text in (right, latex):
        assert judge.judge(read_statement(text, claim.notation, None)[0]).outcome in HOLDS


@pytest.mark.parametrize("text", [PRODUCT, RECURRENCE])
def test_true_claims_need_no_other_definitions(tmp_path, text):
    right = text.replace(r"'a \times b'", r"'b \times a'").replace(r"\dot{\Phi}_n -", r"\dot{\Phi}_n +")
    assert repair_definitions(claims_of(tmp_path, right)) == []


@pytest.mark.slow
def test_misprinted_claims_do_not_count_against_a_definition():
    """A transpose in the recurrence of Φₙ would mend div Φ₄, and the others with one change each."""
    claims = {claim.id: claim for claim in find_paper().claims}
    assert repair_definitions([claims[name] for name in ("70.div", "46", "48")]) == []
