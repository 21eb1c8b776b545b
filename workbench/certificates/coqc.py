"""Coq's compiler: builds the library once for each version of it, and checks certificates.

Answers are cached by the hash of the Coq version, of the imported files, and of the certificate.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import threading
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import asdict, dataclass, replace
from functools import cache
from importlib import resources
from pathlib import Path

#: The files in the order of compilation; a reader of certificates must read the first one.
LIBRARY = (
    "Kin", "Poly", "Terms", "Certify", "Divide", "Modulo", "Symbols", "Forms", "Facts", "Fraction",
    "Context", "Steps", "Orders", "Smooth", "Time", "Refute", "Witness", "Duals", "Moment",
    "Instant", "Reciprocals", "Inverses", "Every",
)  # fmt: skip

#: The axioms of Coq's real numbers: the only ones that statements about real motions may depend on.
REALS = frozenset((
    "ClassicalDedekindReals.sig_not_dec", "ClassicalDedekindReals.sig_forall_dec",
    "FunctionalExtensionality.functional_extensionality_dep", "Classical_Prop.classic",
))  # fmt: skip

#: The limit of processor time for one certificate.
SECONDS = 300

#: The most certificates that Coq checks in one run.
TOGETHER = 24

#: The most characters in one run.
LENGTH = 400_000

#: The exit codes of a process that has used up its time: of the signal itself, or as the shell reports it.
_STOPPED = frozenset(code for sign in (signal.SIGXCPU, signal.SIGKILL) for code in (-sign, 128 + sign))

#: The fault of a certificate that takes longer.
UNFINISHED = "not finished"

INSTALL = "apt-get install coq (Debian 12 and later, Ubuntu), or opam install coq"


class CoqFault(RuntimeError):
    """The library does not compile: a defect, or an unsupported version of Coq."""


@dataclass(frozen=True)
class Checked:
    """Coq's answer on a certificate.

    Attributes:
        axioms: The axioms that its theorems depend on at most, sorted.
        fault: Why it was rejected.
    """

    accepted: bool
    axioms: tuple[str, ...]
    fault: str
    seconds: float

    @property
    def expected(self) -> bool:
        return self.accepted and set(self.axioms) <= REALS

    @property
    def unfinished(self) -> bool:
        return self.fault.startswith(UNFINISHED)


def library_text(name: str) -> str:
    return resources.files("workbench.certificates").joinpath("coq", f"{name}.v").read_text(encoding="utf-8")


@cache
def version() -> str | None:
    """Returns the version, such as 8.16.1; None if there is no coqc."""
    if shutil.which("coqc") is None:
        return None
    found = subprocess.run(["coqc", "--print-version"], capture_output=True, text=True, check=False)
    return found.stdout.split()[0] if found.returncode == 0 and found.stdout.split() else None


@cache
def _needs(name: str) -> frozenset[str]:
    """Returns the files of the library that a file depends on, including itself."""
    return _imported(library_text(name)) | {name}


def _imported(text: str) -> frozenset[str]:
    lines = re.findall(r"^From Kin Require Import ([\w ]+)\.", text, re.MULTILINE)
    return frozenset().union(*(_needs(name) for line in lines for name in line.split()))


def _fingerprint(names: Iterable[str]) -> str:
    seen = hashlib.sha256((version() or "").encode())
    for name in LIBRARY:
        if name in names:
            seen.update(library_text(name).encode())
    return seen.hexdigest()


def memory() -> Path:
    """Returns the directory of compiled libraries and results."""
    root = os.environ.get("XDG_CACHE_HOME")
    return (Path(root) if root else Path.home() / ".cache") / "workbench" / "certificates"


def library() -> Path:
    """Returns the directory of the compiled library; compiles it on first use (half a minute on two
    cores)."""
    place = memory() / _fingerprint(LIBRARY)[:16]
    if _is_whole(place):
        return place
    place.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=place.parent, prefix=".unfinished-") as unfinished:
        _compile(Path(unfinished))
        if not _is_whole(place):  # another process may have been faster
            shutil.rmtree(place, ignore_errors=True)
            shutil.copytree(unfinished, f"{place}.unfinished-{os.getpid()}")
            os.replace(f"{place}.unfinished-{os.getpid()}", place)
    return place


def _is_whole(place: Path) -> bool:
    return all((place / f"{name}.vo").exists() for name in LIBRARY)


def _compile(place: Path) -> None:
    """Compiles each file of the library as soon as its dependencies are compiled."""
    compiled: dict[str, Future[None]] = {}
    cores = threading.Semaphore(os.cpu_count() or 1)

    def one(name: str) -> None:
        for needed in _needs(name) - {name}:
            compiled[needed].result()
        file = place / f"{name}.v"
        file.write_text(library_text(name), encoding="utf-8")
        with cores:
            made, _ = _run(file, place)
        if made.returncode:
            raise CoqFault(f"Coq {version()} refuses {name}.v of the library: {_first_error(made.stderr)}")

    with ThreadPoolExecutor(len(LIBRARY)) as pool:
        for name in LIBRARY:
            compiled[name] = pool.submit(one, name)
    for done in compiled.values():
        done.result()


def is_settled(text: str) -> bool:
    """True if Coq has finished with the certificate. One that ran out of time may be tried again."""
    known = recall(text)
    return known is not None and not known.unfinished


def recall(text: str) -> Checked | None:
    """Returns the cached answer on the certificate; None if there is none."""
    note = _note(text)
    if version() is None or not note.exists():
        return None
    known = json.loads(note.read_text(encoding="utf-8"))
    return Checked(known["accepted"], tuple(known["axioms"]), known["fault"], known["seconds"])


def _note(text: str) -> Path:
    key = hashlib.sha256((_fingerprint(_imported(text)) + text).encode()).hexdigest()
    return memory() / "results" / f"{key}.json"


def check(text: str, remember: bool = True) -> Checked:
    """Returns whether Coq accepts the certificate, and the axioms of its theorems."""
    known = recall(text) if remember else None
    if known is not None and not known.unfinished:
        return known
    result, _ = _asked(text)
    if remember:
        _remember(text, result)
    return result


def _asked(text: str) -> tuple[Checked, str]:
    """Returns the answer and Coq's whole output."""
    compiled = library()
    with tempfile.TemporaryDirectory() as place:
        file = Path(place, "claim.v")
        file.write_text(text, encoding="utf-8")
        made, seconds = _run(file, compiled)
    if made.returncode in _STOPPED:
        return Checked(False, (), f"{UNFINISHED} in {SECONDS} s", float(SECONDS)), made.stdout
    fault = _first_error(made.stderr) if made.returncode else ""
    return Checked(not made.returncode, _axioms(made.stdout), fault, round(seconds, 2)), made.stdout


def _remember(text: str, result: Checked) -> None:
    note = _note(text)
    note.parent.mkdir(parents=True, exist_ok=True)
    draft = note.with_name(f".{note.name}-{os.getpid()}-{threading.get_ident()}")
    draft.write_text(json.dumps(asdict(result)), encoding="utf-8")
    os.replace(draft, note)


def check_all(texts: Iterable[str], progress: Callable[[object], None] = lambda done: None) -> None:
    """Checks certificates on all cores, many in one run, and caches the answers."""
    library()
    texts = list(dict.fromkeys(texts))
    batches = in_batches(texts)
    for known in set(texts).difference(*batches):
        progress(known)
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for batch in pool.map(check_together, batches):
            for done in batch:
                progress(done)


def check_together(texts: Sequence[str]) -> Sequence[str]:
    """Checks certificates with the same header in one run of Coq, and returns them.

    Coq takes half a second to start and one to print assumptions, so the assumptions of all together are
    recorded for each. If one is rejected, the first such certificate is checked by itself, and the others
    again without it.
    """
    left = list(texts)
    while left:
        said, passed = _asked(_joined(left))
        if said.expected:
            for text in left:
                _remember(text, replace(said, seconds=round(said.seconds / len(left), 2)))
            break
        culprit = left.pop(min(len(re.findall(r"^Module \S*m\d+$", passed, re.MULTILINE)), len(left) - 1))
        check(culprit)
    return texts


def _joined(texts: Sequence[str]) -> str:
    """Returns one file with a module for each text; Coq prints which ones it has passed."""
    parts = [
        f"Module m{index}.\n{_theorems(text)}\nEnd m{index}.\nLocate Module m{index}.\n"
        for index, text in enumerate(texts, start=1)
    ]
    names = [f"@m{index}.{_last(text)}" for index, text in enumerate(texts, start=1)]
    every = f"Definition all_of_them := ({', '.join(names)}).\nPrint Assumptions all_of_them.\n"
    return "\n".join([_header(texts[0]), *parts, every])


def in_batches(texts: Iterable[str]) -> list[list[str]]:
    """Returns the unchecked certificates in batches: equal imports, limited number and length."""
    batches: list[list[str]] = []
    open_batches: dict[str, list[str]] = {}
    for text in texts:
        if not is_settled(text):
            batch = open_batches.get(_header(text), [])
            if not batch or len(batch) == TOGETHER or sum(map(len, batch)) + len(text) > LENGTH:
                batch = open_batches[_header(text)] = []
                batches.append(batch)
            batch.append(text)
    return batches


def _header(text: str) -> str:
    """Returns the lines before the first theorem, without the comment."""
    lines = text.partition("\nTheorem ")[0].splitlines()
    return "\n".join(line for line in lines if not line.startswith("(*"))


def _theorems(text: str) -> str:
    return text[text.index("\nTheorem ") :].rpartition("Print Assumptions ")[0]


def _last(text: str) -> str:
    """Returns the name whose assumptions the text prints."""
    return text.rpartition("Print Assumptions ")[2].strip().removesuffix(".")


def _run(file: Path, compiled: Path) -> tuple[subprocess.CompletedProcess[str], float]:
    """Returns the output of Coq's compiler within its time limit, and the processor time used."""
    command = ["coqc", "-q", "-w", "none", "-Q", str(compiled), "Kin", str(file)]
    limited = ["sh", "-c", f'ulimit -t {SECONDS}; exec "$@"', "sh", *command]
    with tempfile.TemporaryFile("w+") as said, tempfile.TemporaryFile("w+") as faults:
        running = subprocess.Popen(limited, stdout=said, stderr=faults)
        _, status, used = os.wait4(running.pid, 0)
        running.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        faults.seek(0)
        made = subprocess.CompletedProcess(command, running.returncode, said.read(), faults.read())
    return made, used.ru_utime + used.ru_stime


def with_assumptions(text: str) -> str:
    """Returns a handwritten file that also prints the assumptions of its theorems. Raises CoqFault if it has
    none."""
    names = re.findall(r"^(?:Theorem|Lemma|Corollary|Example)\s+([\w']+)", text, re.MULTILINE)
    if not names:
        raise CoqFault("a file without theorems")
    every = ", ".join(f"@{name}" for name in names)
    return f"{text}\nDefinition all_of_them := ({every}).\nPrint Assumptions all_of_them.\n"


def _axioms(output: str) -> tuple[str, ...]:
    """Returns the names that `Print Assumptions` lists; none if everything is closed."""
    names = set(re.findall(r"^([A-Za-z_][\w.']*)\s*:", output, re.MULTILINE))
    return tuple(sorted(names - {"Axioms"}))  # the heading of the list


def _first_error(message: str) -> str:
    at = message.find("Error:")
    return " ".join(message[max(at, 0) :].split())[:300]
