"""The LaTeX commands that a report can typeset, and the character for each.

The table is the report's promise: a command that is not in it is shown as source, and a formula whose MathML
does not contain exactly these characters is shown as source, too (see `mathml`).
"""

from __future__ import annotations

GREEK = {
    r"\alpha": "α", r"\beta": "β", r"\gamma": "γ", r"\delta": "δ", r"\epsilon": "ϵ",
    r"\varepsilon": "ε", r"\zeta": "ζ", r"\eta": "η", r"\theta": "θ", r"\iota": "ι",
    r"\kappa": "κ", r"\lambda": "λ", r"\mu": "μ", r"\nu": "ν", r"\xi": "ξ", r"\pi": "π",
    r"\rho": "ρ", r"\sigma": "σ", r"\tau": "τ", r"\upsilon": "υ", r"\phi": "ϕ", r"\varphi": "φ",
    r"\chi": "χ", r"\psi": "ψ", r"\omega": "ω", r"\Gamma": "Γ", r"\Delta": "Δ", r"\Theta": "Θ",
    r"\Lambda": "Λ", r"\Xi": "Ξ", r"\Pi": "Π", r"\Sigma": "Σ", r"\Upsilon": "Υ", r"\Phi": "Φ",
    r"\Psi": "Ψ", r"\Omega": "Ω",
}  # fmt: skip

#: Greek letters without a command.
LETTERS = {glyph: command for command, glyph in GREEK.items()}

BINARY_OPERATORS = {
    "+": "+", "-": "−", r"\cdot": "·", r"\times": "×", r"\otimes": "⊗", r"\circ": "∘",
    r"\oplus": "⊕", r"\pm": "±", r"\mp": "∓", "*": "*", r"\ast": "*", r"\wedge": "∧",
    r"\vee": "∨", r"\cap": "∩", r"\cup": "∪", r"\bullet": "•", r"\star": "⋆", r"\ominus": "⊖",
    r"\odot": "⊙", r"\setminus": "⧵", r"\div": "÷",
}  # fmt: skip

RELATIONS = {
    "=": "=", "<": "<", ">": ">", r"\neq": "≠", r"\ne": "≠", r"\leq": "≤", r"\le": "≤",
    r"\geq": "≥", r"\ge": "≥", r"\equiv": "≡", r"\approx": "≈", r"\triangleq": "≜",
    r"\in": "∈", r"\notin": "∉", r"\subset": "⊂", r"\subseteq": "⊆", r"\to": "→",
    r"\rightarrow": "→", r"\leftrightarrow": "↔", r"\Rightarrow": "⇒", r"\Leftrightarrow": "⇔",
    r"\iff": "⟺", r"\mid": "∣", r"\perp": "⟂", r"\parallel": "∥", ":": ":", r"\propto": "∝",
    r"\simeq": "≃", r"\cong": "≅", r"\ll": "≪", r"\gg": "≫", r"\supset": "⊃", r"\supseteq": "⊇",
    r"\coloneqq": "≔", r"\implies": "⟹", r"\longrightarrow": "⟶",
}  # fmt: skip

ORDINARY = {
    r"\infty": "∞", r"\forall": "∀", r"\exists": "∃", r"\partial": "∂", r"\nabla": "∇",
    r"\top": "⊤", r"\dots": "…", r"\ldots": "…", r"\cdots": "⋯", r"\sum": "∑", r"\prod": "∏",
    r"\int": "∫", r"\ell": "ℓ", r"\langle": "⟨", r"\rangle": "⟩", r"\|": "‖", r"\Vert": "‖",
    r"\lVert": "‖", r"\rVert": "‖", r"\lvert": "|", r"\rvert": "|", r"\{": "{", r"\}": "}",
    "(": "(", ")": ")", "[": "[", "]": "]", "|": "|", ",": ",", ";": ";", ".": ".", "/": "/",
    "!": "!", "'": "′", r"\lfloor": "⌊", r"\rfloor": "⌋", r"\lceil": "⌈", r"\rceil": "⌉",
    r"\angle": "∠", r"\emptyset": "∅", r"\neg": "¬", r"\dagger": "†", r"\hbar": "ℏ", r"\Re": "ℜ",
    r"\Im": "ℑ",
}  # fmt: skip

FUNCTION_NAMES = {
    "\\" + name: name
    for name in (
        *(
            "sin",
            "cos",
            "tan",
            "cot",
            "sec",
            "csc",
            "arcsin",
            "arccos",
            "arctan",
            "sinh",
            "cosh",
            "tanh",
            "coth",
        ),
        *("exp", "log", "ln", "det", "min", "max", "inf", "sup", "lim", "deg", "dim", "ker", "gcd"),
    )
}

SYMBOLS = GREEK | BINARY_OPERATORS | RELATIONS | ORDINARY | FUNCTION_NAMES

#: Characters that stand for other characters.
SAME = {"≜": "=", "⊤": "T", "⟺": "⇔"}

ACCENTS = {
    r"\dot": "˙", r"\ddot": "¨", r"\dddot": "...", r"\ddddot": "....", r"\tilde": "˜",
    r"\widetilde": "˜", r"\hat": "ˆ", r"\widehat": "ˆ", r"\bar": "¯", r"\overline": "¯",
    r"\vec": "→", r"\underline": "_", r"\mathring": "˚",
}  # fmt: skip
DELIMITERS = {
    "(", ")", "[", "]", "|", ".", "/", r"\{", r"\}", r"\langle", r"\rangle", r"\|", r"\Vert",
    r"\lVert", r"\rVert", r"\lvert", r"\rvert", r"\lfloor", r"\rfloor", r"\lceil", r"\rceil",
}  # fmt: skip
SIZES = frozenset(
    "\\" + size + side for size in ("big", "Big", "bigg", "Bigg") for side in ("", "l", "r", "m")
)

STYLES = {
    r"\mathbf", r"\boldsymbol", r"\bm", r"\mathrm", r"\mathit", r"\mathcal", r"\mathbb", r"\mathfrak",
    r"\mathsf", r"\mathscr",
}  # fmt: skip
WEIGHT_STYLES = frozenset((r"\mathbf", r"\boldsymbol", r"\bm"))
TEXT_COMMANDS = frozenset((r"\text", r"\operatorname", r"\textbf", r"\textit", r"\textrm"))
SPACES = frozenset((r"\,", r"\;", r"\:", r"\!", r"\ ", r"\quad", r"\qquad", "~"))
TWO_ARGUMENTS = frozenset((r"\frac", r"\dfrac", r"\tfrac", r"\binom", r"\stackrel")) | {
    r"\overset", r"\underset",
}  # fmt: skip
ENVIRONMENTS = frozenset(
    ("cases", "aligned", "split", "gathered", "array", "matrix", "bmatrix", "pmatrix", "vmatrix")
)
