"""Proof rules: from a goal and its proof to the obligations for the judge of formulas.

A rule applies only to a goal of its form. It derives further goals, down to equations, which the judge proves
with both of its engines. A wrong witness, a wrong instance, or a proof of another goal therefore fails.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Mapping
from dataclasses import replace

from workbench.core.construct import apply, power, relation, symbol, zero
from workbench.core.integer_expressions import Linear
from workbench.core.terms import Relation, Statement, Term, Zero
from workbench.core.types import SCALAR, VECTOR, Declaration
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.goals import (
    All,
    AllBelow,
    AllFrom,
    AtLeast,
    Atom,
    Both,
    Exists,
    Goal,
    GoalError,
    Iff,
    Implies,
    Variable,
    equations,
)
from workbench.language.goals.proofs import (
    AndIntroduction,
    BinomialInduction,
    Cases,
    Congruence,
    Cut,
    DerivativeAxiom,
    ExistsElimination,
    ExistsIntroduction,
    Extensionality,
    IffIntroduction,
    Induction,
    Instance,
    Introductions,
    Kernel,
    NegationIntroduction,
    Proof,
    SumCongruence,
    SumOfSquares,
    UniqueExists,
    UnitCircleAxiom,
    ZeroFromSquare,
)
from workbench.language.naming.declarations import read_key
from workbench.language.reader import read_term
from workbench.prover.goals.definedness import is_defined_everywhere, that_is_defined
from workbench.prover.goals.named_members import angle, belongs, jet, members_belong, put_in, read_members
from workbench.prover.goals.rule_arguments import integer_given, is_at_least, premise_at, says_the_same
from workbench.prover.goals.sequents import (
    FORMULA,
    NotShown,
    Obligation,
    Sequent,
    atoms_of,
    kind_of,
    refuse_used,
    relations_of,
    supposed,
)
from workbench.prover.goals.substitution import Substitution, at_integer, differentiates
from workbench.prover.goals.sum_rules import pascal, termwise


def obligations(sequent: Sequent, proof: Proof) -> Iterator[Obligation]:
    """Yields the obligations of a proof. Raises NotShown if the proof does not match the goal."""
    match sequent.goal, proof:
        case goal, Introductions(then) if not isinstance(goal, All | AllFrom | Implies):
            yield from obligations(sequent, then)
        case _, Cut(text, by, then):
            lemma = read_goal(text, sequent.scope)
            yield from obligations(sequent.of(lemma), by)
            yield from obligations(sequent.given(lemma, sequent.lasts), then)
        case _, ExistsElimination(place, then):
            yield from obligations(_obtained(sequent, place), then)
        case _, Cases(text, equal, unequal):
            yield from _cases(sequent, text, equal, unequal)
        case All() | AllFrom() as goal, _:
            yield from _for_all(sequent, goal, proof)
        case Exists() as goal, _:
            yield from _for_some(sequent, goal, proof)
        case Atom(statement), _:
            yield from _of_statement(sequent, statement, proof)
        case AtLeast(left, right), SumOfSquares(terms):
            yield from _squares(sequent, left, right, terms)
        case _:
            yield from _of_parts(sequent, proof)


def _no_rule(sequent: Sequent, proof: Proof) -> NotShown:
    return NotShown(f"{type(proof).__name__} is no rule for {kind_of(sequent.goal)}")


def _for_all(sequent: Sequent, goal: All | AllFrom, proof: Proof) -> Iterator[Obligation]:
    """The introduction of ∀, and the induction over the integers."""
    match goal, proof:
        case AllFrom(integer, least, body), Induction():
            yield from _induction(sequent, integer, least, body, proof)
        case AllFrom(body=Atom()), BinomialInduction():
            for inner, own in pascal(sequent, goal, proof):
                yield from obligations(inner, own)
        case AllFrom(integer, least, body), _:
            yield from obligations(sequent.with_integer(integer, least).of(body), proof)
        case All(variables, body), _:
            refuse_used(sequent, variables)
            inner = replace(sequent, goal=body, scope=sequent.scope.with_variables(variables))
            yield from obligations(inner, proof)


def _for_some(sequent: Sequent, goal: Exists, proof: Proof) -> Iterator[Obligation]:
    """The introduction of ∃ and ∃! by a witness."""
    match goal, proof:
        case Exists(variables, body, False), ExistsIntroduction(members, then, using):
            yield from members_belong("witness", sequent, variables, members, using)
            yield from obligations(sequent.of(put_in(sequent, variables, members, body)), then)
        case Exists((variable,), body, False), UnitCircleAxiom():
            yield angle(sequent, variable, body)
        case Exists((variable,), body, False), DerivativeAxiom():
            yield jet(sequent, variable, body)
        case Exists(variables, body, True), UniqueExists():
            yield from _unique(sequent, variables, body, proof)
        case _:
            raise _no_rule(sequent, proof)


def _of_parts(sequent: Sequent, proof: Proof) -> Iterator[Obligation]:
    """The introduction of ⇒, ⇔ and ∧."""
    match sequent.goal, proof:
        case Implies(premise, conclusion, lasting), _:
            yield from obligations(sequent.given(premise, lasting).of(conclusion), proof)
        case Iff(left, right), _:
            there, back = (proof.there, proof.back) if isinstance(proof, IffIntroduction) else (proof, proof)
            yield from obligations(sequent.given(left, False).of(right), there)
            yield from obligations(sequent.given(right, False).of(left), back)
        case Both(parts), AndIntroduction(proofs):
            if len(parts) != len(proofs):
                raise NotShown(f"expected {len(parts)} proofs, one for each part, got {len(proofs)}")
            for part, own in zip(parts, proofs, strict=True):
                yield from obligations(sequent.of(part), own)
        case Both(parts), Kernel():
            for part in parts:
                yield from obligations(sequent.of(part), proof)
        case _:
            raise _no_rule(sequent, proof)


def _of_statement(sequent: Sequent, statement: Statement, proof: Proof) -> Iterator[Obligation]:
    """The rules for what one formula says."""
    match statement, proof:
        case _, Congruence():
            yield from _follows(sequent, statement, proof)
        case Relation("=") as said, SumCongruence():
            for inner, own in termwise(sequent, said, proof):
                yield from obligations(inner, own)
        case _, Extensionality(letter, then):
            yield from _pointwise(sequent, statement, letter, then)
        case Relation("=", left, Zero()), ZeroFromSquare(then) if left.type in (SCALAR, VECTOR):
            square = relation("=", power(left, 2), zero(SCALAR))
            yield from obligations(sequent.of(Atom(square)), then)
        case Relation("≠") as said, NegationIntroduction(place, then):
            yield from _contradicted(sequent, said, place, then)
        case _, AndIntroduction(proofs):
            every = list(equations(statement))
            if len(every) != len(proofs):
                raise NotShown(f"expected {len(every)} proofs, one for each equation, got {len(proofs)}")
            for one, own in zip(every, proofs, strict=True):
                yield from obligations(sequent.of(Atom(one)), own)
        case _, Kernel(using):
            for alone in _separate(statement):
                yield Obligation(FORMULA, alone, sequent.scope, tuple(supposed(sequent, using)))
        case _:
            raise _no_rule(sequent, proof)


def _contradicted(sequent: Sequent, said: Relation, place: int, then: Proof) -> Iterator[Obligation]:
    """left ≠ right, since left = right gives what a premise denies."""
    denied = premise_at(sequent, place).goal
    if not isinstance(denied, Atom) or not isinstance(denied.statement, Relation):
        raise NotShown(f"premise {place} is no inequation")
    if denied.statement.operator != "≠":
        raise NotShown(f"premise {place} denies nothing")
    yield from _defined(sequent, said)
    inner = sequent.given(Atom(relation("=", said.left, said.right)), False)
    absurd = relation("=", denied.statement.left, denied.statement.right)
    yield from obligations(inner.of(Atom(absurd)), then)


def _separate(statement: Statement) -> list[Statement]:
    try:
        return list(equations(statement))
    except GoalError:
        return [statement]


def _unique(
    sequent: Sequent, variables: tuple[Variable, ...], body: Goal, proof: UniqueExists
) -> Iterator[Obligation]:
    yield from members_belong("∃!", sequent, variables, proof.members)
    yield from obligations(sequent.of(put_in(sequent, variables, proof.members, body)), proof.exists)
    terms = read_members(sequent.scope, variables, proof.members)
    refuse_used(sequent, variables)
    inner = replace(sequent, scope=sequent.scope.with_variables(variables)).given(body, False)
    same = [Atom(relation("=", symbol(variable.declaration), term)) for variable, term in terms.items()]
    yield from obligations(inner.of(same[0] if len(same) == 1 else Both(tuple(same))), proof.only)


# The other rules.


def _obtained(sequent: Sequent, place: int) -> Sequent:
    """Returns the sequent with the letters of an ∃ among the premises, and its body: at one instant, for
    constants."""
    known = premise_at(sequent, place).goal
    if not isinstance(known, Exists):
        raise NotShown(f"premise {place} is {kind_of(known)}, and no ∃")
    scope = sequent.scope
    for variable in known.variables:
        if variable.name in scope.table.symbols or variable.name in scope.table.functions:
            raise NotShown(f"{variable.letter} is a symbol already; bind another letter")
    return replace(sequent, scope=scope.with_variables(known.variables)).given(known.body, False)


def _induction(
    sequent: Sequent, integer: str, least: int, body: Goal, proof: Induction
) -> Iterator[Obligation]:
    yield from obligations(sequent.of(at_integer(body, integer, least)), proof.begin)
    n = Linear.variable(integer)
    known = body
    if letter := proof.letter:
        if letter == integer or letter in sequent.scope.integers:
            raise NotShown(f"{letter} is an integer already; take another letter")
        known = AllBelow(letter, least, n + 1, at_integer(body, integer, Linear.variable(letter)))
    inner = sequent.with_integer(integer, least).given(known, sequent.lasts)
    yield from obligations(inner.of(at_integer(body, integer, n + 1)), proof.step)


def _cases(sequent: Sequent, text: str, equal: Proof, unequal: Proof) -> Iterator[Obligation]:
    said = sequent.scope.statement(text)
    if not isinstance(said, Relation) or said.operator != "=":
        raise NotShown(f"expected one equation to tell the cases apart, got {text}")
    yield from _defined(sequent, said)
    other = relation("≠", said.left, said.right)
    yield from obligations(sequent.given(Atom(said), False), equal)
    yield from obligations(sequent.given(Atom(other), False), unequal)


def _defined(sequent: Sequent, said: Relation) -> Iterator[Obligation]:
    """Yields the obligation that both sides are defined, if they divide: as a premise, the statement would
    imply it."""
    scope = sequent.scope
    sides = said.left, said.right
    if not all(is_defined_everywhere(side, scope.definitions) for side in sides):
        yield Obligation("defined", that_is_defined(*sides), scope, tuple(supposed(sequent, None)))


def _pointwise(sequent: Sequent, statement: Statement, letter: str, then: Proof) -> Iterator[Obligation]:
    if not isinstance(statement, Relation) or statement.operator != "=":
        raise NotShown("expected one equation for vectors")
    left, right = statement.left, statement.right
    kind = left.type.kind
    if kind not in ("tensor", "vector"):
        raise NotShown(f"expected an equation of tensors or vectors, got one of a {kind}")
    name, _ = read_key(letter)
    if name in sequent.scope.table.symbols:
        raise NotShown(f"{letter} is a symbol already; take a fresh letter")
    dual = left.type.dual or right.type.dual
    variable = Variable(Declaration(name, VECTOR.with_dual(dual)).with_flags(constant=True))
    vector = symbol(variable.declaration)
    if kind == "tensor":
        sides = apply("mul", left, vector), apply("mul", right, vector)
    else:
        sides = apply("dot", vector, left), apply("dot", vector, right)
    goal = All((variable,), Atom(relation("=", *sides)))
    yield from obligations(sequent.of(goal), then)


def _squares(sequent: Sequent, left: Term, right: Term, terms: tuple[str, ...]) -> Iterator[Obligation]:
    scope = sequent.scope
    total: Term | None = None
    for latex in terms:
        term = scope.term(latex)
        if term.type.dual or term.type.kind not in ("scalar", "vector"):
            raise NotShown(f"expected a real scalar or vector, got the {term.type} {latex}")
        square = power(term, 2)
        total = square if total is None else apply("add", total, square)
    if total is None:
        raise NotShown("expected at least one square")
    if left.type != SCALAR or right.type != SCALAR:
        raise NotShown("≥ compares real scalars")
    said = relation("=", left, apply("add", right, total))
    yield Obligation("≥: a sum of squares more", said, scope, tuple(supposed(sequent, None)))


def _follows(sequent: Sequent, statement: Statement, proof: Congruence) -> Iterator[Obligation]:
    if not isinstance(statement, Relation) or statement.operator != "=":
        raise NotShown("expected one equation to follow")
    if not proof.uses:
        raise NotShown("expected at least one premise to follow from")
    scope, lefts, rights, letters = sequent.scope, {}, {}, []
    for letter, use in proof.uses.items():
        said, lasting = yield from _instance(sequent, use)
        name, _ = read_key(letter)
        if name in scope.table.symbols:
            raise NotShown(f"{letter} is a symbol already; take a fresh letter")
        kind = said.left.type
        kind = kind.with_dual(kind.dual or said.right.type.dual)
        variable = Variable(Declaration(name, kind))
        letters.append((variable, lasting))
        lefts[variable], rights[variable] = said.left, said.right
    inner = scope.with_variables([variable for variable, _ in letters])
    image = read_term(proof.expression, inner.table, scope.integers)
    for variable, lasting in letters:
        if not lasting and differentiates(image, variable.name, scope.definitions):
            raise NotShown("a premise at one instant may not be differentiated")
    from_left = Substitution(lefts, scope.definitions).as_written(image)
    from_right = Substitution(rights, scope.definitions).as_written(image)
    assume = tuple(s for s in supposed(sequent, None) if _is_unequal(s))
    yield Obligation("left side", relation("=", statement.left, from_left), scope, assume)
    yield Obligation("right side", relation("=", from_right, statement.right), scope, assume)


def _is_unequal(statement: Statement) -> bool:
    return all(r.operator == "≠" for r in relations_of(statement))


def _instance(sequent: Sequent, use: Instance) -> Generator[Obligation, None, tuple[Relation, bool]]:
    """Returns the equation that a premise gives for these values, and whether it lasts.

    Yields the obligations of its own premises and sets: at all times, if it holds at all times.
    """
    premise = premise_at(sequent, use.premise)
    goal, scope, given = premise.goal, sequent.scope, dict(use.at)
    lasting = premise.lasting
    while not isinstance(goal, Atom):
        match goal:
            case All(variables, body):
                letters = {variable.letter for variable in variables}
                taken = {key: given.pop(key) for key in list(given) if read_key(key)[0] in letters}
                for variable, term in read_members(scope, variables, taken).items():
                    own = [Atom(o.statement) for o in belongs("instance", sequent, variable, term)]
                    if own:
                        known = sequent if variable.declaration.constant else sequent.at_all_times()
                        lasting = lasting and known.lasts
                        by = use.members
                        by = by.get(str(variable.letter), Kernel()) if isinstance(by, Mapping) else by
                        yield from obligations(known.of(Both(tuple(own))), by)
                goal = put_in(sequent, variables, taken, body)
            case AllFrom(integer, least, body):
                value = integer_given(given.pop(integer, None), integer, least, scope)
                goal = at_integer(body, integer, value)
            case AllBelow(integer, least, bound, body):
                value = integer_given(given.pop(integer, None), integer, least, scope)
                if not is_at_least(bound - value, 1, scope):
                    raise NotShown(f"{integer} = {value} is not seen to be less than {bound}")
                goal = at_integer(body, integer, value)
            case Implies(antecedent, conclusion, always):
                known = sequent.at_all_times() if always else sequent
                lasting = lasting and known.lasts
                if not any(says_the_same(supposed.goal, antecedent, scope) for supposed in known.premises):
                    yield from obligations(known.of(antecedent), Kernel())
                goal = conclusion
            case Both(parts):
                atoms = atoms_of(Both(parts))
                each = parts if atoms is None else [Atom(e) for a in atoms for e in equations(a.statement)]
                if not 0 <= use.part < len(each):
                    raise NotShown(f"the premise has no part {use.part}; it has {len(each)}")
                goal = each[use.part]
            case _:
                raise NotShown(f"{kind_of(goal)} in a premise cannot be used for an equation")
    if given:
        raise NotShown(f"the premise does not bind {', '.join(given)}")
    said = list(equations(goal.statement))
    place = use.part if len(said) > 1 else 0
    if not 0 <= place < len(said):
        raise NotShown(f"the premise has no part {place}; it has {len(said)}")
    one = said[place]
    if one.operator != "=":
        raise NotShown("expected an equation as the premise to follow from")
    return (relation("=", one.right, one.left) if use.back else one), lasting
