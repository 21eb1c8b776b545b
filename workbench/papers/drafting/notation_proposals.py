"""Proposals for notation, conventions and frames; each is tried, and kept if it makes formulas readable."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from workbench.papers.drafting.drafted_abbreviations import USUAL, letters_of_functions
from workbench.papers.drafting.drafted_frames import frames
from workbench.papers.drafting.inference.infer import Inference
from workbench.papers.drafting.model_proposal import Proposal
from workbench.papers.drafting.typefaces import flat
from workbench.papers.drafting.words_on_symbols import speaks_of_quaternions
from workbench.papers.notation_tables import FUNCTIONS, HAMILTON

_BELOW = r"\s*_\s*(?:[2-9]|\{\s*[2-9]\s*(?:\\times\s*\d\s*)?\})"
#: Unit tensors by their letters: a blackboard 1 or I, a bold 1, and I with its size.
_UNITS = re.compile(
    rf"\\(?:mathbb|mathds)\s*\{{?\s*[1I]\s*\}}?(?:{_BELOW})?|\\(?:mathbf|boldsymbol|mathrm)\s*\{{?\s*1\s*\}}?(?:{_BELOW})?"
    rf"|(?:\\(?:mathbf|boldsymbol|mathrm)\s*\{{?\s*)?(?<![A-Za-z\\])[IE]\s*\}}?{_BELOW}|\\(?:boldsymbol|math(?:rm|cal|sf))\s*\{{?\s*I\s*\}}?(?!\s*_)"
)
_SYMBOL = r"(?:\\(?:mathbf|boldsymbol|bar|vec|mathsf|underline)\s*)?(?:\{\\?[A-Za-z]+\}|\\[A-Za-z]+|[A-Za-z])"
_DOTTED = rf"(?:\\d*dot\s*\{{?\s*{_SYMBOL}\s*\}}?|{_SYMBOL})"
_LABELLED = rf"{_DOTTED}\s*(?:_\s*(?:\w|\{{\s*\w+\s*\}}))?"
_BEHIND = r"(?:(?<=[A-Za-z}'*])|(?<=[_^]\d))\s*(?:\\left)?\(\s*"
_BRACKET = re.compile(rf"{_BEHIND}({_SYMBOL}(?:\s*_\s*(?:\w|\{{\s*\w+\s*\}}))?)\s*(?:\\right)?\)")
_WORD_WITH_BRACKET = re.compile(
    r"\\(?:mathrm|text|operatorname|mathsf|mathit|textrm|mbox)\s*\{\s*\w{2,}\s*\}"
    r"\s*(?:_\s*(?:\w|\{[^{}]*\}))?\s*(?:\\left)?\([^()]*\)"
)
_LIST = re.compile(rf"{_BEHIND}({_LABELLED}(?:\s*,\s*{_LABELLED})+)\s*(?:\\right)?\)")
#: (∂f/∂x)^T, in a text whose gradients are then columns.
_TRANSPOSED_SLOPE = re.compile(
    r"\\partial\s*\{?\\?[A-Za-z{}\\() ,]*\}\s*(?:\\right)?\s*\)?\s*\^\s*\{?\s*(?:\\top|T)(?![A-Za-z])"
)
#: Behind a letter, a bracket around a sum or a list.
_CALL = re.compile(
    rf"(?P<letter>{_LABELLED})\s*(?P<space>\\[,!;:]\s*)?(?:\\left|\\[bB]igg?l?)?\(\s*(?P<inside>(?:[^()]|\([^()]*\))*?)\s*(?:\\right|\\[bB]igg?r?)?\)"
)
#: What no argument of a function of several symbols is: a sine in a list.
_ENTRIES = re.compile(r"\\(?:sin|cos|tan)(?![A-Za-z]).*,|,.*\\(?:sin|cos|tan)(?![A-Za-z])", re.DOTALL)
#: Words, functions and commands before a bracket.
_OWN_FUNCTIONS = re.compile(
    r"\{[A-Za-z]{2,}\}|\\(?:exp|log|ln|d?frac|sqrt|left|right|[Bb]igg?[lr]?|(?:arc)?(?:sin|cos|tan)h?|quad|qquad|det)"
)
_DOTS_OFF = re.compile(rf"\\d*dot\s*\{{?\s*({_SYMBOL})\s*\}}?")
_TYPED = {name: re.compile(rf"(?<!\\)(?<!\\arc)(?<!arc)(?<!a){name}(?![A-Za-z2])") for name in FUNCTIONS}
_INERTIA = re.compile(r"\binertias?\b", re.IGNORECASE)
#: The sum of a quaternion's parts, or i j k = -1: group `font` is the font of the units.
_UNITS_OF_QUATERNIONS = re.compile(
    r"(?P<font>\\(?:mathbf|boldsymbol|hat|vec|mathrm)\s*\{?|)(?<![\\A-Za-z])?\s*i\}?(?:\s*\+[^=+]*|\s*)(?P=font)\s*j\}?(?:\s*\+[^=+]*|\s*)(?P=font)\s*k(?![A-Za-z])"
)


def proposals_for(formulas: Sequence[str], prose: str, inference: Inference) -> Iterator[Proposal]:
    """Yields the proposals that the formulas suggest, those that others depend on first."""
    together = "\n".join(formulas)
    if speaks_of_quaternions(prose):
        hamilton = {"quaternion": f'"{HAMILTON}"'}
        why = 'the text says "quaternion"'
        yield Proposal("conventions", hamilton, why, _QUATERNIONS, re.compile(""), stands=True)
        for trigger, key, where, means in _OF_QUATERNIONS:
            why = "a sign between or on quaternions"
            entry = _notation(trigger, key, where, means, why, _QUATERNIONS)
            yield replace(entry, stands="matrix" not in key)
        for units in dict.fromkeys(match["font"] for match in _UNITS_OF_QUATERNIONS.finditer(together)):
            yield _units(units.strip().rstrip("{"))
    for name, pattern in _TYPED.items():
        why = f"{name} stands without a backslash"
        question = f"Is {name} the function {name}?"
        yield replace(_conventions("functions", f"['{name}']", why, question, pattern), stands=True)
    for name, letter in letters_of_functions(formulas).items():
        head, why = USUAL[letter], f"{name} stands before angles"
        question = f"Is {name} the function {head}?"
        entry = _notation("", f"{name} x", {"x": "scalar"}, rf"\{head} x", why, question)
        yield replace(entry, stands=True)
    spin, other = (_TOP, _BOTTOM) if _SPIN_FIRST.search(together) else (_BOTTOM, _TOP)
    means = rf"\begin{{bmatrix}} \operatorname{{skew}}({spin}) & {other} \\ 0 & 0 \end{{bmatrix}}"
    for trigger, key in ((_IN_BRACKETS, "[V]"), (r"\^\s*\{?\s*\\wedge(?![A-Za-z])", r"V^\wedge")):
        question = f"Is {key} of a twist its matrix of 4×4?"
        yield _notation(trigger, key, {"V": "matrix 6×1"}, means, "a bracket or a wedge on a twist", question)
    for row in _NOTATION:
        yield _notation(*row)
    symbols = set(map(flat, inference.kinds))
    written = (" ".join(match[0].split()) for match in _UNITS.finditer(together))
    units = [each for each in written if flat(each) not in symbols]
    if "I" in inference.kinds and inference.is_square("I") and not _INERTIA.search(prose):
        units.append("I")
    for unit in dict.fromkeys(units):
        trigger = re.escape(unit) if len(unit) > 1 else r"(?<![A-Za-z\\{])I(?![A-Za-z])"
        yield replace(unit_tensor(unit), trigger=re.compile(trigger), stands=True)
    yield _prime(("scalar", "vector", "tensor", *(["quaternion"] if speaks_of_quaternions(prose) else [])))
    for inside in _arguments(together):
        question = f"Does ({inside}) only say what a symbol depends on?"
        found = re.compile(re.escape(inside))
        yield _conventions("arguments", f"['{inside}']", "a bracket with one symbol", question, found)
    for inside in dict.fromkeys(match[1].strip() for match in _LIST.finditer(together)):
        question = f"Does ({inside}) only say what a symbol depends on?"
        bare = (_DOTS_OFF.sub(r"\1", symbol.strip()) for symbol in inside.split(","))
        several = ", ".join(f"'{symbol}'" for symbol in dict.fromkeys(bare))
        found = re.compile(re.escape(inside))
        yield _conventions("arguments", f"[{several}]", "symbols in a bracket", question, found)
    if _multiplies_lists(together):
        yield _conventions("brackets", '"factors"', "a list of values behind a letter", _FACTORS, _CALL)
    gradient = '"row"' if _TRANSPOSED_SLOPE.search(together) else '"column"'
    question = "How does the derivative of a scalar by a column stand, as a row or a column?"
    yield _conventions("gradient", gradient, "a partial derivative", question, re.compile(r"\\partial"))
    if "dyad" in prose.lower():
        question = "Are vectors beside each other dyads?"
        yield _conventions("products", '"dyads"', 'the text says "dyad"', question, re.compile(""))
    ones = re.compile(r"(?<![\d.])1(?![\d.])")
    yield _conventions("one", '"unit"', "a number beside tensors", "Is 1 the unit tensor?", ones)
    powers = re.compile(r"(?:sin|cos|tan)\s*(?:\\left\s*)?\([^()]*\)\s*\^")
    question = r"Is \sin(x)^2 the power of the sine?"
    yield _conventions("powers", '"values"', "a power behind a bracket", question, powers)
    yield from frames(together)
    question = r"Is \hat{x} the skew tensor of x?"
    hat = _notation(
        r"\\(?:wide)?hat(?![A-Za-z])", r"\hat{x}", {"x": "vector"}, _SKEW, "a hat on a symbol", question
    )
    if "\\hat" in inference.skew_marks:
        yield hat


def _arguments(formulas: str) -> dict[str, None]:
    """Returns the symbols that stand alone in a bracket behind a letter, the innermost ones first: t and α
    of R_n(α(t))."""
    formulas = _WORD_WITH_BRACKET.sub("", formulas)  # Rot_z(θ_i) takes a value
    found: dict[str, None] = {}
    while new := dict.fromkeys(match[1] for match in _BRACKET.finditer(formulas)):
        found |= new
        formulas = _BRACKET.sub("", formulas)
    return found


def _multiplies_lists(formulas: str) -> bool:
    r"""True if letters stand before lists of values, as in r\,(\cos\theta, \sin\theta), and before no bracket
    that may contain an argument."""
    calls = [match for match in _CALL.finditer(formulas) if not _OWN_FUNCTIONS.fullmatch(match["letter"])]
    others = [match for match in calls if not _ENTRIES.search(match["inside"])]
    return len(others) < len(calls) and all(match["space"] or match["inside"] == "t" for match in others)


def unit_tensor(name: str) -> Proposal:
    """Returns the proposal that a letter is the unit tensor."""
    question = f"Is {name} the unit tensor?"
    return _notation(re.escape(name), name, {}, r"\mathbf{I}", "a letter of unit tensors", question)


_FACTORS = "Does what stands in a bracket behind a letter multiply it?"
_QUATERNIONS = "Are quaternions Hamilton's (i j = k), scalar part first?"
_SKEW = r"\operatorname{skew}(x)"
_LEFT = (
    r"\begin{bmatrix} \operatorname{Sc}(q) & -(\operatorname{Vec}(q))^T \\ \operatorname{Vec}(q)"
    r" & \operatorname{Sc}(q) \mathbf{I} %s \operatorname{skew}(\operatorname{Vec}(q)) \end{bmatrix}"
)
#: One symbol in square brackets, which do not group then.
_IN_BRACKETS = (
    r"\[\s*(?:\\[a-z]+\s*\{?\s*)*\\?[A-Za-z]+\}*(?:_\s*(?:\w|\{[^{}]*\}))?\}*\s*(?:\\right\s*)?\]"
    r"(?!\s*[_^]\s*\{?\s*\\times)"
)
_Q = {"q": "quaternion"}
_OF_QUATERNIONS: tuple[tuple[str, str, dict[str, str], str], ...] = (
    (r"\*|\\ast", "q^*", _Q, r"\operatorname{conj}(q)"),
    (r"(?<![\^{])\*", "p * q", {"p": "quaternion", "q": "quaternion"}, "p q"),
    (r"\[[^\],]*,[^\],]*\]", "[s, v]", {"s": "scalar", "v": "vector"}, r"\operatorname{quat}(s, v)"),
    (
        r"\[[^\],]*(?:,[^\],]*){3}\]",
        "[s, x, y, z]",
        dict.fromkeys("sxyz", "scalar"),
        r"\operatorname{quat}(s, \begin{bmatrix} x \\ y \\ z \end{bmatrix})",
    ),
    (
        r"\\begin\{[bp]matrix",
        r"\begin{bmatrix} s \\ v \end{bmatrix}",
        {"s": "scalar", "v": "vector"},
        r"\operatorname{quat}(s, v)",
    ),
    (
        r"\\begin\{[bp]matrix",
        r"\begin{bmatrix} s \\ x \\ y \\ z \end{bmatrix}",
        dict.fromkeys("sxyz", "scalar"),
        r"\operatorname{quat}(s, \begin{bmatrix} x \\ y \\ z \end{bmatrix})",
    ),
    (r"\^\{?\s*\+", "q^+", _Q, _LEFT % "+"),
    (r"\^\{?\s*\\oplus", r"q^\oplus", _Q, _LEFT % "-"),
    (r"-1\s*\\oplus", r"q^{-1 \oplus}", _Q, r"(q^{-1})^\oplus"),
)
_TOP, _BOTTOM = (
    rf"\begin{{bmatrix}} {row} \end{{bmatrix}} V"
    for row in (r"\mathbf{I} & \mathbf{0}_{3\times 3}", r"\mathbf{0}_{3\times 3} & \mathbf{I}")
)
_SPIN_FIRST = re.compile(r"matrix\}\s*(?:\{\})?(?:[_^]\S*\s*)?(?:\\[a-z]+\s*\{?\s*)*\\(?:omega|Omega)")
_NOTATION: tuple[tuple[str, str, dict[str, str], str, str, str], ...] = (
    (
        r"(?<!\^)(?<!\^\{)\s*\\(?:wedge|land)(?![A-Za-z])",
        r"x \wedge y",
        {"x": "vector", "y": "vector"},
        r"x \times y",
        "a wedge between vectors",
        r"Is \wedge between two vectors the vector product?",
    ),
    (
        r"\^\s*\{?\s*\\(?:wedge|land)(?![A-Za-z])",
        r"x^\wedge",
        {"x": "vector"},
        _SKEW,
        "a wedge as a superscript",
        r"Is x^\wedge the skew tensor of x?",
    ),
    *(
        (
            trigger,
            key,
            {"x": "vector"},
            _SKEW,
            "a bracket or a cross on a symbol",
            f"Is {key} the skew tensor of x?",
        )
        for trigger, key in (
            (r"\]\s*_\s*\{?\s*\\times", r"[x]_\times"),
            (r"\]\s*\^\s*\{?\s*\\times", r"[x]^\times"),
            (r"\\rfloor\s*_\s*\{?\s*\\times", r"\lfloor x \rfloor_\times"),
            (r"\\times\s*(?:\\right\s*)?\\rfloor", r"\lfloor x \times \rfloor"),
            (r"\\times\s*\}?\s*(?:\\right\s*)?\]", r"[x \times]"),
            (r"\\times\s*\}?\s*(?:\\right\s*)?\)", r"(x \times)"),
            (r"[A-Za-z}]\s*\^\s*\{?\s*\\times", r"x^\times"),
            (_IN_BRACKETS, "[x]"),
        )
    ),
    (
        r"(?<![\^{*])\*(?![*}])",
        "x * y",
        {"x": "scalar", "y": "scalar"},
        "x y",
        "a star between factors",
        "Is * the product?",
    ),
    (
        r"\^\s*\{?\s*\\(?:vee|lor)(?![A-Za-z])",
        r"T^\vee",
        {"T": "tensor"},
        r"\operatorname{vect}(T)",
        "a vee as a superscript",
        r"Is T^\vee the vector of the skew tensor T?",
    ),
    *(
        (
            r"[A-Za-z}\])]\s*\.\s*\\?[A-Za-z({\[\\]",
            key,
            dict.fromkeys(key[::4], kind),
            means,
            "a full stop between factors",
            "Is a full stop between factors the product, of vectors the scalar one?",
        )
        for key, kind, means in (("x . y", "vector", r"x \cdot y"), ("a . b", "scalar", "a b"))
    ),
)


def _notation(
    trigger: str, key: str, where: Mapping[str, str], means: str, why: str, question: str
) -> Proposal:
    formal = ", ".join(f'{name} = "{kind}"' for name, kind in where.items())
    given = f"where = {{ {formal} }}, " if where else ""
    entry = {f"'{key}'": f"{{ {given}means = '{means}' }}"}
    return Proposal("notation", entry, why, question, re.compile(trigger))


def _units(font: str) -> Proposal:
    """Returns the proposal that i, j and k in this font are the units of quaternions."""
    spelled = [f"{font}{{{letter}}}" if font else letter for letter in "ijk"]
    columns = (r" \\ ".join(str(int(index == other)) for other in range(3)) for index in range(3))
    entries = {
        f"'{unit}'": rf"{{ means = '\operatorname{{quat}}(0, \begin{{bmatrix}} {column} \end{{bmatrix}})' }}"
        for unit, column in zip(spelled, columns, strict=True)
    }
    question = f"Are {', '.join(spelled)} the units of the quaternions?"
    trigger = re.compile("|".join(map(re.escape, spelled)))
    return Proposal("notation", entries, "i, j and k in a quaternion", question, trigger, stands=True)


def _prime(kinds: Sequence[str]) -> Proposal:
    entries = {
        f'"{letter}\'"': f"{{ where = {{ {letter} = \"{kind}\" }}, means = '\\dot{{{letter}}}' }}"
        for letter, kind in zip("axTq", kinds, strict=False)
    }
    return Proposal("notation", entries, "a prime", "Is a prime d/dt?", re.compile(r"(?<!\\)'"))


def _conventions(key: str, value: str, why: str, question: str, trigger: re.Pattern[str]) -> Proposal:
    return Proposal("conventions", {key: value}, why, question, trigger)
