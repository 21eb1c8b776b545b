"""Coq's compiler: the library, compiled once for each version of it, and the check of one certificate.

What was found is remembered by the hash of the Coq version, the library and the certificate.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import subprocess
import tempfile
from dataclasses import asdict, dataclass
from functools import cache
from importlib import resources
from pathlib import Path

#: In the order in which they are compiled; the first is the one that a reader must read.
LIBRARY = (
    "Kin",
    "Poly",
    "Terms",
    "Certify",
    "Divide",
    "Modulo",
    "Symbols",
    "Forms",
    "Facts",
    "Fraction",
    "Context",
    "Steps",
    "Orders",
    "Joins",
    "Smooth",
    "Refute",
    "Witness",
)

#: Of Coq's real numbers: what statements about real motions may rest on, and nothing else.
REALS = frozenset(
    {
        "ClassicalDedekindReals.sig_not_dec",
        "ClassicalDedekindReals.sig_forall_dec",
        "FunctionalExtensionality.functional_extensionality_dep",
        "Classical_Prop.classic",
    }
)

#: No certificate may take longer.
SECONDS = 120

INSTALL = "apt-get install coq (Debian 12 and later, Ubuntu), or opam install coq"


class CoqFault(RuntimeError):
    """The library does not compile: a defect, or a version of Coq that it was not written for."""


@dataclass(frozen=True)
class Checked:
    """What Coq said of a certificate. `axioms`: of all its theorems, sorted; `fault`: why it was refused."""

    accepted: bool
    axioms: tuple[str, ...]
    fault: str
    seconds: float

    @property
    def expected(self) -> bool:
        return self.accepted and set(self.axioms) <= REALS


def library_text(name: str) -> str:
    return resources.files("workbench.certificates").joinpath("coq", f"{name}.v").read_text(encoding="utf-8")


@cache
def version() -> str | None:
    """Such as 8.16.1; None where there is no coqc."""
    if shutil.which("coqc") is None:
        return None
    found = subprocess.run(["coqc", "--print-version"], capture_output=True, text=True, check=False)
    return found.stdout.split()[0] if found.returncode == 0 and found.stdout.split() else None


@cache
def _fingerprint() -> str:
    seen = hashlib.sha256((version() or "").encode())
    for name in LIBRARY:
        seen.update(library_text(name).encode())
    return seen.hexdigest()


def memory() -> Path:
    """Where compiled libraries and results are kept."""
    root = os.environ.get("XDG_CACHE_HOME")
    return (Path(root) if root else Path.home() / ".cache") / "workbench" / "certificates"


def library() -> Path:
    """The directory of the compiled library; compiled on first use (half a minute)."""
    place = memory() / _fingerprint()[:16]
    if (place / f"{LIBRARY[-1]}.vo").exists():
        return place
    place.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=place.parent, prefix=".unfinished-") as unfinished:
        for name in LIBRARY:
            Path(unfinished, f"{name}.v").write_text(library_text(name), encoding="utf-8")
            made = _run(Path(unfinished, f"{name}.v"), Path(unfinished))
            if made.returncode:
                raise CoqFault(
                    f"Coq {version()} refuses {name}.v of the library: {_first_error(made.stderr)}"
                )
        if not place.exists():
            shutil.copytree(unfinished, f"{place}.unfinished-{os.getpid()}")
            os.replace(f"{place}.unfinished-{os.getpid()}", place)
    return place


def recall(text: str) -> Checked | None:
    """What is remembered of the certificate."""
    note = _note(text)
    if version() is None or not note.exists():
        return None
    known = json.loads(note.read_text(encoding="utf-8"))
    return Checked(known["accepted"], tuple(known["axioms"]), known["fault"], known["seconds"])


def _note(text: str) -> Path:
    key = hashlib.sha256((_fingerprint() + text).encode()).hexdigest()
    return memory() / "results" / f"{key}.json"


def check(text: str, remember: bool = True) -> Checked:
    """Whether Coq accepts the certificate, and what its theorems rest on."""
    note = _note(text)
    if remember and (known := recall(text)) is not None:
        return known
    compiled = library()
    with tempfile.TemporaryDirectory() as place:
        file = Path(place, "claim.v")
        file.write_text(text, encoding="utf-8")
        before = os.times()
        try:
            made = _run(file, compiled)
        except subprocess.TimeoutExpired:
            return Checked(False, (), f"not finished in {SECONDS} s", float(SECONDS))
        after = os.times()
    seconds = (after.children_user + after.children_system) - (before.children_user + before.children_system)
    accepted = made.returncode == 0
    result = Checked(
        accepted, _axioms(made.stdout), "" if accepted else _first_error(made.stderr), round(seconds, 2)
    )
    if remember:
        note.parent.mkdir(parents=True, exist_ok=True)
        draft = note.with_name(f".{note.name}-{os.getpid()}")
        draft.write_text(json.dumps(asdict(result)), encoding="utf-8")
        os.replace(draft, note)
    return result


def _run(file: Path, compiled: Path) -> subprocess.CompletedProcess[str]:
    command = ["coqc", "-q", "-w", "none", "-Q", str(compiled), "Kin", str(file)]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=SECONDS)


def _axioms(output: str) -> tuple[str, ...]:
    """The names that `Print Assumptions` gives; none if it says that all is closed."""
    names = set(re.findall(r"^([A-Za-z_][\w.']*)\s*:", output, re.MULTILINE))
    return tuple(sorted(names - {"Axioms"}))  # the heading of the list


def _first_error(message: str) -> str:
    at = message.find("Error:")
    return " ".join(message[max(at, 0) :].split())[:300]
