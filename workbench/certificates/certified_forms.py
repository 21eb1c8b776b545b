"""The exact forms of a paper (printed, reading, corrected) and their certificates."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

from workbench.certificates.disequations import HEADER as OF_INEQUATIONS
from workbench.certificates.disequations import denies, unequal
from workbench.certificates.emission.emitted_families import general
from workbench.certificates.emission.emitted_nodes import NotCertified
from workbench.certificates.theorem import HEADER, theorem
from workbench.certificates.values.trial import can_be_certified
from workbench.context.claim_parts import ClaimForm
from workbench.context.claims import Claim, Formula
from workbench.core.integer_instances import instantiate
from workbench.core.terms import IllFormed, Relation, Statement

#: Extensions of the library for division by dual quantities and their lengths, and for sums and numbers that
#: depend on n.
MORE = {
    "Duals": ("dual_over", "dual_length"),
    "Inverses": ("inverse_matrix",),
    "Reciprocals": ("quadratic_over",),
    "Orders": ("sum_from", "whole", "fact_"),
    "Every": ("from_least", "by_induction", "throughout", "added"),
}


@dataclass(frozen=True)
class Form:
    """One form of a claim."""

    claim: Claim
    name: str
    formula: Formula

    @property
    def identifier(self) -> str:
        return "claim_" + re.sub(r"\W+", "_", f"{self.claim.id}_{self.name}").strip("_")

    @property
    def statement(self) -> Statement:
        """The statement of the formula, which every form has (`forms_of`)."""
        assert self.formula.statement is not None, f"{self.claim.id}, {self.name} is not read"
        return self.formula.statement


class Written(Protocol):
    """A theorem in a file: its name, its statement, and its whole text."""

    name: str

    @property
    def statement(self) -> str: ...

    @property
    def text(self) -> str: ...

    def read_back_faults(self) -> list[str]: ...


@dataclass(frozen=True)
class Certificate:
    """A Coq file with theorems in order.

    Attributes:
        motions: A file that shows that the premises can be met. It is a separate file without a form, since
            it depends on the real numbers and many theorems can share it.
    """

    form: Form | None
    theorems: tuple[Written, ...]
    scope: str | None = None
    header: str = HEADER
    motions: Certificate | None = None
    title: str = ""

    @property
    def misread(self) -> str:
        """The differences between the terms and the text as read back; "" if there are none.

        A difference is a defect of the emitter.
        """
        return "; ".join(fault for theorem in self.theorems for fault in theorem.read_back_faults())

    @property
    def statement(self) -> str:
        """The statement of the file, after its title if it is not that of a form."""
        own = [] if self.form or not self.title else [_comment(self.title)]
        return "\n".join([*own, "\n\n".join(t.statement for t in self.theorems)])

    @property
    def text(self) -> str:
        about = _comment(_said(self.form) if self.form else self.title)
        names = [t.name for t in self.theorems]
        last = names[0]
        together = ""
        if len(names) > 1:  # printing the assumptions of a theorem takes about a second
            last = f"{names[0]}_each"
            together = f"Definition {last} := ({', '.join(f'@{name}' for name in names)})."
        texts = [t.text for t in self.theorems]
        words = set(re.findall(r"\w+", " ".join(texts)))
        needed = [name for name, own in MORE.items() if not words.isdisjoint(own)]
        more = [f"From Kin Require Import {name}." for name in needed]
        return "\n".join([about, *more, self.header, *texts, together, f"Print Assumptions {last}.", ""])


def _said(form: Form) -> str:
    return f"{form.claim.id}, {form.name}: {form.formula.latex}"


def _comment(text: str) -> str:
    escaped = " ".join(text.split()).replace("(*", "( *").replace("*)", "* )").replace('"', "''")
    return f"(* {escaped} *)"


def forms_of(claim: Claim) -> Iterator[Form]:
    """Yields the forms that are formulas; a theorem's printed form is words, or more than one identity."""
    for name, formula in claim.forms.items():
        is_words = name is ClaimForm.PRINTED and claim.proof.theorem is not None
        if formula.statement is None or is_words:
            continue
        yield Form(claim, name, formula)


def certificate(form: Form, every: bool) -> Certificate:
    """Returns the theorems of a form: one for all n if that can be stated, else one for each instance.

    Raises:
        NotCertified: The first obstacle.
    """
    claim = form.claim
    definitions = claim.notation.definitions
    if every:
        try:
            statement, supposed, integers = general(form.statement, claim.supposed)
            made = theorem(form.identifier, statement, supposed, definitions, list(integers))
            if not can_be_certified(made):
                raise NotCertified("a sum of which the library knows too little")
            return Certificate(form, (made,), f"all {', '.join(integers)}" if integers else None)
        except NotCertified:
            pass
    if denies(form.statement):
        denied = unequal(form.identifier, form.statement, claim.supposed, definitions)
        return Certificate(form, (denied,), header=OF_INEQUATIONS)
    theorems = []
    for values in claim.instances:
        suffix = "".join(f"_{name}{value}" for name, value in values.items())
        try:
            statement = instantiate(form.statement, values)
            supposed = [instantiate(s, values) for s in claim.supposed]
            if isinstance(statement, Relation) and statement.left == statement.right:
                continue
            theorems.append(theorem(form.identifier + suffix, statement, supposed, definitions))
        except IllFormed as error:
            raise NotCertified(str(error)) from None
    if not theorems:
        raise NotCertified("both sides are the same term")
    return Certificate(form, tuple(theorems), str(claim.orders) if claim.orders else None)
