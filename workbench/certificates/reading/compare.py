"""Differences between a theorem's text, as read back, and its terms: definitions, premises, conclusions."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from workbench.certificates.emission import emitted_nodes
from workbench.certificates.emission.emitted_nodes import KINDS
from workbench.certificates.emission.emitted_suppositions import conditions
from workbench.certificates.emission.emitter import Emitter
from workbench.certificates.reading import read_back
from workbench.certificates.reading.meaning import OfTerm, OfText, applied, bound
from workbench.core.construct import symbol as make_symbol
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import instantiate
from workbench.core.terms import Apply, Relation, Symbol, Term
from workbench.core.types import Declaration


def faults_of(
    emitter: Emitter, conclusions: Sequence[str], relations: Sequence[Relation], premises: Sequence[Relation]
) -> list[str]:
    """Returns where the text, read back, differs from the terms, or does not reproduce the text."""
    of_term = OfTerm(emitter.definitions, len(emitter.integers))
    of_text = OfText(emitter.read_back, of_term, emitter.families, emitter.integers)
    faults = binder_faults(emitter, emitter.read_back)
    supposed = [(of_term(r.left), of_term(r.right)) for r in premises]
    for line in emitter.statement:
        faults += line_faults(emitter, line, of_text, supposed)
    for conclusion, relation in zip(conclusions, relations, strict=True):
        if "≡" not in conclusion:  # a matrix equation
            _, _, _, left, right = read_back.expression(conclusion).arguments
            sides = [str(left), str(right)]
        else:
            sides = re.split(r" (?:≡ε|≡) ", conclusion)
        for text, term in zip(sides, (relation.left, relation.right), strict=True):
            wanted = of_term(term)
            if "operator" in (relation.left.type.kind, relation.right.type.kind):
                wanted = applied(wanted, ("probe",))
                of_text.bound = {emitter.binders[0][0] if emitter.binders else "x": ("probe",)}
            faults += differs("the conclusion", text, of_text, wanted)
    return faults


def line_faults(
    emitter: Emitter, line: str, of_text: OfText, supposed: Sequence[tuple[object, object]]
) -> list[str]:
    """Returns the differences in a definition or a premise."""
    if line.endswith("->"):
        return premise_faults(line.removesuffix(" ->"), of_text, supposed)
    found = re.fullmatch(r"let (\S+)(?: : [^:=]+)? := (.*) in", line, re.DOTALL)
    if found is None:
        return [f"{line} is neither a definition nor a premise"]
    name, text = found.groups()
    if name in emitter.families.values():
        return _family_faults(emitter, name, text, of_text)
    defined = of_text.names.get(name)
    if defined is None:
        return []
    body = emitter.definitions.lookup(defined) if isinstance(defined, Symbol) else None
    if body is None:
        return [f"{name} is defined, and nothing defines its term"]
    return differs(name, text, of_text, of_text.of_term(body))


def _family_faults(emitter: Emitter, name: str, text: str, of_text: OfText) -> list[str]:
    """Returns the differences in a family given by its first member and a step, or by a function of the
    index."""
    declaration = next(d for d, n in emitter.families.items() if n == name)
    of_term = OfTerm(emitter.definitions, len(emitter.integers) + 1)
    (step,) = (d for d in emitter.definitions if d.declaration == declaration and not d.index[0].is_number)
    index = Linear.variable(bound(len(emitter.integers)))
    found = re.fullmatch(r"from_(zero|one) (.+) \(fun \((\S+) : nat\) \((\S+) : ([^)]+)\) => (.+)\)", text)
    first_index = index - (0 if found else step.index[0].constant)
    wanted = of_term(instantiate(step.body, dict.fromkeys(step.index[0].variables, first_index)))
    inner = OfText(of_text.names, of_term, emitter.families, emitter.integers)
    if found is None:
        argument, image = read_back.expression(text).arguments
        inner.integers = {**inner.integers, str(argument): index}
        return differs(name, str(image), inner, wanted)
    first, base, variable, member, type_, body = found.groups()
    inner.integers = {**inner.integers, variable: index}
    inner.bound = {member: ("symbol", make_symbol(declaration, (index,)))}
    least = make_symbol(declaration, (Linear({"zero": 0, "one": 1}[first]),))
    kind = emitted_nodes.type_name(declaration.type.dual, KINDS[declaration.type.kind])
    wrong = [] if type_ == kind else [f"{name}: its members are said to be {type_}"]
    return wrong + differs(name, base, of_text, of_term(least)) + differs(name, body, inner, wanted)


def binder_faults(emitter: Emitter, names: Mapping[str, Term]) -> list[str]:
    """Returns the variables whose type or premises differ from those of their term."""
    faults, members = [], {}
    families = {name: declaration for declaration, name in emitter.families.items()}
    for name, type_ in emitter.binders:
        if name in families:
            members.update(_members(families[name], name))
        if members.get(name) == type_:
            continue
        own = names.get(re.split(r"[ )]", type_)[-1] if name in emitter.holes else name)
        if own is None and name not in emitter.holes and " " not in type_.removesuffix(" K"):
            continue  # the argument of an operator
        if name in emitter.holes:
            declared = own.declaration if isinstance(own, Symbol) else None
            wanted = conditions(declared, type_.split()[-1]) if declared else []
        elif own is None:
            wanted = []
        elif isinstance(own, Apply) and own.head in ("cos", "sin", "norm"):
            wanted = ["scalar K"]
        else:
            kind = KINDS.get(own.type.kind)
            wanted = [emitted_nodes.type_name(own.type.dual, kind) if kind else "@matrix K"]
        if type_ not in wanted:
            faults.append(f"{name} is supposed to be {type_}")
    return faults


def _members(declaration: Declaration, name: str) -> dict[str, str]:
    """Returns the type of a family, and the premises on its members."""
    kind = emitted_nodes.type_name(declaration.type.dual, KINDS[declaration.type.kind])
    places = " ".join(f"i{index}" for index in range(declaration.indices))
    said = conditions(declaration, f"({name} {places})")
    words = [one.split()[0].removeprefix("dual_") for one in said]
    supposed = [f"forall {places} : nat, {one}" for one in said]
    found = {f"{name}_{word}": one for word, one in zip(words, supposed, strict=True)}
    return found | {name: "nat -> " * declaration.indices + kind}


def premise_faults(text: str, of_text: OfText, supposed: Sequence[tuple[object, object]]) -> list[str]:
    """Returns the differences in a premise: a wrong statement on a name, or an unknown premise."""
    if "≡" in text:
        said = tuple(of_text(read_back.expression(side)) for side in re.split(r" (?:≡ε|≡) ", text))
        length = said[0][1] if said[0][:1] == ("mul",) and said[0][1] == said[0][2] else None
        true = said in supposed or (length and length[0] == "norm" and said[1] == ("square", length[1]))
        return [] if true else [f"{text} is supposed"]
    word, *parts = read_back.expression(text).arguments
    of = [of_text(part) for part in parts if not str(part).isdigit()]
    wanted = {
        "inverse": [("inverse", of[0])],
        "inverse_matrix": [("inverse", of[0])],
        "reciprocal": [("over", of[0])],
        "turn": [("cos", of[0]), ("sin", of[0])],
    }.get(str(word))
    if wanted == of[1:] or (of[0][0] == "re" and of[1:] == [("cos", of[0][1]), ("sin", of[0][1])]):
        return []
    return [f"{text} is supposed"]


def differs(what: str, text: str, of_text: OfText, wanted: object) -> list[str]:
    read = read_back.expression(text)
    again = str(read)
    faults = (
        []
        if again in (text, f"({text})") or f"({again})" == text
        else [f"{what}: {text} is written again as {again}"]
    )
    if of_text(read) != wanted:
        faults.append(f"{what}: the text says {of_text(read)}, the term {wanted}")
    return faults
