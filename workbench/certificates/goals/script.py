"""The script of a proof in Coq, with names for letters and terms."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import pairwise

from workbench.certificates.emission import emitted_nodes
from workbench.certificates.emission.emitted_nodes import ATOM, NotCertified
from workbench.certificates.emission.emitted_suppositions import conditions
from workbench.certificates.goals.propositions import ALWAYS, Speaker, binder
from workbench.certificates.theorem import Theorem
from workbench.core.construct import relation
from workbench.core.integer_expressions import Linear
from workbench.core.terms import Relation, Term
from workbench.language.goals.goals import Variable


def after(many: int, number: str) -> str:
    return "(S " * many + number + ")" * many


def nat_sum(parts: Sequence[str]) -> str:
    first, *rest = parts
    return f"(nat_plus {first} {nat_sum(rest)})" if rest else first


class Script:
    """A proof script. lines: the proof.   lemmas: the steps that it uses."""

    def __init__(self, speaker: Speaker) -> None:
        self.speaker = speaker
        self.lemmas: list[Theorem] = []
        self.lines: list[str] = []
        self.top, speaker.statement = speaker.statement, []
        self._binders = list(speaker.binders)
        self.of_families = {name for name, what in speaker.binders if what.startswith("forall ")}
        self.at_instant: set[str] = set()  # names of lemmas that are used at an instant
        self._fresh = 0

    def tell(self, line: str) -> None:
        """Adds a line, after the definitions that the texts so far need."""
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

    @contextmanager
    def shown(self, name: str, text: str, lasts: bool) -> Iterator[str]:
        """Shows a proposition first, at all times if it lasts; yields its proof for `now`."""
        self.tell(f"assert ({name} : {ALWAYS if lasts else ''}{text}).")
        with self.part():
            if lasts:
                self.tell(f"rename now into {self.fresh('then')}. intros now.")
            yield f"({name} now)" if lasts else name

    def counted(self, letter: str, least: int) -> str:
        """Introduces an integer as its least value plus an excess, and returns the name."""
        name = self.speaker.integer(letter, least)
        less = self.speaker.fresh(f"{name}_less_{least}") if least else name
        self.speaker.less[letter] = (less, least)
        return name

    def number(self, value: Linear) -> str:
        """Returns the integer in terms of the excesses of its letters."""
        constant, parts = value.constant, []
        for letter, coefficient in value.coefficients:
            less, least = self.speaker.less[letter]
            parts += [less] * coefficient
            constant += coefficient * least
        if constant < 0 or any(c < 0 for _, c in value.coefficients):
            raise NotCertified(f"the integer {value}")
        return after(constant, nat_sum(parts)) if parts else f"{constant}%nat"

    def fresh(self, stem: str) -> str:
        self._fresh += 1
        return f"{stem}_{self._fresh}"

    @contextmanager
    def part(self) -> Iterator[None]:
        self.tell("{")
        with self.speaker.within():
            yield
        self.tell("}")

    def _letter(self, variable: Variable, suffix: str = "") -> str:
        name = self.speaker.letter(variable, suffix)
        said = conditions(variable.declaration, name)
        self.speaker.known |= zip(said, self._supposed([variable], [name]), strict=True)
        binder(variable, name)
        return name

    def _supposed(self, variables: Sequence[Variable], names: Sequence[str]) -> list[str]:
        """Returns the names of the premises on letters."""
        return [
            f"{name}_{one.split()[0]}"
            for v, name in zip(variables, names, strict=True)
            for one in conditions(v.declaration, name)
        ]

    def _node(self, term: Term, dual: bool, plain: bool = True) -> str:
        """Returns the term as an argument, with its type over the smooth functions. plain: a name needs
        none."""
        node = self.speaker.term(term)
        node = emitted_nodes.embedded(node, node.dual or dual)
        return node.text if plain and node.level == ATOM else f"({node.text} : {node.type})"

    def text(self, term: Term) -> str:
        return self.speaker.term(term).at(ATOM)

    def by_way_of(
        self, one: Relation, first: Term, last: Term, dual: bool | None = None
    ) -> Iterator[Relation]:
        """Yields three equations to show instead of one: to the first of these terms, to the last, and to the
        other side."""
        dual = one.left.type.dual or one.right.type.dual if dual is None else dual
        nodes_ = (self._node(term, dual, plain=False) for term in (first, last))
        self.tell(f"refine {' '.join(f'(then_at now (y := {node}) _' for node in nodes_)} _)).")
        for left, right in pairwise((one.left, first, last, one.right)):
            with self.part():
                yield relation("=", left, right)
