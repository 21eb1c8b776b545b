"""The lines of a formula typeset in rows: what each says, where it stands, and layouts that are refused."""

import re
from itertools import product
from random import Random

import pytest

from tests.display_layouts import LAYOUTS, plain, some_chains
from workbench.core.formula_errors import ReadError
from workbench.language.grammar.formula_tokens import MOST_CHARACTERS
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read
from workbench.source.documents import read_text
from workbench.source.rows.cutter import cut_display
from workbench.source.rows.formula_lines import split_lines

TABLE = SymbolTable.build({name: {"kind": "scalar", "weight": 0} for name in "abcdx"})
ENVIRONMENTS = [
    (r"\begin{aligned}", r"\end{aligned}"),
    (r"\begin{cases}", r"\end{cases}, d \neq 0"),
    (r"\left\{\begin{array}{l}", r"\end{array}\right."),
]
BREAKS = [r" \\ ", r", \\[2pt] & ", "\\\\\n"]
#: Two rows, and what they say.
ROWS = [
    ("a &= b", "c = d", ["a = b", "c = d"]),
    ("a &= b", "= c", ["a = b = c"]),
    ("a &= b", "+ c", ["a = b + c"]),
    ("a &= b +", "c", ["a = b + c"]),
    ("a &= b +", "+ c", ["a = b + c"]),
    ("a &= b", r"\cdot c", [r"a = b \cdot c"]),
    ("a &= b", "- c = d", ["a = b", "- c = d"]),
    ("a = b, c = d", "- x", ["a = b, c = d - x"]),
    ("a &= b", "(c) + d = x", ["a = b", "(c) + d = x"]),
    ("a &= b", "- (c + d) x", ["a = b - (c + d) x"]),
    (r"a = b \quad c = d", "x = d", ["a = b, c = d", "x = d"]),
    ("a &= b && + c", "x &= d", ["a = b + c", "x = d"]),
    ("a &= b", r"\text{and}", ["a = b"]),
]
RANGES = ["", r", d \neq 0", ""]


@pytest.mark.parametrize(("environment", "sign", "rows"), list(product(range(3), BREAKS, ROWS)))
def test_rows_say_what_they_say_as_lines(
    environment: int, sign: str, rows: tuple[str, str, list[str]]
) -> None:
    first, second, said = rows
    if "," in sign and (first.endswith("+") or second == "- c = d"):
        return
    opening, closing = ENVIRONMENTS[environment]
    lines = split_lines(f"{opening} {first}{sign}{second} {closing}")
    assert [read(line.latex, TABLE) for line in lines] == [
        read(f"{each}{RANGES[environment]}", TABLE) for each in said
    ]


@pytest.mark.parametrize("layout", LAYOUTS)
def test_lines_of_a_layout_are_its_known_formulas(layout: str) -> None:
    random = Random(layout)
    for _ in range(12):
        chains = some_chains(random)
        text = re.sub(
            r"\\(?:begin|end)\{equation\}|\$\$|\\\[(?!\d)|\\\]", "", LAYOUTS[layout](chains, random)
        )
        said = ["".join(line.latex.split()) for line in split_lines(text)]
        assert said == ["=".join(map(plain, (chain.left, *chain.sides))) for chain in chains], text


@pytest.mark.parametrize(
    "rows",
    [
        r"a = b \text{ for } c = 1 \\ + d",
        r"a = b, c \neq 0 \\ + d",
        r"a = b, \\ \text{where } c = 1 \\ + d",
        r"a = b & c = d",
        r"& a = b \\ & \quad - c = d",
        r"a = b \\ \text{et} \\ c = d",
        r"a = b \quad \text{falls} \quad c = d \\ x = d",
        "a = b & c",
        "a = b & c = d, d = 1 \\\\ & = c",
    ],
)
@pytest.mark.parametrize("name", ["aligned", "cases"])
def test_rows_of_two_readings_are_refused(rows: str, name: str) -> None:
    with pytest.raises(ReadError):
        for line in split_lines(rf"\begin{{{name}}} {rows} \end{{{name}}}"):
            read(line.latex, TABLE)


def test_the_values_of_cases_do_not_go_on():
    (one, other) = read(r"x = \begin{cases} a, & c = 0 \\ - b, & c \neq 0 \end{cases}", TABLE)
    assert (one, other) == read(r"x = a \text{ for } c = 0", TABLE) + read(
        r"x = -b \text{ for } c \neq 0", TABLE
    )


@pytest.mark.parametrize(
    ("latex", "lines"),
    [
        ("a = b", ["a = b"]),
        (r"\begin{aligned} a &= b \end{aligned}", ["a  = b"]),
        (r"\begin{cases} a = b, \\ c = d. \end{cases}", ["a = b", "c = d"]),
        (r"\begin{cases} a = b, \\ c = d \end{cases}, n \geq 1", [r"a = b, n \geq 1", r"c = d, n \geq 1"]),
        (
            r"\left\{\begin{array}{l} a = b \\[2pt] + c \\ d = e \end{array}\right.",
            ["a = b         + c", "d = e"],
        ),
        (r"\begin{aligned} a &= b, \\ &= c \\ &\neq d. \end{aligned}", ["a  = b      = c     \\neq d"]),
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
    first, second, said = rows
    formula = rf"\begin{{aligned}} {first} \\ {second} \end{{aligned}}"
    (tmp_path / "paper.tex").write_text(rf"\begin{{document}}\[ {formula} \]\end{{document}}")
    (display,) = read_text(tmp_path / "paper.tex").displays
    assert len(cut_display(display).statements) == len(said) + "".join(said).count(", ")


def test_only_formulas_within_the_length_limit_are_split():
    rows = r"a &= b \\ c &= d"
    latex = rf"\begin{{aligned}} {' ' * (MOST_CHARACTERS - len(rows) - 30)}{rows} \end{{aligned}}"
    assert len(latex) == MOST_CHARACTERS
    assert len(split_lines(latex)) == 2
    assert len(split_lines(f"{latex} ")) == 1
    with pytest.raises(ReadError, match="column 1: a formula of 20001 characters"):
        read(f"{latex} ", TABLE)


@pytest.mark.parametrize("side", [r"a \neq 0", r"c \geq 1", r"a &< b", r"x \in \mathbb{R}"])
@pytest.mark.parametrize("behind", [r"d \neq 0", r"\text{if } d = 1", r"d > 0"])
@pytest.mark.parametrize("rows", [r"a &= b \\ {}", r"{} \\ a &= b", r"a &= b \\ {} \\ c &= d"])
def test_conditions_of_unclear_rows_raise_a_question(side: str, behind: str, rows: str) -> None:
    system = rf"\begin{{aligned}} {rows.format(side)} \end{{aligned}}"
    with pytest.raises(ReadError, match="of which row"):
        split_lines(f"{system}, {behind}")
    split_lines(system)
