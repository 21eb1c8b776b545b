"""The true kind and size of every symbol of texts with models, beside what is inferred of the text alone.

`true_kinds.json`: file → symbol → its kinds in the model, one for each meaning that it has in the text.
`python tests/ingest/true_kinds.py [--unseen]` prints a table, and each symbol that is wrong.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from time import process_time

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(ROOT)]

from workbench.core.types import type_of_kind  # noqa: E402
from workbench.papers.drafting.draft_model import ingest  # noqa: E402
from workbench.papers.drafting.inference.infer import Inference, Inferred, kind_name  # noqa: E402

TRUE: Mapping[str, Mapping[str, list[str]]] = json.loads((HERE / "true_kinds.json").read_text("utf-8"))
#: Formulas of public texts whose true kinds were written down before anything was inferred of them.
UNSEEN: Mapping[str, Mapping[str, list[str]]] = json.loads(
    (HERE / "unseen" / "true_kinds.json").read_text("utf-8")
)
_UNIT = re.compile(r".*(?:I\}?(?:_.*)?|1\}?(?:_.*)?)")


@dataclass(frozen=True)
class Symbol:
    """One symbol with one of its true kinds; `got`: what is inferred."""

    name: str
    true: str
    got: str
    is_right: bool


def symbols_of(path: str) -> Iterator[Symbol]:
    """Yields the symbols of a text of this repository, each with what is inferred."""
    yield from compared({**TRUE, **UNSEEN}[path], ingest(ROOT / path).inference)


def compared(true: Mapping[str, list[str]], inference: Inference) -> Iterator[Symbol]:
    found = {_plain(name): own for name, own in inference.kinds.items()}
    for name, kinds in true.items():
        own = _found(name, found)
        for kind in kinds:
            yield Symbol(name, kind, _shown(own), _is_right(name, own, kind))


def _plain(name: str) -> str:
    return re.sub(r"\s", "", name).replace("boldsymbol", "mathbf")


def _found(name: str, found: Mapping[str, Inferred]) -> Inferred | None:
    """What is inferred of a name, or of a member of a family x_n."""
    plain = _plain(name)
    if plain in found:
        return found[plain]
    family = re.escape(plain).replace("n", "[0-9a-z]")
    return next((own for other, own in found.items() if re.fullmatch(family, other)), None)


def _shown(own: Inferred | None) -> str:
    if own is None:
        return "nothing"
    name = kind_name(own.kind)
    exact = type_of_kind(name)
    return name.removeprefix("matrix ") if exact is None else _size(exact.rows, exact.columns, name)


def _size(rows: int, columns: int, name: str) -> str:
    return name if "quaternion" in name else f"{rows}×{columns}"


def _is_right(name: str, own: Inferred | None, kind: str) -> bool:
    """An open size n is right whatever the model takes for it. A unit tensor is known by its letter."""
    if own is None:
        rows, _, columns = kind.partition("×")
        return rows == columns != "1" and _UNIT.fullmatch(_plain(name)) is not None
    got = _shown(own)
    sizes, true = got.split("×"), kind.split("×")
    open_places = zip(sizes, true, strict=False)
    return got == kind or (
        len(sizes) == len(true) == 2 and all(one in (other, "n") for one, other in open_places)
    )


def main() -> None:
    right = count = 0
    for path in UNSEEN if "--unseen" in sys.argv else TRUE:
        start = process_time()
        symbols = list(symbols_of(path))
        good = sum(symbol.is_right for symbol in symbols)
        right, count = right + good, count + len(symbols)
        print(f"{path:64} {good:4} of {len(symbols):4}  {process_time() - start:5.1f} s")
        for symbol in symbols:
            if not symbol.is_right:
                print(f"    {symbol.name}: {symbol.true}, inferred {symbol.got}")
    print(f"{right} of {count} symbols ({100 * right / count:.1f} %)")


if __name__ == "__main__":
    main()
