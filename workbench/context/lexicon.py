"""The words by which sentences describe symbols: data for `sentences`."""

from __future__ import annotations

from collections.abc import Mapping

from workbench.source.documents.condition_words import (
    CASES,
    EXCEPTIONS,
    EXPLAINS,
    LETS,
    REASONS,
    SUPPOSES,
)

#: The words for each property of core/properties.py.
PROPERTY_WORDS: Mapping[str, str] = {
    "unit": r"unit(?:ary)?|normali[sz]ed|of (?:length|norm|magnitude) (?:one|1)"
    r"|of unit (?:length|norm|magnitude)",
    "rotation": r"rotations?|proper orthogonal|rotation matri(?:x|ces)|direction cosine matri(?:x|ces)",
    "orthogonal": r"orthogonal|orthonormal",
    "symmetric": r"(?<!skew[- ])(?<!anti)symmetric",
    "diagonal": r"diagonal",
    "skew": r"skew(?:[- ]symmetric)?|antisymmetric",
    "constant": r"constant|fixed|stationary|at rest|time[- ]invariant|independent of time|uniform",
    "positive": r"positive|length|radius|distance",
    "small": r"small|infinitesimal",
    "zero": r"zero|vanish(?:es|ing)?|negligible|neglected|ignored",
    "identity": r"identity|unit (?:matrix|tensor)",
    "perpendicular": r"perpendicular|orthogonal|normal",
    "parallel": r"parallel|collinear|aligned",
}

#: The predicates that state a property without "is".
PREDICATES: Mapping[str, str] = {
    "unit": r"ha(?:s|ve) (?:unit (?:length|norm|magnitude)|(?:length|norm|magnitude) (?:one|1))",
    "constant": r"do(?:es)? not (?:depend on|vary (?:with|in)|change (?:with|in)) time",
    "zero": r"vanish(?:es)?",
    "parallel": r"ha(?:s|ve) the same direction",
}

#: For each kind, the nouns that stand for all symbols of it: "unit vectors", "small angles".
KIND_NOUNS: Mapping[str, str] = {
    "vector": r"vectors?|ax[ei]s|directions?",
    "tensor": r"matri(?:x|ces)|tensors?|rotations?",
    "matrix": r"matri(?:x|ces)|columns?",
    "scalar": r"angles?|numbers?|scalars?|components?|masses|mass|lengths?",
    "quaternion": r"quaternions?",
}

#: Pairs of property and kind that a sentence can state for the rest of the text.
FOR_ALL = (("unit", "quaternion"),)

#: A clause with one of these words makes no fact.
NEGATION = (
    r"\b(?:not|no|never|nor|neither|without|cannot|need|hardly|only|unless|unlike|any|instead|rather)\b"
    r"|\bnon-?$"
)

#: A kind noun counts only after one of these words.
CONDITION = rf"\b(?:{LETS}|{EXPLAINS}|{CASES}|{SUPPOSES}|{REASONS}|restrict\w*|consider\w*)\b"

#: The beginning of a supposition that an earlier sentence makes for itself alone.
CASE = rf"\b(?:{CASES}|{EXCEPTIONS})\b[^,]*$"

#: Words that state something unformalized of a symbol.
OPAQUE = (
    r"\b(?:approximat\w*|linear[iy]\w*|neglect\w*|ignor\w*|first[- ]order|compared (?:with|to)"
    r"|limit|tends?|approach(?:es|ing)?|(?:close|near) to|planar|special case|coincid\w+"
    r"|coplanar|linearly (?:in)?dependent|proportional|isotropic|spherical|diagonal|traceless"
    r"|singular|invertible|nilpotent|idempotent|purely|principal ax[ei]s|eigen\w+)\b"
)

#: Verbs between a symbol and its property.
BE = r"(?:is|are|be|being|remains?|stays?|denotes?)"

#: Words that separate a symbol from a property.
STOP = r"is|are|be|not|of|to|no|and|or|for|if|when|where|with|by|in|on|at"
