"""Change of frame: cancels rotations with their transposes and moves rotations out of isotropic functions.

    R Rᵀ = Rᵀ R = I    R⁻¹ = adj R = Rᵀ    det R = 1    (A B)ᵀ = Bᵀ Aᵀ    (A B)⁻¹ = B⁻¹ A⁻¹
    adj (A B) = adj B adj A    det (A B) = det A det B    tr (R A Rᵀ) = tr A    vect (R A Rᵀ) = R vect A
    (R x)~ = R x̃ Rᵀ    R a · R b = a · b    R a × R b = R (a × b)    R a ⊗ R b = R (a ⊗ b) Rᵀ    ‖R a‖ = ‖a‖

for free rotations R, real or dual, and any A, B, a, b. Each law holds wherever either side is defined. A
relation is therefore true, false or undefined exactly where the rewritten one is: only rotations are
cancelled.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce as fold

from workbench.core.construct import apply, identity, number, relation, with_children
from workbench.core.terms import Apply, Head, Identity, Power, Relation, Symbol, Term
from workbench.engines.inventory import Lookup

#: Least degree of a side for which the rewriting pays.
DEAR = 8

Word = list[Term]  # factors of a product of tensors; the last one may be a vector


def in_rotated_frame(judged: Relation, definitions: Lookup) -> Relation | None:
    """Returns the relation rewritten by the rules, without rotations that both sides begin or end with.

    Returns None if nothing changes or the rewriting does not pay.
    """
    frame = _Frame(definitions)
    if judged.operator != "=" or max(map(frame.degree, (judged.left, judged.right))) < DEAR:
        return None
    left, right = frame.word(judged.left), frame.word(judged.right)
    while left and right and left[0] == right[0] and frame.turns(left[0]):
        left, right = left[1:], right[1:]
    while left and right and left[-1] == right[-1] and frame.turns(left[-1]):
        left, right = left[:-1], right[:-1]
    rewritten = relation("=", _product(left, judged.left), _product(right, judged.right))
    return None if rewritten == judged else rewritten


class _Frame:
    def __init__(self, definitions: Lookup) -> None:
        self._definitions = definitions
        self._degrees: dict[Term, int] = {}
        self._words: dict[Term, Word] = {}

    def turns(self, letter: Term) -> bool:
        """True if the letter is a free rotation or the transpose of one."""
        if isinstance(letter, Apply) and letter.head == "transpose":
            letter = letter.arguments[0]
        return (
            isinstance(letter, Symbol)
            and letter.declaration.rotation
            and self._definitions.lookup(letter) is None
        )

    def degree(self, term: Term) -> int:
        """Returns the degree in the indeterminates; an entry of a rotation has the degree 2."""
        if term not in self._degrees:
            self._degrees[term] = self._degree(term)
        return self._degrees[term]

    def _degree(self, term: Term) -> int:
        inner = [self.degree(child) for child in term.children]
        match term:
            case Symbol():
                return 2 if self.turns(term) else 1
            case Power() if term.exponent.is_number:
                return int(term.exponent) * inner[0]
            case Apply(head="inverse" | "det" | "adjugate", arguments=(body,)) if body.type.kind == "tensor":
                return (2 if term.head == "adjugate" else 3) * inner[0] * (2 if body.type.dual else 1)
            case Apply(head="add"):
                return max(inner)
        return sum(inner)

    def word(self, term: Term) -> Word:
        """Returns the factors of a tensor or vector, with rotations moved outwards; a single factor for other
        terms."""
        if term not in self._words:
            self._words[term] = self._word(term)
        return self._words[term]

    def _word(self, term: Term) -> Word:
        if term.type.kind not in ("tensor", "vector"):
            return [self._other(term)]
        match term:
            case Identity():
                return []
            case Power() if term.exponent.is_number and int(term.exponent) > 0 and term.type.kind == "tensor":
                return self._reduced(self.word(term.base) * int(term.exponent))
            case Apply(head="mul", arguments=(left, right)) if left.type.kind == "scalar":
                return self._around(lambda core: apply("mul", self.simple(left), core), self.word(right))
            case Apply(head="mul", arguments=(left, right)) if right.type.kind == "scalar":
                return self._around(lambda core: apply("mul", core, self.simple(right)), self.word(left))
            case Apply(head="mul", arguments=(left, right)) if left.type.kind == "tensor":
                return self._reduced([*self.word(left), *self.word(right)])
            case Apply(head="neg", arguments=(body,)):
                return self._around(lambda core: apply("neg", core), self.word(body))
            case Apply(head="transpose" | "inverse" | "adjugate", arguments=(body,)):
                return [self._flipped(term.head, letter) for letter in reversed(self.word(body))]
            case Apply(head="skew", arguments=(body,)):
                out, core = self._out(self.word(body))
                return [*out, apply("skew", core), *self._back(out)]
            case Apply(head="vect" | "symmetric" | "antisymmetric", arguments=(body,)):
                out, core = self._out_of_both(self.word(body), body)
                back = [] if term.head == "vect" else self._back(out)
                return [*out, apply(term.head, core), *back]
            case Apply(head="cross" | "outer", arguments=(left, right)):
                out, cores = self._shared([self.word(left), self.word(right)])
                back = self._back(out) if term.head == "outer" else []
                return [*out, apply(term.head, *cores), *back]
        return [self._other(term)]

    def simple(self, term: Term) -> Term:
        return _product(self.word(term), term)

    def _other(self, term: Term) -> Term:
        match term:
            case Apply(head="det", arguments=(body,)):
                factors = [apply("det", letter) for letter in self.word(body) if not self.turns(letter)]
                return fold(lambda a, b: apply("mul", a, b), factors) if factors else number(1)
            case Apply(head="trace", arguments=(body,)) if body.type.kind == "tensor":
                return apply("trace", self._out_of_both(self.word(body), body)[1])
            case Apply(head="dot" | "triple" | "norm", arguments=arguments):
                return apply(term.head, *self._shared([self.word(a) for a in arguments])[1])
        return with_children(term, self.simple)

    def _reduced(self, word: Word) -> Word:
        """Returns the word without adjacent rotations and their transposes."""
        kept: Word = []
        for letter in word:
            if kept and self._undo(kept[-1], letter):
                kept.pop()
            else:
                kept.append(letter)
        return kept

    def _undo(self, a: Term, b: Term) -> bool:
        return self.turns(a) and self._flipped("transpose", a) == b

    def _flipped(self, head: Head, letter: Term) -> Term:
        """Returns the transpose, inverse or adjugate of a letter."""
        head = "transpose" if self.turns(letter) else head
        if head == "transpose" and isinstance(letter, Apply) and letter.head == "transpose":
            return letter.arguments[0]
        return apply(head, letter)

    def _back(self, out: Sequence[Term]) -> Word:
        return [self._flipped("transpose", letter) for letter in reversed(out)]

    def _out(self, word: Word) -> tuple[Word, Term]:
        """Returns the rotations in front of a vector, and the vector that they rotate."""
        place = 0
        while place < len(word) - 1 and self.turns(word[place]):
            place += 1
        return word[:place], _product(word[place:], word[-1])

    def _out_of_both(self, word: Word, tensor: Term) -> tuple[Word, Term]:
        """Returns Q and A of Q A Qᵀ, where Q is a product of rotations."""
        place = 0
        while 2 * place + 1 < len(word) and self._undo(word[place], word[-1 - place]):
            place += 1
        return word[:place], _product(word[place : len(word) - place], tensor)

    def _around(self, function: Callable[[Term], Term], word: Word) -> Word:
        """Returns a linear function applied to the part between the rotations at both ends."""
        first, last = 0, len(word)
        while first < last - 1 and self.turns(word[first]):
            first += 1
        while last > first + 1 and self.turns(word[last - 1]):
            last -= 1
        core = function(_product(word[first:last], identity()))
        return [*word[:first], core, *word[last:]]

    def _shared(self, words: list[Word]) -> tuple[Word, list[Term]]:
        """Returns the rotations that all vectors begin with, and the vectors without them."""
        place = 0
        while all(len(w) > place + 1 and w[place] == words[0][place] for w in words):
            if not self.turns(words[0][place]):
                break
            place += 1
        return words[0][:place], [_product(word[place:], word[-1]) for word in words]


def _product(word: Word, like: Term) -> Term:
    """Returns the product of the letters; for an empty word the unit tensor of the size of `like`."""
    if not word:
        return identity(like.type, printed=str(like.type.rows))
    return fold(lambda a, b: apply("mul", a, b), word)
