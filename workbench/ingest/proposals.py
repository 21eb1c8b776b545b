"""Notation, conventions and frames that a text seems to use: each is tried, and kept where it helps."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from workbench.language.symbols import SymbolTable
from workbench.papers.notation import FUNCTIONS, HAMILTON, notation_of
from workbench.papers.toml_file import TomlFile

_STYLE = r"(?:\\(?:bar|vec|mathbf|boldsymbol|mathsf|underline|mathrm|hat)\s*)"
_SCRIPT = (
    rf"(?:\{{[^{{}}]*(?:\{{[^{{}}]*\}}[^{{}}]*)*\}}|{_STYLE}\{{[A-Za-z]+\}}|{_STYLE}[A-Za-z](?![A-Za-z])"
    r"|\\[A-Za-z]+(?![A-Za-z{])|[A-Za-z0-9])"
)
_CORE = rf"(?:{_STYLE}\{{\s*\\?[A-Za-z]+\s*\}}|{_STYLE}?\\?[A-Za-z])"
_SEEN_FROM = re.compile(rf"\{{\}}\s*\^\s*(?P<F>{_SCRIPT})\s*(?P<core>{_CORE})(?:\s*\^\s*(?P<G>{_SCRIPT}))?")
_RATE_IN = re.compile(rf"\{{\}}\s*\^\s*(?P<F>{_SCRIPT})\s*(?:d(?![A-Za-z])|\\frac\s*\{{?\s*d)")
_BETWEEN = re.compile(rf"(?P<core>{_CORE})\s*\^\s*\{{\s*(?P<P>[^{{}}/]+?)\s*/\s*(?P<O>[^{{}}/]+?)\s*\}}")
_JOINED = re.compile(rf"(?P<core>{_CORE})\s*\^\s*\{{\s*(?P<O>[A-Z])\s*(?P<P>[A-Z])\s*\}}")
_BOLD = r"\\(?:mathbf|boldsymbol)"
_AXIS = re.compile(
    rf"(?:(?P<outer>{_BOLD})\s*\{{\s*)?\\hat\s*\{{?\s*(?:(?P<inner>{_BOLD})\s*\{{?\s*)?(?P<letter>[a-z])\}}*"
    r"\s*_\s*\{?\s*(?P<axis>[xyz123])(?![A-Za-z0-9])"
)
#: The frame in which the others move, where the text names none.
_NOWHERE = "O"
#: Capitals that mechanics has for rotations; X and T may be transforms.
_ROTATIONS = frozenset("ACDQRS")
_LABELS = re.compile(r"\{\}\s*[_^]|/|\\hat|\[\s*(?:\\dot\s*\{)?\s*[A-Z]\s*[A-Z]")
#: [BN], where neither letter stands for itself.
_TURN = re.compile(r"\[\s*(?:\\dot\s*\{)?\s*([A-Z])\s*([A-Z])\s*(?:\(t\)\s*)?\}?\s*\]")
_ALONE = r"(?<![\\A-Za-z/_^{{]){}(?![A-Za-z])"
_UNITS = re.compile(r"\\(?:mathbb|mathds)\s*\{?\s*[1I]\s*\}?(?:_\{\s*\d\s*\\times\s*\d\s*\})?")
_SYMBOL = r"(?:\\(?:mathbf|boldsymbol|bar|vec|mathsf|underline)\s*)?(?:\{\\?[A-Za-z]+\}|\\[A-Za-z]+|[A-Za-z])"
_DOTTED = rf"(?:\\d*dot\s*\{{?\s*{_SYMBOL}\s*\}}?|{_SYMBOL})"
_LABELLED = rf"{_DOTTED}\s*(?:_\s*(?:\w|\{{\s*\w+\s*\}}))?"
_BEHIND = r"(?<=[A-Za-z}])\s*(?:\\left)?\(\s*"
_BRACKET = re.compile(rf"{_BEHIND}({_SYMBOL})\s*(?:\\right)?\)")
_LIST = re.compile(rf"{_BEHIND}({_LABELLED}(?:\s*,\s*{_LABELLED})+)\s*(?:\\right)?\)")
#: (∂f/∂x)^T, which is a column then.
_TRANSPOSED_SLOPE = re.compile(
    r"\\partial\s*\{?\\?[A-Za-z{}\\() ,]*\}\s*(?:\\right)?\s*\)?\s*\^\s*\{?\s*(?:\\top|T)(?![A-Za-z])"
)
_DOTS_OFF = re.compile(rf"\\d*dot\s*\{{?\s*({_SYMBOL})\s*\}}?")
_TYPED = {name: re.compile(rf"(?<!\\)(?<!\\arc)(?<!arc)(?<!a){name}(?![A-Za-z2])") for name in FUNCTIONS}
#: The sum of a quaternion's parts, or i j k = -1: by the font of the units.
_UNITS_OF_QUATERNIONS = re.compile(
    r"(?P<font>\\(?:mathbf|boldsymbol|hat|vec|mathrm)\s*\{?|)(?<![\\A-Za-z])?\s*i\}?(?:\s*\+[^=+]*|\s*)(?P=font)\s*j\}?(?:\s*\+[^=+]*|\s*)(?P=font)\s*k(?![A-Za-z])"
)


@dataclass(frozen=True)
class Proposal:
    """Entries of one table of a model, as TOML, and what they rest on. `stands`: kept unless it loses a
    formula; others, where formulas come further by it, or, if it `reads`, are read by it."""

    table: str
    entries: Mapping[str, str]
    why: str
    question: str
    trigger: re.Pattern[str]
    stands: bool = False
    reads: bool = False


def tables_of(proposals: Sequence[Proposal]) -> dict[str, dict[str, tuple[str, str]]]:
    """Table → key → value as TOML, and why. Lists of one convention grow together."""
    tables: dict[str, dict[str, tuple[str, str]]] = {}
    for proposal in proposals:
        table = tables.setdefault(proposal.table, {})
        for key, value in proposal.entries.items():
            if key in table and value.startswith("["):
                value = f"{table[key][0][:-1]}, {value[1:]}"
            table[key] = (value, proposal.why)
    return tables


def ground_of(proposals: Sequence[Proposal]) -> SymbolTable:
    """The table that the reader has with these proposals alone. Raises PaperError."""
    lines = []
    for name, entries in tables_of(proposals).items():
        lines += [f"[{name}]", *(f"{key} = {value}" for key, (value, _) in entries.items())]
    return notation_of([TomlFile(Path("guessed"), "\n".join(lines) + "\n")]).symbols


def words_of(proposals: Sequence[Proposal]) -> frozenset[str]:
    """The functions that the text writes without a backslash."""
    texts = (p.entries["functions"] for p in proposals if "functions" in p.entries)
    return frozenset(re.findall(r"[a-z]+", " ".join(texts)))


def proposals_for(formulas: Sequence[str], prose: str) -> Iterator[Proposal]:
    """What the formulas show signs of, what others need first."""
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
    for entry in _NOTATION:
        yield _notation(*entry)
    spin, other = (_TOP, _BOTTOM) if _SPIN_FIRST.search(together) else (_BOTTOM, _TOP)
    means = rf"\begin{{bmatrix}} \operatorname{{skew}}({spin}) & {other} \\ 0 & 0 \end{{bmatrix}}"
    for trigger, key in ((_IN_BRACKETS, "[V]"), (r"\^\s*\{?\s*\\wedge(?![A-Za-z])", r"V^\wedge")):
        question = f"Is {key} of a twist its matrix of 4×4?"
        yield _notation(trigger, key, {"V": "matrix 6×1"}, means, "a bracket or a wedge on a twist", question)
    for unit in dict.fromkeys(match[0] for match in _UNITS.finditer(together)):
        trigger = re.escape(unit)
        question = f"Is {unit} the unit tensor?"
        entry = _notation(trigger, unit, {}, r"\mathbf{I}", "a blackboard 1 or I", question)
        yield replace(entry, stands=True)
    yield _prime(("scalar", "vector", "tensor", *(["quaternion"] if speaks_of_quaternions(prose) else [])))
    for inside in dict.fromkeys(match[1] for match in _BRACKET.finditer(together)):
        question = f"Does ({inside}) only say what a symbol depends on?"
        trigger = re.compile(re.escape(inside))
        yield _conventions("arguments", f"['{inside}']", "a bracket with one symbol", question, trigger)
    for inside in dict.fromkeys(match[1].strip() for match in _LIST.finditer(together)):
        question = f"Does ({inside}) only say what a symbol depends on?"
        bare = (_DOTS_OFF.sub(r"\1", symbol.strip()) for symbol in inside.split(","))
        several = ", ".join(f"'{symbol}'" for symbol in dict.fromkeys(bare))
        trigger = re.compile(re.escape(inside))
        yield _conventions("arguments", f"[{several}]", "symbols in a bracket", question, trigger)
    gradient = '"row"' if _TRANSPOSED_SLOPE.search(together) else '"column"'
    question = "How does the derivative of a scalar by a column stand, as a row or a column?"
    yield _conventions("gradient", gradient, "a partial derivative", question, re.compile(r"\\partial"))
    yield from _frames(together)
    question = r"Is \hat{x} the skew tensor of x?"
    hat = _notation(
        r"\\(?:wide)?hat(?![A-Za-z])", r"\hat{x}", {"x": "vector"}, _SKEW, "a hat on a symbol", question
    )
    yield replace(hat, reads=True)


def speaks_of_quaternions(prose: str) -> bool:
    return len(re.findall(r"quaternion", prose, re.IGNORECASE)) > 2


_QUATERNIONS = "Are quaternions Hamilton's (i j = k), scalar part first?"
_SKEW = r"\operatorname{skew}(x)"
_LEFT = (
    r"\begin{bmatrix} \operatorname{Sc}(q) & -(\operatorname{Vec}(q))^T \\ \operatorname{Vec}(q)"
    r" & \operatorname{Sc}(q) \mathbf{I} %s \operatorname{skew}(\operatorname{Vec}(q)) \end{bmatrix}"
)
#: One symbol in square brackets, which group nothing then.
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
    """i, j and k in this font as the quaternions that they are."""
    spelled = [f"{font}{{{letter}}}" if font else letter for letter in "ijk"]
    columns = (r" \\ ".join(str(int(place == other)) for other in range(3)) for place in range(3))
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


def _frames(formulas: str) -> Iterator[Proposal]:
    """Labels on the left, as in {}^A ω^B and {}^A d/dt; points, as in r^{P/O}."""
    seen = list(_SEEN_FROM.finditer(formulas))
    rates = [_label(match["F"]) for match in _RATE_IN.finditer(formulas)]
    frames = Counter(rates + [_label(match["F"]) for match in seen])
    points: Counter[str] = Counter()
    spelled: dict[str, dict[str, str]] = {"frames": {}, "points": {}}
    for match in seen:
        core, right = match["core"].strip(), match["G"]
        meaning = None if right is None else _meaning(core)
        if meaning is None:
            continue
        where, phrase = meaning
        (frames if where == "frames" else points)[_label(right)] += 1
        spelled[where][f"'{{}}^F{core}^{'G' if where == 'frames' else 'P'}'"] = f'"{phrase}"'
    for match in _BETWEEN.finditer(formulas):
        points.update((_label(match["P"]), _label(match["O"])))
        spelled["points"][f"'{match['core'].strip()}^{{P/O}}'"] = '"to P from O"'
    for match in _JOINED.finditer(formulas):
        points.update((match["P"], match["O"]))
        spelled["points"][f"'{match['core'].strip()}^{{OP}}'"] = '"to P from O"'
    triads, turns = _triads(formulas), _TURN.findall(formulas)
    named, rest = [letter for turn in turns for letter in turn], _TURN.sub("", formulas)
    if any(re.search(_ALONE.format(letter), rest) for letter in named):
        turns = []  # a product in brackets
    elif turns:
        frames.update(named)
        spelled["frames"]["'[FG]'"] = '"rotation to F from G"'
    if not (seen or rates or triads or turns):
        return
    labels = Counter(rates or [_label(match["F"]) for match in seen] or [seen_from for _, seen_from in turns])
    base = labels.most_common(1)[0][0] if labels else _NOWHERE
    names = [name for name in frames if name != base]
    axes = _axes(triads, base, names)
    entries = {"base": f"'{base}'", "names": _list(names), "dot": f"'{base}'", **spelled["frames"], **axes}
    question = (
        "Do scripts on the left name frames, and is {}^F ω^G that of G in F, [FG] the turn to F from G?"
    )
    yield Proposal("frames", entries, "labels of frames", question, _LABELS, stands=True)
    if points:
        entries = {"names": _list(list(points)), **spelled["points"]}
        question = (
            "Do the labels of positions, velocities and accelerations name points, and is r^{OP} from O?"
        )
        yield Proposal("points", entries, "labels of points", question, _LABELS, stands=True)


def _triads(formulas: str) -> dict[str, tuple[str, str]]:
    """\\hat{b}_x, \\hat{b}_y, \\hat{b}_z: by their letter, its font and the three indices."""
    found: dict[tuple[str, str], set[str]] = {}
    for match in _AXIS.finditer(formulas):
        font = match["inner"] or match["outer"] or ""
        found.setdefault((match["letter"], font), set()).add(match["axis"])
    return {
        letter: (font, triad)
        for (letter, font), axes in found.items()
        for triad in ("xyz", "123")
        if set(triad) <= axes
    }


def _axes(triads: Mapping[str, tuple[str, str]], base: str, names: list[str]) -> dict[str, str]:
    """The triads as the axes of frames: of B, or of one more frame, for the letter b."""
    rows = []
    for letter, (font, indices) in triads.items():
        frame = next((name for name in [base, *names] if name.strip("{}")[-1:] == letter.upper()), None)
        if frame is None:
            frame = letter.upper()
            names.append(frame)
        core = f"{font}{{{letter}}}" if font else letter
        rows.append(f"'{frame}' = " + _list([f"\\hat{{{core}}}_{axis}" for axis in indices]))
    return {"axes": f"{{ {', '.join(rows)} }}"} if rows else {}


def _meaning(core: str) -> tuple[str, str] | None:
    """By the letter, as mechanics has it: in which table, and what it is."""
    letter = re.findall(r"\\?[A-Za-z]+", core)[-1]
    if "\\hat" in core:
        return None
    if letter == "\\omega":
        return "frames", "angular velocity of G in F"
    if letter == "\\alpha":
        return "frames", "angular acceleration of G in F"
    if letter in _ROTATIONS:
        return "frames", "rotation to F from G"
    return {"v": ("points", "velocity of P in F"), "a": ("points", "acceleration of P in F")}.get(letter)


def _label(script: str) -> str:
    return script.strip().removeprefix("{").removesuffix("}").strip() if script[:1] == "{" else script.strip()


def _list(names: Sequence[str]) -> str:
    return "[" + ", ".join(f"'{name}'" for name in names) + "]"
