"""The table of relations, evaluated by the judge's engine on every motion: each holds, a changed one does not."""

import numpy as np
import pytest

from workbench.core.construct import relation, symbol
from workbench.core.names import Name
from workbench.core.terms import Symbol
from workbench.core.types import SCALAR, TENSOR, VECTOR, Declaration
from workbench.drake.bindings import ANGLE_BINDINGS, BINDINGS, SIX_BINDINGS, TURN_BINDINGS, bound
from workbench.drake.motions import reference_motions
from workbench.drake.relations import ALSO, DEFINED, names_in
from workbench.drake.sampled_motions import sampled_motions
from workbench.language.definitions import Definitions
from workbench.prover.motions.motion_check import Subject, witness
from workbench.prover.motions.motion_source import Bindings
from workbench.prover.motions.relation_terms import term_of

#: Free bindings: a rotation R(t), a vector of time, a constant vector, a scalar of time, a constant line.
FREE = {
    "R_WB": "rotation",
    "p_WBo": "vector",
    "p_BoP_B": "constant vector",
    "p_BoQ_B": "constant vector",
    "R_WA": "rotation",
    "p_WAo": "vector",
    "R_AB": "rotation",
    "p_ABo_A": "vector",
    "theta1": "scalar",
    "d1": "scalar",
    "theta2": "scalar",
    "d2": "scalar",
    "dual_u1_W": "constant line",
    "dual_u2_A": "constant line",
}


#: Where A's bindings are used beside B's.
DEFINED_ON_CHAINS = (
    ("R_WB", ("mul", "R_WA", "R_AB")),
    ("p_WBo", ("add", "p_WAo", ("mul", "R_WA", "p_ABo_A"))),
)

#: What the joints of a cylindrical chain turn and slide: the rate of a dual twist's angle times its line.
DRIVEN = (
    ("dual_w_WA", ("mul", ("rate", "dual_theta1"), "dual_u1_W")),
    ("dual_w_AB_A", ("mul", ("rate", "dual_theta2"), "dual_u2_A")),
    ("dual_w_AB_W", ("mul", ("rate", "dual_theta2"), "dual_u2_W")),
)

MOTIONS = (*reference_motions(), *sampled_motions())
TABLE = (*DEFINED, *ALSO, *DEFINED_ON_CHAINS, *DRIVEN)
KINDS = {(): SCALAR, (3,): VECTOR, (3, 3): TENSOR}


def symbol_of(name: str) -> Symbol:
    shape, dual = BINDINGS[name].shape, name.startswith("dual_")
    kind = KINDS[shape[1:] if dual else shape]
    return symbol(Declaration(Name(name), kind.with_dual(dual)))


def seen(name, data):
    used = {name, *names_in(data)}
    bindings = Bindings({symbol_of(n): bound(n) for n in used})
    statement = relation("=", symbol_of(name), term_of(data, symbol_of))
    return witness(Subject(statement, (), None, Definitions(), (bindings,), MOTIONS))


@pytest.mark.parametrize("name, data", TABLE, ids=[f"{name}-{i}" for i, (name, _) in enumerate(TABLE)])
def test_each_binding_is_the_term_that_the_table_says(name, data):
    found = seen(name, data)
    assert found.evidence is not None and not found.vetoed, found
    assert len(found.evidence.figures["motions"]) >= 3
    assert max(found.evidence.figures["residuals_below"]) <= 1e-8


@pytest.mark.parametrize(
    "name, data",
    [
        ("w_WB", ("vect", ("mul", ("transpose", "R_WB"), ("rate", "R_WB")))),  # that is w_WB_B
        ("w_WB_B", "w_WB"),
        ("w_WB", ("vect", ("mul", "R_WB", ("transpose", ("rate", "R_WB"))))),
        ("v_WB0", "v_WBo"),
        ("v_WB0", ("add", "v_WBo", ("cross", "w_WB", "p_WBo"))),
        ("dual_w_AB_W", "dual_w_AB_A"),
        ("p_PQ_W", ("sub", "p_WP", "p_WQ")),
        ("dual_w_WA", ("mul", ("rate", "dual_theta2"), "dual_u1_W")),
    ],
)
def test_a_sign_a_frame_or_a_point_too_many_parts_the_sides(name, data):
    found = seen(name, data)
    assert found.vetoed and found.evidence.figures["residual"] > 1e-2


def test_every_binding_of_a_chain_is_free_or_defined_once():
    defined = [name for name, _ in DEFINED]
    assert len(set(defined)) == len(defined) and not set(defined) & set(FREE)
    standing = set(FREE)
    for name, data in DEFINED:
        assert names_in(data) <= standing, name
        standing.add(name)
    blocks_and_directions = {"X_WB", "X_WA", "X_AB", "u1_W", "u2_A", "u2_W", "V_WB", "V_WB_B", "A_WB"}
    blocks_and_directions |= {"q_WA", "q_AB", "q_WB"}
    third_body_and_origin = {n for n in BINDINGS if "C" in n or n.endswith("3")} | {"p_W0", "dual_u3_W"}
    of_coordinates = {
        b.name for b in (*SIX_BINDINGS, *ANGLE_BINDINGS, *TURN_BINDINGS)
    }  # see test_witness_kinds
    shown = (
        {b.name for b in BINDINGS.values()} - blocks_and_directions - third_body_and_origin - of_coordinates
    )
    assert shown == standing


def test_the_free_ones_are_of_their_kind():
    for motion in MOTIONS:
        for name in set(FREE) & set(motion.available_bindings()):
            jet = motion.jet(name, 1, motion.samples[0])
            if FREE[name].startswith("constant"):
                np.testing.assert_allclose(jet[1], 0, atol=1e-9)
            if FREE[name] == "rotation":
                np.testing.assert_allclose(jet[0] @ jet[0].T, np.eye(3), atol=1e-14)
