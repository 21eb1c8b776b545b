"""Collector of the parts of a Coq theorem that the terms of one statement need: variables, definitions,
premises, steps."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from workbench.certificates.emission import emitted_nodes
from workbench.certificates.emission.emitted_nodes import ATOM, Node, NotCertified, flag, single
from workbench.core.integer_expressions import Linear
from workbench.core.terms import BigSum, Symbol, Term
from workbench.core.types import Declaration
from workbench.language.definitions import Definitions

#: Names that Coq, the library and the proofs use for other things.
_TAKEN = frozenset([
    "K", "D", "as", "at", "by", "do", "else", "end", "exists", "fix", "for", "forall", "fun", "if",
    "in", "let", "match", "of", "then", "using", "where", "with", "O", "S", "T", "U", "V", "S_", "DT",
    "DU", "DS", "I", "Q", "N", "Z", "Set", "Prop", "Type", "number", "zero", "ident", "eps", "cell",
    "void", "axis", "part", "sum", "dot", "cross", "skew", "act", "prod", "outer", "trace", "triple",
    "det", "adj", "sym", "anti", "vect", "square", "times", "after", "beside", "above", "inverse",
    "rotation", "half", "scale", "plus", "minus", "neg", "map", "zip", "each", "both", "fill", "add",
    "mul", "opp", "dt", "num", "sub", "re", "du", "val", "key", "real_part", "dual_part", "embed",
    "spin", "shift", "moment", "along", "curl", "divergence", "turn", "constant", "rodrigues", "all3",
    "every", "equal", "same", "der", "left", "right", "conj", "split", "pair", "fst", "snd", "nil",
    "cons", "app", "list", "nat", "bool", "slots", "given", "known", "free", "these", "here", "single",
    "joined", "alike", "turned", "carried", "defined", "true", "false", "start", "deriv", "table",
    "red", "pow", "size", "total", "jets", "base", "slot", "find", "env", "upd", "den", "hom", "made",
    "of_time", "claimed", "found", "cosine", "sine", "time", "nonzero_at", "zero_at", "equal_at",
    "value_at", "minv", "unique", "now", "agreed", "still", "sum_from", "choose", "whole", "nat_plus",
    "nat_minus", "pred", "fact",
])  # fmt: skip


@dataclass(frozen=True)
class Origin:
    """The meaning of a symbol of the proof.

    Attributes:
        how: `free`, or free and a `rotation`, `unit` or `constant`. Otherwise the symbol `is` the value, by
            definition or by a premise, or is one `over` it, its `inverse`, `cos` or `sin`.
        after: The number of lines of the statement before it.
    """

    node: Node
    how: str
    after: int
    value: Node | None = None

    @property
    def meaning(self) -> Node:
        """Returns the value of a symbol that is not free."""
        assert self.value is not None, f"{self.node.text} is {self.how}"
        return self.value


@dataclass(frozen=True)
class Summed:
    """A sum in a statement or a premise, or the common part of several sums.

    Attributes:
        differentiated: Whether the proof needs its derivative.
    """

    total: BigSum
    differentiated: bool


class Collector:
    """Collects the parts of the theorem that the terms of one statement need."""

    def __init__(self, definitions: Definitions, slots: Sequence[tuple[bool, str, str]] = ()) -> None:
        self.definitions = definitions
        self.binders: list[tuple[str, str]] = []  # universally quantified, in order
        self.statement: list[str] = []  # definitions and premises before the conclusion
        self.introduced: list[str] = []  # the names given to `intros`
        self.slots = list(slots)  # symbols with indeterminates, and their substitutes
        self.facts: list[str] = []  # facts of symbols, each with its proof
        self.values: list[str] = []  # values of symbols, in terms of earlier ones
        self.origins: list[Origin] = []  # one for each symbol, in order
        self.places: dict[str, Node] = {}  # the universally quantified variables
        self.holes: dict[str, list[tuple[str, str]]] = {}  # the equations of each premise, as deep copies
        self.steps: list[str] = []  # steps of the context after the premises
        self.pivots: dict[Symbol, bool] = {}  # defined symbols whose definition is not used
        self.read_back: dict[str, Term] = {}
        self.operators: dict = {}
        self.matrices: dict = {}
        self.solved: dict[str, tuple[str, str]] = {}  # premise → its matrix and the proof
        self.before: dict[str, str] = {}  # names of the preceding theorems
        self.helpers: dict[Term, Node] = {}  # reciprocals and inverses
        self.circles: dict[Term, tuple[Node, Node]] = {}
        self.families: dict[Declaration, str] = {}  # recurrences and free functions of n
        self.firsts: dict[str, int] = {}  # the first index of a recurrence
        self.positive: set[str] = set()  # integers that index a recurrence starting at 1
        self.integers: dict[str, str] = {}  # integer variables of the statement
        self.orders: dict = {}  # derivatives of symbolic order
        self.bounds: dict[str, tuple[Linear, Linear]] = {}  # bounds of the summation variables
        self.met: list[Summed] = []  # the sums so far (`emitted_sums.py`)
        self.cores: Sequence[Summed] = ()  # their known common parts
        self.middles: dict[Term, Node] = {}  # the symbols of the common parts
        self.rates: dict[str, str] = {}  # rates of common parts, as deep copies
        self.differentiated: set[BigSum] = set()  # the sums under a dot
        self.composed = False  # whether sums or n-th derivatives of compound terms occur
        self.expands = True  # whether x⁽ⁿ⁾ is expanded by the parts of x
        self.lemmas: list[str] = []  # lemmas that the proof shows first
        self.premised: dict[Symbol, tuple[Term, str]] = {}  # values given to symbols at all times
        self.coordinate: Node | None = None
        self.several = False  # whether families with several indices are accepted
        self._places = 1000
        self._symbols: dict[Symbol, Node] = {}
        self._names: set[str] = set(_TAKEN)
        self._made: dict[Term, Node] = {}

    # names, variables, definitions

    def name(self, symbol: Symbol) -> str:
        return self.fresh(identifier(symbol))

    def fresh(self, wanted: str) -> str:
        name = f"{wanted}_" if wanted in _TAKEN else wanted
        while name in self._names:
            name += "'"
        self._names.add(name)
        return name

    def forget(self, name: str) -> None:
        """Frees a name that was bound locally."""
        self._names.discard(name)

    def variable(self, dual: bool, kind: str, name: str, how: str = "free") -> Node:
        """Adds a universally quantified variable."""
        self.binders.append((name, emitted_nodes.type_name(dual, kind)))
        self.places[name] = self.slot(dual, kind, name)
        self.origins.append(Origin(self.places[name], how, len(self.statement)))
        return self.places[name]

    def helper(self, node: Node, how: str, value: Node) -> Node:
        """Adds a universally quantified variable that a premise determines completely."""
        self.binders.append((node.text, emitted_nodes.type_name(node.dual, node.kind)))
        self.places[node.text] = node
        self.origins.append(Origin(node, how, len(self.statement), value))
        return node

    def slot(self, dual: bool, kind: str, text: str, level: int = ATOM) -> Node:
        self.slots.append((dual, kind, text))
        return Node(dual, kind, text, level, f"(Var {flag(dual)} {kind} {len(self.slots) - 1})")

    def suppose(self, text: str, name: str, says: list[tuple[str, str]]) -> str:
        """Adds a premise to the statement, and returns its name in the proof."""
        name = self.fresh(name)
        self.holes[name] = says
        self.statement.append(f"{text} ->")
        self.introduced.append(name)
        return name

    @property
    def premises(self) -> list[tuple[str, str]]:
        """The names and texts of the premises."""
        texts = [line.removesuffix(" ->") for line in self.statement if line.endswith("->")]
        return list(zip((n for n in self.introduced if n in self.holes), texts, strict=True))

    def stands_for(self, node: Node, value: Node, proof: str, by_definition: bool = True) -> None:
        """Records that the symbol of a slot has the value."""
        if by_definition:
            self.origins.append(Origin(node, "is", len(self.statement), value))
        index = node.deep.split()[-1].rstrip(")")
        place = f"{flag(node.dual)} {node.kind} {index}"
        if self.steps:
            self.step(f"given {{}} {place} {value.deep} {proof}")
        else:
            self.values.append(single(f"@Value {place} {value.deep}", proof))

    def shown(self, left: Node, right: Node, script: str) -> str:
        """Adds an equation that the proof shows first, and returns its name there."""
        left, right = emitted_nodes.together((left, right))
        name = self.fresh("fact")
        said = f"{left.at(69)} {'≡ε' if left.dual else '≡'} {right.at(69)}"
        self.lemmas.append(f"assert ({name} : {said}). {{ {script} }}")
        return name

    def place(self) -> int:
        """Returns a new index for a symbol that a step of the context introduces."""
        self._places += 1
        return self._places

    def step(self, made: str) -> None:
        self.steps.append(f"pose (known{len(self.steps) + 1} := {made.format(f'known{len(self.steps)}')}).")

    def defined(self, name: str, value: Node) -> Node:
        """Adds a definition to the statement."""
        self.statement.append(f"let {name} := {value.text} in")
        self.introduced.append(name)
        return self.same(name, value)

    def same(self, text: str, value: Node, level: int = ATOM) -> Node:
        node = self.slot(value.dual, value.kind, text, level)
        self.stands_for(
            node, value, f"(alike (K := K) (d := {flag(node.dual)}) (k := {node.kind}) {node.at(ATOM)})"
        )
        return node

    def put(self, symbol: Symbol, node: Node) -> None:
        self._symbols[symbol] = node

    def symbol_named(self, name: str) -> Symbol:
        """Returns the symbol of a name in the text."""
        term = self.read_back[name]
        if not isinstance(term, Symbol):
            raise NotCertified(f"{name}, which stands for no symbol")
        return term

    def inside(self, variable: str, body: Term, name: str = "i") -> Collector:
        """Returns an emitter for the body of a step, whose definitions must all exist.

        name: the name of the variable.
        """
        for part in body.walk():
            if isinstance(part, Symbol) and all(i.is_number for i in part.index):
                self.symbol(part)
        inner = type(self)(self.definitions)
        inner.several, inner.families, inner.firsts = self.several, self.families, self.firsts
        shadowed = (s for s in self._symbols if any(variable in place.variables for place in s.index))
        inner._symbols = {s: self._symbols[s] for s in set(self._symbols).difference(shadowed)}
        inner._names = self._names
        inner.integers = {variable: self.fresh(name)}
        return inner

    def shows(self, terms: Sequence[Term], value: Term) -> str:
        """Returns the proof that all terms are equal to the value, by a preceding theorem."""
        raise NotImplementedError

    def term(self, term: Term) -> Node:
        raise NotImplementedError

    def symbol(self, symbol: Symbol) -> Node:
        raise NotImplementedError


def identifier(symbol: Symbol) -> str:
    index = [f" {place} ".replace("+", "_plus_").replace("-", "_minus_") for place in symbol.index]
    return spelled(symbol.declaration.name.latex(index))


def spelled(latex: str) -> str:
    """Returns LaTeX as an identifier."""
    name = re.sub(r"\\(boldsymbol|mathbf|mathrm|text|left|right)\b", "", latex)
    name = name.replace("\\underline", "u").replace("*", "_star").replace("'", "_prime")
    name = re.sub(r"[^A-Za-z0-9_]+", "_", name).strip("_")
    name = re.sub(r"__+", "_", name) or "x"
    return "x" + name if name[0].isdigit() else name
