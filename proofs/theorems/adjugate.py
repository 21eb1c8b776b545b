"""The sentence before (48): Φₙ* is `uniquely defined by` Φₙ Φₙ* = (det Φₙ) I."""

from __future__ import annotations

from workbench.language.goals.proofs import At, Follows, Proven, TwoWitnesses, Unique, Use

THEOREMS = {
    "adjugate_is_unique": Proven(
        Unique({"X": r"\Phi^*"}, only=Follows(r"\Phi^{-1} Y", Y=Use(-1))),
        against=At(
            {r"\Phi": r"\tilde{\omega}"},
            TwoWitnesses({"X": r"\omega \otimes \omega"}, {"X": r"2 \omega \otimes \omega"}),
        ),
    )
}
