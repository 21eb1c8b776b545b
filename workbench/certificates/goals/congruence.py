"""Congruence: the same expression of both sides of known equations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from workbench.certificates.emission.emitted_nodes import NotCertified
from workbench.certificates.emission.emitted_suppositions import conditions
from workbench.certificates.goals.equations import Equations
from workbench.certificates.goals.lemmas import of_letters
from workbench.certificates.goals.proof_positions import Known, Place, belongs, conj, flattened, same
from workbench.certificates.goals.propositions import said
from workbench.core.construct import relation, symbol
from workbench.core.names import Name
from workbench.core.terms import Apply, Derivative, Relation, Symbol, Term, TimeOperator, Zero
from workbench.core.types import Declaration
from workbench.language.goals.goals import All, AllFrom, Atom, Both, Implies, Variable
from workbench.language.goals.proofs import Congruence, Instance, Kernel, Proof
from workbench.language.grammar.parser import parse
from workbench.language.naming.declarations import read_key
from workbench.language.naming.linear_indices import linear
from workbench.language.reader import read_term
from workbench.prover.goals.named_members import read_members
from workbench.prover.goals.sequents import kind_of
from workbench.prover.goals.substitution import Substitution, at_integer


class Following(Equations):
    """Writes the proofs of consequences of premises by congruence."""

    def _follows(self, at: Place, one: Relation, proof: Congruence) -> None:
        lefts: dict[Variable, Term] = {}
        rights: dict[Variable, Term] = {}
        shown, lasts = [], True
        for letter, use in proof.uses.items():
            at, said_, known, lasting = self._instance(at, use)
            lasts = lasts and lasting
            kind = said_.left.type.with_dual(said_.left.type.dual or said_.right.type.dual)
            variable = Variable(Declaration(read_key(letter)[0], kind))
            lefts[variable], rights[variable] = said_.left, said_.right
            shown.append((variable, said_, known))
        scope = at.scope.with_variables(list(lefts))
        image = read_term(proof.expression, scope.table, at.scope.integers)
        first, last = (Substitution(x, scope.definitions).as_written(image) for x in (lefts, rights))
        dual = one.left.type.dual or one.right.type.dual or first.type.dual or last.type.dual
        for index, new in enumerate(self.by_way_of(one, first, last, dual)):
            self._real(new, dual)
            if index == 1:
                self._alike(at, image, shown, lasts)
            else:
                self._prove(at, new, ())

    def _real(self, one: Relation, dual: bool) -> None:
        """Converts a goal between real quantities to dual ones."""
        if dual and not (one.left.type.dual or one.right.type.dual):
            x, y = (self._node(side, False) for side in (one.left, one.right))
            self.tell(f"refine (embedded_at now (x := {x}) (y := {y}) _).")

    def _alike(
        self, at: Place, image: Term, shown: Sequence[tuple[Variable, Relation, str]], lasts: bool
    ) -> None:
        """Proves that the same expression of equal values is equal."""
        if isinstance(image, Symbol) and len(shown) == 1:
            self.tell(f"exact {shown[0][2]}.")
            return
        scope, letters = at.scope.definitions, [symbol(v.declaration) for v, _, _ in shown]
        moving = lasts and _differentiates(image, letters)
        image, stand = of_letters(image, letters) if moving else (image, {})
        there = {v: Variable(replace(v.declaration, name=Name(self.fresh("there")))) for v, _, _ in shown}
        ends = []
        for variables, side in ((dict(zip(there, there, strict=True)), "left"), (there, "right")):
            for v, said_, _ in shown:
                node = self._node(getattr(said_, side), v.declaration.type.dual)
                self.speaker.call(symbol(variables[v].declaration), node)
            stands = {v: symbol(w.declaration) for v, w in variables.items()}
            ends.append(Substitution(stands, scope).as_written(image))
        first, last = ends
        given = [
            (relation("=", symbol(v.declaration), symbol(there[v].declaration)), known)
            for v, _, known in shown
        ]
        if moving:
            self._always(at, relation("=", first, last), given, stand)
            return
        pairs = [(v, side) for v, said_, _ in shown for side in (said_.left, said_.right)]
        if all(v.declaration.type.dual == side.type.dual and not isinstance(side, Zero) for v, side in pairs):
            self._by_lemma(at, relation("=", first, last), given, plain=True)
            return
        # a real quantity for a dual one, or a 0 that the judge removed
        values = [{v: getattr(r, side) for v, r, _ in shown} for side in ("left", "right")]
        before, after = (
            [(relation("=", symbol(letters_[v].declaration), of[v]), same(v)) for v in of]
            for letters_, of in zip((dict(zip(there, there, strict=True)), there), values, strict=True)
        )
        one = relation("=", *(Substitution(of, scope).as_written(image) for of in values))
        dual = any(end.type.dual for end in ends)
        for new, known in zip(self.by_way_of(one, first, last, dual), (before, given, after), strict=True):
            self._by_lemma(at, new, known, plain=True)

    def _instance(self, at: Place, use: Instance) -> tuple[Place, Relation, str, bool]:
        """Returns the instance of a premise at these values, its proof, and whether it holds at all times."""
        known = at.known[use.premise]
        goal, proof, given, lasts = known.goal, known.proof, dict(use.at), known.lasts
        while not isinstance(goal, Atom):
            match goal:
                case All(variables, body):
                    taken = {
                        k: given.pop(k)
                        for k in list(given)
                        if read_key(k)[0] in {v.letter for v in variables}
                    }
                    terms = read_members(at.scope, variables, taken)
                    new, said_, aliases = {}, [], len(at.aliases)
                    for variable, term in terms.items():
                        by = use.members
                        by = by.get(str(variable.letter), Kernel()) if isinstance(by, Mapping) else by
                        at, new[variable] = self._member(at, variable, term, by)
                        name = self._node(new[variable], variable.declaration.type.dual)
                        said_.append(name)
                    lasts = lasts and len(at.aliases) == aliases
                    for variable, name in zip(variables, list(said_), strict=True):
                        for condition in conditions(variable.declaration, name):
                            if (is_one := self.known_to_be(condition)) is None:
                                raise NotCertified("an instance that is not known to be in its set")
                            said_.append(is_one)
                    proof = f"({' '.join([proof, *said_])})"
                    goal = Substitution(new, at.scope.definitions).goal(body)
                case AllFrom(integer, least, body):
                    value = linear(parse(given.pop(integer)).lines[0][0], list(at.scope.integers))
                    if value is None:
                        raise NotCertified(f"an instance at {integer} that is no known integer")
                    here = " ltac:(from_here)" if least else ""
                    goal, proof = at_integer(body, integer, value), f"({proof} {self.number(value)}{here})"
                case Implies(premise, conclusion, always):
                    same = next((k for k in at.known if k.goal == premise and (k.lasts or not always)), None)
                    if same is None:
                        where = at.at_all_times() if always else at
                        name = self.fresh("met")
                        with self.shown(name, said(self.speaker, premise), where.lasts) as shown:
                            self.show(where.of(premise), Kernel())
                        same = Known(premise, shown, where.lasts)
                    lasts = lasts and same.lasts
                    given_ = f"(fun now => {same.proof})" if always else same.proof
                    goal, proof = conclusion, f"({proof} {given_})"
                case Both():
                    break
                case _:
                    raise NotCertified(f"{kind_of(goal)} in a premise")
        found = flattened(goal, proof)
        one, proof = found[use.part] if len(found) > 1 else found[0]
        if use.back:
            return at, relation("=", one.right, one.left), f"(back_at now {proof})", lasts
        return at, one, proof, lasts

    def _member(self, at: Place, variable: Variable, term: Term, by: Proof) -> tuple[Place, Term]:
        """Returns the term, or a letter with its value if a constant is required and the term is none."""
        own = variable.declaration
        meant = at.scope.definitions.lookup(term) if isinstance(term, Symbol) else None
        if isinstance(meant, Symbol):  # facts of the definition hold for the term
            each = (conditions(own, self._node(one, own.type.dual)) for one in (term, meant))
            self.speaker.known |= {a: k for a, b in zip(*each, strict=True) if (k := self.known_to_be(b))}
        if all(map(self.known_to_be, conditions(own, self._node(term, own.type.dual)))):
            return at, term
        if not own.constant:
            self._of_its_set(at.at_all_times(), variable, term, by)
            return at, term
        letter = Variable(replace(own, name=Name(self.fresh("at"))))
        alias = self._alias(at, letter, term, by)
        return replace(at, aliases=(*at.aliases, alias)), symbol(letter.declaration)

    def _of_its_set(self, at: Place, variable: Variable, term: Term, by: Proof) -> None:
        """Proves that a motion is a rotation, or a unit vector, at all times."""
        parts = tuple(Atom(one) for one in belongs(variable, term))
        own = parts[0] if len(parts) == 1 else Both(parts)
        with self.shown(self.fresh("member"), said(self.speaker, own), True) as shown:
            self.show(at.of(own), by)
        (one,) = conditions(variable.declaration, self._node(term, variable.declaration.type.dual))
        self.speaker.known[one] = conj([f"(throughout (fun now => {p}))" for _, p in flattened(own, shown)])


def _differentiates(image: Term, letters: Sequence[Symbol]) -> bool:
    """True if the term differentiates an expression in these letters."""
    return any(
        (isinstance(part, Derivative | TimeOperator) and any(p in letters for p in part.walk()))
        or (isinstance(part, Apply) and part.arguments[0].type.kind == "operator")
        for part in image.walk()
    )
