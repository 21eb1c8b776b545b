"""∇ of fields: the identities of vector analysis, of any smooth fields and of given ones, and what is refused."""

from __future__ import annotations

from workbench import check

SYMBOLS = {
    "x": {"kind": "vector", "coordinate": True},
    "f": {"kind": "scalar", "of": ["x"]},
    "g": {"kind": "scalar", "of": ["x"]},
    "u": {"kind": "vector", "of": ["x"]},
    "v": {"kind": "vector", "of": ["x"]},
    "a": {"kind": "vector", "uniform": True},
    "c": {"kind": "scalar", "uniform": True},
    "q": {"kind": "matrix 2×1", "independent": True},
    "V": {"kind": "scalar", "of": ["q"]},
    "T": {"kind": "tensor", "uniform": True},
    "h": "scalar",
}


def test_proposals_keep_the_coordinate():
    found = check(r"\nabla \times (a \times x) = a", symbols=SYMBOLS).repair().proposals
    assert found and all(r"\partial x" in each.latex for each in found)
