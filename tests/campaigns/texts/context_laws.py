"""How many verdicts change when a letter is renamed everywhere, or when sentences about nothing are added.

Counts only: nothing is asserted of them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from random import Random

from judged_claims import Seen, claims_of
from written_documents import Document, documents

#: Other letters of each kind; among them are some of which conventions speak.
OTHERS = {
    "scalar": ("p", "r", "m", "t_1", "x", r"\lambda"),
    "vector": ("r", "v", "w", "s", r"\hat{e}", "x"),
    "tensor": ("B", "M", "J", "U", "E", "L"),
}
#: They speak of no symbol of a text, or of one that it has not.
SENTENCES = (
    "The following is well known, where all quantities are constant in that case.",
    "Suppose that $q_7 = 0$ on the boundary.",
    "The vector $z$ has unit length, and $z_2 > 0$.",
    "For small angles other formulas are used.",
    "Here the matrix $Q_9$ is symmetric.",
)
_KIND = re.compile(r"'([A-Za-z])' = \{ kind = \"(\w+)\"")
_WORDS = re.compile(
    r"\\frac\{d\}\{dt\}|\\(?:label|text|intertext|begin|end|operatorname|tag)\{[^{}]*\}|\\\\|\\[A-Za-z]+"
)


def laws(seed: int, formulas: int) -> str:
    """A table of the changes by law."""
    lines = ["law          |   pairs | changed | by verdicts"]
    texts = [each for each in documents(seed, 3 * formulas) if each.format in ("md", "rst", "tex")]
    texts = [replace(each, text=each.text) for each in texts if "newcommand" not in each.text]
    for name, change in (("renaming", renamed), ("irrelevance", with_sentences)):
        changes: Counter[str] = Counter()
        pairs = 0
        random = Random(seed)
        for one in texts:
            if pairs >= formulas:
                break
            for before, after in _pairs(one, change(one, random)):
                pairs += 1
                if before.outcome != after.outcome:
                    changes[f"{before.outcome} → {after.outcome}"] += 1
        told = ", ".join(f"{word}: {count}" for word, count in changes.most_common())
        lines.append(f"{name.ljust(12)} | {pairs:7d} | {sum(changes.values()):7d} | {told}")
    return "\n".join(lines)


def _pairs(one: Document, other: Document) -> Iterator[tuple[Seen, Seen]]:
    try:
        before = {each.id: each for each in claims_of(one.text, one.model, one.format)}
        after = {each.id: each for each in claims_of(other.text, other.model, other.format)}
    except Exception as error:  # a count goes on
        print(f"no verdicts: {type(error).__name__}: {error}")
        return
    for name in before.keys() & after.keys():
        yield before[name], after[name]


def renamed(one: Document, random: Random) -> Document:
    """A document with other letters."""
    taken: dict[str, str] = {}
    for letter, kind in _KIND.findall(one.model):
        free = [each for each in OTHERS.get(kind, ()) if each not in taken.values()]
        if free and random.random() < 0.7 and letter not in "xy":
            taken[letter] = random.choice(free)
    model = _KIND.sub(lambda match: match[0].replace(match[1], taken.get(match[1], match[1]), 1), one.model)
    model = re.sub(
        r"'n' = .*",
        lambda match: in_formula(match[0].replace("'n'", "\0"), taken).replace("\0", "'n'"),
        model,
    )
    return replace(one, text=_displays(one, taken), model=model)


def _displays(one: Document, taken: dict[str, str]) -> str:
    lines = one.text.split("\n")
    for each in one.shown:
        for at in range(each.lines[0] - 1, each.lines[1]):
            if 0 <= at < len(lines) and ":label:" not in lines[at] and ".. math" not in lines[at]:
                lines[at] = in_formula(lines[at], taken)
    return "\n".join(lines)


def in_formula(line: str, taken: dict[str, str]) -> str:
    """A line of a display with other letters."""
    parts, last = [], 0
    for match in _WORDS.finditer(line):
        parts += [_letters(line[last : match.start()], taken), match[0]]
        last = match.end()
    return "".join(parts) + _letters(line[last:], taken)


def _letters(text: str, taken: dict[str, str]) -> str:
    return re.sub(r"(?<![A-Za-z^])[A-Za-z](?![A-Za-z])", lambda match: taken.get(match[0], match[0]), text)


def with_sentences(one: Document, random: Random) -> Document:
    """A document with sentences that say nothing of its symbols."""
    lines = one.text.split("\n")
    at = max(each.lines[0] - 1 for each in one.shown[:1])
    places = [at, *(each.lines[0] - 1 for each in one.shown[2::4])]
    for place in sorted(places, reverse=True):
        lines[place:place] = [random.choice(SENTENCES), ""]
    return replace(one, text="\n".join(lines))
