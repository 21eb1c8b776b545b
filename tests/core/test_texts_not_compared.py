"""Decisions compare codes of reasons, never the texts of messages."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import workbench

ROOT = Path(workbench.__file__).parent
#: Names of values that are messages.
TEXTS = frozenset({"complaint", "message", "reason", "why"})
#: Methods that look into a text.
LOOKS = frozenset({"count", "endswith", "find", "index", "partition", "split", "startswith"})
#: Methods that return a text changed.
CHANGES = frozenset({"casefold", "lower", "removeprefix", "removesuffix", "rstrip", "lstrip", "strip"})
#: Methods of patterns.
MATCHES = frozenset({"findall", "finditer", "fullmatch", "match", "search"})
#: Functions that read messages of other programs, or that list equal ones once.
ALLOWED = frozenset({"_first_error", "_syntax_error", "warn"})


def comparisons(source: str) -> Iterator[str]:
    """Yields the comparisons of texts of messages outside the functions that are allowed."""
    waiting: list[ast.AST] = [ast.parse(source)]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.FunctionDef) and node.name in ALLOWED:
            continue
        if any(map(is_text, compared(node))):
            yield ast.unparse(node)
        waiting += ast.iter_child_nodes(node)


def compared(node: ast.AST) -> list[ast.expr]:
    """Returns the values that a node compares, or looks into."""
    match node:
        case ast.Compare(left=left, ops=operators, comparators=others):
            is_of_values = any(
                isinstance(each, ast.Eq | ast.NotEq | ast.In | ast.NotIn) for each in operators
            )
            return [left, *others] if is_of_values else []
        case ast.Call(func=ast.Attribute(attr=name, value=value)) if name in LOOKS:
            return [value]
        case ast.Call(func=ast.Attribute(attr=name), args=arguments) if name in MATCHES:
            return arguments
        case ast.Match(subject=subject):
            return [subject]
    return []


def is_text(node: ast.expr) -> bool:
    """True for a message, or a text made of one."""
    match node:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name in TEXTS
        case ast.Call(func=ast.Name(id="str" | "repr"), args=[ast.Name(id="error" | "fault")]):
            return True
        case ast.Call(func=ast.Name(id="str" | "repr"), args=[argument]) | ast.Subscript(value=argument):
            return is_text(argument)
        case ast.Call(func=ast.Attribute(attr=name, value=value)) if name in CHANGES:
            return is_text(value)
        case ast.BoolOp(values=values):
            return any(map(is_text, values))
        case ast.IfExp(body=body, orelse=otherwise):
            return is_text(body) or is_text(otherwise)
    return False


def test_no_decision_compares_texts_of_messages() -> None:
    found = {
        str(path.relative_to(ROOT)): [*comparisons(path.read_text("utf-8"))] for path in ROOT.rglob("*.py")
    }
    assert {path: lines for path, lines in found.items() if lines} == {}


@pytest.mark.parametrize(
    "planted",
    [
        "'a vector' in verdict.reason",
        "'for n = 2' not in (verdict.reason or '')",
        "error.message == other.message",
        "str(error) != 'no'",
        "guess.why.startswith('the text says')",
        "reason.lower().strip() in KNOWN",
        "PATTERN.search(str(verdict.reason))",
    ],
)
def test_a_planted_comparison_of_texts_is_found(planted: str) -> None:
    assert [*comparisons(f"def f(error):\n    if {planted}:\n        return 1\n")] == [
        ast.unparse(ast.parse(planted))
    ]


def test_comparisons_of_codes_are_allowed() -> None:
    source = "TypeCode.SUM in reason.codes, reason.code == TypeCode.SUM, reason is None, error.reason.code"
    assert [*comparisons(source)] == []
