"""The sentence before (48): Φₙ* is `uniquely defined by` Φₙ Φₙ* = (det Φₙ) I."""

from __future__ import annotations

from workbench.language.goals.proofs import At, Congruence, Instance, Proven, TwoWitnesses, UniqueExists

THEOREMS = {
    "adjugate_is_unique": Proven(
        UniqueExists({"X": r"\Phi^*"}, only=Congruence(r"\Phi^{-1} Y", Y=Instance(-1))),
        against=At(
            {r"\Phi": r"\tilde{\omega}"},
            TwoWitnesses({"X": r"\omega \otimes \omega"}, {"X": r"2 \omega \otimes \omega"}),
        ),
    )
}
