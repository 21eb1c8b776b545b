"""Reasons: every message has a code, comes back from JSON, and is compared by no code."""

from __future__ import annotations

import ast
import pickle
import re
from collections.abc import Iterator
from pathlib import Path
from string import Formatter

import pytest

import workbench
from workbench.core.codes.context_codes import ContextCode
from workbench.core.codes.declaration_codes import DeclarationCode
from workbench.core.codes.model_codes import ModelCode
from workbench.core.codes.motion_codes import MotionCode
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import TypeCode
from workbench.core.codes.verdict_codes import ResultCode, VerdictCode
from workbench.core.reasons import Code, ErrorCode, Position, Reason, code_named
from workbench.core.verdict import Outcome, Verdict

ROOT = Path(workbench.__file__).parent
CODES: list[Code] = [
    *(*ContextCode, *DeclarationCode, *ErrorCode, *ModelCode, *MotionCode, *ResultCode),
    *(*SyntaxCode, *TypeCode, *VerdictCode),
]


def example(code: Code) -> Reason:
    """A reason with the code, and its names for arguments."""
    names = {name for _, name, _, _ in Formatter().parse(code.template) if name}
    return code(**{name: name for name in names})


@pytest.mark.parametrize("code", CODES, ids=lambda code: code.slug)
def test_a_reason_survives_json_and_pickle(code: Code) -> None:
    reason = VerdictCode.FOR_BECAUSE(values="n = 2", reason=example(code).at(1, 2))
    for again in (Reason.from_dict(reason.to_dict()), pickle.loads(pickle.dumps(reason))):
        assert again == reason and again.code is reason.code
        assert [part.code for part in again.parts()] == [VerdictCode.FOR_BECAUSE, code]
        assert again.arguments["reason"].position == Position(1, 2)


def test_no_two_codes_have_one_slug_or_message() -> None:
    assert len({code.slug for code in CODES}) == len(CODES)
    assert all(code_named(code.slug) is code for code in CODES)


def test_a_verdict_keeps_the_code_of_its_reason() -> None:
    verdict = Verdict(Outcome.UNCHECKED, reason=VerdictCode.SAME_TERM(), no_motion=MotionCode.ALGEBRA())
    again = Verdict.from_dict(verdict.to_dict())
    assert again == verdict and again.code is VerdictCode.SAME_TERM
    assert again.no_motion is not None and again.no_motion.code is MotionCode.ALGEBRA


def test_a_nested_position_is_printed_before_its_message() -> None:
    reason = SyntaxCode.CANNOT_BE_READ(why=SyntaxCode.UNKNOWN_SYMBOL(text="x").at(1, 25))
    assert reason == "cannot be read: line 1, column 25: unknown symbol x"
    assert SyntaxCode.UNKNOWN_SYMBOL in reason.codes


#: They read the messages of coqc and of tomllib.
FOREIGN = {"certificates/coqc.py", "source/toml/toml_file.py"}

#: How a message is called where one is at hand.
_MESSAGE = re.compile(
    r"(^|\.)(reason|message|why_not|no_motion|ill_formed|unread)( or ''\))?$|^str\(error\)$"
)


def compared_messages(source: str) -> Iterator[str]:
    """The comparisons of a message with a text, and searches for a text in one."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Compare):
            sides = [node.left, *node.comparators]
            is_text = [isinstance(side, ast.Constant) and isinstance(side.value, str) for side in sides]
            if any(is_text) and any(_is_message(side) for side in sides):
                yield ast.unparse(node)
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            asks_itself = node.func.attr in ("startswith", "endswith", "partition", "find", "index", "split")
            if asks_itself and _is_message(node.func.value):
                yield ast.unparse(node)
            if node.func.attr in ("search", "match", "fullmatch", "sub", "findall") and any(
                map(_is_message, node.args)
            ):
                yield ast.unparse(node)


def _is_message(node: ast.expr) -> bool:
    if isinstance(node, ast.BoolOp):
        return any(map(_is_message, node.values))
    return _MESSAGE.search(ast.unparse(node)) is not None


def test_no_code_compares_a_message() -> None:
    paths = [path for path in ROOT.rglob("*.py") if str(path.relative_to(ROOT)) not in FOREIGN]
    found = {str(path.relative_to(ROOT)): list(compared_messages(path.read_text("utf-8"))) for path in paths}
    assert {name: texts for name, texts in found.items() if texts} == {}


@pytest.mark.parametrize(
    "source",
    [
        "verdict.reason == 'both sides'",
        "'unknown' in (result.unread or '')",
        "(verdict.reason or '').startswith(WORDS)",
        "re.search(PATTERN, error.message)",
        "_OF_KINDS.search(str(error))",
        "why_not.partition(': ')",
    ],
)
def test_a_comparison_of_a_message_is_found(source: str) -> None:
    assert list(compared_messages(source)) == [ast.unparse(ast.parse(source).body[0])]
