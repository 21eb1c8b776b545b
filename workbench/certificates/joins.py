"""Goals as one theorem of Coq: the steps of their proof as lemmas, and each rule as what Coq is told to do with them.

A lemma is about any differential ring. Where it supposes nothing it is used for the smooth functions; else for
their values at the instant, which are a ring in which nothing changes (`Moment.v`). What a derivative stands
for is then a symbol of its own.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace

from workbench.certificates import nodes
from workbench.certificates.emitter import Emitter
from workbench.certificates.nodes import ATOM, KINDS, NotCertified, flag
from workbench.certificates.propositions import Speaker, binder, conditions, equal, relations, said, sides
from workbench.certificates.read_back import expression
from workbench.certificates.theorem import Theorem, theorem
from workbench.judge.theorems.goals import (
    All,
    AtLeast,
    Atom,
    Both,
    Exists,
    Goal,
    Iff,
    Implies,
    Scope,
    Variable,
    equations,
    read_goal,
)
from workbench.judge.theorems.members import read_members, same_letter
from workbench.judge.theorems.proofs import (
    ByLength,
    Cases,
    Contradicts,
    Each,
    Follows,
    Given,
    Have,
    Kernel,
    Pointwise,
    Proof,
    Squares,
    Unique,
    Use,
    Ways,
    Witness,
)
from workbench.judge.theorems.sequents import kind_of
from workbench.judge.theorems.substitution import Substitution
from workbench.language.construct import apply, identity, number, power, rebuild, relation, symbol, zero
from workbench.language.definitions import Definitions, expand
from workbench.language.reader import read_term
from workbench.language.terms import Apply, Derivative, Number, Relation, Symbol, Term, TimeOperator, Zero
from workbench.language.types import SCALAR, TENSOR, VECTOR, Declaration


@dataclass(frozen=True)
class Known:
    """A premise, and the proof of it in Coq."""

    goal: Goal
    proof: str


@dataclass(frozen=True)
class Alias:
    """A letter whose value at the instant is the term's; `proof` says so."""

    letter: Variable
    term: Term
    proof: str


@dataclass(frozen=True)
class Place:
    """Where a proof stands: what is to be shown, in what letters, from what."""

    goal: Goal
    scope: Scope
    known: tuple[Known, ...] = ()
    aliases: tuple[Alias, ...] = ()

    def of(self, goal: Goal) -> Place:
        return replace(self, goal=goal)

    def given(self, goal: Goal, proof: str) -> Place:
        return replace(self, known=(*self.known, Known(goal, proof)))


class Joiner:
    """Writes the proof of a goal; `lemmas` are its steps."""

    def __init__(self, speaker: Speaker) -> None:
        self.speaker = speaker
        self.lemmas: list[Theorem] = []
        self.lines: list[str] = []
        self.top, speaker.statement = speaker.statement, []
        self._binders = list(speaker.binders)
        self.at_instant: set[str] = set()  # names of lemmas that are used of an instant
        self._fresh = 0

    def tell(self, line: str) -> None:
        """What the texts before have defined is defined first."""
        for made in self.speaker.statement:
            if not made.startswith("let "):
                raise NotCertified("an inverse or an angle that the goal does not mention")
            name, meaning = made.removeprefix("let ").removesuffix(" in").split(" := ", 1)
            self.lines.append(f"pose ({name} := {meaning}).")
        self.speaker.statement.clear()
        if self.speaker.binders != self._binders:
            new = [n for n, _ in self.speaker.binders if n not in dict(self._binders)]
            raise NotCertified(f"a proof about {', '.join(new)}, of which the goal does not speak")
        self.lines.append(line)

    def fresh(self, stem: str) -> str:
        self._fresh += 1
        return f"{stem}_{self._fresh}"

    @contextmanager
    def part(self) -> Iterator[None]:
        self.tell("{")
        with self.speaker.within():
            yield
        self.tell("}")

    # the rules, as in judge.theorems.rules

    def show(self, at: Place, proof: Proof) -> None:
        match at.goal, proof:
            case goal, Given(then) if not isinstance(goal, All | Implies):
                self.show(at, then)
            case _, Have(text, by, then):
                lemma = read_goal(text, at.scope)
                name = self.fresh("have")
                self.tell(f"assert ({name} : {said(self.speaker, lemma)}).")
                with self.part():
                    self.show(at.of(lemma), by)
                self.show(at.given(lemma, name), then)
            case _, Cases(text, equal_, unequal):
                self._cases(at, text, equal_, unequal)
            case All(variables, body), _:
                names = [self._letter(v) for v in variables]
                self.tell(f"intros {' '.join([*names, *self._supposed(variables, names)])}.")
                self.show(replace(at, goal=body, scope=at.scope.with_variables(variables)), proof)
            case Implies(premise, conclusion, False), _:
                name = self.fresh("premise")
                self.tell(f"intros {name}.")
                self.show(at.given(premise, name).of(conclusion), proof)
            case Iff(left, right), _:
                ways = (proof.there, proof.back) if isinstance(proof, Ways) else (proof, proof)
                self.tell("split.")
                for premise, conclusion, own in ((left, right, ways[0]), (right, left, ways[1])):
                    name = self.fresh("premise")
                    with self.part():
                        self.tell(f"intros {name}.")
                        self.show(at.given(premise, name).of(conclusion), own)
            case Both(parts), Each(proofs) if len(parts) == len(proofs):
                self._each([(at.of(part), own) for part, own in zip(parts, proofs, strict=True)])
            case Both(parts), Kernel():
                self._each([(at.of(part), proof) for part in parts])
            case Exists(variables, body, False), Witness(members, then):
                place, made = self._valued(at, variables, members)
                self._offer(made)
                self.show(place.of(body), then)
            case Exists(variables, body, True), Unique():
                self._unique(at, variables, body, proof)
            case Atom(statement), Follows():
                self._follows(at, _one(statement), proof)
            case Atom(statement), Pointwise(letter, then):
                self._pointwise(at, _one(statement), letter, then)
            case Atom(Relation("=", left, Zero())), ByLength(then) if left.type in (SCALAR, VECTOR):
                self.tell(f"apply {'by_length' if left.type == VECTOR else 'by_scalar_length'}.")
                self.show(at.of(Atom(relation("=", power(left, 2), zero(SCALAR)))), then)
            case Atom(Relation("≠", left, right)), Contradicts(place, then):
                denied = at.known[place]
                inner = at.given(Atom(relation("=", left, right)), name := self.fresh("if_so"))
                self.tell(f"intros {name}. apply {denied.proof}.")
                one = _one(denied.goal.statement)
                self.show(inner.of(Atom(relation("=", one.left, one.right))), then)
            case Atom(statement), Each(proofs):
                said_ = list(equations(statement))
                self._each([(at.of(Atom(one)), own) for one, own in zip(said_, proofs, strict=True)])
            case Atom(statement), Kernel(using):
                self._each([(at.of(Atom(one)), using) for one in equations(statement)], self._kernel)
            case AtLeast(left, right), Squares((latex,)):
                term = at.scope.term(latex)
                if term.type != VECTOR:
                    raise NotCertified("a sum of squares")
                self.tell(f"apply (by_square now) with (u := {self.text(term)}).")
                self._prove(at, relation("=", left, apply("add", right, power(term, 2))), ())
            case goal, _:
                raise NotCertified(f"the rule {type(proof).__name__} for {kind_of(goal)}")

    def _each(self, parts: Sequence[tuple[Place, object]], show=None) -> None:
        show = show or self.show
        for number, (place, own) in enumerate(parts):
            if number < len(parts) - 1:
                self.tell("split.")
            if len(parts) == 1:
                show(place, own)
                return
            with self.part():
                show(place, own)

    def _kernel(self, at: Place, using: tuple[int, ...] | None) -> None:
        self._prove(at, _one(at.goal.statement), self._equations(at, using))

    def _cases(self, at: Place, text: str, equal_: Proof, unequal: Proof) -> None:
        one = _one(at.scope.statement(text))
        left, right = sides(self.speaker, one)
        name = self.fresh("case")
        self.tell(f"destruct (or_not now {left.at(ATOM)} {right.at(ATOM)}) as [{name} | {name}].")
        for sign, own in (("=", equal_), ("≠", unequal)):
            with self.part():
                self.show(at.given(Atom(relation(sign, one.left, one.right)), name), own)

    def _pointwise(self, at: Place, one: Relation, letter: str, then: Proof) -> None:
        variable = Variable(Declaration(letter, VECTOR.with_dual(one.left.type.dual), constant=True))
        vector = symbol(variable.declaration)
        name = self._letter(variable)
        rule, head, order = (
            ("by_vectors", "mul", 1) if one.left.type.kind == "tensor" else ("by_products", "dot", -1)
        )
        self.tell(f"apply ({rule} now). intros {name} {' '.join(self._supposed([variable], [name]))}.")
        made = [apply(head, *(side, vector)[::order]) for side in (one.left, one.right)]
        self.show(
            replace(at, goal=Atom(relation("=", *made)), scope=at.scope.with_variables([variable])), then
        )

    def _unique(self, at: Place, variables: Sequence[Variable], body: Goal, proof: Unique) -> None:
        place, made = self._valued(at, variables, proof.members)
        self._offer(made)
        self.tell("split.")
        with self.part():
            self.show(place.of(body), proof.exists)
        others = [self._letter(v, "'") for v in variables]
        holds = self.fresh("holds")
        self.tell(f"intros {' '.join([*others, *self._supposed(variables, others), holds])}.")
        same = [Atom(relation("=", symbol(a.letter.declaration), a.term)) for a in made]
        goal = same[0] if len(same) == 1 else Both(tuple(same))
        only = self.fresh("only")
        self.tell(f"enough ({only} : {said(self.speaker, goal)}).")
        agree = [
            f"(then_at now {p} (back_at now {a.proof}))"
            for a, (_, p) in zip(made, flattened(goal, only), strict=True)
        ]
        self.tell(f"{{ exact {_conj(agree)}. }}")
        inner = replace(at, goal=goal, scope=at.scope.with_variables(variables))
        self.show(replace(inner, known=(*at.known, Known(body, holds))), proof.only)

    # letters and their values

    def _letter(self, variable: Variable, suffix: str = "") -> str:
        name = self.speaker.letter(variable, suffix)
        for one, hypothesis in zip(
            conditions(variable, name), self._supposed([variable], [name]), strict=True
        ):
            self.speaker.known[one] = hypothesis
        binder(variable, name)
        return name

    def _supposed(self, variables: Sequence[Variable], names: Sequence[str]) -> list[str]:
        """The names of what is supposed of letters."""
        return [
            f"{name}_{one.split()[0]}"
            for v, name in zip(variables, names, strict=True)
            for one in conditions(v, name)
        ]

    def _valued(
        self, at: Place, variables: Sequence[Variable], members: dict[str, str]
    ) -> tuple[Place, list[Alias]]:
        """Letters that have the values of these members."""
        terms = read_members(at.scope, variables, members)
        made = []
        for variable, term in terms.items():
            made.append(self._alias(at, variable, term))
        return replace(at, aliases=(*at.aliases, *made)), made

    def _alias(self, at: Place, variable: Variable, term: Term) -> Alias:
        own = variable.declaration
        if not own.constant or own.type.kind not in KINDS:
            raise NotCertified("a witness that is a function of time")
        dual = own.type.dual
        value = self._node(term, dual)
        shown = []
        for one in _belongs(variable, term):
            name = self.fresh("member")
            self.tell(f"assert ({name} : {said(self.speaker, Atom(one))}).")
            with self.part():
                self._prove(at, one, self._equations(at, None))
            shown.append(name)
        name = self._letter(variable)
        known, holds = [f"{name}_constant"], f"{name}_is"
        lemma = "value"
        if own.rotation:
            lemma = "value_dual_rotation" if dual else "value_rotation"
            known.append(f"{name}_{'dual_' if dual else ''}rotation")
        elif own.unit:
            if dual:
                raise NotCertified("a dual unit vector as a witness")
            lemma = "value_unit"
            known.append(f"{name}_unit_vector")
        pattern = known[0] if len(known) == 1 else f"[{' '.join(known)}]"
        self.tell(f"destruct ({lemma} now {' '.join([value, *shown])}) as [{name} [{pattern} {holds}]].")
        return Alias(variable, term, holds)

    def _offer(self, made: Sequence[Alias]) -> None:
        names = [self.text(symbol(a.letter.declaration)) for a in made]
        self.tell(f"exists {', '.join(names)}.")
        for a, name in zip(made, names, strict=True):
            for hypothesis in self._supposed([a.letter], [name]):
                self.tell(f"split; [exact {hypothesis}|].")

    def _node(self, term: Term, dual: bool) -> str:
        """The term as an argument, of its type over the smooth functions."""
        node = self.speaker.term(term)
        node = nodes.embedded(node, node.dual or dual)
        if node.level == ATOM:
            return node.text
        return f"({node.text} : {node.type})"

    def text(self, term: Term) -> str:
        return self.speaker.term(term).at(ATOM)

    # equations

    def _equations(self, at: Place, using: tuple[int, ...] | None) -> list[tuple[Relation, str]]:
        """What may be supposed of equations, each with its proof."""
        found = []
        for place, known in enumerate(at.known):
            if using is None or place in using:
                with suppress(NotCertified):
                    found += flattened(known.goal, known.proof)
        return [(one, proof) for one, proof in found if one.operator == "="]

    def _prove(self, at: Place, one: Relation, given: Sequence[tuple[Relation, str]]) -> None:
        """The goal is this equation."""
        if one.operator != "=":
            raise NotCertified("an inequation to be shown by computing")
        used = [a for a in at.aliases if any(_has(a, side, at) for side in (one.left, one.right))]
        if given:
            also = [
                a
                for a in at.aliases
                if a in used or any(_has(a, s, at) for r, _ in given for s in (r.left, r.right))
            ]
            self._by_lemma(at, one, [*given, *map(_as_given, also)])
            return
        left, right = (self._unaliased(at, side) for side in (one.left, one.right))
        if not used:
            self._by_lemma(at, one, ())
            return
        dual = one.left.type.dual or one.right.type.dual
        self.tell(
            f"refine (then_at now (y := {self._node(left, dual)}) _ (then_at now (y := {self._node(right, dual)}) _ _))."
        )
        for new in (
            relation("=", one.left, left),
            relation("=", left, right),
            relation("=", right, one.right),
        ):
            with self.part():
                if new.left == left and new.right == right:
                    self._by_lemma(at, new, ())
                else:
                    self._by_lemma(at, new, [_as_given(a) for a in used], plain=True)

    def _unaliased(self, at: Place, term: Term) -> Term:
        for alias in reversed(at.aliases):
            term = Substitution({alias.letter: alias.term}, at.scope.definitions).term(term)
        return term

    def _by_lemma(
        self, at: Place, one: Relation, given: Sequence[tuple[Relation, str]], plain: bool = False
    ) -> None:
        """plain: whatever the symbols are."""
        if one.left == one.right:
            self.tell("exact (same_at now _).")
            return
        if not given and not any(_only_now(side) for side in (one.left, one.right)):
            lemma, stand = self._step(at, one, ()), {}
            self.tell(
                f"exact (always now ({lemma.name} {' '.join(['K', *self._arguments(lemma, stand, [], False)])}))."
            )
            return
        bare, stand = without_derivatives([one, *(r for r, _ in given)], at.scope.definitions, plain)
        lemma = self._step(at, bare[0], bare[1:])
        arguments = self._arguments(lemma, stand, [proof for _, proof in given], True)
        self.tell(f"refine ({lemma.name}_now K (at_instant now) {' '.join(arguments)}); nonzero.")
        self.at_instant.add(lemma.name)

    def _step(self, at: Place, one: Relation, premises: Sequence[Relation]) -> Theorem:
        """The lemma that says so."""
        lemma = theorem(f"step_{len(self.lemmas) + 1}", one, premises, at.scope.definitions)
        same = next((x for x in self.lemmas if x.text == lemma.text.replace(lemma.name, x.name)), None)
        if same is None:
            self.lemmas.append(lemma)
        return same or lemma

    def _arguments(self, lemma: Theorem, stand: dict[Term, Term], proofs: list[str], now: bool) -> list[str]:
        """What the lemma is about here, and the proofs of what it supposes."""
        own, speaker, given = lemma.emitter, self.speaker, []
        for name, type_ in own.binders:
            if name not in own.holes:
                term = own.read_back.get(name)
                if term is None:
                    raise NotCertified("an equation of operators")
                given.append(self._node(_restored(term, stand), type_.startswith("dual_")))
                continue
            what, _, of = type_.rpartition(" ")
            known = speaker.known.get(f"{what} {speaker.term(_restored(own.read_back[of], stand)).at(ATOM)}")
            if known is None:
                raise NotCertified(f"what is not known to be a {what.split()[0]}")
            given.append(known)
        for name, text in _premises(own):
            if text.startswith("turn "):
                given.append(self._turning(own.read_back[text.split()[-1]].arguments[0], stand, now))
            elif text.startswith("reciprocal "):
                given.append("(over_is now _ _)")
            elif name.startswith("length"):
                given.append("(length_is now _)")
            elif proofs:
                given.append(proofs.pop(0))
            else:
                raise NotCertified("a premise of a step that nothing shows")
        return given

    def _turning(self, angle: Term, stand: dict[Term, Term], now: bool) -> str:
        """That cosine and sine are such."""
        angle = _restored(angle, stand)
        cosine = self.text(Apply(angle.type, None, "cos", (angle,)))
        if cosine.startswith("(cosine_of"):
            return f"(turn_of now {self.text(angle)})"
        names = (n for n in self.speaker.introduced if n in self.speaker.holes)
        lines = zip(names, (x for x in self.top if x.endswith("->")), strict=False)
        known = next((name for name, line in lines if f" {cosine} " in line), None)
        if known is None:
            raise NotCertified("an angle that the goal does not mention")
        return f"(turned_now K (at_instant now) _ _ _ {known})" if now else known

    # an equation from premises

    def _follows(self, at: Place, one: Relation, proof: Follows) -> None:
        lefts, rights, shown = {}, {}, []
        for letter, use in proof.uses.items():
            at, said_, known = self._instance(at, use)
            kind = said_.left.type.with_dual(said_.left.type.dual or said_.right.type.dual)
            variable = Variable(Declaration(letter, kind))
            lefts[variable], rights[variable] = said_.left, said_.right
            shown.append((variable, said_, known))
        scope = at.scope.with_variables(lefts)
        image = read_term(proof.expression, scope.table, at.scope.integers)
        first, last = (Substitution(x, scope.definitions)._term(image, False) for x in (lefts, rights))
        dual = one.left.type.dual or one.right.type.dual or first.type.dual or last.type.dual
        self.tell(
            f"refine (then_at now (y := {self._node(first, dual)}) _ (then_at now (y := {self._node(last, dual)}) _ _))."
        )
        with self.part():
            self._real(relation("=", one.left, first), dual)
            self._prove(at, relation("=", one.left, first), ())
        with self.part():
            self._real(relation("=", first, last), dual)
            self._alike(at, image, shown)
        with self.part():
            self._real(relation("=", last, one.right), dual)
            self._prove(at, relation("=", last, one.right), ())

    def _real(self, one: Relation, dual: bool) -> None:
        """An equation of real quantities among dual ones."""
        if dual and not (one.left.type.dual or one.right.type.dual):
            x, y = (self._node(side, False) for side in (one.left, one.right))
            self.tell(f"refine (embedded_at now (x := {x}) (y := {y}) _).")

    def _alike(self, at: Place, image: Term, shown: Sequence[tuple[Variable, Relation, str]]) -> None:
        """The same expression of what is equal."""
        if isinstance(image, Symbol) and len(shown) == 1:
            self.tell(f"exact {shown[0][2]}.")
            return
        scope = at.scope.definitions
        there = {v: Variable(replace(v.declaration, name=f"{v.name}\\_there")) for v, _, _ in shown}
        ends = []
        for variables, side in ((dict(zip(there, there, strict=True)), "left"), (there, "right")):
            for v, said_, _ in shown:
                node = self._node(getattr(said_, side), v.declaration.type.dual)
                self.speaker.call(symbol(variables[v].declaration), node)
            ends.append(
                Substitution({v: symbol(w.declaration) for v, w in variables.items()}, scope)._term(
                    image, False
                )
            )
        given = [
            (relation("=", symbol(v.declaration), symbol(there[v].declaration)), known)
            for v, _, known in shown
        ]
        pairs = [(v, side) for v, said_, _ in shown for side in (said_.left, said_.right)]
        if all(v.declaration.type.dual == side.type.dual and not isinstance(side, Zero) for v, side in pairs):
            self._by_lemma(at, relation("=", *ends), given, plain=True)
            return
        # a real quantity stands for a dual one, or a 0, of which the judge leaves nothing
        dual = any(end.type.dual for end in ends)
        before, after = (
            [
                (
                    relation(
                        "=",
                        symbol(there[v].declaration if side == "right" else v.declaration),
                        getattr(r, side),
                    ),
                    _same(v),
                )
                for v, r, _ in shown
            ]
            for side in ("left", "right")
        )
        first, last = (
            Substitution({v: getattr(r, side) for v, r, _ in shown}, scope)._term(image, False)
            for side in ("left", "right")
        )
        middle = " ".join(f"(then_at now (y := {self._node(end, dual)}) _" for end in ends)
        self.tell(f"refine {middle} _)).")
        for new, known in (
            (relation("=", first, ends[0]), before),
            (relation("=", *ends), given),
            (relation("=", ends[1], last), after),
        ):
            with self.part():
                self._by_lemma(at, new, known, plain=True)

    def _instance(self, at: Place, use: Use) -> tuple[Place, Relation, str]:
        """The equation that a premise says for these values, and its proof."""
        known = at.known[use.premise]
        goal, proof, given = known.goal, known.proof, dict(use.at)
        while not isinstance(goal, Atom):
            match goal:
                case All(variables, body):
                    taken = {
                        k: given.pop(k) for k in list(given) if any(same_letter(k, v.name) for v in variables)
                    }
                    terms = read_members(at.scope, variables, taken)
                    new, said_ = {}, []
                    for variable, term in terms.items():
                        at, new[variable] = self._member(at, variable, term)
                        name = self._node(new[variable], variable.declaration.type.dual)
                        said_.append(name)
                    for variable, name in zip(variables, list(said_), strict=True):
                        for one in conditions(variable, name):
                            if one not in self.speaker.known:
                                raise NotCertified("an instance that is not known to be in its set")
                            said_.append(self.speaker.known[one])
                    proof = f"({' '.join([proof, *said_])})"
                    goal = Substitution(new, at.scope.definitions).goal(body)
                case Implies(premise, conclusion, False):
                    same = next((k.proof for k in at.known if k.goal == premise), None)
                    if same is None:
                        same = self.fresh("met")
                        self.tell(f"assert ({same} : {said(self.speaker, premise)}).")
                        with self.part():
                            self.show(at.of(premise), Kernel())
                    goal, proof = conclusion, f"({proof} {same})"
                case Both():
                    break
                case _:
                    raise NotCertified(f"{kind_of(goal)} in a premise")
        found = flattened(goal, proof)
        one, proof = found[use.part] if len(found) > 1 else found[0]
        if use.back:
            return at, relation("=", one.right, one.left), f"(back_at now {proof})"
        return at, one, proof

    def _member(self, at: Place, variable: Variable, term: Term) -> tuple[Place, Term]:
        """The term, or a letter with its value if a constant is asked for and the term is none."""
        if not variable.declaration.constant:
            return at, term
        if isinstance(term, Symbol) and all(
            c in self.speaker.known for c in conditions(variable, self.text(term))
        ):
            return at, term
        own = Variable(
            replace(variable.declaration, name=f"{variable.name}_{{{self.fresh('at').partition('_')[2]}}}")
        )
        alias = self._alias(at, own, term)
        return replace(at, aliases=(*at.aliases, alias)), symbol(own.declaration)


# what needs no state


def flattened(goal: Goal, proof: str) -> list[tuple[Relation, str]]:
    """The equations and inequations of a conjunction, each with its proof."""
    match goal:
        case Atom(statement):
            parts: list = list(relations(statement))
            return [(one, _projected(proof, i, len(parts))) for i, one in enumerate(parts)]
        case Both(parts):
            return [
                pair
                for i, part in enumerate(parts)
                for pair in flattened(part, _projected(proof, i, len(parts)))
            ]
    raise NotCertified(f"{kind_of(goal)} among equations")


def _projected(proof: str, place: int, count: int) -> str:
    for _ in range(place):
        proof = f"(proj2 {proof})"
    return f"(proj1 {proof})" if place < count - 1 else proof


def _conj(proofs: Sequence[str]) -> str:
    first, *rest = proofs
    return f"(conj {first} {_conj(rest)})" if rest else first


def _same(variable: Variable) -> str:
    own = variable.declaration.type
    return f"(@same_at now {flag(own.dual)} {KINDS[own.kind]} _)"


def _one(statement) -> Relation:
    (one,) = relations(statement)
    return one


def _has(alias: Alias, term: Term, at: Place) -> bool:
    letter = symbol(alias.letter.declaration)
    return any(part == letter for part in expand(term, at.scope.definitions).walk())


def _as_given(alias: Alias) -> tuple[Relation, str]:
    return relation("=", symbol(alias.letter.declaration), alias.term), alias.proof


def at_an_instant(lemma: Theorem) -> str:
    """The lemma for what agrees in some respect: its premises and its conclusion are that they agree."""
    own = lemma.emitter
    binders = " ".join(f"({name} : {type_})" for name, type_ in own.binders)
    lines = [_agreeing(line) for line in own.statement]
    given = []
    for name, type_ in own.binders:
        if name not in own.holes:
            given.append(name)
            continue
        word = ("dual_" if "(d := true)" in type_ else "") + type_.split()[0]
        given.append(f"({word}_now K agreed {'_ _' if 'constant' in word else f'_ {name}'})")
    (said_,) = lemma.conclusions
    return "\n  ".join(
        [
            f"Theorem {lemma.name}_now (K : diff_ring) (agreed : agreement K) {binders} :",
            *lines,
            f"{_agreeing(said_)}.",
            f"Proof. vm_cast_no_check (@{lemma.name} (still agreed) {' '.join(given)}). Qed.\n",
        ]
    )


def _agreeing(line: str) -> str:
    if line.startswith("let "):
        return line
    if line.startswith(("turn ", "reciprocal ")):
        word, _, rest = line.partition(" ")
        return f"@{word} (still agreed) {rest}"
    text, arrow = line.removesuffix(" ->"), " ->" if line.endswith(" ->") else ""
    dual = "(d := true) " if "≡ε" in text else ""
    both = " ".join(expression(side).at(0) for side in re.split(r" (?:≡ε|≡) ", text))
    return f"equal_in agreed {dual}{both}{arrow}"


def _premises(own: Emitter) -> Iterator[tuple[str, str]]:
    """The names and the texts of what is supposed before the conclusion."""
    texts = [line.removesuffix(" ->") for line in own.statement if line.endswith("->")]
    return zip((n for n in own.introduced if n in own.holes), texts, strict=True)


def _only_now(term: Term) -> bool:
    """Whether it has words that are about the instant."""
    return any(
        isinstance(part, Apply)
        and (
            part.head in ("norm", "reciprocal")
            or (part.head == "div" and not isinstance(part.arguments[1], Number))
            or (
                part.head in ("cos", "sin")
                and part.arguments[0].type.kind == "scalar"
                and getattr(part.arguments[0], "declaration", None) is not None
                and part.arguments[0].declaration.constant
            )
        )
        for part in term.walk()
    )


def _belongs(variable: Variable, term: Term) -> list[Relation]:
    own, said_ = variable.declaration, []
    if own.rotation:
        said_.append(relation("=", apply("mul", term, apply("transpose", term)), identity(TENSOR)))
        said_.append(relation("=", apply("det", term), number(1)))
    if own.unit:
        said_.append(relation("=", apply("dot", term, term), number(1)))
    return said_


def without_derivatives(
    said_: Sequence[Relation], definitions: Definitions, plain: bool
) -> tuple[list[Relation], dict[Term, Term]]:
    """The equations with a symbol for each derivative, or a plain one for each symbol, too; and what these
    stand for."""
    stand: dict[Term, Term] = {}

    def other(term: Term, declaration: Declaration) -> Term:
        known = next((s for s, t in stand.items() if t == term), None)
        if known is None:
            known = symbol(declaration)
            stand[known] = term
        return known

    def bare(term: Term) -> Term:
        if isinstance(term, TimeOperator):
            raise NotCertified("an operator at an instant")
        if isinstance(term, Derivative) or (plain and _special(term)):
            return other(term, Declaration(f"q_{len(stand) + 1}", term.type))
        if isinstance(term, Symbol) and term.declaration.constant:
            return other(term, replace(term.declaration, name=f"c_{len(stand) + 1}", constant=False))
        if isinstance(term, Symbol):
            body = definitions.lookup(term)
            new = None if body is None else bare(body)
            return term if new == body else new
        return rebuild(term, [bare(c) for c in term.children]) if term.children else term

    return [relation(r.operator, bare(r.left), bare(r.right)) for r in said_], stand


def _restored(term: Term, stand: dict[Term, Term]) -> Term:
    if term in stand:
        return stand[term]
    if isinstance(term, Apply):
        return replace(term, arguments=tuple(_restored(c, stand) for c in term.arguments))
    return rebuild(term, [_restored(c, stand) for c in term.children]) if term.children else term


def _special(term: Term) -> bool:
    """What is more than any quantity of its kind, or comes with premises of its own."""
    if isinstance(term, Apply) and term.head in ("cos", "sin", "exp"):
        return True
    own = term.declaration if isinstance(term, Symbol) else None
    return own is not None and (own.rotation or own.unit or own.constant)
