"""Texts as they stood in the commits of a git repository."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from workbench.app.commands.options import Unusable
from workbench.source.documents import SUFFIXES

#: What a text can be read from.
_READ = frozenset({*SUFFIXES, ".toml", ".sty", ".cls", ".def", ".cfg", ".ltx", ".ins", ".urdf"})
_MOST_BYTES = 20_000_000


@dataclass(frozen=True)
class Commit:
    """One commit. day: of its author.   title: the first line of its message."""

    revision: str
    day: str
    title: str

    def __str__(self) -> str:
        return f"{self.revision[:10]}, {self.day}: {self.title}"


@dataclass(frozen=True)
class Repository:
    """A checkout. folder: its top."""

    folder: Path

    @staticmethod
    def around(file: Path) -> Repository:
        """Returns the repository that a file stands in. Raises Unusable if there is none."""
        if shutil.which("git") is None:
            raise Unusable("git: not found; the history of a text needs it")
        folder = file.resolve().parent
        done = _git(folder, "rev-parse", "--show-toplevel")
        if done.returncode:
            raise Unusable(f"{file}: expected a file in a git repository")
        return Repository(Path(done.stdout.decode().removesuffix("\n")).resolve())

    def revision(self, name: str) -> str:
        """Returns the full name of a commit. Raises Unusable for what names none."""
        done = _git(self.folder, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{name}^{{commit}}")
        if done.returncode:
            raise Unusable(f"{name!r}: expected a commit of {self.folder}, as HEAD~1 or a branch")
        return done.stdout.decode().strip()

    def commits(self, files: Sequence[Path]) -> Iterator[Commit]:
        """Yields the commits that changed any of the files, the newest first."""
        names = [str(each.resolve().relative_to(self.folder)) for each in files if self._holds(each)]
        form = "--format=%H%x00%as%x00%s"
        done = _git(self.folder, "--literal-pathspecs", "log", "--topo-order", form, "--", *names)
        for line in done.stdout.decode("utf-8", "replace").splitlines():
            yield Commit(*line.split("\0"))

    def _holds(self, file: Path) -> bool:
        return file.resolve().is_relative_to(self.folder)

    @contextmanager
    def at(self, revision: str) -> Iterator[Path]:
        """Within it a folder has the texts of a commit, and nothing else of it. No filter and no hook runs;
        links are left out."""
        with TemporaryDirectory(prefix="workbench-") as name:
            folder = Path(name)
            blobs = list(self._blobs(revision))
            contents = self._contents([blob for blob, _ in blobs])
            for (_, path), content in zip(blobs, contents, strict=True):
                place = folder / path
                place.parent.mkdir(parents=True, exist_ok=True)
                place.write_bytes(content)
            yield folder

    def _blobs(self, revision: str) -> Iterator[tuple[str, str]]:
        """Yields name and path of each text in a commit."""
        listed = _git(self.folder, "ls-tree", "-r", "-z", "-l", "--full-tree", revision).stdout
        for entry in listed.decode("utf-8", "surrogateescape").split("\0"):
            about, _, path = entry.partition("\t")
            if not path or Path(path).suffix.lower() not in _READ:
                continue
            mode, _, blob, size = about.split()
            if mode.startswith("100") and int(size) <= _MOST_BYTES and ".git" not in Path(path).parts:
                yield blob, path

    def _contents(self, blobs: Sequence[str]) -> list[bytes]:
        asked = "".join(f"{blob}\n" for blob in blobs).encode()
        told = _git(self.folder, "cat-file", "--batch", asked=asked).stdout
        found, at = [], 0
        for _ in blobs:
            end = told.index(b"\n", at)
            size = int(told[at:end].split()[2])
            found.append(told[end + 1 : end + 1 + size])
            at = end + 2 + size
        return found


def _git(folder: Path, *arguments: str, asked: bytes = b"") -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(["git", "-C", str(folder), *arguments], input=asked, capture_output=True)
