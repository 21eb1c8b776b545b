"""Vocabulary of displays: the tokens that give a display its structure, by the kind of their node."""

from __future__ import annotations

import re
from enum import Enum, auto

from workbench.language.grammar.vocabulary import spellings
from workbench.source.rewriting.wrappers import WRAPPERS


class Kind(Enum):
    """The kind of a node. PLAIN: a letter, a number, or a command with its arguments."""

    PLAIN = auto()
    RELATION = auto()
    SIGN = auto()
    INFIX = auto()
    IMPLICATION = auto()
    FORALL = auto()
    WIDE = auto()
    GAP = auto()
    COMMA = auto()
    STOP = auto()
    OPEN = auto()
    CLOSE = auto()
    WORDS = auto()
    GROUP = auto()
    ENVIRONMENT = auto()
    SCRIPT = auto()
    BRACE_NOTE = auto()
    CANCEL = auto()
    NOTHING = auto()
    MARK = auto()
    BREAK = auto()


class Marks(Enum):
    """What the alignment marks of an environment of lines separate: right and left columns in pairs, single
    columns, or nothing."""

    PAIRS = auto()
    CELLS = auto()
    NONE = auto()


def _commands(names: str) -> frozenset[str]:
    return frozenset(f"\\{name}" for name in names.split())


#: The signs of inequalities, as authors write them.
ORDERS = {
    **dict.fromkeys((">", "\\gt"), ">"),
    **dict.fromkeys(("<", "\\lt"), "<"),
    **dict.fromkeys(("\\geq", "\\ge", "\\geqslant"), "≥"),
    **dict.fromkeys(("\\leq", "\\le", "\\leqslant"), "≤"),
}
UNEQUAL = _commands("neq ne")
_MUCH = _commands("ll gg")
#: A sign of an inequality in LaTeX.
ORDER = re.compile(r"\\(?:[lg](?:t|eq?|eqslant)|ll|gg)(?![A-Za-z])|[<>≤≥]")
EQUALITIES = frozenset({"=", ":=", "\\equiv", "\\stackrel", "\\overset"})
ARROWS = _commands("rightarrow to longrightarrow")
RELATIONS = (
    EQUALITIES
    | (spellings("RELATION") - {":", "\\colon"})
    | ORDERS.keys()
    | _MUCH
    | _commands(
        "simeq sim propto cong doteq subset subseteq prec succ preceq succeq lesssim defeq coloneq coloneqq"
        " eqqcolon"
    )
)
IMPLICATIONS = spellings("IMPLICATION") | _commands("Leftarrow impliedby Longleftarrow")
#: Relations next to an equation that state ranges of symbols.
RANGE_RELATIONS = ORDERS.keys() | _MUCH | _commands("in subset subseteq")
SIDE_RELATIONS = RANGE_RELATIONS | UNEQUAL | _commands("perp parallel")

GAPS = frozenset([" ", "\\,", "\\;", "\\:", "\\!", "\\ ", "\\\n", "~", "\\>"]) | _commands(
    "par enspace enskip thinspace medspace thickspace negthinspace negmedspace negthickspace space"
)
#: Narrow spaces that authors write intentionally.
VISIBLE_GAPS = frozenset({"\\ ", "\\\n", "~", "\\;"})
WIDE = _commands("quad qquad hfill hfil therefore because")
WIDE_WITH_ARGUMENT = _commands("hspace hskip mspace phantom hphantom")
KERNS = _commands("kern mkern mskip")
LENGTH = re.compile(r"\s*[+-]?\s*\d*\.?\d+\s*(?:mu|pt|em|ex|mm|cm|in|bp|sp|pc)")
ELLIPSES = _commands("dots ldots cdots vdots ddots dotsb dotsc")

INTERTEXTS = _commands("intertext shortintertext")
WORD_COMMANDS = _commands("text mbox hbox textrm textit textbf textnormal textsf tag") | INTERTEXTS
#: Words that some authors write in an upright face.
UPRIGHT_WORDS = frozenset({"and", "or", "if", "where"})
UPRIGHT_FACES = _commands("mathrm operatorname mathit")

#: Commands that print their last argument: the number of arguments before it.
WRAPPED = {f"\\{name}": count for name, count in WRAPPERS.items()}
NOTHING_WITH_ARGUMENT = _commands("color vspace label vphantom require")
NOTHING = _commands(
    "displaystyle textstyle nonumber notag nobreak allowbreak limits nolimits null relax strut mathstrut"
    " qedhere IEEEeqnarraynumspace IEEEyesnumber IEEEnonumber IEEEyessubnumber IEEEnosubnumber"
)
#: Commands with arguments that form one symbol or term: the number of arguments.
TERMS = dict.fromkeys(_commands("frac dfrac tfrac cfrac binom"), 2)
TERMS |= dict.fromkeys(
    _commands(
        "sqrt operatorname mathrm mathbf boldsymbol mathsf mathit mathcal mathbb bm vec dot ddot hat bar"
        " tilde widehat widetilde overline underline"
    ),
    1,
)
#: Commands of plain TeX for rows in braces, and the environment that prints the same.
ROWS_IN_BRACES = {
    "\\displaylines": "gathered",
    "\\substack": "gathered",
    "\\eqalign": "aligned",
    "\\eqalignno": "aligned",
    "\\leqalignno": "aligned",
}
ANNOTATED = _commands("stackrel overset underset xrightarrow xlongequal")
BRACES = _commands("underbrace overbrace underbracket overbracket")
CANCELS = _commands("cancel bcancel xcancel cancelto")
#: Two characters that form one sign.
TYPED = {(":", "="): ":=", ("=", ":"): "=", ("=", ">"): "\\Rightarrow"}

_OPENING = frozenset("([") | _commands("{ lbrace langle lfloor lbrack lparen")
_CLOSING = frozenset(")]") | _commands("} rbrace rangle rfloor rbrack rparen")

KINDS: dict[str, Kind] = {
    text: kind
    for kind, texts in (
        (Kind.OPEN, _OPENING),
        (Kind.CLOSE, _CLOSING),
        (Kind.RELATION, RELATIONS - {"\\stackrel", "\\overset"}),
        (Kind.IMPLICATION, IMPLICATIONS),
        (Kind.SIGN, spellings("SIGN") | _commands("pm mp")),
        (Kind.INFIX, (spellings("INFIX") - {"\\circ"}) | {"/"} | _commands("div")),
        (Kind.WIDE, WIDE),
        (Kind.GAP, GAPS),
        (Kind.NOTHING, NOTHING),
        (Kind.COMMA, {",", ";", "\\&"}),
        (Kind.STOP, {"."}),
        (Kind.MARK, {"&"}),
        (Kind.BREAK, {"\\\\", "\\cr"}),
        (Kind.FORALL, {"\\forall"}),
    )
    for text in texts
}


def _names(names: str) -> frozenset[str]:
    return frozenset(names.split())


#: Environments whose rows are lines.
LINES = {
    **dict.fromkeys(
        _names("align alignat flalign xalignat aligned alignedat split dgroup dmath"), Marks.PAIRS
    ),
    **dict.fromkeys(
        _names("eqnarray subeqnarray IEEEeqnarray array cases dcases rcases empheq"), Marks.CELLS
    ),
    **dict.fromkeys(_names("gather gathered multline multlined equation"), Marks.NONE),
}
#: Environments of one formula, whose rows can be its factors.
ONE_FORMULA = _names("split multline multline* multlined aligned alignedat")
CASES = ("cases", "dcases", "rcases")
#: Environments of lines with an argument.
WITH_ARGUMENT = _names("array alignedat alignat alignat* IEEEeqnarray xalignat")
#: Matrices whose rows are equations.
MATRICES_OF_LINES = frozenset({"matrix", "smallmatrix"})
