"""Letters with fonts, accents and scripts: the symbol, and the operations applied to it."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import TypeCode
from workbench.core.formula_errors import Fault, TypeMismatch, Unranged
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.terms import Identity, IllFormed, Symbol, Term, Zero
from workbench.core.types import CLOCK, PI, SCALAR, VECTOR, Declaration
from workbench.language.elaboration.letter_shapes import column, is_braced
from workbench.language.elaboration.meanings import EXPONENTIALS, Meaning, constant, meaning
from workbench.language.elaboration.operators.quotients import value_of
from workbench.language.elaboration.printed_sizes import size_below, sized_as_printed, sized_matrix
from workbench.language.elaboration.spelled import subscripted_norm, word_of
from workbench.language.elaboration.superscripts import (
    is_transpose,
    notated,
    raised,
    refuse_label,
    refuse_other_order,
    with_quotients,
)
from workbench.language.grammar.syntax import (
    Accented,
    Bracket,
    Group,
    Leaf,
    Node,
    Product,
    Scripted,
    Styled,
    both_below,
    core,
)
from workbench.language.naming.notations import Notation
from workbench.language.naming.scope import Scope
from workbench.language.naming.spelling import INDEX_LETTERS, Scripts, spell, under_accent

#: A term, and a superscript outside its accents that is still to be applied.
Lettered = tuple[Term, Node | None]


def named(scope: Scope, node: Node) -> Term:
    """Returns the term of a symbol with its accents and scripts."""
    term, sup, _ = letter(scope, node, Scripts(), None)
    return term if sup is None else raised(scope, term, sup)


def letter(
    scope: Scope, node: Node, scripts: Scripts, bracket: Bracket | None
) -> tuple[Term, Node | None, bool]:
    """Returns the symbol in the node, its remaining superscript, and whether it takes the bracket that
    follows.

    Scripts outside the accents belong to the symbol (in \\dot{x}_1 the index belongs to x). A function symbol
    takes the bracket.
    """
    lettering = _Lettering(scope, bracket)
    return *lettering.read(node, scripts, ()), lettering.takes_bracket


_WHOSE_RATE = (
    "the components of the rate, or the rate of the components?"
    ' [frames] rates = "resolved" says the former, "of components" the latter'
)


class _Lettering:
    def __init__(self, scope: Scope, bracket: Bracket | None) -> None:
        self.scope = scope
        self.bracket = bracket
        self.takes_bracket = False
        self.primes = 0  # number of primes that are marks of the paper
        self.below: Node | None = None  # a subscript that is a mark of the paper, still to be read

    def read(self, node: Node, scripts: Scripts, styles: tuple[str, ...]) -> Lettered:
        match node:
            case Leaf(kind="LETTER" | "MARK"):
                return self.symbol(node, styles, scripts)
            case Leaf(kind="NUMBER") if (figure := self.figure(node, scripts, styles)) is not None:
                return figure
            case Styled() if self.scope.table.notations.accents(node.style):
                return self.accented_by_the_paper(node, scripts, styles)
            case Styled():
                return self.read(node.body, scripts, (*styles, node.style))
            case Accented(accent="~") if (tilde := self.own_tilde(node, scripts, styles)) is not None:
                return tilde
            case Accented():
                return self.accented(node, scripts, styles)
            case Scripted(factorial=True):
                return self.factorial(node), scripts.sup
            case Scripted():
                return self.scripted(node, scripts, styles)
            case Group(parts=(Product(items=items),)) if word := word_of(self.scope, items, styles):
                return self.read(word, scripts, styles)
            case Group(parts=(part,)) if styles or isinstance(
                part, Leaf | Styled | Accented | Scripted | Group
            ):
                return self.read(part, scripts, styles)
            case Group(parts=(Product(items=(Scripted(nucleus=Group(parts=())) as left, body)),)):
                return self.read(body, replace(scripts, left_sub=left.sub, left_sup=left.sup), styles)
        if styles:
            if scripts != Scripts(sup=scripts.sup):
                raise Fault(SyntaxCode.SCRIPT_AT_MORE_THAN(styles=styles[-1]), node.at)
            return self.of_a_pair(node, styles), scripts.sup
        return self.expression(node, scripts)

    def figure(self, node: Leaf, scripts: Scripts, styles: tuple[str, ...]) -> Lettered | None:
        """A figure in a typeface, or a 0 with a subscript, that stands for a constant; None for a number."""
        if styles and (found := constant(self.scope.table, Name.styled(styles, node.text), scripts)):
            return self.meant(found, node, scripts), found.sup
        if styles and (sized := self.sized_sign(node, styles, scripts)):
            return sized, scripts.sup
        if node.text == "0" and (styles or scripts.sub is not None):
            return self.zero(scripts, node.at), scripts.sup
        return None

    def accented(self, node: Accented, scripts: Scripts, styles: tuple[str, ...]) -> Lettered:
        """The symbol under an accent, which takes the scripts, and the accent applied to it."""
        over_all = scripts.sup if is_braced(node.body) else None  # \widetilde{x + y}^T
        term, sup = self.read(node.body, scripts if over_all is None else scripts.without_sup(), styles)
        self.refuse_primed(node, scripts)
        is_left = scripts.left_sub is not None or scripts.left_sup is not None
        dotted = self.resolved_rate(node, term) if is_left else None
        return dotted or self.accent(node, term), sup if over_all is None else over_all

    def expression(self, node: Node, scripts: Scripts) -> Lettered:
        """A term that is no symbol, with the scripts that stand on it."""
        only = scripts.sub if scripts == Scripts(sub=scripts.sub, sup=scripts.sup) else None
        if only is not None and (norm := subscripted_norm(self.scope, node, only)) is not None:
            return norm, scripts.sup
        if scripts.left_sub is not None or scripts.left_sup is not None:
            raise Fault(SyntaxCode.SUBSCRIPT_ON_EXPRESSION(), node.at)
        if scripts.sup is not None and is_braced(node):
            raise Fault(SyntaxCode.BRACES_PRINT_NOTHING_WHAT(), node.at)
        entries = self.scope.table.notations.primes()
        if scripts.primes and not entries:
            raise Fault(SyntaxCode.PRIME_EXPRESSION(), node.at)
        for sup in dict.fromkeys((scripts.sup, None)):  # [x]_\\times, also under a superscript
            shape = Scripted(node.at, core(node), scripts.sub, sup)
            if scripts.primes == 0 and (spelt := self.scope.spelt(shape)) is not None:
                return spelt, scripts.sup if sup is None else None
        if (labelled := self.labelled(core(node), scripts)) is not None:
            return labelled
        if self.scope.table.notations.below(scripts.sub):
            term, self.below = self.scope.term(node), scripts.sub
        else:
            below = scripts.sub
            term = self.scope.term(node) if below is None else sized_matrix(self.scope, node, below)
        for _ in range(scripts.primes):
            term = notated(self.scope, node.at, entries, term, "the prime")
        return term, scripts.sup

    def labelled(self, node: Node, scripts: Scripts) -> Lettered | None:
        """Returns (x)_B, (x_1)_B and [C]_B, if x_B, {x_1}_B and C_B are symbols; else None."""
        match node:
            case Bracket(
                kind="(" | "[",
                parts=(
                    Leaf(kind="LETTER")
                    | Styled()
                    | Accented(accent="~")
                    | Scripted(sup=None, primes=0, factorial=False) as inner,
                ),
            ) if scripts.sub is not None:
                with suppress(Fault):
                    term, sup = self.read(inner, scripts, ())
                    symbols = term.symbols()
                    return (term, sup) if all(not each.index for each in symbols) else None
        return None

    def of_a_pair(self, node: Node, styles: tuple[str, ...]) -> Term:
        """Returns \\vec{AB}, which must be declared. Raises Fault."""
        pair = under_accent(node, styles)
        declared = None if pair is None else self.scope.table.symbols.get(pair.name)
        if declared is None:
            hint = "" if pair is None else f"; {pair.name} may be declared as one"
            raise Fault(SyntaxCode.MORE_THAN_ONE_SYMBOL(styles=styles[-1], hint=hint), node.at)
        return self.scope.build(node.at, construct.symbol, declared)

    def scripted(self, node: Scripted, outer: Scripts, styles: tuple[str, ...]) -> Lettered:
        if isinstance(node.nucleus, Bracket) and len(node.nucleus.parts) > 1 and is_transpose(node.sup):
            return column(self.scope, node.nucleus), outer.sup
        scripts = Scripts(
            outer.left_sub,
            outer.left_sup,
            both_below(node.sub, outer.sub),
            node.sup if node.sup is not None else outer.sup,
            node.primes + outer.primes,
        )
        term, sup = self.read(node.nucleus, scripts, styles)
        if self.below is not None:
            entries, at = self.scope.table.notations.below(self.below), self.below.at
            term, self.below = notated(self.scope, at, entries, term, "the subscript"), None
        if sup is not None and sup is node.sup:
            refuse_other_order(term, node.nucleus, sup)
            if not isinstance(node.nucleus, Bracket):
                refuse_label(term, sup)
        if node.sup is None:
            return term, sup
        return (term if sup is None else raised(self.scope, term, sup)), outer.sup

    def symbol(self, leaf: Leaf, styles: tuple[str, ...], scripts: Scripts) -> Lettered:
        """Returns the term of a letter; the superscript is part of the name if such a name exists."""
        scope = self.scope
        found = meaning(scope.table, scope.variables, leaf, styles, scripts, self.bracket is not None)
        if found is None and (term := self.of_what_is_below(leaf, styles, scripts)) is not None:
            return term, scripts.sup
        if found is None and (sized := self.sized_sign(leaf, styles, scripts)) is not None:
            return sized, scripts.sup
        if found is None and leaf.kind == "MARK":
            raise Fault(SyntaxCode.CANNOT_STAND_HERE(text=leaf.text), leaf.at)
        if found is None:
            raise self.unknown(Name.styled(styles, leaf.text), scripts, leaf.at)
        term = self.meant(found, leaf, scripts)
        self.primes = found.primes
        for _ in range(found.primes):
            term = notated(scope, leaf.at, scope.table.notations.primes(), term, "the prime")
        self.below = found.below
        return term, found.sup

    def of_what_is_below(self, leaf: Leaf, styles: tuple[str, ...], scripts: Scripts) -> Term | None:
        """Returns c_\\theta, if the paper defines the letter for an angle; None if the subscript is a
        label."""
        if scripts != Scripts(sub=scripts.sub, sup=scripts.sup) or scripts.sub is None:
            return None
        letter: Node = leaf
        for style in reversed(styles):
            letter = Styled(leaf.at, style, letter)
        entries = self.scope.table.notations.letters(letter)
        term = self.scope.term(scripts.sub) if entries else None
        if term is None or not any(isinstance(part, Symbol) for part in term.walk()):
            return None
        return notated(self.scope, leaf.at, entries, term, leaf.text)

    def meant(self, found: Meaning, leaf: Leaf, scripts: Scripts) -> Term:
        match found.what:
            case str() as variable:
                return self.scope.integer_variable(variable, leaf.at)
            case Declaration() as declaration if found.takes_bracket:
                return self.function(leaf, declaration, found.index)
            case Declaration() as declaration:
                return self.scope.build(leaf.at, construct.symbol, declaration, found.index)
            case Notation() as entry:
                return sized_as_printed(self.scope.term(entry.filled({})), scripts.sub, leaf.at)
        return self.built_in(found.what, scripts, leaf.at)

    def sized_sign(self, leaf: Leaf, styles: tuple[str, ...], scripts: Scripts) -> Term | None:
        """Returns E_{3×3}, if E is the paper's sign for a unit matrix or a zero of any size; else None."""
        if scripts != Scripts(sub=scripts.sub, sup=scripts.sup) or size_below(scripts.sub)[0] is None:
            return None
        letter = Name.styled(styles, leaf.text)
        if (spelling := spell(letter, scripts, ())) is not None and self.scope.table.find(spelling):
            return None
        found = constant(self.scope.table, letter, Scripts())
        term = None if found is None else self.meant(found, leaf, scripts)
        return term if isinstance(term, Zero | Identity) and term.printed else None

    def function(self, leaf: Leaf, declaration, index) -> Term:
        self.takes_bracket = True
        assert self.bracket is not None, "a function before its bracket"
        arguments = [self.scope.term(part) for part in self.bracket.parts]
        self.scope.build(leaf.at, self.scope.table.check_arguments, declaration, arguments)
        return self.scope.build(leaf.at, construct.symbol, declaration, index, arguments)

    def own_tilde(self, node: Accented, scripts: Scripts, styles: tuple[str, ...]) -> Lettered | None:
        """Returns \\tilde{x}, if that is a symbol; else None."""
        if "\\tilde" in styles or not self.scope.table.has_tildes:
            return None
        try:
            return self.read(node.body, scripts, (*styles, "\\tilde"))
        except Fault:
            return None

    def accented_by_the_paper(self, node: Styled, scripts: Scripts, styles: tuple[str, ...]) -> Lettered:
        """Returns \\hat{x}: the symbol of that name, or else the meaning of the accent in the paper."""
        try:
            return self.read(node.body, scripts, (*styles, node.style))
        except Fault as fault:
            if styles:
                raise
            try:
                term, sup = self.read(node.body, scripts, ())
            except Fault:
                raise fault from None
            self.refuse_primed(node, scripts)
            entries = self.scope.table.notations.accents(node.style)
            return notated(self.scope, node.at, entries, term, node.style), sup

    def refuse_primed(self, node: Node, scripts: Scripts) -> None:
        """Raises Fault for \\dot{x}': the mark ' may apply to x or to the accented term."""
        if scripts.primes and self.primes:
            raise Fault(SyntaxCode.FIRST_ACCENT_OR_PRIME(), node.at)

    def built_in(self, name: Name, scripts: Scripts, at: int) -> Term:
        """Returns a built-in: I, ε, D, t, π, e^x and C_n^k."""
        match name.base:
            case "\\mathbf{I}" | "\\underline{\\mathbf{I}}":
                return sized_as_printed(construct.identity(), scripts.sub, at)
            case "\\varepsilon":
                return construct.dual_unit()
            case "t":
                return construct.symbol(CLOCK)
            case "\\pi":
                return construct.symbol(PI)
            case "\\mathbf{D}":
                return construct.time_operator()
        if name in EXPONENTIALS:
            assert scripts.sup is not None, "no constant without its exponent"
            exponent = self.scope.term(with_quotients(scripts.sup))
            return self.scope.build(scripts.sup.at, value_of, self.scope, "exp", exponent)
        if self.scope.table.has_letter(name.base):
            what = "write the number of combinations as \\binom{n}{k}"
            raise Fault(SyntaxCode.LETTER_IS_SYMBOL(name=name, what=what), at)
        assert scripts.sub is not None and scripts.sup is not None, "C_n^k"
        return self.scope.combinations(scripts.sub, scripts.sup)

    def zero(self, scripts: Scripts, at: int) -> Term:
        """Returns the zero vector 𝟎 or the zero tensor 𝟎_{3×3}. Next to other terms 𝟎 takes their kind, and
        𝟎₃ the type of a column or of a square matrix."""
        if scripts.sub is not None and size_below(scripts.sub) in ((None, False), (SCALAR, True)):
            raise Fault(SyntaxCode.EXPECTED_SHAPE_ZERO_SUCH(), scripts.sub.at)
        return sized_as_printed(construct.zero(VECTOR), scripts.sub, at)

    def unknown(self, letter: Name, scripts: Scripts, at: int) -> Fault:
        """Returns the fault of an unknown name: an index without a range, or an undeclared symbol."""
        scope = self.scope
        for tried in (scripts, scripts.without_sup()):
            spelling = spell(letter, tried, INDEX_LETTERS | scope.variables)
            if spelling is not None and (found := scope.table.find(spelling)) is not None:
                letters = {name for place in spelling.places for name in place.variables}
                missing = sorted(letters - scope.variables)
                if not missing:
                    break
                message = SyntaxCode.INTEGER_WITHOUT_RANGE(
                    missing=", ".join(missing), spelling=spelling, first=missing[0]
                )
                members = scope.table.defined.members.get(found[0].name, ())
                is_free = not any(place.is_number or place.constant for each in members for place in each)
                return Unranged(missing[0], message, at) if is_free else Fault(message, at)
        spellings = (spell(letter, s, scope.variables) for s in (scripts, scripts.without_sup(), Scripts()))
        return Fault(scope.table.unknown(next(s for s in spellings if s is not None)), at)

    def resolved_rate(self, node: Accented, term: Term) -> Term | None:
        """Returns {}^F\\dot{x} if the paper says that it has the components of \\dot{x} in F; else None."""
        known = self.scope.table.frames.resolved
        if node.accent == "~" or not isinstance(term, Symbol) or term.declaration.name not in known:
            return None
        if (found := known[term.declaration.name]) is None:
            raise Fault(_WHOSE_RATE, node.at)
        to_frame, vector = found
        rate = self.scope.rate(node.at, vector, Linear(int(node.accent)), None)
        return self.scope.apply(node.at, "mul", to_frame, rate)

    def accent(self, node: Accented, term: Term) -> Term:
        if node.accent != "~":
            return self.scope.rate(node.at, term, Linear(int(node.accent)), None)
        if term.type.kind != "tensor":
            return self.scope.apply(node.at, "skew", term)
        intent = "the tilde over a whole product T x, \\widetilde{T x}"
        raise TypeMismatch(IllFormed(TypeCode.TENSOR_UNDER_TILDE(), intent), node.at)

    def factorial(self, node: Scripted) -> Term:
        argument = node.nucleus if node.sub is None else Scripted(node.at, node.nucleus, node.sub)
        if isinstance(argument, Bracket) and len(argument.parts) == 1:
            (argument,) = argument.parts
        if node.sup is not None or node.primes:
            raise Fault(SyntaxCode.FACTORIAL_WHAT_BRACKET(), node.at)
        return construct.counting("factorial", self.scope.integer(argument))
