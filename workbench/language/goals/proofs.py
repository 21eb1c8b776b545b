"""Proofs of goals: trees of rules, with the witnesses and instances that a rule needs.

    inverse = {"X": r"\\Phi^{-1} (\\det \\Phi) \\mathbf{I}"}
    UniqueExists(inverse, only=Congruence(r"\\Phi^{-1} Y", Y=Instance(0)))

A proof asserts nothing: `prove_goal.prove` derives the obligations from it, and for which n. Formulas are
LaTeX in the notation of the claim, with the letters that the goal has bound so far. The quantifier ∀,
premises and conjunctions are decomposed automatically.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Kernel:
    """The judge of formulas decides. `using`: the premises that it may assume (by number, default all)."""

    using: tuple[int, ...] | None = None


@dataclass(frozen=True)
class AndIntroduction:
    """One proof for each part of a conjunction."""

    proofs: tuple[Proof, ...]

    def __init__(self, *proofs: Proof) -> None:
        object.__setattr__(self, "proofs", proofs)


@dataclass(frozen=True)
class IffIntroduction:
    """⇔: one proof with the left side as a premise, and one for the converse."""

    there: Proof = field(default_factory=Kernel)
    back: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class ExistsIntroduction:
    """∃: the witnesses. using: the premises that show that constants are in their sets."""

    members: Mapping[str, str]
    then: Proof = field(default_factory=Kernel)
    using: tuple[int, ...] | None = None


@dataclass(frozen=True)
class UniqueExists:
    """∃!: `exists` proves that the witnesses satisfy the goal; `only` proves that any others are equal to
    them.

    The last premise of `only` is the body of the goal for the bound letters.
    """

    members: Mapping[str, str]
    exists: Proof = field(default_factory=Kernel)
    only: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class Induction:
    """∀ n ≥ k: a proof at k, and one at n + 1.

    The last premise of `step` is the goal at n, or, with a letter, the goal at each such integer from k to n.
    """

    begin: Proof = field(default_factory=Kernel)
    step: Proof = field(default_factory=Kernel)
    letter: str | None = None


@dataclass(frozen=True)
class Instance:
    """One premise, for these values of its ∀ (LaTeX; an integer such as n+1).

    part: which of its equations.   back: read from right to left.
    members: the proof that values of rotations and unit vectors are such, for all of them or by letter.
    """

    premise: int
    at: Mapping[str, str] = field(default_factory=dict)
    part: int = 0
    back: bool = False
    members: Proof | Mapping[str, Proof] = field(default_factory=Kernel)


@dataclass(frozen=True)
class Congruence:
    """An equation a = b from premises lᵢ = rᵢ and an expression F: a = F(l₁, …) and F(r₁, …) = b."""

    expression: str
    uses: Mapping[str, Instance]

    def __init__(self, expression: str, **uses: Instance) -> None:
        object.__setattr__(self, "expression", expression)
        object.__setattr__(self, "uses", uses)


@dataclass(frozen=True)
class Cut:
    """Proves `goal` by `by` first; it is the last premise of `then`."""

    goal: str
    by: Proof
    then: Proof


@dataclass(frozen=True)
class Introductions:
    """Decomposes the ∀ and premises at the front of the goal first. (`Cut` does not do so.)"""

    then: Proof


@dataclass(frozen=True)
class ExistsElimination:
    """Names the witnesses of a premise ∃ by its letters; its body is the last premise of `then`."""

    premise: int
    then: Proof


@dataclass(frozen=True)
class UnitCircleAxiom:
    """∃ a ∈ ℝ : cos a = c ∧ sin a = s, for c² + s² = 1.

    That every point of the unit circle is the cosine and sine of an angle is not derived: it defines cos and
    sin.
    """


@dataclass(frozen=True)
class DerivativeAxiom:
    """∃ v ∈ V₃^ℝ : (∀ k < n : v⁽ᵏ⁾ = 0) ∧ v⁽ⁿ⁾ = b, at the instant; also for scalars and tensors.

    With t₀ the instant, (t − t₀)ⁿ b / n! is a witness.
    """


@dataclass(frozen=True)
class Cases:
    """One proof under the equation, and one under its negation."""

    equation: str
    equal: Proof = field(default_factory=Kernel)
    unequal: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class Extensionality:
    """Two tensors are equal if they map every vector `letter` to equal vectors; two vectors, if their
    products with every vector are equal."""

    letter: str
    then: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class BinomialInduction:
    """∀ n ≥ 0 : Gₙ = Σ_{k=0}^{n} C(n, k) F(n−k, k).

    term: F, in the integers j and k.
    step: L, in Y, with Gₙ₊₁ = L Gₙ (by `follow`) and L F(j, k) = F(j+1, k) + F(j, k+1) (by `grow`).
    begin: the proof of G₀ = F(0, 0).
    """

    term: str
    step: str = r"\dot{Y}"
    begin: Proof = field(default_factory=Kernel)
    follow: Proof = field(default_factory=Kernel)
    grow: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class SumCongruence:
    """Two sums over one range are equal if their addends are.

    `letter` stands for the summation integer, and j for the rest of n: premises about n become premises about
    n = letter + j (less the offset of n in the range).
    """

    letter: str = "k"
    then: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class ZeroFromSquare:
    """A real scalar or vector is 0 if its square is 0."""

    then: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class NegationIntroduction:
    """a ≠ b: from a = b, the last premise of `then`, follows the equation that the premise denies."""

    premise: int
    then: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class SumOfSquares:
    """≥: the difference is this sum of squares of real scalars and vectors."""

    terms: tuple[str, ...]

    def __init__(self, *terms: str) -> None:
        object.__setattr__(self, "terms", terms)


@dataclass(frozen=True)
class TwoWitnesses:
    """Against ∃!: both witnesses satisfy the goal, and they are not equal."""

    first: Mapping[str, str]
    second: Mapping[str, str]
    firstly: Proof = field(default_factory=Kernel)
    secondly: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class At:
    """Against ∀: it fails for these values of the bound letters (numbers for integers)."""

    values: Mapping[str, str]
    then: Against


@dataclass(frozen=True)
class Part:
    """Against a conjunction: this part fails (an equivalence has two parts, the implication and its
    converse)."""

    number: int
    then: Against


@dataclass(frozen=True)
class Broken:
    """Against an implication: its premise holds, by `premise`, and its conclusion fails."""

    then: Against
    premise: Proof = field(default_factory=Kernel)


@dataclass(frozen=True)
class Impossible:
    """Against ∃: its body, the last premise, implies an equation that fails.

    The equation does not contain the bound letters, and fails for some values, or always, as 0 = 1 does.
    """

    then: Proof
    so: str = "0 = 1"


@dataclass(frozen=True)
class False_:
    """Against an equation: the judge of formulas finds values for which it fails."""


Proof = (
    Kernel
    | AndIntroduction
    | IffIntroduction
    | ExistsIntroduction
    | UniqueExists
    | Induction
    | Congruence
    | Cut
    | Introductions
    | ExistsElimination
    | UnitCircleAxiom
    | DerivativeAxiom
    | Cases
    | Extensionality
    | BinomialInduction
    | SumCongruence
    | ZeroFromSquare
    | NegationIntroduction
    | SumOfSquares
)
Against = TwoWitnesses | At | Part | Broken | Impossible | False_


@dataclass(frozen=True)
class Proven:
    """A proof of a claim's goal, or a refutation `against` it; or both: with its hypothesis, and without."""

    proof: Proof | None = None
    against: Against | None = None
