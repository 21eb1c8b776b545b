"""Sentences that state no condition on the symbols of a formula."""

from itertools import product

#: With words that conditions are told by.
TRAPS = (
    "It is known that",
    "The next identity is close to the standard one:",
    "Without any approximation,",
    "We do not ignore any term and obtain",
    "No term is neglected, so",
    "As one assumes in every course,",
    "In this case study we find",
    "The result approaches the reader gently:",
    "We first order the terms and then",
    "This is a special case of nothing:",
    "The proof is of the form known to all:",
    "The following does not hold only for constant vectors but for all:",
    "It vanishes for zero; in general",
    "For all vectors, perpendicular or not,",
    "Here is, e.g., the rule",
)

_OPENINGS = (
    "Recall that",
    "A short calculation shows that",
    "One easily verifies that",
    "By the rules of the previous chapter,",
    "Without loss of rigour,",
    "As the reader may check,",
    "In the notation of the appendix,",
    "For later reference we record that",
    "In every course on mechanics",
    "Collecting terms,",
)
_ASIDES = (
    "",
    "with no approximation whatever,",
    "and nothing has been neglected,",
    "not only for unit vectors,",
    "which is not restricted to small angles,",
    "in any limit and in none,",
    "as in the special case that opened this section,",
    "whether the matrices are symmetric or not,",
    "be the motion planar or not,",
    "after the first order of business,",
    "close to the end of the proof,",
    "where no constant of integration appears,",
    "and this approach is standard,",
    "whatever vanishes elsewhere,",
    "rather than assuming anything fixed,",
    "once more and at rest from other work,",
    "for example,",
    "parallel to the argument above,",
    "with the same care,",
    "as a matter of principle,",
)

NEUTRAL = tuple(" ".join(filter(None, pair)) for pair in product(_OPENINGS, _ASIDES))
