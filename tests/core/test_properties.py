"""The table of properties: what the reader, the engines and the certificates take from it agrees."""

import pytest

from workbench.certificates.emission.emitted_suppositions import conditions
from workbench.core.construct import symbol
from workbench.core.names import Name
from workbench.core.properties import PROPERTIES, Property, members_of
from workbench.core.schema import flag_names, key_names
from workbench.core.types import KINDS, Declaration
from workbench.core.verdict import Outcome
from workbench.engines.inventory.parameters import parts
from workbench.language.definitions import Definitions
from workbench.prover.decide.decide import Judge

FLAGGED = [row for row in PROPERTIES.values() if row.flag]
STATED = [(row, kind) for row in FLAGGED if row.equations for kind in sorted(row.kinds & KINDS.keys())]


def _symbol(row: Property, kind: str, has: bool = True):
    return symbol(Declaration(Name("x"), KINDS[kind]).with_flags(**{row.flag: has}))


@pytest.mark.parametrize("row", FLAGGED, ids=lambda row: row.name)
def test_flag_is_a_key_or_kind_of_models_and_a_field(row: Property) -> None:
    assert row.flag in key_names("symbol") or row.flag in KINDS or row.flag == "rotation"
    assert row.keyed == () or row.flag in flag_names()
    assert row.flag in vars(Declaration)


@pytest.mark.parametrize(("row", "kind"), STATED, ids=lambda each: getattr(each, "name", each))
def test_flag_gives_the_symbol_its_property(row: Property, kind: str) -> None:
    judge = Judge(Definitions())
    assert judge.judge(row.statement_of(_symbol(row, kind))).outcome is Outcome.PROVED
    assert judge.judge(row.statement_of(_symbol(row, kind, has=False))).outcome is Outcome.REFUTED


@pytest.mark.parametrize(("row", "kind"), STATED, ids=lambda each: getattr(each, "name", each))
def test_coordinates_and_equations_of_a_set_go_together(row: Property, kind: str) -> None:
    own = _symbol(row, kind)
    is_charted = parts(own, 1)[0][0] != "value"
    assert is_charted == (kind in row.chart) == bool(members_of(own.declaration, own))


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        ({"rotation": True}, ["rotation x"]),
        ({"unit": True, "constant": True}, ["unit_vector (K := K) (d := false) x"]),
    ],
)
def test_certificate_states_the_declared_properties(flags: dict[str, bool], said: list[str]) -> None:
    kind = "tensor" if "rotation" in flags else "vector"
    first = conditions(Declaration(Name("x"), KINDS[kind]).with_flags(**flags), "x")
    assert first[:1] == said and len(first) == len(flags)
