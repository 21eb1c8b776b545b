"""Cache of verdicts: unchanged claims are not judged again.

The key of a verdict is a digest of everything that its judges see (`judged_parts`), the options, the versions
of the engines, and the code of the workbench and of the paper's theorems.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, fields
from typing import Any

from workbench.context.claims import Claim, Notation
from workbench.core.verdict import Outcome, Verdict
from workbench.language.goals.proofs import Proven
from workbench.prover.decide.inference import Seal
from workbench.prover.explain.canonical_text import canonical_text
from workbench.prover.explain.judged_parts import JudgedParts, judged_fields_of
from workbench.prover.results.proposed_form import Proposed
from workbench.runtime.fingerprint import code_digest, digest
from workbench.runtime.store import Store

_ENGINES = ("drake", "python-flint", "sympy", "numpy")

#: The fields of a notation that concern all claims.
_OF_ALL_CLAIMS = tuple(each.name for each in fields(Notation) if each.name != "on_motions")


class Memory(Store):
    """A file of verdicts."""

    def recall(self, key: str) -> Verdict | None:
        """Returns the cached verdict; None if it is missing or damaged."""
        with suppress(ValueError, KeyError, TypeError):
            if (text := self.get(key)) is not None:
                return Seal(self.secret).opened(key, json.loads(text))
        return None

    def remember(self, key: str, verdict: Verdict) -> None:
        """Stores a verdict, unless it cannot be restored exactly."""
        seal = Seal(self.secret)
        text = json.dumps(seal.closed(key, verdict), ensure_ascii=False)
        if seal.opened(key, json.loads(text)) == verdict:
            self.put(key, text.encode())

    def proposals(self, key: str) -> tuple[Proposed, ...] | None:
        """Returns the cached proposals of an earlier search; None if they are missing or damaged."""
        with suppress(ValueError, KeyError, TypeError):
            if (text := self.get(key)) is not None:
                return tuple(
                    Proposed(**{**each, "verdict": Outcome(each["verdict"])}) for each in json.loads(text)
                )
        return None

    def keep_proposals(self, key: str, proposed: Sequence[Proposed]) -> None:
        self.put(key, json.dumps([asdict(each) for each in proposed], ensure_ascii=False).encode())

    def knows(self, key: str) -> bool:
        """True if a check with this key has succeeded before."""
        return self.get(key) is not None

    def know(self, key: str) -> None:
        self.put(key, b"known")


class Keys:
    """The keys of one paper's verdicts. options: what else they depend on."""

    def __init__(self, theorems: Mapping[str, Proven], options: Mapping[str, Any]) -> None:
        self._proofs = {name: digest(repr(proof)) for name, proof in theorems.items()}
        self._ground = digest(repr((code_digest(["workbench"], _ENGINES), sorted(options.items()))))
        self.parts = JudgedParts()
        self._notations: dict[tuple[int, ...], tuple[Notation, str]] = {}
        self._last: tuple[Claim, str] | None = None  # a claim's forms are requested one after the other

    def of(self, claim: Claim, form: str) -> str:
        """Returns the key of the verdict on one form of a claim."""
        if self._last is None or self._last[0] is not claim:
            self._last = claim, self._of_part(self.parts.of(claim))
        return digest(f"{form}\n{self._last[1]}")

    def of_proposals(self, claim: Claim, beside: str = "") -> str:
        """Returns the key of the proposals for a claim. beside: the formulas that proposals must agree
        with."""
        return digest(f"proposals\n{beside}\n{self._of_part(self.parts.for_proposals(claim))}")

    def of_bindings(self, notation: Notation) -> str:
        """Returns the key of the check that a notation's bindings agree with its definitions on motions."""
        return digest(repr(("bindings", self._of_notation(self.parts.bound(notation)), self._ground)))

    def _of_part(self, claim: Claim) -> str:
        text = canonical_text([*judged_fields_of(claim).values(), claim.notation.on_motions]).text
        proofs = [self._proofs.get(name or "", "") for name in (claim.proof.theorem, claim.proof.every_n)]
        return digest(repr((text, self._of_notation(claim.notation), proofs, self._ground)))

    def _of_notation(self, notation: Notation) -> str:
        """Returns the digest of a notation without its [motion.claims]."""
        parts = {name: getattr(notation, name) for name in _OF_ALL_CLAIMS}
        key = tuple(map(id, parts.values()))
        if key not in self._notations:
            parts |= {"definitions": list(notation.definitions), "motion": None}
            motion = sorted((canonical_text(symbol).text, bound) for symbol, bound in notation.motion.items())
            urdf = notation.robot and notation.robot.urdf.read_bytes()
            self._notations[key] = notation, digest(repr((canonical_text(parts).text, motion, urdf)))
        return self._notations[key][1]
