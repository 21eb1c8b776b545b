"""Tokens of a formula: drops spacing, matches brackets and environments, and opens and closes |x|."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from lark import Token

from workbench.core.brackets import end_of_group
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault
from workbench.core.operations import FUNCTIONS
from workbench.language.grammar.token_context import marked
from workbench.language.grammar.token_patterns import AFTER_ALIGNMENT, CONTROL, SIDES, TOKEN
from workbench.language.grammar.vocabulary import (
    BAR,
    BRACKETS,
    CHARACTERS,
    COMMANDS,
    DOTS,
    ENDS_A_FACTOR,
    ENVIRONMENTS,
    EXPECTED,
    MATRICES,
    NAMES,
    SIZES,
    SPACING,
    UPRIGHT_NAMES,
    WORDS,
    guessed,
    is_upright,
    words_in_a_formula,
)

_OPENS_A_CLAUSE = frozenset({"COMMA", "GIVEN", "THEN", "AND", "IMPLICATION", "BREAK", "BEGIN_LINES"})

#: Limits on length and nesting, far above those of formulas in print.
MOST_CHARACTERS = 20_000
DEEPEST = 40


class _Open(NamedTuple):
    """An open bracket or environment."""

    what: str
    at: int
    contents: str = ""


class _Script(NamedTuple):
    """The first or second argument of \\prescript{A}{B}{x} that is still to come. depth: the number of open
    brackets around it."""

    depth: int
    below: bool


def tokenize(text: str) -> Iterator[Token]:
    """Returns the tokens of a formula; token.start_pos and token.end_pos are offsets in the text. Raises
    Fault."""
    return iter(Tokenizer(text).tokens())


class Tokenizer:
    def __init__(self, text: str) -> None:
        self.text = text
        self.out: list[Token] = []
        self.open: list[_Open] = []
        self.size = ""  # a pending \left, \right, \bigl …
        self.scripts: list[_Script] = []
        self.refused: list[Fault] = []  # the first one is raised if the brackets match

    def tokens(self) -> list[Token]:
        if found := CONTROL.search(self.text):
            raise Fault(SyntaxCode.FORBIDDEN_CHARACTER(ord=f"{ord(found[0]):04X}"), found.start())
        for match in TOKEN.finditer(self.text):
            self.match(match)
        if self.open:
            raise Fault(f"{self.open[-1].what} is never closed", self.open[-1].at)
        if self.size:
            raise Fault(SyntaxCode.WITHOUT_BRACKET(size=self.size), len(self.text))
        if self.refused:
            raise self.refused[0]
        return marked(self.out)

    def emit(self, kind: str, value: str, at: int) -> None:
        self.out.append(Token(kind, value, start_pos=at, end_pos=self.end))

    def ends(self, *kinds: str) -> bool:
        """True if the last token is of one of these kinds."""
        return any(token.type in kinds for token in self.out[-1:])

    def match(self, match: re.Match[str]) -> None:
        kind, text, at = match.lastgroup, match[0], match.start()
        self.end = match.end()
        if kind == "space":
            return
        if text == "/" and self.size not in ("left", "right"):  # \\Big/
            self.size = ""
        if self.size and not self.is_bracket(match):
            raise Fault(SyntaxCode.MUST_FOLLOWED_BRACKET_GOT(size=self.size, text=text), at)
        match kind:
            case "defined" | "assign":
                self.emit("RELATION", "=", at)
            case "ring":
                self.command("mathring", at)
            case "prose" | "said":
                self.prose(text, at, is_heading=kind == "prose")
            case "words":
                self.words(text, match["words"], at)
            case "name":
                self.environment(match["environment"], match["name"], at)
            case "newline":
                self.emit("ROW" if self.inside("matrix") else "BREAK", text, at)
            case "function":
                self.emit("FUNCTION", text, at)
            case "command":
                self.command(match["command"], at)
            case "number" if self.ends("FRACTION") and len(text) == 2:
                self.emit("NUMBER", text[0], at)  # \frac12
                self.emit("NUMBER", text[1], at + 1)
            case "number":
                self.emit("NUMBER", text, at)
            case "letters":
                self.letters(text, at)
            case _:
                self.character(text, at)

    def prose(self, text: str, at: int, is_heading: bool) -> None:
        """Words that are no formula: nothing where they begin a line of it, and a fault elsewhere."""
        if not is_heading:
            raise Fault(words_in_a_formula(text), at)
        if self.out and not self.ends("BREAK", "BEGIN_LINES"):
            raise Fault(SyntaxCode.WORDS_IN_FORMULA(text=text), at)

    def letters(self, text: str, at: int) -> None:
        """Letters in a row: a function, a word that joins formulas, or a symbol each."""
        if self.ends("SUB", "SUP"):
            self.emit("LETTER", text[0], at)  # k_Re is k_R e
            at, text = at + 1, text[1:]
        if text in FUNCTIONS and not (text in NAMES and self.in_script()):
            self.emit("FUNCTION", text, at)
        elif text in NAMES and not self.in_script():
            self.words(text, text, at)
        else:
            for i, letter in enumerate(text):
                self.emit("LETTER", letter, at + i)

    def is_bracket(self, match: re.Match[str]) -> bool:
        return match[0] in BRACKETS or match[0] == "."

    def words(self, text: str, words: str, at: int) -> None:
        plain = " ".join(words.replace(",", " ").split()).rstrip(".")
        is_script = self.ends("SUB", "SUP")
        is_label = is_script or [token.type for token in self.out[-2:]] == ["SUB", "LBRACE"]
        is_name = plain[-1:].isalpha() or plain[:1].isdecimal()  # 3-2-1
        if is_label and is_name and (is_script or plain not in FUNCTIONS or plain in NAMES):
            self.label(words.strip(" ,."), at, braced=is_script)
        elif plain in FUNCTIONS:
            self.emit("FUNCTION", f"\\{plain}", at)
        elif (word := plain[:1].lower() + plain[1:]) in WORDS:
            self.joining(WORDS[word], word, at)
        elif plain and not text.startswith("\\op") and (self.in_script() or is_upright(text, plain)):
            self.label(words.strip(" ,."), at)
        elif plain in EXPECTED:
            self.refused.append(Fault(SyntaxCode.NOT_A_FORMULA_SIGN(text=text, EXPECTED=EXPECTED[plain]), at))
        elif plain in UPRIGHT_NAMES or (text.startswith("\\operatorname") and plain.isalpha()):
            self.emit("FUNCTION", f"\\{plain}", at)  # the paper may define it
        elif plain:
            raise Fault(words_in_a_formula(text), at)

    def in_script(self) -> bool:
        """True if the next token is in a script, or begins one."""
        return self.ends("SUB", "SUP") or any(opened.contents == "script" for opened in self.open)

    def joining(self, kind: str, word: str, at: int) -> None:
        """Emits "and", "where" and the like; a comma before them is dropped. "for all" without a comma begins
        conditions."""
        if kind == "FORALL":
            if self.out and not self.ends(*_OPENS_A_CLAUSE):
                self.emit("GIVEN", word, at)
        elif self.ends("COMMA"):
            self.out.pop()
        if not (kind in ("GIVEN", "AND") and self.ends("GIVEN")):
            self.emit(kind, {"IMPLICATION": "⇔", "FORALL": "∀"}.get(kind, word), at)

    def label(self, letters: str, at: int, braced: bool = False) -> None:
        """Emits upright letters, with the commas between words, or the figures of 3-2-1; a script without
        braces gets braces."""
        if braced:
            self.emit("LBRACE", "{", at)
        if letters[:1].isdecimal():
            self.emit("NUMBER", letters.replace("-", ""), at)
        for letter in letters:
            if letter == ",":
                self.emit("COMMA", letter, at)
            elif letter.isalpha():
                self.emit("STYLE", "\\mathrm", at)
                self.emit("LETTER", letter, at)
        if braced:
            self.emit("RBRACE", "}", at)

    def command(self, name: str, at: int) -> None:
        text = f"\\{name}"
        if name in SPACING or name.isspace():
            return
        if name in SIZES:
            self.size = name
        elif name == "prescript":
            for kind, value in (("LBRACE", "{"), ("RBRACE", "}"), ("SUP", "^")):
                self.emit(kind, value, at)
            self.scripts += [_Script(len(self.open), below) for below in (True, False)]
        elif text in BRACKETS:
            self.bracket(text, at)
        elif name in COMMANDS:
            kind, value = COMMANDS[name]
            self.bound_prefixes(kind, at)
            self.emit(kind, value, at)
        elif name in DOTS:
            raise Fault(guessed(text), at)
        elif name in EXPECTED:
            self.refused.append(Fault(SyntaxCode.NOT_A_FORMULA_SIGN(text=text, EXPECTED=EXPECTED[name]), at))
        else:
            raise Fault(SyntaxCode.UNKNOWN_COMMAND(text=text), at)

    def bound_prefixes(self, kind: str, at: int) -> None:
        """Raises Fault for more than nine accents: \\dot\\dot\\dot… nests without brackets."""
        if kind in ("ACCENT", "STYLE") and [token.type for token in self.out[-9:]] == [kind] * 9:
            raise Fault(SyntaxCode.MORE_THAN_NINE_ACCENTS(), at)

    def character(self, text: str, at: int) -> None:
        if text in CHARACTERS:
            self.emit(*CHARACTERS[text], at)
        elif text in ("{", "}"):
            self.brace(text, at)
        elif text == "&":
            self.alignment_mark(text, at)
        elif text == "." and self.size:
            self.null_delimiter(at)
        elif text == "…" or self.text.startswith("...", at):
            raise Fault(guessed("…"), at)
        elif text == ".":
            rest = self.text[at + 1 :].lstrip()
            if rest and not rest.startswith(("\\\\", "\\end", "\\quad", "}")):
                self.emit("INFIX", ".", at)
        elif text in BRACKETS:
            self.bracket(text, at)
        elif text in EXPECTED:
            self.refused.append(Fault(SyntaxCode.NOT_A_FORMULA_SIGN(text=text, EXPECTED=EXPECTED[text]), at))
        elif text == "/":
            self.emit("MARK" if self.in_script() else "INFIX", text, at)  # r^{P/O}
        else:
            raise Fault(SyntaxCode.UNEXPECTED_CHARACTER(text=repr(text), ord=f"{ord(text):04X}"), at)

    def brace(self, text: str, at: int) -> None:
        """A brace that groups; one of \\prescript begins or ends a script."""
        if text == "{":
            if any(script.below for script in self.script_here()):
                self.emit("SUB", "_", at)
            self.push(text, at, "script" * self.ends("SUB", "SUP"))
            self.emit("LBRACE", text, at)
            return
        self.pop("{", text, at)
        is_script = bool(self.script_here())
        if is_script and self.ends("LBRACE"):
            del self.out[-2:]  # a script that is empty
        else:
            self.emit("RBRACE", text, at)
        if is_script:
            self.scripts.pop()

    def alignment_mark(self, text: str, at: int) -> None:
        if self.inside("cases") and not AFTER_ALIGNMENT.match(self.text, at + 1):
            self.joining("GIVEN", text, at)  # the value, and behind the mark its condition
        elif self.inside("matrix"):
            doubled = self.text[at - 1 : at] == "&"  # && may leave room between two columns
            self.emit("CELL", "&&" if doubled else text, at)
        elif not self.inside("lines", "cases"):
            raise Fault(SyntaxCode.ALIGNMENT_MARK(), at)

    def script_here(self) -> list[_Script]:
        """Returns the \\prescript whose argument a brace at this position begins; [] if there is none."""
        return [script for script in self.scripts[-1:] if script.depth == len(self.open)]

    def null_delimiter(self, at: int) -> None:
        """Opens \\left. f \\right|, or closes \\left\\{ \\begin{array} … \\right., a brace around lines.

        Raises Fault for another one-sided bracket."""
        size, self.size = self.size, ""
        if size == "left":
            self.push(BAR, at)
            self.emit("OPEN", BAR, at)
        elif size == "right" and self.is_open("\\left\\{"):
            self.open.pop()
        else:
            opened = self.open[-1].at if self.is_open(BAR) else at
            raise Fault(SyntaxCode.ONE_SIDED_BRACKET_LEFT(), opened)

    def bracket(self, text: str, at: int) -> None:
        kind, side = BRACKETS[text]
        size, self.size = self.size, ""
        if size == "left" and kind == "\\{" and self.is_brace_of_lines(at + len(text)):
            self.push("\\left\\{", at)
        elif side == 0 and not size and self.parts_a_script(text, at):
            self.emit("MARK", text, at)
        elif kind == "|" and size == "right" and self.is_open(BAR):
            self.pop(BAR, text, at)
            self.emit("CLOSE", kind, at)
        elif kind == "|" and not self.is_open(kind) and self.text[self.end :].lstrip().startswith("_"):
            self.emit("MARK", kind, at)  # f |_{x = 0}
        elif side > 0 or (side == 0 and self.opens(kind, size)):
            self.push(kind, at)
            self.emit("OPEN", kind, at)
        else:
            self.pop(kind, text, at)
            self.emit("CLOSE", kind, at)

    def is_brace_of_lines(self, behind: int) -> bool:
        """True if an environment follows and \\right. closes the brace; \\right\\} closes a set."""
        if not re.match(r"\s*\\begin", self.text[behind:]):
            return False
        sides = list(SIDES.finditer(self.text, behind))
        last = end_of_group(["left", *(match[1] for match in sides)], ("left",), ("right",))
        return last is None or sides[last - 2][2] == "."

    def parts_a_script(self, bar: str, at: int) -> bool:
        """True for the single bar of x_{t|t-1} or v_{\\|}, which is not a bracket."""
        rest = self.text[at + len(bar) :].partition("}")[0]
        return self.inside("script") and bar not in rest

    def opens(self, kind: str, size: str) -> bool:
        """True if a bar opens a bracket."""
        if size.endswith(("l", "left", "r", "right")):
            return size.endswith(("l", "left"))
        return not (self.is_open(kind) and self.ends(*ENDS_A_FACTOR))

    def environment(self, side: str, name: str, at: int) -> None:
        if name not in ENVIRONMENTS:
            raise Fault(
                SyntaxCode.UNKNOWN_ENVIRONMENT_KNOWN(name=name, ENVIRONMENTS=", ".join(sorted(ENVIRONMENTS))),
                at,
            )
        if side == "end":
            is_matrix = self.inside("matrix")
            self.pop(f"\\begin{{{name}}}", f"\\end{{{name}}}", at)
            self.emit("END_MATRIX" if is_matrix else "END_LINES", name, at)
            return
        in_brace = self.is_open("\\left\\{")
        undecided = name == "array" or (name == "matrix" and in_brace)
        is_matrix = self.ends("OPEN") if undecided else name in MATRICES
        if name == "vmatrix":
            self.emit("FUNCTION", "\\det", at)
        in_cases = self.ends("RELATION") and (name == "cases" or in_brace)
        self.push(f"\\begin{{{name}}}", at, "matrix" if is_matrix else "cases" if in_cases else "lines")
        self.emit("BEGIN_MATRIX" if is_matrix else "BEGIN_LINES", name, at)

    def push(self, what: str, at: int, contents: str = "") -> None:
        if len(self.open) >= DEEPEST:
            raise Fault(SyntaxCode.BRACKETS_NESTED_DEEPER_THAN(DEEPEST=DEEPEST), at)
        self.open.append(_Open(what, at, contents))

    def pop(self, what: str, text: str, at: int) -> None:
        if not self.open:
            raise Fault(SyntaxCode.CLOSES_NOTHING(text=text), at)
        opened = self.open.pop()
        if opened.what == BAR != what:
            raise Fault(SyntaxCode.ONE_SIDED_BRACKET_LEFT(), opened.at)
        if opened.what != what:
            raise Fault(SyntaxCode.CANNOT_CLOSE_OPENED_BEFORE(text=text, what=opened.what), at)

    def is_open(self, what: str) -> bool:
        """True if this is the innermost bracket or environment."""
        return any(each.what == what for each in self.open[-1:])

    def inside(self, *contents: str) -> bool:
        """True if the innermost bracket has one of these contents: "matrix", "lines", "cases", "script"."""
        return any(each.contents in contents for each in self.open[-1:])
