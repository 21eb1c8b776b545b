"""Statements for all n: families given by a first member and a step, and derivatives of order n.

Φₙ of a recurrence is `Phi n`, where `Phi` is `from_one Phi_1 (fun n Phi_n => …)`. Φₙ₊₁ is then by computation
the step applied to Φₙ, and the proof holds for any tensor Φₙ.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from workbench.certificates.emission import emitted_nodes, emitted_suppositions
from workbench.certificates.emission.collector import Collector, Origin, spelled
from workbench.certificates.emission.emitted_nodes import APPLICATION, Node, NotCertified
from workbench.core.construct import symbol as make_symbol
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import instantiate
from workbench.core.terms import BigSum, Counting, Derivative, Integer, Power, Symbol, Term
from workbench.prover.goals.sequents import relations_of

if TYPE_CHECKING:
    from workbench.core.terms import Definition, Statement
    from workbench.core.types import Declaration


def general(
    statement: Statement, supposed: Sequence[Statement]
) -> tuple[Statement, list[Statement], dict[str, Linear]]:
    """Returns the statement for all n, with n shifted so that n is the least index, and the meaning of its n.

    Raises NotCertified if no integer variable is left, or an index has several variables.
    """
    statements = [statement, *supposed]
    least: dict[str, Linear] = {}
    for place in (p for s in statements for t in _terms(s) for p in _places(t, frozenset())):
        if any(c < 0 for _, c in place.coefficients) or (len(place.coefficients) > 1 and place.constant < 0):
            raise NotCertified(f"the index {place}")
        for name, _ in place.coefficients:
            shifted = Linear.variable(name) - (place.constant if len(place.coefficients) == 1 else 0)
            least[name] = max(least.get(name, shifted), shifted, key=lambda s: s.constant)
    if not least:
        raise NotCertified("no integer variable")
    made = [instantiate(s, least) for s in statements]
    return made[0], made[1:], {name: least[name] for name in sorted(least)}


def _places(term: Term, bound: frozenset[str]) -> Iterator[Linear]:
    """Yields the integers of the term that no sum binds."""
    found: tuple[Linear, ...] = ()
    match term:
        case Symbol(index=found) | Counting(arguments=found):
            pass
        case Derivative(order=one) | Integer(value=one):
            found = (one,)
        case Power(exponent=one) if not one.is_number:
            raise NotCertified("a power that depends on n")
        case BigSum(variables=variables, lower=lower, upper=upper):
            found = (upper,) if lower is None else (lower, upper - lower + 1)
            bound = bound | set(variables)
    yield from (p for p in found if not p.is_number and not p.variables & bound)
    for child in term.children:
        yield from _places(child, bound)


def _terms(statement: Statement) -> Iterator[Term]:
    for one in relations_of(statement):
        yield from (one.left, one.right)


def member(emitter: Collector, symbol: Symbol, kind: str, body: Term | None) -> Node:
    """Returns a member of a family whose index contains an integer variable."""
    if len(symbol.index) != 1:
        return _of_several(emitter, symbol, kind, body)
    own = [d for d in emitter.definitions if d.declaration == symbol.declaration]
    recurrence = next((d for d in own if not d.index[0].is_number and _mentions(d.body, d)), None)
    number = numeral(emitter, symbol.index[0])
    if recurrence is not None:
        name = _recursion(emitter, symbol, own, recurrence, kind)
        if emitter.firsts[name] == 1 and symbol.index[0] in map(Linear.variable, emitter.integers):
            emitter.positive |= symbol.index[0].variables - set(emitter.bounds)
        text = f"{name} {number}"
        emitter.read_back[text] = symbol
        if body is None or emitter.bounds:
            return emitter.slot(symbol.type.dual, kind, text, APPLICATION)
        value = emitted_nodes.embedded(emitter.term(body), symbol.type.dual)
        return emitter.same(text, value, APPLICATION)
    if symbol.declaration in emitter.families and own:
        numeral(emitter, symbol.index[0] - own[0].index[0].constant)  # checks that it is defined there
        text = f"{emitter.families[symbol.declaration]} {number}"
        node = emitter.slot(symbol.type.dual, kind, text, APPLICATION)
        if not emitter.bounds:
            if body is None:
                raise NotCertified("a member of a family that nothing defines")
            value = emitted_nodes.embedded(emitter.term(body), symbol.type.dual)
            emitter.stands_for(node, value, emitter.shown(node, value, "indices."))
        return node
    if body is not None:
        value = emitted_nodes.embedded(emitter.term(body), symbol.type.dual)
        name = emitter.name(symbol)
        emitter.read_back[name] = symbol
        return emitter.defined(name, value)
    return _free(emitter, symbol, kind)


def _of_several(emitter: Collector, symbol: Symbol, kind: str, body: Term | None) -> Node:
    """Returns a member of a free family with several indices, such as ᵐR₍ₘ₊₁₎, in a step of a proof."""
    if (
        not emitter.several
        or body is not None
        or any(d.declaration == symbol.declaration for d in emitter.definitions)
    ):
        raise NotCertified("a family of several symbolic indices")
    return _free(emitter, symbol, kind)


def _free(emitter: Collector, symbol: Symbol, kind: str) -> Node:
    name = _free_family(emitter, symbol, kind)
    numbers = [numeral(emitter, i) for i in symbol.index]
    text = " ".join([name, *numbers])
    emitter.read_back[text] = symbol
    node = emitter.slot(symbol.type.dual, kind, text, APPLICATION)
    if symbol.declaration.rotation:
        emitter.origins.append(Origin(node, "rotation", len(emitter.statement)))
        emitted_suppositions.rotation(emitter, node, f"({name}_rotation {' '.join(numbers)})")
    return node


def _free_family(emitter: Collector, symbol: Symbol, kind: str) -> str:
    declaration = symbol.declaration
    if declaration.unit or declaration.constant or (declaration.rotation and not emitter.several):
        raise NotCertified("a family of rotations, units or constants")
    if declaration not in emitter.families:
        name = emitter.fresh(_family_name(symbol))
        emitter.families[declaration] = name
        places = [f"i{index}" for index, _ in enumerate(symbol.index)]
        type_ = emitted_nodes.type_name(symbol.type.dual, kind)
        emitter.binders.append((name, "nat -> " * len(places) + type_))
        if declaration.rotation:
            word = emitted_suppositions.predicate("rotation", symbol.type.dual, kind)
            member_ = " ".join([name, *places])
            emitter.binders.append(
                (f"{name}_rotation", f"forall {' '.join(places)} : nat, {word} ({member_})")
            )
    return emitter.families[declaration]


def numeral(emitter: Collector, index: Linear) -> str:
    """Returns n + c, n - k, … as a natural number of Coq, if it is never below 0."""
    least = index
    for variable, (lower, upper) in reversed(emitter.bounds.items()):
        end = lower if index.coefficient(variable) > 0 else upper
        least = least.substitute({variable: end})
    if least.constant < 0 or any(c < 0 for _, c in least.coefficients):
        raise NotCertified(f"the index {index}")
    added = _total(emitter, index, index.constant)
    if min((c for _, c in index.coefficients), default=1) > 0:
        for _ in range(-index.constant):
            added = f"(pred {added})"
        return added
    return f"(nat_minus {added} {_total(emitter, -index, -index.constant)})"


def _total(emitter: Collector, index: Linear, constant: int) -> str:
    """Returns the sum of the variables and the constant as text."""
    names = [name for name, coefficient in index.coefficients for _ in range(coefficient)]
    if any(name not in emitter.integers for name in names):
        raise NotCertified(f"the index {index}")
    if not names:
        return str(max(constant, 0))
    text = emitter.integers[names[0]]
    for name in names[1:]:
        text = f"(nat_plus {text} {emitter.integers[name]})"
    for _ in range(constant):
        text = f"(S {text})"
    return text


def _mentions(body: Term, definition: Definition) -> bool:
    return any(p.declaration == definition.declaration for p in body.symbols())


def _family_name(symbol: Symbol) -> str:
    name = symbol.declaration.name
    return spelled(name.latex([""] * name.indices))


def _recursion(emitter: Collector, symbol: Symbol, own: list[Definition], step: Definition, kind: str) -> str:
    """Writes `let Phi := from_one base (fun n Phi_n => …) in` once, and returns the name."""
    declaration = symbol.declaration
    if declaration in emitter.families:
        return emitter.families[declaration]
    bases = [d for d in own if d.index[0].is_number and not _mentions(d.body, d)]
    lowest = min((int(d.index[0]) for d in bases), default=1)
    if lowest not in (0, 1) or step.parameters:
        raise NotCertified("a recurrence that starts neither at 0 nor at 1")
    ((variable, _),) = step.index[0].coefficients
    if step.index[0].constant != 1:
        raise NotCertified("a recurrence of several steps")
    type_ = emitted_nodes.type_name(symbol.type.dual, kind)
    base = emitted_nodes.embedded(emitter.term(make_symbol(declaration, (Linear(lowest),))), symbol.type.dual)
    prepare(emitter, step.body, declaration)
    name = emitter.fresh(_family_name(symbol))
    inner = emitter.inside(variable, step.body)
    current = make_symbol(declaration, (Linear.variable(variable),))
    argument = f"{name}_n"
    inner.put(current, Node(symbol.type.dual, kind, argument, emitted_nodes.ATOM, "?"))
    made = emitted_nodes.embedded(inner.term(step.body), symbol.type.dual)
    if inner.statement or inner.binders:
        raise NotCertified("a recurrence whose step has definitions of its own")
    start = {0: "from_zero", 1: "from_one"}[lowest]
    function = f"(fun ({inner.integers[variable]} : nat) ({argument} : {type_}) => {made.text})"
    emitter.statement.append(f"let {name} := {start} {base.at(emitted_nodes.ATOM)} {function} in")
    emitter.introduced.append(name)
    emitter.families[declaration] = name
    emitter.firsts[name] = lowest
    return name


def prepare(emitter: Collector, body: Term, but: Declaration | None = None) -> None:
    """Writes the families that the body uses before it."""
    for part in body.walk():
        if not isinstance(part, Symbol) or part.declaration == but or all(i.is_number for i in part.index):
            continue
        kind = emitted_nodes.KINDS.get(part.type.kind)
        own = [d for d in emitter.definitions if d.declaration == part.declaration]
        rule = next((d for d in own if not d.index[0].is_number and _mentions(d.body, d)), None)
        if kind is not None and rule is not None:
            _recursion(emitter, part, own, rule, kind)
        elif kind is not None and not own:
            _free_family(emitter, part, kind)
        elif kind is not None and len(own) == 1 and len(part.index) == 1:
            _function(emitter, part, own[0])


def _function(emitter: Collector, symbol: Symbol, defined: Definition) -> None:
    """Writes `let w := (fun i => …) in` once, for a family that is defined for every index."""
    variables, least = defined.index[0].variables, defined.index[0].constant
    if symbol.declaration in emitter.families or defined.parameters or len(variables) != 1 or least < 0:
        return
    (variable,) = variables
    place = Linear.variable(variable)
    if defined.index[0] - least != place:
        return
    body = instantiate(defined.body, {variable: place - least})
    prepare(emitter, body, symbol.declaration)
    name = emitter.fresh(_family_name(symbol))
    inner = emitter.inside(variable, body)
    inner.bounds = {variable: (Linear(max(least, 1)), place)}
    emitter.forget(index := inner.integers[variable])
    made = emitted_nodes.embedded(inner.term(body), symbol.type.dual)
    if inner.statement or inner.binders:
        raise NotCertified("a family with definitions of its own")
    emitter.statement.append(f"let {name} := (fun {index} => {made.text}) in")
    emitter.introduced.append(name)
    emitter.families[symbol.declaration] = name
    emitter.firsts[name] = least
