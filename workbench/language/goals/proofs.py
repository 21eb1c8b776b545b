"""Proofs of goals: which rule is applied where, with the witnesses and instances that a rule needs.

    Unique({"X": r"\\Phi^{-1} (\\det \\Phi) \\mathbf{I}"}, only=Follows(r"\\Phi^{-1} Y", Y=Use(0)))

A proof says nothing of itself: `rules.prove` derives from it what has to be shown, and for which n. Formulas
are LaTeX in the notation of the claim, with the letters that the goal has bound on the way. Quantifiers ∀,
premises and conjunctions are taken apart without being asked.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Kernel:
    """The judge of formulas decides; `using`: the premises that it may suppose (by number, all by
    default)."""

    using: tuple[int, ...] | None = None


@dataclass(frozen=True)
class Each:
    """One proof for each part of a conjunction."""

    proofs: tuple[Proof, ...]

    def __init__(self, *proofs: Proof) -> None:
        object.__setattr__(self, "proofs", proofs)


@dataclass(frozen=True)
class Ways:
    """⇔: there, with the left side as a premise, and back."""

    there: Proof = field(default_factory=Kernel)
    back: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class Witness:
    """∃: these are the members asked for. using: the premises by which constants are of their set."""

    members: Mapping[str, str]
    then: Proof = field(default_factory=Kernel)
    using: tuple[int, ...] | None = None


@dataclass(frozen=True)
class Unique:
    """∃!: these members do, by `exists`; and whatever does is equal to them, by `only`, where the body of the
    goal, of the bound letters, is the last premise."""

    members: Mapping[str, str]
    exists: Proof = field(default_factory=Kernel)
    only: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class Induction:
    """∀ n ≥ k: at k; and at n + 1, where the last premise is the goal at n, or, with a letter, at each such
    integer from k to n."""

    begin: Proof = field(default_factory=Kernel)
    step: Proof = field(default_factory=Kernel)
    letter: str | None = None


@dataclass(frozen=True)
class Use:
    """One premise, for these values of its ∀ (LaTeX; an integer such as n+1): which of its equations, read
    from right to left if `back`. members: the proof that values of rotations and unit vectors are such, for
    all of them or by letter."""

    premise: int
    at: Mapping[str, str] = field(default_factory=dict)
    part: int = 0
    back: bool = False
    members: Proof | Mapping[str, Proof] = field(default_factory=Kernel)


@dataclass(frozen=True)
class Follows:
    """An equation a = b from premises lᵢ = rᵢ and an expression F: by a = F(l₁, …) and F(r₁, …) = b."""

    expression: str
    uses: Mapping[str, Use]

    def __init__(self, expression: str, **uses: Use) -> None:
        object.__setattr__(self, "expression", expression)
        object.__setattr__(self, "uses", uses)


@dataclass(frozen=True)
class Have:
    """First `goal`, by `by`; it is the last premise of `then`."""

    goal: str
    by: Proof
    then: Proof


@dataclass(frozen=True)
class Given:
    """First what the goal begins with is taken apart: each ∀ and each premise. (`Have` does not do so.)"""

    then: Proof


@dataclass(frozen=True)
class Obtain:
    """From the premise ∃: members as it says, by its letters, with its body as the last premise of `then`."""

    premise: int
    then: Proof


@dataclass(frozen=True)
class OnCircle:
    """∃ a ∈ ℝ : cos a = c ∧ sin a = s, for c² + s² = 1. That every point of the unit circle is the cosine and
    the sine of an angle is not derived from anything: it is what cos and sin are."""


@dataclass(frozen=True)
class Jet:
    """∃ v ∈ V₃^ℝ : (∀ k < n : v⁽ᵏ⁾ = 0) ∧ v⁽ⁿ⁾ = b, at the instant; also for scalars and tensors. With t₀ the
    instant, (t − t₀)ⁿ b / n! is one."""


@dataclass(frozen=True)
class Cases:
    """Under the equation, and under its opposite: one of the two is always so."""

    equation: str
    equal: Proof = field(default_factory=Kernel)
    unequal: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class Pointwise:
    """Two tensors are equal if they take every vector `letter` to the same one; two vectors, if their
    products with every vector are equal."""

    letter: str
    then: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class Pascal:
    """∀ n ≥ 0 : Gₙ = Σ_{k=0}^{n} C(n, k) F(n−k, k). term: F, in the integers j and k.   step: L, in Y, with
    Gₙ₊₁ = L Gₙ (by `follow`) and L F(j, k) = F(j+1, k) + F(j, k+1) (by `grow`); G₀ = F(0, 0), by `begin`."""

    term: str
    step: str = r"\dot{Y}"
    begin: Proof = field(default_factory=Kernel)
    follow: Proof = field(default_factory=Kernel)
    grow: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class Termwise:
    """Two sums over one range are equal if their addends are; `letter` stands for the integer, and j for what
    is left of n: premises about n are about n = letter + j then (less what is added to n in the range)."""

    letter: str = "k"
    then: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class ByLength:
    """A real scalar or vector is 0 if its square is."""

    then: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class Contradicts:
    """a ≠ b, for from a = b, the last premise of `then`, follows the equation that the premise denies."""

    premise: int
    then: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class Squares:
    """≥: the difference is this sum of squares of real scalars and vectors."""

    terms: tuple[str, ...]

    def __init__(self, *terms: str) -> None:
        object.__setattr__(self, "terms", terms)


@dataclass(frozen=True)
class TwoWitnesses:
    """Against ∃!: both do, and they are not equal."""

    first: Mapping[str, str]
    second: Mapping[str, str]
    firstly: Proof = field(default_factory=Kernel)
    secondly: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class At:
    """Against ∀: it fails for these values of the letters that it binds (of integers, numbers)."""

    values: Mapping[str, str]
    then: Against


@dataclass(frozen=True)
class Part:
    """Against a conjunction: this part of it fails (an equivalence has two, there and back)."""

    number: int
    then: Against


@dataclass(frozen=True)
class Broken:
    """Against an implication: its premise holds, by `premise`, and its conclusion fails."""

    then: Against
    premise: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class Impossible:
    """Against ∃: from its body, which is the last premise, an equation follows that does not speak of what is
    asked for and fails for some values, or always, as 0 = 1 does."""

    then: Proof
    so: str = "0 = 1"


@dataclass(frozen=True)
class False_:
    """Against an equation: the judge of formulas finds values for which it fails."""


Proof = (
    Kernel
    | Each
    | Ways
    | Witness
    | Unique
    | Induction
    | Follows
    | Have
    | Given
    | Obtain
    | OnCircle
    | Jet
    | Cases
    | Pointwise
    | Pascal
    | Termwise
    | ByLength
    | Contradicts
    | Squares
)
Against = TwoWitnesses | At | Part | Broken | Impossible | False_


@dataclass(frozen=True)
class Proven:
    """A proof of a claim's goal; or what stands `against` it; or both: with its hypothesis, and without."""

    proof: Proof | None = None
    against: Against | None = None
