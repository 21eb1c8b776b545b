"""The reference of messages, made from the tables of codes and from messages.toml."""

from __future__ import annotations

import pkgutil
import re
import tomllib
from collections.abc import Mapping
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

from workbench.core import codes
from workbench.core.code_labels import label
from workbench.core.codes.doubt_codes import DoubtCode
from workbench.core.reasons import Code

_DATA = Path(__file__).parent / "messages.toml"

#: The entries for codes without one of their own: for questions, for expectations, and by table.
_QUESTION = {
    "meaning": "The notation has more than one reading, and the reader takes none of them by itself.",
    "way_out": "Write the reading that you mean, or name it in [conventions] or [notation].",
}
_EXPECTATION = {
    "meaning": "The formula has something else at this position than its form needs.",
    "way_out": "Write what the message expects.",
}
_BY_TABLE = {
    "SyntaxCode": {
        "meaning": "The formula cannot be read, so it has no verdict.",
        "way_out": "Correct the formula at the position; `workbench help notation` says what is read.",
    },
    "TypeCode": {
        "meaning": "The parts of the formula do not fit together: it is ill-formed.",
        "way_out": "Correct the formula, or the kinds in [symbols]; a `reading` says what is meant.",
    },
    "DeclarationCode": {
        "meaning": "An entry of [symbols], [definitions] or [notation] cannot be used.",
        "way_out": "Correct the entry; `workbench help model-keys` lists the keys.",
    },
    "VerdictCode": {
        "meaning": "This is why the claim has its verdict.",
        "way_out": "See `workbench help why-not-judged`.",
    },
    "ModelCode": {
        "meaning": "A table of a paper file or a model lacks something.",
        "way_out": "Add the key; `workbench help model-keys` explains it.",
    },
    "InputCode": {
        "meaning": "A file or a command line cannot be used; nothing is judged or written.",
        "way_out": "Correct what the message names; `workbench help model-keys` lists the keys of a file.",
    },
    "ErrorCode": {
        "meaning": "The message is that of an error without a code of its own.",
        "way_out": "Follow the message.",
    },
    "EngineCode": {
        "meaning": "The engines have no exact value for this part of the formula, so it is not judged.",
        "way_out": "Write the part in another form, or define it; see `workbench help why-not-judged`.",
    },
    "ContextCode": {
        "meaning": "The verdict rests on what the text says around the formula.",
        "way_out": "Say in the model what holds; `given = []` says that the formula needs nothing else.",
    },
    "MotionCode": {
        "meaning": "No simulated motion tests the claim.",
        "way_out": "Nothing; or bind its symbols in [motion].",
    },
}


@cache
def all_codes() -> Mapping[str, Code]:
    """Returns the codes of all tables by their label, as in WB-UNKNOWN-SYMBOL."""
    for module in pkgutil.iter_modules(codes.__path__, "workbench.core.codes."):
        import_module(module.name)
    tables = (table for table in Code.__subclasses__() if table is not DoubtCode)  # shown without codes
    return {label(code): code for table in tables for code in table}


def known_codes() -> list[str]:
    return list(all_codes())


@cache
def entries() -> Mapping[str, Mapping[str, Any]]:
    """Returns the entries of messages.toml by label: meaning, way_out, and an example: a formula, a text with
    its model, a paper file or a command."""
    with _DATA.open("rb") as file:
        return {f"WB-{slug.upper()}": entry for slug, entry in tomllib.load(file).items()}


def code_text(label: str) -> str | None:
    """Returns the page of one code as Markdown; None for an unknown code."""
    name = label.strip().strip("[]").upper()
    code = all_codes().get(name if name.startswith("WB-") else f"WB-{name}")
    return None if code is None else _entry(code, "#")


def message_page() -> str:
    """Returns the page of all messages, table by table."""
    parts = [
        "# Messages",
        "Every reason and message with its code: what it means, an example, what to do.",
        "A message ends with its code in brackets, and `workbench help CODE` shows its entry.",
        "Words in braces stand for what the message names at that place.",
    ]
    tables = dict.fromkeys(type(code) for code in all_codes().values())
    for table in tables:
        title = (table.__doc__ or table.__name__).split("\n")[0].rstrip(".")
        parts.append(f"## {title}")
        parts += [_entry(code, "###") for code in sorted(table, key=lambda each: each.name)]
    return "\n\n".join(part.rstrip() for part in parts) + "\n"


def meaning_of(code: Code) -> Mapping[str, Any]:
    """Returns the entry of the code: its own, or the general one of its form or its table."""
    own = entries().get(label(code), {})
    if "meaning" in own:
        return own
    if "?" in code.template:
        return _QUESTION | dict(own)
    if re.search(r"\bexpected\b", code.template):
        return _EXPECTATION | dict(own)
    return _BY_TABLE.get(type(code).__name__, {}) | dict(own)


def _entry(code: Code, level: str) -> str:
    said = meaning_of(code)
    lines = [f"{level} {label(code)}", "", f"> {_template(code)}", ""]
    if meaning := said.get("meaning"):
        lines += [meaning, ""]
    lines += _example(said)
    if way_out := said.get("way_out"):
        lines += [f"What to do: {way_out}", ""]
    return "\n".join(lines)


def _example(said: Mapping[str, Any]) -> list[str]:
    """Returns the lines of the example: a formula and what it is read with, files, or a command."""
    lines = [f"Example: `{said['example']}`{_where(said)}", ""] if "example" in said else []
    for key, name, language in (
        ("text", "paper.md", ""),
        ("model", "paper.toml", "toml"),
        ("paper", "paper.toml", "toml"),
        ("python", "Python", "python"),
    ):
        if key in said:
            lines += [f"Example, `{name}`:", "", f"```{language}", said[key].strip("\n\ufeff"), "```", ""]
    return lines + ([f"Example: `{said['command']}`", ""] if "command" in said else [])


def _where(said: Mapping[str, Any]) -> str:
    """Returns what the example is read with: kinds, whole entries of [symbols], definitions, [notation]."""
    given = [
        f"`{name}` a {kind}" if isinstance(kind, str) else f"`{name} = {_inline(kind)}`"
        for name, kind in said.get("symbols", {}).items()
    ]
    given += [f"the definition `{name} = {body}`" for name, body in said.get("definitions", {}).items()]
    given += [f"`{line}` assumed" for line in said.get("assume", ())]
    given += [f"`{line}`" for line in said.get("notation", "").splitlines()[1:]]
    return f" with {', '.join(given)}" if given else ""


def _inline(value: Any) -> str:
    """Returns a value as TOML in one line."""
    if isinstance(value, dict):
        return f"{{ {', '.join(f'{key} = {_inline(each)}' for key, each in value.items())} }}"
    if isinstance(value, list):
        return f"[{', '.join(map(_inline, value))}]"
    return str(value).lower() if isinstance(value, bool) else repr(value)


def _template(code: Code) -> str:
    """Returns the message, its arguments as `{name}`."""
    text = code.template.replace("{{", "\0").replace("}}", "\1")
    text = re.sub(r"\{(\w+)\}", lambda found: "{" + found[1].lower().replace("_", " ") + "}", text)
    return text.replace("\0", "{").replace("\1", "}")
