"""Frames and points inferred from the labels of a text."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from workbench.papers.drafting.drafted_definitions import Proposed
from workbench.papers.drafting.model_proposal import Proposal
from workbench.papers.drafting.sentence_kinds import Spin
from workbench.papers.drafting.typefaces import Guess, flat

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
#: The frame in which the others move, if the text names none.
_NOWHERE = "O"
#: Capitals that denote rotations in mechanics; X and T may be transforms.
_ROTATIONS = frozenset("ACDQRS")
_LABELS = re.compile(r"\{\}\s*[_^]|/|\\hat|\[\s*(?:\\dot\s*\{)?\s*[A-Z]\s*[A-Z]")
#: [BN], where no letter is a symbol by itself.
_TURN = re.compile(r"\[\s*(?:\\dot\s*\{)?\s*([A-Z])\s*([A-Z])\s*(?:\(t\)\s*)?\}?\s*\]")
_ONE = r"(?:\{(?:[^{}]|\{[^{}]*\})*\}|\\?[A-Za-z]+)"
_SPACING = re.compile(r"\s+|\\[,;!:]|[.,]+$|(?<!\\)&")
#: The equation between the rates of a vector in two frames (the transport theorem).
_TWO_RATES = re.compile(
    rf"\\dot(?P<one>{_ONE})=(?P<mark>\\(?:mathring|breve|check))(?P=one)"
    rf"\+(?P<spin>(?:\\[a-z]+)?{_ONE})\\times(?P<other>.+)"
)
#: The rates of one vector in a frame and, without a label, in another one.
_TWO_FRAMES = re.compile(
    rf"\\frac\s*\{{\s*d\s*(?P<own>(?:[^{{}}=]|\{{[^{{}}]*\}})+?)\s*\}}\s*\{{\s*dt\s*\}}\s*&?=[^\n=]*\{{\}}\s*\^\s*{_SCRIPT}\s*d\s*(?P=own)"
)
_ALONE = r"(?<![\\A-Za-z/_^{{]){}(?![A-Za-z])"


def frames(formulas: str) -> Iterator[Proposal]:
    """Yields proposals from left labels, as in {}^A ω^B and {}^A d/dt, and from points, as in r^{P/O}."""
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
    is_elsewhere = not labels or (len(labels) == 1 and _TWO_FRAMES.search(formulas) is not None)
    base = _NOWHERE if is_elsewhere else labels.most_common(1)[0][0]
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


def with_spins(proposal: Proposal | None, spins: Sequence[Spin]) -> Proposal:
    """Returns the frames with the angular velocities that sentences state: the angular velocity of B in A."""
    entries = dict(proposal.entries) if proposal is not None else {}
    bases = Counter(spin.base for spin in spins)
    base = entries.get("base") or (f"'{bases.most_common(1)[0][0]}'" if bases else f"'{_NOWHERE}'")
    names = labels_in(entries.get("names", ""))
    for label in (label for spin in spins for label in (spin.base, spin.frame)):
        if f"'{label}'" != base and label not in names:
            names.append(label)
    entries |= {"base": base, "names": _list(names), "dot": entries.get("dot", base)}
    for spin in spins:
        entries[f"'{spin.name}'"] = f'"{spin.what} of {spin.frame} in {spin.base}"'
    if proposal is not None:
        return replace(proposal, entries=entries)
    question = "Which frames does the text have, and in which does \\dot{x} differentiate?"
    return Proposal("frames", entries, "a sentence says so", question, re.compile(""), stands=True)


def _triads(formulas: str) -> dict[str, tuple[str, str]]:
    r"""Returns the font and the indices of axes such as \hat{b}_x, \hat{b}_y, \hat{b}_z, by their letter."""
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
    """Returns the entries for triads as the axes of frames: letter b means the axes of B."""
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
    """Returns the table and the meaning of a letter by the conventions of mechanics."""
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


def labels_in(value: str) -> list[str]:
    """Returns the quoted labels of a TOML value that a draft wrote."""
    return re.findall("'([^']*)'", value)


def _list(names: Sequence[str]) -> str:
    return "[" + ", ".join(f"'{name}'" for name in names) + "]"


def rates_in_turning_frames(
    formulas: Iterable[str], guesses: Mapping[str, Guess], lines: Mapping[str, int]
) -> Iterator[Proposed]:
    """Yields each vector with the accent as its rate less ω × x.

    lines: symbol → line of its first occurrence.
    """
    for mark, spin in _marks(formulas).items():
        accent = re.compile(rf"{re.escape(mark)}\{{(\\?[A-Za-z]+)\}}")
        for name, guess in guesses.items():
            plain = accent.sub(r"\1", name)
            if guess.kind == "vector" and plain != name:
                body = rf"\dot{{{plain}}} - {spin} \times {plain}"
                yield Proposed(name, body, lines.get(name, 1), "the rate in a turning frame", True)


def _marks(formulas: Iterable[str]) -> dict[str, str]:
    """Returns the accents of rates in a turning frame, each with the frame's angular velocity."""
    found: dict[str, str] = {}
    for formula in formulas:
        match = _TWO_RATES.fullmatch(_SPACING.sub("", formula))
        if match is not None and flat(match["one"]) == flat(match["other"]):
            found.setdefault(match["mark"], match["spin"])
    return found
