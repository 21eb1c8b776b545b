"""The commands, characters and words that the claim language knows, and the token that each becomes."""

from __future__ import annotations

#: What a function is called in a paper → the head of the term.
FUNCTIONS = {
    "det": "det",
    "tr": "trace",
    "Tr": "trace",
    "trace": "trace",
    "sym": "symmetric",
    "skew": "skew",
    "vect": "vect",
    "adj": "adjugate",
    "Re": "re",
    "Du": "du",
    "sin": "sin",
    "cos": "cos",
    "exp": "exp",
    "div": "divergence",
    "curl": "curl",
    "rot": "curl",
}

_LETTERS = """
    alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa lambda mu nu xi pi varpi rho
    varrho sigma varsigma tau upsilon phi varphi chi psi omega ell
    Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega
"""
_STYLES = "mathbf boldsymbol mathrm mathit mathsf mathcal mathbb mathfrak underline overline bar vec"
_SIZES = "left right big Big bigg Bigg bigl Bigl biggl Biggl bigr Bigr biggr Biggr"
_SPACING = "quad qquad displaystyle textstyle limits nolimits nonumber notag , ; : ! >"

COMMANDS: dict[str, tuple[str, str]] = {
    **{name: ("LETTER", f"\\{name}") for name in _LETTERS.split()},
    **{name: ("STYLE", f"\\{name}") for name in _STYLES.split()},
    **{name: ("FUNCTION", f"\\{name}") for name in ("det", "sin", "cos", "exp", "Re")},
    "bm": ("STYLE", "\\boldsymbol"),
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
    "cdot": ("INFIX", "·"),
    "times": ("INFIX", "×"),
    "otimes": ("INFIX", "⊗"),
    "circ": ("INFIX", "∘"),
    "neq": ("RELATION", "≠"),
    "ne": ("RELATION", "≠"),
    "triangleq": ("RELATION", "="),
    "geq": ("RELATION", "≥"),
    "ge": ("RELATION", "≥"),
    "in": ("RELATION", "∈"),
    "forall": ("FORALL", "∀"),
    "Leftrightarrow": ("IMPLICATION", "⇔"),
    "Longleftrightarrow": ("IMPLICATION", "⇔"),
    "iff": ("IMPLICATION", "⇔"),
    "Rightarrow": ("IMPLICATION", "⇒"),
    "Longrightarrow": ("IMPLICATION", "⇒"),
    "implies": ("IMPLICATION", "⇒"),
    "top": ("MARK", "T"),
    "intercal": ("MARK", "T"),
    "ast": ("MARK", "*"),
    "infty": ("MARK", "∞"),
}
CHARACTERS = {
    "+": ("SIGN", "+"),
    "-": ("SIGN", "-"),
    "=": ("RELATION", "="),
    ">": ("RELATION", ">"),
    ",": ("COMMA", ","),
    ";": ("COMMA", ";"),
    "^": ("SUP", "^"),
    "_": ("SUB", "_"),
    "'": ("PRIME", "'"),
    "!": ("BANG", "!"),
    "*": ("MARK", "*"),
}
SPACING = frozenset(_SPACING.split()) | {" "}
SIZES = frozenset(_SIZES.split())

#: Bracket → (its kind, 1 if it opens, -1 if it closes, 0 if that depends on what stands before it).
BRACKETS = {
    "(": ("(", 1),
    ")": ("(", -1),
    "[": ("[", 1),
    "]": ("[", -1),
    "\\{": ("\\{", 1),
    "\\}": ("\\{", -1),
    "\\langle": ("\\langle", 1),
    "\\rangle": ("\\langle", -1),
    "|": ("|", 0),
    "\\|": ("\\|", 0),
    "\\lvert": ("|", 1),
    "\\rvert": ("|", -1),
    "\\lVert": ("\\|", 1),
    "\\rVert": ("\\|", -1),
}
MATRICES = frozenset({"matrix", "bmatrix", "pmatrix", "smallmatrix"})
LINES = frozenset({"cases", "aligned", "align", "align*", "gathered", "split"})

#: Words that join statements; "a if b" is b ⇒ a.
WORDS = {
    "where": "COMMA",
    "with": "COMMA",
    "and": "COMMA",
    "for": "COMMA",
    "for all": "FORALL",
    "if": "IMPLICATION",
    "when": "IMPLICATION",
    "iff": "IMPLICATION",
    "if and only if": "IMPLICATION",
}
CONVERSE = {"if": "⇐", "when": "⇐", "if and only if": "⇔", "iff": "⇔"}

#: Ellipses; none of them can be read.
DOTS = frozenset({"dots", "ldots", "cdots", "vdots", "ddots", "dotsb", "dotsc", "dotsi", "dotsm", "dotso"})
#: What to write in place of commands that cannot be read.
EXPECTED = {
    **dict.fromkeys(("leq", "le", "lt"), "a range is written n \\geq 1 or n = \\overline{1,5}"),
    "wedge": "the vector product is written \\times, the skew tensor of x \\tilde{x}",
    "prime": "a prime is written '",
}

ENDS_A_FACTOR = frozenset(
    {"LETTER", "NUMBER", "MARK", "RBRACE", "CLOSE", "PRIME", "BANG", "END_MATRIX", "END_LINES"}
)
#: A line that ends with one of these, or is followed by one, goes on.
GOES_ON = frozenset({"RELATION", "INFIX", "IMPLICATION"})
