"""Cache of the terms of nodes: the variants of a formula share most of their nodes."""

from __future__ import annotations

from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.terms import IllFormed, Term
from workbench.language.elaboration.elaborate import Elaborator
from workbench.language.grammar.syntax import Node
from workbench.language.naming.symbols import SymbolTable


class RememberingElaborator(Elaborator):
    """An elaborator that reads each node once."""

    def __init__(self, table: SymbolTable, variables: frozenset[str]) -> None:
        super().__init__(table, variables)
        self._known: dict[tuple[int, frozenset[str]], tuple[Node, Term | Exception]] = {}

    def term(self, node: Node) -> Term:
        """Returns the term of a node. Raises Fault, TypeMismatch or IllFormed at each call."""
        key = id(node), self.variables
        if key not in self._known:
            try:
                self._known[key] = node, super().term(node)
            except (Fault, TypeMismatch, IllFormed) as fault:
                self._known[key] = node, fault
        found = self._known[key][1]
        if isinstance(found, Exception):
            raise found
        return found
