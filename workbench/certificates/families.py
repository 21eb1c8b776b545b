"""Statements for all n: families given by a first member and a step, and derivatives of order n.

Φₙ of a recurrence is `Phi n`, where `Phi` is `from_one Phi_1 (fun n Phi_n => …)`; Φₙ₊₁ is then by computation
what the step makes of Φₙ, and the proof holds for any tensor at the place of Φₙ.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from workbench.certificates import nodes, suppositions
from workbench.certificates.collector import Collector, spelled
from workbench.certificates.nodes import APPLICATION, Node, NotCertified
from workbench.language.construct import symbol as make_symbol
from workbench.language.instances import instantiate
from workbench.language.integers import Linear
from workbench.language.terms import (
    BigSum,
    Conjunction,
    Counting,
    Derivative,
    Integer,
    Power,
    Relation,
    Symbol,
    Term,
)

if TYPE_CHECKING:
    from workbench.language.definitions import Definitions
    from workbench.language.terms import Definition, Statement


def general(
    statement: Statement, supposed: Sequence[Statement], definitions: Definitions
) -> tuple[Statement, list[Statement], list[str]]:
    """The statement for all n, its n shifted so that the least index is n itself, and its integer variables.

    Raises NotCertified where no integer variable is left, or one of them does not stand alone in an index.
    """
    statements = [statement, *supposed]
    least: dict[str, Linear] = {}
    for term in (t for s in statements for t in _terms(s)):
        for part in term.walk():
            if isinstance(part, BigSum | Counting | Integer | Power) and not _numeric(part):
                raise NotCertified("a sum, a power or a number that depends on n")
            places = (
                part.index
                if isinstance(part, Symbol)
                else (part.order,)
                if isinstance(part, Derivative)
                else ()
            )
            for place in (p for p in places if not p.is_number):
                ((name, coefficient), *others) = place.coefficients
                if others or coefficient != 1:
                    raise NotCertified(f"the index {place}")
                shifted = Linear.variable(name) - place.constant
                least[name] = max(least.get(name, shifted), shifted, key=lambda s: s.constant)
    if not least:
        raise NotCertified("no integer variable")
    made = [instantiate(s, least) for s in statements]
    return made[0], made[1:], sorted(least)


def _numeric(part: Term) -> bool:
    match part:
        case Integer(value=value) | Power(exponent=value):
            return value.is_number
        case Counting(arguments=arguments):
            return all(a.is_number for a in arguments)
    return False


def _terms(statement: Statement) -> Iterator[Term]:
    match statement:
        case Relation(left=left, right=right):
            yield left
            yield right
        case Conjunction(parts=parts):
            for part in parts:
                yield from _terms(part)
        case _:
            yield from _terms(statement.left)
            yield from _terms(statement.right)


def member(emitter: Collector, symbol: Symbol, kind: str, body: Term | None) -> Node:
    """A member of a family whose index holds an integer variable."""
    if len(symbol.index) != 1:
        return _of_several(emitter, symbol, kind, body)
    own = [d for d in emitter.definitions if d.declaration == symbol.declaration]
    recurrence = next((d for d in own if not d.index[0].is_number and _mentions(d.body, d)), None)
    number = numeral(emitter, symbol.index[0])
    if recurrence is not None:
        name = _recursion(emitter, symbol, own, recurrence, kind)
        text = f"{name} {number}"
        emitter.read_back[text] = symbol
        if body is None:
            return emitter.slot(symbol.type.dual, kind, text, APPLICATION)
        value = nodes.embedded(emitter.term(body), symbol.type.dual)
        return emitter.same(text, value, APPLICATION)
    if body is not None:
        value = nodes.embedded(emitter.term(body), symbol.type.dual)
        name = emitter.name(symbol)
        emitter.read_back[name] = symbol
        return emitter.defined(name, value)
    name = emitter.families.get(symbol.declaration)
    if name is None:
        declaration = symbol.declaration
        if declaration.rotation or declaration.unit or declaration.constant:
            raise NotCertified("a family of rotations, units or constants")
        name = emitter.fresh(_family_name(emitter, symbol))
        emitter.families[declaration] = name
        emitter.binders.append((name, f"nat -> {nodes.type_name(symbol.type.dual, kind)}"))
    emitter.read_back[f"{name} {number}"] = symbol
    return emitter.slot(symbol.type.dual, kind, f"{name} {number}", APPLICATION)


def _of_several(emitter: Collector, symbol: Symbol, kind: str, body: Term | None) -> Node:
    """A member of a free family of several indices, such as ᵐR₍ₘ₊₁₎, in a step of a proof."""
    if (
        not emitter.several
        or body is not None
        or any(d.declaration == symbol.declaration for d in emitter.definitions)
    ):
        raise NotCertified("a family of several symbolic indices")
    name = _free_family(emitter, symbol, kind)
    numbers = [str(i.constant) if i.is_number else numeral(emitter, i) for i in symbol.index]
    text = " ".join([name, *numbers])
    emitter.read_back[text] = symbol
    node = emitter.slot(symbol.type.dual, kind, text, APPLICATION)
    if symbol.declaration.rotation:
        suppositions.rotation(emitter, node, f"({name}_rotation {' '.join(numbers)})")
    return node


def _free_family(emitter: Collector, symbol: Symbol, kind: str) -> str:
    declaration = symbol.declaration
    if declaration.unit or declaration.constant:
        raise NotCertified("a family of units or constants")
    if declaration not in emitter.families:
        name = emitter.fresh(_family_name(emitter, symbol))
        emitter.families[declaration] = name
        places = [f"i{place}" for place, _ in enumerate(symbol.index)]
        type_ = nodes.type_name(symbol.type.dual, kind)
        emitter.binders.append((name, "nat -> " * len(places) + type_))
        if declaration.rotation:
            word = "dual_rotation" if symbol.type.dual else "rotation"
            member_ = " ".join([name, *places])
            emitter.binders.append(
                (f"{name}_rotation", f"forall {' '.join(places)} : nat, {word} ({member_})")
            )
    return emitter.families[declaration]


def numeral(emitter: Collector, index: Linear) -> str:
    """n + c as a natural number of Coq; n is quantified on first use."""
    ((variable, coefficient), *others) = index.coefficients
    if others or coefficient != 1 or index.constant < 0:
        raise NotCertified(f"the index {index}")
    name = emitter.integers.get(variable)
    if name is None:
        raise NotCertified(f"the index {index}")
    text = name
    for _ in range(index.constant):
        text = f"(S {text})"
    return text


def _mentions(body: Term, definition: Definition) -> bool:
    return any(isinstance(p, Symbol) and p.declaration == definition.declaration for p in body.walk())


def _family_name(emitter: Collector, symbol: Symbol) -> str:
    name = symbol.declaration.name
    return spelled(name.latex([""] * name.indices))


def _recursion(emitter: Collector, symbol: Symbol, own: list[Definition], step: Definition, kind: str) -> str:
    """`let Phi := from_one base (fun n Phi_n => …) in`, once."""
    declaration = symbol.declaration
    if declaration in emitter.families:
        return emitter.families[declaration]
    bases = [d for d in own if d.index[0].is_number and _is_base(emitter, d, own)]
    lowest = min((int(d.index[0]) for d in bases), default=None)
    if lowest not in (0, 1) or step.parameters:
        raise NotCertified("a recurrence that starts neither at 0 nor at 1")
    ((variable, _),) = step.index[0].coefficients
    if step.index[0].constant != 1:
        raise NotCertified("a recurrence of several steps")
    type_ = nodes.type_name(symbol.type.dual, kind)
    base = nodes.embedded(emitter.term(make_symbol(declaration, (Linear(lowest),))), symbol.type.dual)
    for part in step.body.walk():  # the families on which it rests stand before it
        if (
            isinstance(part, Symbol)
            and part.declaration != declaration
            and not all(i.is_number for i in part.index)
        ):
            others = [d for d in emitter.definitions if d.declaration == part.declaration]
            if not others and len(part.index) > 1 and emitter.several:
                _free_family(emitter, part, nodes.KINDS[part.type.kind])
            rule = next((d for d in others if not d.index[0].is_number and _mentions(d.body, d)), None)
            if rule is not None:
                _recursion(emitter, part, others, rule, nodes.KINDS[part.type.kind])
    name = emitter.fresh(_family_name(emitter, symbol))
    inner = emitter.inside(variable, step.body)
    current = make_symbol(declaration, (Linear.variable(variable),))
    argument = f"{name}_n"
    inner.put(current, Node(symbol.type.dual, kind, argument, nodes.ATOM, "?"))
    made = nodes.embedded(inner.term(step.body), symbol.type.dual)
    if inner.statement or inner.binders:
        raise NotCertified("a recurrence whose step has definitions of its own")
    start = {0: "from_zero", 1: "from_one"}[lowest]
    function = f"(fun ({inner.integers[variable]} : nat) ({argument} : {type_}) => {made.text})"
    emitter.statement.append(f"let {name} := {start} {base.at(nodes.ATOM)} {function} in")
    emitter.introduced.append(name)
    emitter.families[declaration] = name
    emitter.firsts[name] = lowest
    return name


def _is_base(emitter: Collector, definition: Definition, own: list[Definition]) -> bool:
    return not _mentions(definition.body, definition)


def of_symbolic_order(emitter: Collector, term: Derivative) -> Node:
    """x⁽ⁿ⁺ᶜ⁾ of a free symbol x, or of another name of one; x⁽ⁿ⁾ is then a symbol of its own."""
    body = term.body
    named = body
    while isinstance(named, Symbol) and (definition := emitter.definitions.lookup(named)) is not None:
        named = definition
    if not isinstance(body, Symbol) or not isinstance(named, Symbol):
        raise NotCertified("a derivative of symbolic order of anything but a symbol")
    value = emitter.symbol(body)
    order = term.order
    key = (body, order - order.constant)
    if key not in emitter.orders:
        number = numeral(emitter, order - order.constant)
        emitter.read_back[f"der {number} {value.at(nodes.ATOM)}"] = Derivative(term.type, None, body, key[1])
        emitter.orders[key] = emitter.slot(
            value.dual, value.kind, f"der {number} {value.at(nodes.ATOM)}", APPLICATION
        )
    return nodes.derivative(emitter.orders[key], order.constant)
