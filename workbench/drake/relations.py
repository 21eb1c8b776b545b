"""Definitions of bindings by other bindings, as data.

`DEFINED` gives for a binding the term of other bindings that it is equal to, in an order in which each uses
only free or earlier ones. Bindings without an entry are free: `FREE` gives their kinds. On a chain,
`DEFINED_ON_CHAINS` has priority: there the motion of B is that of A and that of B in A.

A term is a binding's name, or (operation, terms …): add, sub, mul (of tensors, vectors, scalars), cross,
skew, vect, transpose, rate (the time derivative), and dual (its real and its dual part).
"""

from __future__ import annotations

Term = str | tuple


def _angular(R: Term) -> Term:
    return ("vect", ("mul", ("rate", R), ("transpose", R)))


def _at_origin(v: Term, w: Term, p: Term) -> Term:
    return ("sub", v, ("cross", w, p))


def _dual_rotation(R: Term, p: Term) -> Term:
    return ("dual", R, ("mul", ("skew", p), R))


def names_in(data: Term) -> set[str]:
    """Returns the bindings in a term."""
    return {data} if isinstance(data, str) else set().union(*map(names_in, data[1:]))


#: (binding, term that defines it), in order.
DEFINED: tuple[tuple[str, Term], ...] = (
    ("w_WB", _angular("R_WB")),
    ("w_WB_B", ("mul", ("transpose", "R_WB"), "w_WB")),
    ("alpha_WB", ("rate", "w_WB")),
    ("v_WBo", ("rate", "p_WBo")),
    ("a_WBo", ("rate", "v_WBo")),
    ("p_WP", ("add", "p_WBo", ("mul", "R_WB", "p_BoP_B"))),
    ("p_WQ", ("add", "p_WBo", ("mul", "R_WB", "p_BoQ_B"))),
    ("p_QP_B", ("sub", "p_BoP_B", "p_BoQ_B")),
    ("p_PQ_W", ("sub", "p_WQ", "p_WP")),
    ("v_WP", ("rate", "p_WP")),
    ("v_WQ", ("rate", "p_WQ")),
    ("a_WP", ("rate", "v_WP")),
    ("a_WQ", ("rate", "v_WQ")),
    ("v_WB0", _at_origin("v_WBo", "w_WB", "p_WBo")),
    ("a_WB0", ("add", ("rate", "v_WB0"), ("cross", "w_WB", "v_WB0"))),
    ("dual_R_WB", _dual_rotation("R_WB", "p_WBo")),
    ("dual_w_WB", ("dual", "w_WB", "v_WB0")),
    ("dual_v_WBo", ("dual", "w_WB", "v_WBo")),
    ("dual_v_WP", ("dual", "w_WB", "v_WP")),
    ("dual_v_WQ", ("dual", "w_WB", "v_WQ")),
    ("w_WA", _angular("R_WA")),
    ("w_AB_A", _angular("R_AB")),
    ("w_AB_W", ("mul", "R_WA", "w_AB_A")),
    ("v_WAo", ("rate", "p_WAo")),
    ("v_WA0", _at_origin("v_WAo", "w_WA", "p_WAo")),
    ("v_AB0_A", _at_origin(("rate", "p_ABo_A"), "w_AB_A", "p_ABo_A")),
    ("v_AB0_W", ("add", ("mul", "R_WA", "v_AB0_A"), ("cross", "p_WAo", "w_AB_W"))),
    ("dual_R_WA", _dual_rotation("R_WA", "p_WAo")),
    ("dual_R_AB", _dual_rotation("R_AB", "p_ABo_A")),
    ("dual_w_WA", ("dual", "w_WA", "v_WA0")),
    ("dual_w_AB_A", ("dual", "w_AB_A", "v_AB0_A")),
    ("dual_w_AB_W", ("mul", "dual_R_WA", "dual_w_AB_A")),
    ("dual_theta1", ("dual", "theta1", "d1")),
    ("dual_theta2", ("dual", "theta2", "d2")),
    ("dual_u2_W", ("mul", "dual_R_WA", "dual_u2_A")),
)

#: Alternative terms for the same bindings, if those of their definitions are not used.
ALSO: tuple[tuple[str, Term], ...] = (
    ("dual_w_WB", _angular("dual_R_WB")),
    ("dual_w_WA", _angular("dual_R_WA")),
    ("dual_w_AB_A", _angular("dual_R_AB")),
)
