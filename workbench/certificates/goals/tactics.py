"""Goals as one Coq theorem: the steps of their proof as lemmas, joined by its rules.

A lemma is about any differential ring. If it has no premises, it is used for the smooth functions, else for
their values at the instant, which are a ring with zero derivation (`Moment.v`). A derivative is then a
quantity of its own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from workbench.certificates.emission.emitted_nodes import ATOM, NotCertified
from workbench.certificates.goals.congruence import Following
from workbench.certificates.goals.proof_positions import Known, Place, conj, flattened, one_of, relation_of
from workbench.certificates.goals.propositions import ALWAYS, every, said, sides, speak_of_what_is_free
from workbench.certificates.goals.script import after
from workbench.certificates.theorem import theorem_for_all
from workbench.certificates.values.trial import holds_whatever_they_are
from workbench.core.construct import apply, power, relation, symbol, zero
from workbench.core.integer_expressions import Linear
from workbench.core.terms import BigSum, Head, Relation, Statement, Zero
from workbench.core.types import SCALAR, VECTOR, Declaration
from workbench.language.definitions import expand
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.goals import (
    All,
    AllFrom,
    AtLeast,
    Atom,
    Both,
    Exists,
    Goal,
    Iff,
    Implies,
    Variable,
    atoms,
    equations,
)
from workbench.language.goals.proofs import (
    AndIntroduction,
    Cases,
    Congruence,
    Cut,
    ExistsIntroduction,
    Extensionality,
    IffIntroduction,
    Induction,
    Introductions,
    Kernel,
    NegationIntroduction,
    Proof,
    SumOfSquares,
    UniqueExists,
    ZeroFromSquare,
)
from workbench.language.naming.declarations import read_key
from workbench.prover.goals.sequents import kind_of, relations_of
from workbench.prover.goals.substitution import at_integer


def _no_rule(goal: Goal, proof: Proof) -> NotCertified:
    return NotCertified(f"the rule {type(proof).__name__} for {kind_of(goal)}")


class Joiner(Following):
    """Writes the proof of a goal, by the rules of proofs in the prover."""

    def show(self, at: Place, proof: Proof) -> None:
        match at.goal, proof:
            case goal, Introductions(then) if not isinstance(goal, All | AllFrom | Implies):
                self.show(at, then)
            case _, Cut(text, by, then):
                lemma = read_goal(text, at.scope)
                speak_of_what_is_free(self.speaker, lemma, at.scope)
                with self.shown(self.fresh("have"), said(self.speaker, lemma), at.lasts) as shown:
                    self.show(at.of(lemma), by)
                self.show(at.given(lemma, shown, at.lasts), then)
            case _, Cases(text, equal_, unequal):
                self._cases(at, text, equal_, unequal)
            case Atom(statement), _:
                self._show_statement(at, statement, proof)
            case AtLeast(left, right), SumOfSquares((latex,)):
                term = at.scope.term(latex)
                if term.type != VECTOR:
                    raise NotCertified("a sum of squares")
                self.tell(f"apply (by_square now) with (u := {self.text(term)}).")
                self._prove(at, relation("=", left, apply("add", right, power(term, 2))), ())
            case All() | AllFrom() | Exists(), _:
                self._show_quantified(at, proof)
            case _:
                self._show_connected(at, proof)

    def _show_quantified(self, at: Place, proof: Proof) -> None:
        """The proof of a goal for all, or of one for some."""
        match at.goal, proof:
            case All(variables, body), _:
                names = [self._letter(v) for v in variables]
                self.tell(f"intros {' '.join([*names, *self._supposed(variables, names)])}.")
                self.show(replace(at, goal=body, scope=at.scope.with_variables(variables)), proof)
            case AllFrom(integer, least, body), Induction(letter=None):
                self._induction(at, integer, least, body, proof)
            case AllFrom(integer, least, body), _:
                if least:
                    self.tell(f"refine (from_least {least} _ _).")
                name = self.counted(integer, least)
                self._introduce(name, integer)
                inner = replace(at, goal=body, scope=at.scope.with_integer(integer, least))
                self.show(inner, proof)
            case Exists(variables, body, False), ExistsIntroduction(members, then):
                place, made = self._valued(at, variables, members)
                self._offer(made)
                self.show(place.of(body), then)
            case Exists(variables, body, True), UniqueExists():
                self._unique(at, variables, body, proof)
            case goal, _:
                raise _no_rule(goal, proof)

    def _show_connected(self, at: Place, proof: Proof) -> None:
        """The proof of an implication, an equivalence or of several goals together."""
        match at.goal, proof:
            case Implies(premise, conclusion, lasting), _:
                name = self.fresh("premise")
                self.tell(f"intros {name}.")
                known = f"({name} now)" if lasting else name
                self.show(at.given(premise, known, lasting).of(conclusion), proof)
            case Iff(left, right), _:
                ways = (proof.there, proof.back) if isinstance(proof, IffIntroduction) else (proof, proof)
                self.tell("split.")
                for premise, conclusion, own in ((left, right, ways[0]), (right, left, ways[1])):
                    name = self.fresh("premise")
                    with self.part():
                        self.tell(f"intros {name}.")
                        self.show(at.given(premise, name).of(conclusion), own)
            case Both(parts), AndIntroduction(proofs) if len(parts) == len(proofs):
                self._each([(at.of(part), own) for part, own in zip(parts, proofs, strict=True)])
            case Both(parts), Kernel():
                self._each([(at.of(part), proof) for part in parts])
            case goal, _:
                raise _no_rule(goal, proof)

    def _show_statement(self, at: Place, statement: Statement, proof: Proof) -> None:
        """The proof of what one formula says."""
        match statement, proof:
            case _, Congruence():
                self._follows(at, one_of(statement), proof)
            case _, Extensionality(letter, then):
                self._pointwise(at, one_of(statement), letter, then)
            case Relation("=", left, Zero()), ZeroFromSquare(then) if left.type in (SCALAR, VECTOR):
                self.tell(f"apply {'by_length' if left.type == VECTOR else 'by_scalar_length'}.")
                self.show(at.of(Atom(relation("=", power(left, 2), zero(SCALAR)))), then)
            case Relation("≠", left, right), NegationIntroduction(place, then):
                denied = at.known[place]
                inner = at.given(Atom(relation("=", left, right)), name := self.fresh("if_so"))
                self.tell(f"intros {name}. apply {denied.proof}.")
                one = relation_of(denied.goal)
                self.show(inner.of(Atom(relation("=", one.left, one.right))), then)
            case _, AndIntroduction(proofs):
                said_ = list(equations(statement))
                self._each([(at.of(Atom(one)), own) for one, own in zip(said_, proofs, strict=True)])
            case _, Kernel(using):
                self._each([(at.of(Atom(one)), using) for one in equations(statement)], self._kernel)
            case _:
                raise _no_rule(at.goal, proof)

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

    def _introduce(self, name: str, integer: str, more: str = "") -> None:
        less, least = self.speaker.less[integer]
        self.tell(f"intros {less}{more}.")
        if least:
            self.tell(f"pose ({name} := {after(least, less)}).")

    def _induction(self, at: Place, integer: str, least: int, body: Goal, proof: Induction) -> None:
        """Proves by induction, at all times if all premises hold at all times."""
        times = " now" if at.lasts else ""
        if times:
            with self.speaker.within():
                name = self.speaker.integer(integer, least)
                text = f"{every(name, least)}{ALWAYS}{said(self.speaker, body)}"
            shown, given = self.fresh("every"), "n n_from" if least else "n"
            self.tell(f"enough ({shown} : {text}) by exact (fun {given} => {shown} {given} now).")
            self.tell(f"rename now into {self.fresh('then')}.")
        self.tell(f"refine (by_induction {least} _ _ _)." if least else "refine (nat_ind _ _ _).")
        with self.part():
            if times:
                self.tell("intros now.")
            self._first(at.of(at_integer(body, integer, least)), body, proof.begin)
        with self.part():
            name, known = self.counted(integer, least), self.fresh("before")
            self._introduce(name, integer, f" {known}{times}")
            inner = replace(at, scope=at.scope.with_integer(integer, least))
            inner = inner.given(body, f"({known}{times})", at.lasts)
            self.show(inner.of(at_integer(body, integer, Linear.variable(integer) + 1)), proof.step)

    def _first(self, at: Place, body: Goal, proof: Proof) -> None:
        """Proves the first step of an induction, where sums are replaced by their addends."""
        sums = [p for s in atoms(body) for r in relations_of(s) for p in (*r.left.walk(), *r.right.walk())]
        if isinstance(at.goal, Atom) and any(isinstance(part, BigSum) for part in sums):
            one = one_of(at.goal.statement)
            for index, _ in enumerate(self.by_way_of(one, one.left, one.right)):
                if index == 1:
                    self.show(at, proof)
                else:
                    self.tell("added.")
        else:
            self.show(at, proof)

    def _kernel(self, at: Place, using: tuple[int, ...] | None) -> None:
        one, given = relation_of(at.goal), self._equations(at, using)
        if given and self._holds_anyway(at, one):
            given = []
        self._prove(at, one, given)

    def _holds_anyway(self, at: Place, one: Relation) -> bool:
        """True if the equation holds without the premises."""
        left, right = (self._unaliased(at, side) for side in (one.left, one.right))
        if expand(left, at.scope.definitions) == expand(right, at.scope.definitions):
            return True
        if not at.scope.integers:
            return False
        try:
            return holds_whatever_they_are(theorem_for_all("alone", one, (), at.scope))
        except NotCertified:
            return False

    def _cases(self, at: Place, text: str, equal_: Proof, unequal: Proof) -> None:
        one = one_of(at.scope.statement(text))
        left, right = sides(self.speaker, one)
        name = self.fresh("case")
        self.tell(f"destruct (or_not now {left.at(ATOM)} {right.at(ATOM)}) as [{name} | {name}].")
        either = relation("=", one.left, one.right), relation("≠", one.left, one.right)
        for case, own in zip(either, (equal_, unequal), strict=True):
            with self.part():
                self.show(at.given(Atom(case), name), own)

    def _pointwise(self, at: Place, one: Relation, letter: str, then: Proof) -> None:
        variable = Variable(
            Declaration(read_key(letter)[0], VECTOR.with_dual(one.left.type.dual)).with_flags(constant=True)
        )
        vector = symbol(variable.declaration)
        name = self._letter(variable)
        is_tensor = one.left.type.kind == "tensor"
        rule, order = ("by_vectors", 1) if is_tensor else ("by_products", -1)
        head: Head = "mul" if is_tensor else "dot"
        self.tell(f"apply ({rule} now). intros {name} {' '.join(self._supposed([variable], [name]))}.")
        made = [apply(head, *(side, vector)[::order]) for side in (one.left, one.right)]
        self.show(
            replace(at, goal=Atom(relation("=", *made)), scope=at.scope.with_variables([variable])), then
        )

    def _unique(self, at: Place, variables: Sequence[Variable], body: Goal, proof: UniqueExists) -> None:
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
        self.tell(f"{{ exact {conj(agree)}. }}")
        inner = replace(at, goal=goal, scope=at.scope.with_variables(variables))
        self.show(replace(inner, known=(*at.known, Known(body, holds))), proof.only)
