"""Equations of a goal: proved by a lemma, for letters with the values of terms."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace

from workbench.certificates.emission.emitted_nodes import ATOM, KINDS, NotCertified
from workbench.certificates.goals.instant_rates import spread
from workbench.certificates.goals.lemmas import only_now, restored, without_derivatives
from workbench.certificates.goals.proof_positions import Alias, Place, as_given, belongs, flattened, has
from workbench.certificates.goals.propositions import said
from workbench.certificates.goals.script import Script
from workbench.certificates.theorem import Theorem, theorem_for_all
from workbench.certificates.values.trial import can_be_certified
from workbench.core.construct import symbol
from workbench.core.integer_expressions import Linear
from workbench.core.terms import Apply, Derivative, Relation, Symbol, Term, TimeOperator
from workbench.language.definitions import expand
from workbench.language.goals.goals import Atom, Variable
from workbench.language.goals.proofs import AndIntroduction, Kernel, Proof
from workbench.prover.goals.named_members import read_members
from workbench.prover.goals.substitution import Substitution


class Equations(Script):
    """Writes the proofs of equations."""

    def show(self, at: Place, proof: Proof) -> None:
        raise NotImplementedError

    def _equations(self, at: Place, using: tuple[int, ...] | None) -> list[tuple[Relation, str]]:
        """Returns the equations that may be used as premises, each with its proof."""
        found = []
        for index, known in enumerate(at.known):
            if using is None or index in using:
                with suppress(NotCertified):
                    found += flattened(known.goal, known.proof)
        return [(one, proof) for one, proof in found if one.operator == "="]

    def _prove(self, at: Place, one: Relation, given: Sequence[tuple[Relation, str]]) -> None:
        """Proves an equation."""
        if one.operator != "=":
            raise NotCertified("an inequation to be shown by computing")
        used = [a for a in at.aliases if any(has(a, side, at) for side in (one.left, one.right))]
        if given and not at.aliases and self._moves(at, one, given):
            self._by_rates(at, one, given)
            return
        if given:
            also = [
                a
                for a in at.aliases
                if a in used or any(has(a, s, at) for r, _ in given for s in (r.left, r.right))
            ]
            self._by_lemma(at, one, [*given, *map(as_given, also)])
            return
        left, right = (self._unaliased(at, side) for side in (one.left, one.right))
        if not used:
            self._by_lemma(at, one, ())
            return
        for new in self.by_way_of(one, left, right):
            if new.left == left and new.right == right:
                self._by_lemma(at, new, ())
            else:
                self._by_lemma(at, new, [as_given(a) for a in used], plain=True)

    def _moves(self, at: Place, one: Relation, given: Sequence[tuple[Relation, str]]) -> bool:
        """True if the equation differentiates an expression in a free symbol that has a premise."""
        free = {p for r, _ in given for p in (r.left, r.right) if isinstance(p, Symbol)}
        full = (expand(side, at.scope.definitions) for side in (one.left, one.right))
        parts = (p for side in full for p in side.walk())
        return any(
            isinstance(p, TimeOperator)
            or (isinstance(p, Derivative) and p.body not in free and bool(free.intersection(p.body.walk())))
            for p in parts
        )

    def _by_rates(self, at: Place, one: Relation, given: Sequence[tuple[Relation, str]]) -> None:
        """Proves an equation by derivatives of free symbols, which have independent values at the instant."""
        left, right = (spread(side, at.scope.definitions) for side in (one.left, one.right))
        for new, known in zip(self.by_way_of(one, left, right), ((), given, ()), strict=True):
            self._by_lemma(at, new, known)

    def _unaliased(self, at: Place, term: Term) -> Term:
        for alias in reversed(at.aliases):
            term = Substitution({alias.letter: alias.term}, at.scope.definitions).term(term)
        return term

    def _by_lemma(
        self, at: Place, one: Relation, given: Sequence[tuple[Relation, str]], plain: bool = False
    ) -> None:
        """Proves an equation by a lemma. plain: for arbitrary values of the symbols."""
        if one.left == one.right:
            self.tell("exact (same_at now _).")
            return
        if not given and not any(only_now(side) for side in (one.left, one.right)):
            self._always(at, one, (), {})
            return
        bare, stand = without_derivatives([one, *(r for r, _ in given)], at.scope.definitions, plain)
        lemma = self._step(at, bare[0], bare[1:])
        arguments = self._arguments(lemma, stand, [proof for _, proof in given], True)
        self.tell(f"refine ({lemma.name}_now K (at_instant now) {' '.join(arguments)}); nonzero.")
        self.at_instant.add(lemma.name)

    def _always(
        self, at: Place, one: Relation, given: Sequence[tuple[Relation, str]], stand: dict[Term, Term]
    ) -> None:
        """Proves an equation at all times from premises at all times, which may be differentiated."""
        lemma = self._step(at, one, [r for r, _ in given], lasting=True)
        proofs = [f"(throughout (fun now => {proof}))" for _, proof in given]
        use = " ".join([lemma.name, "K", *self._arguments(lemma, stand, proofs, False)])
        self.tell(f"exact (always now ({use})).")

    def _step(self, at: Place, one: Relation, premises: Sequence[Relation], lasting: bool = False) -> Theorem:
        """Returns the lemma for an equation."""
        lemma = theorem_for_all(f"step_{len(self.lemmas) + 1}", one, premises, at.scope, lasting)
        if not can_be_certified(lemma):
            raise NotCertified("a sum, or a derivative of order n, of which the library knows too little")
        same = next((x for x in self.lemmas if x.text == lemma.text.replace(lemma.name, x.name)), None)
        if same is None:
            self.lemmas.append(lemma)
        return same or lemma

    def _arguments(self, lemma: Theorem, stand: dict[Term, Term], proofs: list[str], now: bool) -> list[str]:
        """Returns the arguments of the lemma, and the proofs of its premises."""
        own, speaker = lemma.emitter, self.speaker
        families = {name: speaker.families.get(declaration) for declaration, name in own.families.items()}
        given = [
            self.number(
                lemma.stands[variable].substitute({variable: 0}) * -1
                + Linear.variable(variable)
                - (variable in own.positive)
            )
            for variable in own.integers
        ]
        for name, type_ in own.binders:
            family, _, member = name.rpartition("_")
            if name in families or type_.startswith("forall "):
                known = families[name] if name in families else families[family]
                if known is None:
                    raise NotCertified("a family of which the goal does not speak")
                given.append(known if name in families else f"{known}_{member}")
                continue
            if name not in own.holes:
                term = own.read_back.get(name)
                if term is None:
                    raise NotCertified("an equation of operators")
                given.append(self._node(restored(term, stand), type_.startswith("dual_")))
                continue
            what, _, of = type_.rpartition(" ")
            known = self.known_to_be(f"{what} {speaker.term(restored(own.read_back[of], stand)).at(ATOM)}")
            if known is None:
                raise NotCertified(f"what is not known to be a {what.split()[0]}")
            given.append(known)
        for name, text in own.premises:
            if text.startswith("turn "):
                (angle,) = own.read_back[text.split()[-1]].children
                given.append(self._turning(angle, stand, now))
            elif text.startswith("reciprocal "):
                given.append("(over_is now _ _)")
            elif name.startswith("length"):
                given.append("(length_is now _)")
            elif proofs:
                given.append(proofs.pop(0))
            else:
                raise NotCertified("a premise of a step that nothing shows")
        return given

    def known_to_be(self, one: str) -> str | None:
        """Returns the proof that a quantity is a rotation, a constant, …, by itself or as a member of a
        family."""
        word, _, text = one.partition(" ")
        family, _, places = re.sub(r"^\((.*?)(?: : \w+ K)?\)$", r"\1", text).partition(" ")
        if (member := f"{family}_{word.removeprefix('dual_')}") in self.of_families:
            return f"({member} {places})"
        return self.speaker.known.get(one)

    def _turning(self, angle: Term, stand: dict[Term, Term], now: bool) -> str:
        """Returns the proof that cosine and sine are those of an angle."""
        angle = restored(angle, stand)
        cosine = self.text(Apply(angle.type, None, "cos", (angle,)))
        if cosine.startswith("(cosine_of"):
            return f"(turn_of now {self.text(angle)})"
        names = (n for n in self.speaker.introduced if n in self.speaker.holes)
        lines = zip(names, (x for x in self.top if x.endswith("->")), strict=False)
        known = next((name for name, line in lines if f" {cosine} " in line), None)
        if known is None:
            raise NotCertified("an angle that the goal does not mention")
        return f"(turned_now K (at_instant now) _ _ _ {known})" if now else known

    def _valued(
        self, at: Place, variables: Sequence[Variable], members: Mapping[str, str]
    ) -> tuple[Place, list[Alias]]:
        """Returns the place with letters that have the values of these members, and the letters."""
        terms = read_members(at.scope, tuple(variables), members)
        made = []
        for variable, term in terms.items():
            made.append(self._alias(at, variable, term))
        return replace(at, aliases=(*at.aliases, *made)), made

    def _alias(self, at: Place, variable: Variable, term: Term, by: Proof | None = None) -> Alias:
        """Returns a letter with the value of a term. by: the proof that the term belongs to the letter's
        set."""
        own = variable.declaration
        if not own.constant or own.type.kind not in KINDS:
            raise NotCertified("a witness that is a function of time")
        dual = own.type.dual
        value = self._node(term, dual)
        shown = []
        for index, one in enumerate(said_ := belongs(variable, term)):
            name = self.fresh("member")
            with self.shown(name, said(self.speaker, Atom(one)), False):
                if by is None or isinstance(by, Kernel):
                    self._prove(at, one, self._equations(at, None if by is None else by.using))
                elif isinstance(by, AndIntroduction) and len(said_) > 1:
                    self.show(at.of(Atom(one)), by.proofs[index])
                else:
                    self.show(at.of(Atom(one)), by)
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
