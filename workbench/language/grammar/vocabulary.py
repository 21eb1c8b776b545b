"""Vocabulary of the claim language: commands, characters and words, with the token that each becomes."""

from __future__ import annotations

import re

from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.operations import FUNCTIONS, TEX_FUNCTIONS
from workbench.core.reasons import Reason

_LETTERS = """
    alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa lambda mu nu xi pi varpi rho
    varrho sigma varsigma tau upsilon phi varphi chi psi omega ell hbar imath jmath wp varkappa
    Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega
"""
_FONTS = (
    "mathbf boldsymbol mathrm mathit mathsf mathcal mathbb mathfrak mathscr mathds mathbfit mathbfup symup"
)
_STYLES = f"{_FONTS} underline overline bar vec hat check breve mathring"
_LABELS = "dagger ddagger flat natural sharp bullet diamond #"
_SIZES = "left right big Big bigg Bigg bigl Bigl biggl Biggl bigr Bigr biggr Biggr"
#: The printed number of a formula: (2.1), [3] or (A.4b), perhaps after the length of a space.
NUMBER = re.compile(
    r"(?:\{[^{}]*\})?\s*(?:\\(?:text|mathrm|textrm|mbox)\s*\{\s*)?"
    r"[(\[]\s*(?:[A-Z]\.?)?\d[\d.\-–]*\s*[a-z]?'?\s*[)\]]\s*\}?[\s.,;]*"
)
BY_HAND = re.compile(rf"^{NUMBER.pattern}\\q?quad(?![A-Za-z])|\\q?quad\s*{NUMBER.pattern}$")

_SPACING = "enskip quad qquad displaystyle textstyle limits nolimits nonumber notag , ; : ! >"

#: The sign of an equation modulo a number, which is infix or stands at the end.
MODULO = "mod"

COMMANDS: dict[str, tuple[str, str]] = {
    **{name: ("LETTER", f"\\{name}") for name in _LETTERS.split()},
    **{name: ("STYLE", f"\\{name}") for name in _STYLES.split()},
    **{name: ("FUNCTION", f"\\{name}") for name in (*TEX_FUNCTIONS, "sqrt", "Re")},
    "partial": ("LETTER", "\\partial"),
    "nabla": ("LETTER", "\\nabla"),
    "bm": ("STYLE", "\\boldsymbol"),
    "widehat": ("STYLE", "\\hat"),
    "overrightarrow": ("STYLE", "\\vec"),
    "dot": ("ACCENT", "1"),
    "ddot": ("ACCENT", "2"),
    "dddot": ("ACCENT", "3"),
    "ddddot": ("ACCENT", "4"),
    "tilde": ("ACCENT", "~"),
    "widetilde": ("ACCENT", "~"),
    "frac": ("FRACTION", "frac"),
    "tfrac": ("FRACTION", "frac"),
    "dfrac": ("FRACTION", "frac"),
    "binom": ("BINOMIAL", "binom"),
    "sum": ("SUM", "sum"),
    **{name: ("SUM", name) for name in ("int", "iint", "iiint", "oint", "lim")},
    "min": ("EXTREMAL", "min"),
    "max": ("EXTREMAL", "max"),
    "cdot": ("INFIX", "·"),
    **{name: ("INFIX", MODULO) for name in ("bmod", "mod", "pmod")},
    "times": ("INFIX", "×"),
    "otimes": ("INFIX", "⊗"),
    "circ": ("INFIX", "∘"),
    "wedge": ("INFIX", "∧"),
    "land": ("INFIX", "∧"),
    "vee": ("INFIX", "∨"),
    "lor": ("INFIX", "∨"),
    "oplus": ("INFIX", "⊕"),
    "ominus": ("INFIX", "⊖"),
    "odot": ("INFIX", "⊙"),
    "boxplus": ("INFIX", "⊞"),
    "boxminus": ("INFIX", "⊟"),
    "backslash": ("INFIX", "∖"),
    "setminus": ("INFIX", "∖"),
    "neq": ("RELATION", "≠"),
    "ne": ("RELATION", "≠"),
    "triangleq": ("RELATION", "="),
    "equiv": ("RELATION", "="),
    "coloneq": ("RELATION", "="),
    "coloneqq": ("RELATION", "="),
    "approx": ("RELATION", "≈"),
    "geq": ("RELATION", "≥"),
    "ge": ("RELATION", "≥"),
    "in": ("RELATION", "∈"),
    "perp": ("RELATION", "\\perp"),
    "parallel": ("RELATION", "\\parallel"),
    "colon": ("RELATION", ":"),
    **dict.fromkeys(("to", "rightarrow", "longrightarrow"), ("RELATION", "→")),
    **dict.fromkeys(("mapsto", "longmapsto"), ("RELATION", "↦")),
    "mid": ("COMMA", "|"),
    "forall": ("FORALL", "∀"),
    "&": ("AND", "and"),
    "Leftrightarrow": ("IMPLICATION", "⇔"),
    "Longleftrightarrow": ("IMPLICATION", "⇔"),
    "iff": ("IMPLICATION", "⇔"),
    "Rightarrow": ("IMPLICATION", "⇒"),
    "Longrightarrow": ("IMPLICATION", "⇒"),
    "implies": ("IMPLICATION", "⇒"),
    "ln": ("FUNCTION", "\\log"),
    "top": ("MARK", "T"),
    "intercal": ("MARK", "T"),
    "ast": ("MARK", "*"),
    "star": ("MARK", "\\star"),
    "infty": ("MARK", "∞"),
    **{name: ("MARK", f"\\{name}") for name in _LABELS.split()},
}
CHARACTERS = {
    "+": ("SIGN", "+"),
    "-": ("SIGN", "-"),
    "=": ("RELATION", "="),
    ">": ("RELATION", ">"),
    ",": ("COMMA", ","),
    ";": ("COMMA", ";"),
    ":": ("RELATION", ":"),
    "^": ("SUP", "^"),
    "_": ("SUB", "_"),
    "'": ("PRIME", "'"),
    "!": ("BANG", "!"),
    "*": ("MARK", "*"),
}
_WRITTEN = {token: f"\\{name}" for name, token in reversed(COMMANDS.items())} | {
    token: character for character, token in CHARACTERS.items()
}
#: Greek letters in Unicode.
CHARACTERS |= {
    chr(code): ("LETTER", f"\\{name}")
    for name, code in {
        "alpha": 0x3B1, "beta": 0x3B2, "gamma": 0x3B3, "delta": 0x3B4, "zeta": 0x3B6, "eta": 0x3B7,
        "theta": 0x3B8, "iota": 0x3B9, "kappa": 0x3BA, "lambda": 0x3BB, "mu": 0x3BC, "nu": 0x3BD,
        "xi": 0x3BE, "pi": 0x3C0, "rho": 0x3C1, "sigma": 0x3C3, "tau": 0x3C4, "upsilon": 0x3C5,
        "chi": 0x3C7, "psi": 0x3C8, "omega": 0x3C9, "Gamma": 0x393, "Delta": 0x394, "Theta": 0x398,
        "Lambda": 0x39B, "Xi": 0x39E, "Pi": 0x3A0, "Sigma": 0x3A3, "Phi": 0x3A6, "Psi": 0x3A8, "Omega": 0x3A9,
    }.items()
}  # fmt: skip
SPACING = frozenset(_SPACING.split()) | {" "}
SIZES = frozenset(_SIZES.split())
FONTS = frozenset(f"\\{name}" for name in _FONTS.split())

#: Bracket → (its kind, 1 if it opens, -1 if it closes, 0 if that depends on the previous token).
BRACKETS = {
    "(": ("(", 1),
    ")": ("(", -1),
    "[": ("[", 1),
    "]": ("[", -1),
    "\\{": ("\\{", 1),
    "\\}": ("\\{", -1),
    "\\lfloor": ("\\lfloor", 1),
    "\\rfloor": ("\\lfloor", -1),
    "\\langle": ("\\langle", 1),
    "\\rangle": ("\\langle", -1),
    "|": ("|", 0),
    "\\|": ("\\|", 0),
    "\\lvert": ("|", 1),
    "\\rvert": ("|", -1),
    "\\lVert": ("\\|", 1),
    "\\rVert": ("\\|", -1),
}
#: The bracket of \\left. f \\right|_{x = 0}, f at a place.
BAR = "\\left."
CLOSING = {kind: text for text, (kind, side) in reversed(BRACKETS.items()) if side < 1} | {BAR: "\\right|"}

MATRICES = frozenset(
    {"matrix", "bmatrix", "pmatrix", "Bmatrix", "smallmatrix", "bsmallmatrix", "psmallmatrix", "vmatrix"}
)
LINES = frozenset({"cases", "aligned", "align", "align*", "gathered", "split"})
ENVIRONMENTS = MATRICES | LINES | {"array"}

#: Relations of two vectors, and the product that is then zero.
ORIENTATIONS = ("\\perp", "\\parallel")

#: Signs without a built-in meaning: a paper defines them in [notation].
OWN_SIGNS = {
    "∧": "the vector product is written \\times, the skew tensor of x \\tilde{x}",
    **dict.fromkeys("∨⊕⊖⊙⊞⊟∖*", "a sign that [notation] does not explain"),
    ".": "a full stop inside a formula, which [notation] does not explain as a product",
}

#: Words that join statements. After a GIVEN come the conditions of the preceding or, with a THEN, the
#: following statement.
WORDS = {
    **dict.fromkeys(("where", "with", "for", "if", "when", "whenever", "given", "given that"), "GIVEN"),
    **dict.fromkeys(("provided", "provided that", "assuming", "assuming that", "such that"), "GIVEN"),
    "then": "THEN",
    **dict.fromkeys(("and", "\\&"), "AND"),
    "for all": "FORALL",
    "for every": "FORALL",
    "for any": "FORALL",
    "iff": "IMPLICATION",
    "if and only if": "IMPLICATION",
}

#: Names of operations: never products of letters, with or without a backslash.
NAMES = frozenset(["Ad", "Exp", "Log", "diag", "log", "rank", "sgn", "sign", "vec", "vex", "Rot", "Trans"])
#: The same for upright letters; ad without a command is a product.
UPRIGHT_NAMES = NAMES | {"ad"}
#: Upright names of several letters that are not words: groups and differentials.
UPRIGHT = frozenset(["SO", "SE", "so", "se", "dt", "dx", "dy", "dz", "dq", "ds"])

#: Ellipses, which the parser rejects.
DOTS = frozenset({"dots", "ldots", "cdots", "vdots", "ddots", "dotsb", "dotsc", "dotsi", "dotsm", "dotso"})
#: Replacements for commands that the parser rejects.
EXPECTED = {
    **dict.fromkeys(
        ("inf", "sup"),
        "a bound that need not be reached is not read; \\min and \\max are",
    ),
    **dict.fromkeys(("leftrightarrow", "longleftrightarrow"), "a map goes one way: \\to"),
    **dict.fromkeys(("subset", "subseteq"), "a part of a set is not read; its members are, as in x \\in V_3"),
    **dict.fromkeys(("leq", "le", "lt"), "a range is written n \\geq 1 or n = \\overline{1,5}"),
    "prime": "a prime is written '",
    **dict.fromkeys(
        ("pm", "mp"),
        "one sign of two on one side says either, which is read of scalars; on both sides it says both",
    ),
    **dict.fromkeys(("gets", "leftarrow", "Leftarrow"), "an assignment is no equation"),
    **dict.fromkeys(("simeq", "sim", "cong", "doteq", "propto"), "an approximation is not read"),
    "Log": "of two logarithms, the column \\operatorname{vect}(\\log R) and \\log R, [notation] says which",
    **dict.fromkeys(("limsup", "liminf"), "the upper and the lower limit are not read; \\lim is"),
    **dict.fromkeys(("prod", "bigcup", "bigoplus"), "products over an index are not read"),
    **dict.fromkeys(("leqslant", "ll", "gg", "geqslant", "<"), "inequalities are not read"),
    **dict.fromkeys(("arg", "argmin", "argmax"), "where a bound is reached is not read; \\min and \\max are"),
}

ENDS_A_FACTOR = frozenset(
    {"LETTER", "NUMBER", "MARK", "RBRACE", "CLOSE", "PRIME", "BANG", "END_MATRIX", "END_LINES"}
)


def is_upright(text: str, plain: str) -> bool:
    """True if \\mathrm{plain} is a letter or one of UPRIGHT."""
    return text.startswith("\\mathrm") and (len(plain) == 1 or plain in UPRIGHT)


def spellings(kind: str) -> frozenset[str]:
    """Returns the commands and characters that become tokens of this kind."""
    commands = {f"\\{name}" for name, (each, _) in COMMANDS.items() if each == kind}
    return frozenset(commands | {sign for sign, (each, _) in CHARACTERS.items() if each == kind})


def written(kind: str, value: str) -> str:
    """Returns the LaTeX of a token: \\times for the INFIX ×."""
    return _WRITTEN.get((kind, value), value)


def words_in_a_formula(text: str) -> Reason:
    return SyntaxCode.UNKNOWN_FUNCTION(text=text, known=", ".join(sorted(FUNCTIONS)))


def guessed(dots: str) -> Reason:
    return SyntaxCode.ELLIPSIS(dots=dots)
