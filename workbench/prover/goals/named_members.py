"""Members of sets that a proof names: witnesses, and instances of premises with ∀."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from workbench.core.construct import apply, derivative, number, power, relation, symbol, zero
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.properties import members_of
from workbench.core.terms import Relation, Symbol, Term, Zero
from workbench.core.types import SCALAR
from workbench.language.goals.goals import AllBelow, Atom, Both, Goal, Scope, Variable, equations
from workbench.language.naming.declarations import read_key
from workbench.prover.goals.sequents import NotShown, Obligation, Sequent, names_of, supposed
from workbench.prover.goals.substitution import Substitution, differentiates


def put_in(sequent: Sequent, variables: tuple[Variable, ...], members: Mapping[str, str], body: Goal) -> Goal:
    terms = read_members(sequent.scope, variables, members)
    return Substitution(terms, sequent.scope.definitions).goal(body)


def read_members(
    scope: Scope, variables: tuple[Variable, ...], members: Mapping[str, str]
) -> dict[Variable, Term]:
    given = dict(members)
    terms = {}
    for variable in variables:
        latex = next((given.pop(key) for key in list(given) if read_key(key)[0] == variable.letter), None)
        if latex is None:
            raise NotShown(f"no member is given for {variable.letter}")
        terms[variable] = _typed(_member(scope, variable, latex), variable)
    if given:
        raise NotShown(f"the goal does not bind {', '.join(given)} here")
    return terms


def _member(scope: Scope, variable: Variable, latex: str) -> Term:
    """Returns the term given for a letter; for a map, an expression in its argument, which is written X."""
    if variable.argument is None:
        return scope.term(latex)
    argument = replace(variable.argument, name=Name("X"))
    term = scope.with_variables([Variable(argument)]).term(latex)
    if differentiates(term, argument.name, scope.definitions):
        raise NotShown(f"{variable.letter} makes something of a value, and {latex} of its derivatives")
    inner = symbol(variable.argument)
    return Substitution({Variable(argument): inner}, scope.definitions).as_written(term)


def _typed(term: Term, variable: Variable) -> Term:
    wanted = variable.declaration.type
    if isinstance(term, Zero):
        return zero(wanted)
    if term.type.kind == "tensor" and wanted.kind == "operator":
        return term
    if term.type.kind != wanted.kind or (term.type.dual and not wanted.dual):
        raise NotShown(f"{variable.letter} is a {wanted}, and what is given for it a {term.type}")
    return term


def members_belong(
    rule: str,
    sequent: Sequent,
    variables: tuple[Variable, ...],
    members: Mapping[str, str],
    using: tuple[int, ...] | None = None,
) -> Iterator[Obligation]:
    """Yields the obligations that the terms for rotations and unit vectors are such, at all times if they may
    move."""
    for variable, term in read_members(sequent.scope, variables, members).items():
        yield from belongs(rule, sequent, variable, term, using)


def angle(sequent: Sequent, variable: Variable, body: Goal) -> Obligation:
    """Returns the obligation of ∃ a ∈ ℝ : cos a = c ∧ sin a = s."""
    own, parts = variable.declaration, body.parts if isinstance(body, Both) else (body,)
    said = [one for part in parts if isinstance(part, Atom) for one in equations(part.statement)]
    heads = [apply(head, symbol(own)) for head in ("cos", "sin")]
    of_both = all(isinstance(part, Atom) for part in parts) and [one.left for one in said] == heads
    if own.type != SCALAR or not of_both or any(one.operator != "=" for one in said):
        raise NotShown(f"expected a real angle {variable.letter}, and its cosine and its sine")
    values = [one.right for one in said]
    if any(value.type != SCALAR or own.name in names_of(value, sequent.scope) for value in values):
        raise NotShown(f"expected a real cosine and sine of {variable.letter} that do not depend on it")
    on_circle = relation("=", apply("add", *(power(value, 2) for value in values)), number(1))
    known = tuple(supposed(sequent, None))
    return Obligation("∃: the angle of a point of the unit circle", on_circle, sequent.scope, known)


def jet(sequent: Sequent, variable: Variable, body: Goal) -> Obligation:
    """Returns the obligation of ∃ v ∈ V₃^ℝ : (∀ k < n : v⁽ᵏ⁾ = 0) ∧ v⁽ⁿ⁾ = b: none, if b is a letter."""
    own = variable.declaration
    free = not (own.constant or own.rotation or own.unit)
    match body:
        case Both(
            (AllBelow(k, _, n, Atom(Relation("=", low, Zero()))), Atom(Relation("=", high, Symbol() as b)))
        ):
            orders = [derivative(symbol(own), order) for order in (Linear.variable(k), n)]
            known = own.name not in names_of(b, sequent.scope)
            if free and known and [low, high] == orders and b.type == own.type:
                rule = "∃: a function of time with these derivatives at an instant"
                return Obligation(rule, relation("=", b, b), sequent.scope)
    raise NotShown(
        "expected a function of time whose derivatives below an order are 0, and that of it a letter"
    )


def belongs(
    rule: str, sequent: Sequent, variable: Variable, term: Term, using: tuple[int, ...] | None = None
) -> Iterator[Obligation]:
    own = variable.declaration
    if isinstance(term, Symbol) and (
        (own.rotation and term.declaration.rotation) or (own.unit and term.declaration.unit)
    ):
        return
    said = members_of(own, term)
    known = supposed(sequent, using) if own.constant else supposed(sequent.at_all_times(), None)
    premises = tuple(known)
    for one in said:
        yield Obligation(f"{rule}: a member of its set", one, sequent.scope, premises)
