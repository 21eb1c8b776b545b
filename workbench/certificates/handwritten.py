"""Handwritten theorems: files `certificates/*.v` next to a paper's files or their folder.

A comment before a theorem names its claims: (* on 14, 20.Phi: … *). Its statement is not read back; a reader
must compare it with the claims.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from workbench.certificates import coqc
from workbench.papers import Paper
from workbench.prover.results.claim_results import Certification

_ABOUT = re.compile(r"^\(\* on ([^:]+): (.*?) \*\)\n(.*?)^Proof\.", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class ByHand:
    path: Path

    @property
    def text(self) -> str:
        """The file, extended to print the assumptions of its theorems. Raises CoqFault if it has none."""
        try:
            return coqc.with_assumptions(self.path.read_text("utf-8"))
        except (coqc.CoqFault, UnicodeDecodeError) as fault:
            raise coqc.CoqFault(f"{self.path}: {fault}") from None

    @property
    def about(self) -> list[tuple[str, str, str]]:
        """(claim id, description, Coq statement) of each theorem."""
        found = _ABOUT.findall(self.path.read_text("utf-8"))
        return [(claim, words, said.strip()) for ids, words, said in found for claim in ids.split(", ")]

    @property
    def certifications(self) -> Iterator[tuple[str, Certification]]:
        """Yields Coq's cached answer on the theorems of each claim; nothing unless it accepts all."""
        said = coqc.recall(self.text)
        if said is None or not said.expected:
            return
        rest = "axioms of the real numbers" if said.axioms else "no axioms"
        for claim, words, statement in self.about:
            word = f"{words}; written by hand and not read back: Coq {coqc.version()}, {rest}"
            yield (
                claim,
                Certification(
                    "theorem", f"Coq {coqc.version()}", said.axioms, None, statement, None, None, word
                ),
            )


def by_hand(paper: Paper) -> list[ByHand]:
    """Returns the handwritten files of a paper. Raises CoqFault if a theorem is on an unknown claim."""
    folders = {path.parent for path in paper.paths} | {path.parent.parent for path in paper.paths}
    files = [ByHand(file) for folder in folders for file in (folder / "certificates").glob("*.v")]
    known = {claim.id for claim in paper.claims}
    for each in files:
        for claim, _, _ in each.about:
            if claim not in known:
                raise coqc.CoqFault(f"{each.path}: a theorem on {claim}, which is no claim of the paper")
    return sorted(files, key=lambda each: each.path)
