"""Paper files that cannot be used: name, text, where the fault stands, and what the message must say.

A mark « in the text stands where the message must point; it is taken out of the file.
"""

from __future__ import annotations

from typing import NamedTuple

HEAD = """title = "A paper"
[symbols]
'\\omega' = { kind = "vector", weight = 1 }
'\\rho' = { kind = "vector" }
"""
GOOD_CLAIM = r"""
[[claim]]
id = "1"
printed = '\omega \times \omega = 0'
"""


class BadPaper(NamedTuple):
    name: str
    text: str
    says: str

    @property
    def content(self) -> str:
        return self.text.replace("«", "")

    @property
    def place(self) -> tuple[int, int]:
        before = self.text[: self.text.index("«")]
        return before.count("\n") + 1, len(before) - before.rfind("\n")


def claim(body: str) -> str:
    return f"{HEAD}[[claim]]\n{body}\n"


def second_claim(body: str) -> str:
    return f"{HEAD}{GOOD_CLAIM}[[claim]]\n{body}\n"


PRINTED = "id = 'x'\nprinted = '\\omega = \\omega'\n"

BAD_PAPERS = [
    # the file as a whole
    BadPaper("empty file", "«", "empty"),
    BadPaper("blank file", "«  \n\n \n", "empty"),
    BadPaper("not TOML", "title = «\n", "not TOML"),
    BadPaper("an unclosed string", 'title = "A paper«\n', "not TOML"),
    BadPaper("an unclosed list", "title = 'x'\nclaim = [«", "not TOML"),
    BadPaper("an unclosed table header", "[symbols«\n", "not TOML"),
    BadPaper("a key without a value", "title«\n", "not TOML"),
    BadPaper("a bad escape in a string", 'title = "\\o«mega"\n', "not TOML"),
    BadPaper("a key given twice", "title = 'x'\ntitle = 'y'«\n", "not TOML"),
    BadPaper("a table given twice", HEAD + "[symbols«]\n", "not TOML"),
    BadPaper("NUL", "title = 'a«\0b'\n", "not TOML"),
    BadPaper("deep lists", "x = " + "[" * 100 + "«" + "[" * 19_900 + "]" * 20_000, "nested too deep"),
    BadPaper("lists deeper than allowed", "x = " + "[" * 100 + "«" + "[" * 5 + "]" * 105, "nested too deep"),
    BadPaper(
        "deep tables", "x = " + "{a=" * 100 + "«" + "{a=" * 19_900 + "1" + "}" * 20_000, "nested too deep"
    ),
    BadPaper("a deep key", HEAD + "«" + "a." * 20_000 + "a = 1\n", "nested too deep"),
    BadPaper("a deep key of a symbol", HEAD + "«" + "a." * 101 + "a = 1\n", "nested too deep"),
    BadPaper("a deep header", HEAD + "[«" + "a." * 20_000 + "a]\nb = 1\n", "nested too deep"),
    BadPaper("a huge integer", "«x = " + "1" * 5_000, "not TOML"),
    BadPaper("a byte-order mark", "«\ufefftitle = 'x'\n", "byte-order mark"),
    # the top of the file
    BadPaper("no claims", "«" + HEAD, "no claims"),
    BadPaper("an empty claim list", "«title = 'x'\nclaim = []\n", "no claims"),
    BadPaper("no title", "«[symbols]\n'\\omega' = { kind = 'vector' }\n" + GOOD_CLAIM, "'title'"),
    BadPaper("an unknown key on top", "«titel = 'x'\n", "unknown key 'titel'"),
    BadPaper("an unknown table", HEAD + "«[symbol]\n" + GOOD_CLAIM, "did you mean symbols?"),
    BadPaper("claims instead of claim", HEAD + "«[[claims]]\nid = '1'\n", "did you mean claim?"),
    BadPaper("title is a number", "title = «7\n" + GOOD_CLAIM, "expected a string, got an integer"),
    BadPaper("title is blank", "title = «' '\n" + GOOD_CLAIM, "empty"),
    BadPaper("doi is a list", "title = 'x'\ndoi = «[]\n" + GOOD_CLAIM, "expected a string, got a list"),
    BadPaper("section is a number", "title = 'x'\nsection = «4.1\n" + GOOD_CLAIM, "got a number"),
    BadPaper("claim is a table", "title = 'x'\n«[claim]\nid = '1'\n", "expected a list, got a table"),
    BadPaper("claims are numbers", "title = 'x'\nclaim = [«1]\n", "expected tables"),
    BadPaper("symbols is a string", "title = 'x'\nsymbols = «'omega'\n" + GOOD_CLAIM, "expected a table"),
    BadPaper("definitions is a list", "title = 'x'\ndefinitions = «[1]\n" + GOOD_CLAIM, "expected a table"),
    BadPaper("motion is a string", "title = 'x'\nmotion = «'w_WB'\n" + GOOD_CLAIM, "expected a table"),
    # notation files
    BadPaper("a notation that is not there", "title = 'x'\nnotation = «'no.toml'\n" + GOOD_CLAIM, "no file"),
    BadPaper("a notation elsewhere", "title = 'x'\nnotation = «'../n.toml'\n" + GOOD_CLAIM, "beside this"),
    BadPaper("a notation that is itself", "title = 'x'\nnotation = «'bad.toml'\n" + GOOD_CLAIM, "itself"),
    BadPaper("a notation that is a number", "title = 'x'\nnotation = «1\n" + GOOD_CLAIM, "expected a string"),
    # claims
    BadPaper("a claim without id", HEAD + "«[[claim]]\nprinted = '\\omega = \\omega'\n", "missing key 'id'"),
    BadPaper("a claim without printed", HEAD + "«[[claim]]\nid = 'x'\n", "missing key 'printed'"),
    BadPaper("an empty claim", HEAD + GOOD_CLAIM + "«[[claim]]\n", "missing key 'id'"),
    BadPaper("id is a number", claim("id = «58\nprinted = '\\omega = \\omega'"), "expected a string"),
    BadPaper("id is empty", claim("id = «''\nprinted = '\\omega = \\omega'"), "empty"),
    BadPaper("id has a blank", claim("id = «'a b'\nprinted = '\\omega = \\omega'"), "id"),
    BadPaper("an id used twice", second_claim("id = «'1'\nprinted = '\\omega = \\omega'"), "twice"),
    BadPaper(
        "the id of a line used twice",
        claim(
            "id = '1'\nprinted = '\\begin{aligned} \\omega &= \\omega \\\\ \\rho &= \\rho \\end{aligned}'\n"
            "[[claim]]\nid = «'1.2'\nprinted = '\\omega = \\omega'"
        ),
        "twice",
    ),
    BadPaper("an unknown claim key", claim(PRINTED + "«printd = 'x'"), "did you mean printed?"),
    BadPaper("a far unknown key", claim(PRINTED + "«zzz = 1"), "expected one of id,"),
    BadPaper("printed is a list", claim("id = 'x'\nprinted = «['a']"), "expected a string"),
    BadPaper("printed is empty", claim("id = 'x'\nprinted = «''"), "empty"),
    BadPaper("equation is a number", claim(PRINTED + "equation = «58"), "expected a string"),
    BadPaper("note is a table", claim(PRINTED + "note = «{ a = 1 }"), "expected a string"),
    BadPaper("assume is a string", claim(PRINTED + "assume = «'x'"), "expected a list"),
    BadPaper("assume holds a number", claim(PRINTED + "assume = ['\\omega \\neq 0', «1]"), "list of strings"),
    BadPaper("assume holds nothing", claim(PRINTED + "assume = [«'']"), "list of strings"),
    BadPaper("inherits is a string", claim(PRINTED + "inherits = «'x'"), "expected a list"),
    BadPaper("inherits an unknown id", claim(PRINTED + "inherits = ['x', «'y']"), "no claim has the id 'y'"),
    BadPaper("orders is a number", claim(PRINTED + "orders = «8"), "expected a string"),
    BadPaper("orders without a range", claim(PRINTED + "orders = «'n'"), "expected `n = 1..8`"),
    BadPaper("orders run backwards", claim(PRINTED + "orders = «'n = 8..1'"), "empty"),
    BadPaper("orders twice", claim(PRINTED + "orders = «'n = 1..2, n = 1..3'"), "twice"),
    BadPaper("orders are too many", claim(PRINTED + "orders = «'m = 1..99, n = 1..99'"), "more than"),
    BadPaper("orders are negative", claim(PRINTED + "orders = «'n = -1..3'"), "expected `n = 1..8`"),
    BadPaper("orders with a trailing comma", claim(PRINTED + "orders = «'n = 1..3,'"), "expected `n = 1..8`"),
    BadPaper(
        "corrected and hypothesis",
        claim(PRINTED + "corrected = '\\omega = \\omega'\n«hypothesis = '\\omega = 0'"),
        "exclude each other",
    ),
    BadPaper(
        "goal and reading",
        claim("id = 'x'\ngoal = '\\omega = 0'\nstatement = 's'\n«reading = '\\omega = 0'"),
        "exclude each other",
    ),
    BadPaper(
        "theorem that is not installed",
        claim("id = 'x'\ngoal = '\\omega = 0'\nstatement = 's'\ntheorem = «'os.system'"),
        "no proof called 'os.system'",
    ),
    BadPaper(
        "goal without statement",
        HEAD + "«[[claim]]\nid='x'\ngoal = '\\omega = \\omega'\n",
        "missing key 'statement'",
    ),
    BadPaper("only a statement", HEAD + "«[[claim]]\nid='x'\nstatement='s'\n", "missing key 'printed'"),
    # formulas
    BadPaper("an unknown symbol", claim("id = 'x'\nprinted = '\\omega = «\\psi'"), "\\psi"),
    BadPaper("an unknown command", claim("id = 'x'\nprinted = '\\omega = «\\foo{1}'"), "\\foo"),
    BadPaper("an unclosed brace", claim("id = 'x'\nprinted = '\\omega = «{\\omega'"), "printed"),
    BadPaper("an operator too many", claim("id = 'x'\nprinted = '\\omega = \\omega + «'"), "printed"),
    BadPaper("no relation", claim("id = 'x'\nprinted = '«\\omega'"), "printed"),
    BadPaper("a bad reading", claim(PRINTED + "reading = '\\omega = «\\psi'"), "reading: "),
    BadPaper("an ill-typed reading", claim(PRINTED + "reading = '\\omega = \\omega«\\omega'"), "reading: "),
    BadPaper("a bad correction", claim(PRINTED + 'corrected = "\\\\omega = «\\\\psi"'), "corrected: "),
    BadPaper("an unequal weight", claim(PRINTED + "corrected = '\\omega «= \\dot{\\omega}'"), "weight"),
    BadPaper("a bad hypothesis", claim(PRINTED + "hypothesis = '\\omega \\neq «\\psi'"), "hypothesis: "),
    BadPaper(
        "a bad assumption", claim(PRINTED + "assume = ['\\omega \\neq 0', '\\omega = «\\psi']"), "assume: "
    ),
    BadPaper(
        "a fault in the second line of a formula",
        claim(
            "id = 'x'\nprinted = '''\n\\begin{aligned}\n\\omega &= \\omega \\\\\n"
            "  \\omega &= «\\psi\n\\end{aligned}'''"
        ),
        "\\psi",
    ),
    BadPaper(
        "a correction with fewer lines",
        claim(
            "id = '1'\nprinted = '\\begin{aligned} \\omega &= \\omega \\\\ \\rho &= \\rho \\end{aligned}'\n"
            "corrected = «'\\omega = \\omega'"
        ),
        "expected 2 lines, as printed has, got 1",
    ),
    BadPaper(
        "a megabyte of braces",
        claim("id = 'x'\nprinted = '«" + "{" * 1_000_000 + "'"),
        "a formula of 1000000 characters; up to 20000 are read",
    ),
    BadPaper(
        "deeply nested braces",
        claim("id = 'x'\nprinted = '" + "{" * 40 + "«" + "{" * 460 + "x" + "}" * 500 + "'"),
        "deep",
    ),
    BadPaper("a formula that looks like code", claim("id = 'x'\nprinted = '__import__(«\"os\")'"), "printed"),
]
SYMBOL_FAULTS = [
    BadPaper("a symbol of no kind", "title = 'x'\n[symbols]\n«'a' = { weight = 1 }\n" + GOOD_CLAIM, "kind"),
    BadPaper(
        "a symbol of unknown kind", "title='x'\n[symbols]\n«'a' = { kind = 'matrix' }\n" + GOOD_CLAIM, "kind"
    ),
    BadPaper("a symbol that is a number", "title='x'\n[symbols]\n'a' = «3\n" + GOOD_CLAIM, "table"),
    BadPaper(
        "an unknown key of a symbol",
        "title='x'\n[symbols]\n«'a' = { kind = 'vector', wieght = 1 }\n" + GOOD_CLAIM,
        "wieght",
    ),
    BadPaper(
        "a weight that is text",
        "title='x'\n[symbols]\n«'a' = { kind='vector', weight='one two' }\n" + GOOD_CLAIM,
        "weight",
    ),
    BadPaper(
        "an alias used twice",
        HEAD + "«'\\xi' = { kind = 'vector', aliases = ['\\omega'] }\n" + GOOD_CLAIM,
        "\\omega",
    ),
    BadPaper("a symbol that is no symbol", HEAD + "«'a + b' = { kind = 'vector' }\n" + GOOD_CLAIM, "a + b"),
    BadPaper("a unit tensor", HEAD + "«'\\xi' = { kind = 'tensor', unit = true }\n" + GOOD_CLAIM, "unit"),
    BadPaper(
        "a definition that is a number",
        HEAD + "[definitions]\n'\\xi' = «1\n" + GOOD_CLAIM,
        "expected a string",
    ),
    BadPaper(
        "a definition of unknown symbols",
        HEAD + "[definitions]\n'\\xi' = '\\omega + «\\psi'\n" + GOOD_CLAIM,
        "\\psi",
    ),
    BadPaper(
        "an ill-typed definition",
        HEAD
        + "[conventions]\nproducts = 'matrices'\n[definitions]\n'\\xi' = '\\omega«\\omega'\n"
        + GOOD_CLAIM,
        "juxtaposition",
    ),
    BadPaper(
        "a definition in terms of itself",
        HEAD + "[definitions]\n'\\xi' = '\\omega + «\\xi'\n" + GOOD_CLAIM,
        "\\xi",
    ),
    BadPaper(
        "definitions in a circle",
        HEAD + "[definitions]\n'\\xi' = '\\omega + «\\chi'\n'\\chi' = '\\omega - \\xi'\n" + GOOD_CLAIM,
        "\\chi",
    ),
    BadPaper("motion of an unknown symbol", HEAD + "[motion]\n'«\\psi' = 'w_WB'\n" + GOOD_CLAIM, "\\psi"),
    BadPaper(
        "motion by an unknown name", HEAD + "[motion]\n'\\omega' = «'omega_WB'\n" + GOOD_CLAIM, "omega_WB"
    ),
    BadPaper(
        "motion of the wrong type", HEAD + "[motion]\n'\\omega' = «'R_WB'\n" + GOOD_CLAIM, "has the shape"
    ),
    BadPaper("motion of the wrong weight", HEAD + "[motion]\n'\\omega' = «'p_WP'\n" + GOOD_CLAIM, "weight"),
    BadPaper(
        "motion that is a number", HEAD + "[motion]\n'\\omega' = «1\n" + GOOD_CLAIM, "expected a string"
    ),
]
