"""The lines of a formula: each by itself says what it says in the whole, and where it goes on is decided once."""

from itertools import product

import pytest

from workbench.language.grammar.lines import split_lines
from workbench.language.grammar.tokens import MOST_CHARACTERS
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read
from workbench.language.typed.errors import ReadError
from workbench.papers.cutting.cutter import cut_display
from workbench.papers.texts import read_text

TABLE = SymbolTable.build({name: {"kind": "scalar", "weight": 0} for name in "abcdx"})
ENVIRONMENTS = [
    (r"\begin{aligned}", r"\end{aligned}"),
    (r"\begin{cases}", r"\end{cases}, d \neq 0"),
    (r"\left\{\begin{array}{l}", r"\end{array}\right."),
]
BREAKS = [r" \\ ", r", \\[2pt] & ", "\\\\\n"]
#: Two rows, and how many lines they are.
ROWS = [
    ("a &= b", "c = d", 2),
    ("a &= b", "= c", 1),
    ("a &= b", "+ c", 1),
    ("a &= b +", "c", 1),
    ("a &= b +", "+ c", 1),
    ("a &= b", r"\cdot c", 1),
    ("a &= b", "- c = d", 2),
    ("a = b, c = d", "- x", 1),
    ("a &= b", "(c) + d = x", 2),
    ("a &= b", "- (c + d) x", 1),
]


@pytest.mark.parametrize(("environment", "sign", "rows"), list(product(ENVIRONMENTS, BREAKS, ROWS)))
def test_each_line_by_itself_says_what_it_says_in_the_whole(environment, sign, rows):
    first, second, count = rows
    if first.endswith("+") and "," in sign:
        return
    latex = f"{environment[0]} {first}{sign}{second} {environment[1]}"
    lines = split_lines(latex)
    assert len(lines) == count
    said = [statement for line in lines for statement in read(line.latex, TABLE)]
    assert tuple(said) == read(latex, TABLE)


@pytest.mark.parametrize(
    "rows",
    [
        r"a = b \text{ for } c = 1 \\ + d",
        r"a = b, c \neq 0 \\ + d",
        r"a \\ + b",
        r"a = b, \\ \text{where } c = 1 \\ + d",
    ],
)
def test_a_line_that_goes_on_with_a_condition_is_refused(rows):
    with pytest.raises(ReadError):
        read(rf"\begin{{aligned}} {rows} \end{{aligned}}", TABLE)


def test_the_values_of_cases_do_not_go_on():
    (one, other) = read(r"x = \begin{cases} a, & c = 0 \\ - b, & c \neq 0 \end{cases}", TABLE)
    assert (one, other) == read(r"x = a \text{ for } c = 0", TABLE) + read(
        r"x = -b \text{ for } c \neq 0", TABLE
    )


@pytest.mark.parametrize(
    ("latex", "lines"),
    [
        ("a = b", ["a = b"]),
        (r"\begin{aligned} a &= b \end{aligned}", [r"\begin{aligned} a &= b \end{aligned}"]),
        (r"\begin{cases} a = b, \\ c = d. \end{cases}", ["a = b", "c = d"]),
        (r"\begin{cases} a = b, \\ c = d \end{cases}, n \geq 1", [r"a = b, n \geq 1", r"c = d, n \geq 1"]),
        (r"\left\{\begin{array}{l} a = b \\[2pt] + c \\ d = e \end{array}\right.", ["a = b + c", "d = e"]),
        (r"\begin{aligned} a &= b, \\ &= c \\ &\neq d. \end{aligned}", ["a  = b  = c  \\neq d"]),
        (
            r"\begin{aligned} A &= \begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix} \\ a &= b \end{aligned}",
            [r"A  = \begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix}", "a  = b"],
        ),
        (r"x = \begin{cases} a, & p = 0 \\ b, & p \neq 0 \end{cases}", None),
        (r"\begin{aligned} a &= b \\ c", None),
    ],
)
def test_lines(latex, lines):
    assert [line.latex for line in split_lines(latex)] == (lines or [latex])


@pytest.mark.parametrize("gap", ["", " ", "\n  "])
@pytest.mark.parametrize(
    "latex",
    [
        r"a = b.{0}",
        r"a = b.{0}\quad",
        r"a = b.{0}\\ {0}",
        r"\begin{{aligned}} a &= b.{0}\end{{aligned}}",
        r"\begin{{cases}} a = b.{0}\\ a = b.{0}\end{{cases}}",
        r"a = {{b.{0}}}",
    ],
)
def test_a_full_stop_at_the_end_of_a_line_says_nothing(latex, gap):
    assert set(read(latex.format(gap), TABLE)) == set(read("a = b", TABLE))
    with pytest.raises(ReadError, match="full stop"):
        read(latex.format(gap).replace("b.", "b. c.", 1), TABLE)


def test_each_character_of_a_line_is_placed_in_the_formula():
    latex = "\\begin{aligned}\n a &= b \\\\\n  c &= d\n\\end{aligned}, n \\geq 1"
    rows = latex.split("\n")
    for line in split_lines(latex):
        for offset, character in enumerate(line.latex):
            row, column = line.place(
                1 + line.latex.count("\n", 0, offset), offset - line.latex.rfind("\n", 0, offset)
            )
            whole = (rows[row - 1] + "\n")[column - 1]
            assert whole == character or (whole == "&" and character == " ")


@pytest.mark.parametrize("rows", ROWS)
def test_a_text_is_cut_into_the_lines_of_a_formula(rows, tmp_path):
    first, second, _ = rows
    formula = rf"\begin{{aligned}} {first} \\ {second} \end{{aligned}}"
    (tmp_path / "paper.tex").write_text(rf"\begin{{document}}\[ {formula} \]\end{{document}}")
    (display,) = read_text(tmp_path / "paper.tex").displays
    assert len(cut_display(display).statements) == len(split_lines(formula)) + first.count(", ")


def test_a_formula_of_as_many_characters_as_are_read_has_lines_and_no_longer_one():
    rows = r"a &= b \\ c &= d"
    latex = rf"\begin{{aligned}} {' ' * (MOST_CHARACTERS - len(rows) - 30)}{rows} \end{{aligned}}"
    assert len(latex) == MOST_CHARACTERS
    assert len(split_lines(latex)) == len(read(latex, TABLE)) == 2
    assert len(split_lines(f"{latex} ")) == 1
    with pytest.raises(ReadError, match="column 1: a formula of 20001 characters"):
        read(f"{latex} ", TABLE)
