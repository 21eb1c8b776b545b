"""Reader of the edits that correct a fault: `mend = [['for', 'read'], …]` of a claim."""

from __future__ import annotations

from workbench.context.claim_parts import FAULTS, Edit, Mend
from workbench.core.paper_errors import KeyPath
from workbench.language.grammar.latex_keys import Ignored, latex_key
from workbench.source.toml.toml_file import TomlTable

MEND_KEYS = ("fault", "mend", "mended_by", "beside", "place", "cause", "add", "example")


def _fault_of(toml: TomlTable, path: KeyPath) -> str | None:
    fault = toml.text((*path, "fault"))
    if fault is not None and fault not in FAULTS:
        message = f"fault: expected one of {', '.join(FAULTS)}; got {fault!r}"
        raise toml.error_at_value((*path, "fault"), message)
    return fault


def mend_of(toml: TomlTable, path: KeyPath, printed: str) -> Mend:
    """Returns the correction that the keys of one claim state.

    printed: a formula, or a sentence in quotation marks.

    Raises:
        PaperError: A key is given without `fault`, or the `for` of an edit does not occur exactly once.
    """
    said = {key: toml.text((*path, key)) for key in ("beside", "place", "cause", "add", "example")}
    given = [key for key in MEND_KEYS[1:] if key in toml.value(path, dict)]
    fault = _fault_of(toml, path)
    if given and fault is None:
        raise toml.error_at_key((*path, given[0]), f"{given[0]}: only a claim with a fault has it")
    texts = [text for text in (said["beside"], printed) if text]
    edits = tuple(
        _edit(toml, (*path, "mend", index), texts)
        for index in range(len(toml.value((*path, "mend"), list, [])))
    )
    return Mend(fault, edits, by=toml.text((*path, "mended_by")), **said)


def mended(printed: str, edits: tuple[Edit, ...]) -> str:
    """Returns the printed text after the edits."""
    for edit in edits:
        printed = printed.replace(edit.old, edit.new)
    return printed


def same_formula(one: str, other: str) -> bool:
    """True if two formulas are equal up to white space and a final full stop."""
    return _squeezed(one) == _squeezed(other)


def _squeezed(latex: str) -> str:
    return latex_key(latex, Ignored.SIZES | Ignored.ALIGNMENT).rstrip(".,")


def _edit(toml: TomlTable, path: KeyPath, texts: list[str]) -> Edit:
    pair = toml.value(path, list)
    if len(pair) != 2 or not all(isinstance(text, str) for text in pair) or not pair[0].strip():
        raise toml.error_at_value(path, f"mend: expected ['for', 'read'], got {list(pair)!r}")
    old, new = pair
    text = next((text for text in texts if old in text), "")
    if text.count(old) != 1:
        found = f"got it {text.count(old)} times"
        raise toml.error_at_value(path, f"mend: expected {old!r} once in what is printed, {found}")
    before = text[: text.index(old)].replace("$$", "$")
    is_math = "$" not in old and (before.count("$") % 2 == 1 or not text.startswith("“"))
    return Edit(old, new, is_math)
