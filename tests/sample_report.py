"""A sample report with every verdict. Its formulas are typical of the field; its verdicts are made up."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from tests.planted import planted
from workbench.context.claim_parts import ClaimSource, Mend, Sentence
from workbench.context.claims import Claim, ClaimProof, Correction, Formula, Paper
from workbench.context.index_values import Orders
from workbench.core.verdict import Counterexample, Evidence, Outcome, Verdict
from workbench.prover.results.claim_results import ClaimResult
from workbench.prover.results.proposed_form import Proposed

EXACT = {"method": "exact ring (python-flint)", "outcome": "zero residual", "terms": 48, "variables": 6}
SECOND = {"method": "SymPy PolyRing", "outcome": "agrees", "terms": 48}
DRAKE = {
    "method": "Drake motion",
    "outcome": "within tolerance",
    "residual": 3.1e-13,
    "scale": 12.5,
    "tolerance": 1e-9,
    "samples": 7,
}


FAULTS = {"refuted": "error", "ill-formed": "misprint", "conditional": "hypothesis"}


def claim(
    identity: str,
    equation: str | None,
    section: str,
    verdict: str,
    *,
    printed: str = "",
    reading: Mapping[str, Any] | None = None,
    corrected: Mapping[str, Any] | None = None,
    hypothesis: str | None = None,
    assume: Sequence[str] = (),
    orders: str | None = None,
    counterexample: Mapping[str, Any] | None = None,
    proposed: tuple[Proposed, ...] | None = None,
    mend: Mend | None = None,
    note: str = "",
    inherits: Sequence[str] = (),
    statement: str | None = None,
    quote: str | None = None,
    argued: str | None = None,
    **found: Any,
) -> ClaimResult:
    """found: of the verdict on the printed form. A reading and a correction bring their own."""
    said = Claim(
        identity,
        Formula(printed),
        None,
        assume=tuple(map(Formula, assume)),
        orders=orders and Orders.parse(orders),
        correction=Correction(
            reading and Formula(reading["latex"]),
            corrected and Formula(corrected["latex"]),
            hypothesis and Formula(hypothesis),
        ),
        mend=replace(mend or Mend(), fault=FAULTS.get(verdict)),
        source=ClaimSource(equation, section, statement=statement, note=note),
        sentence=Sentence(quote),
        proof=ClaimProof(argued=argued),
        inherits=tuple(inherits),
    )
    verdicts = [_verdict(**form) if form else None for form in (reading, corrected)]
    against = counterexample and Counterexample.from_dict({"defined": {}, "behind": [], **counterexample})
    own = _verdict(verdict=verdict, counterexample=against, **found)
    return ClaimResult(said, own, *verdicts, proposed=proposed)


def with_fault(result: ClaimResult, fault: str | None) -> ClaimResult:
    """The result of a claim with that fault."""
    return replace(result, claim=replace(result.claim, mend=replace(result.claim.mend, fault=fault)))


def _verdict(
    verdict: str, latex: str = "", evidence: Sequence[Mapping[str, Any]] = (), **rest: Any
) -> Verdict:
    if verdict == "proved":
        evidence = evidence or [EXACT]
    return planted(Outcome(verdict), evidence=tuple(map(Evidence.from_dict, evidence)), **rest)


def report_of(
    results: Sequence[ClaimResult], title: str = "Sample", doi: str | None = None, **citation: str
) -> tuple[Paper, Sequence[ClaimResult]]:
    claims = tuple(result.claim for result in results)
    return Paper(title, doi, (), None, claims, citation=citation), results


SECTION_3 = "3. Fields of higher order"
SECTION_4 = "4.1 Centres and invariants"
SECTION_5 = "5.3 Dual tensors"
SECTION_7 = "7. Spatial chains"

CLAIMS = [
    claim(
        "20.tensor", "20", SECTION_3, "proved",
        printed=r"\boldsymbol{\Phi}_{n+1} = \dot{\boldsymbol{\Phi}}_n + \boldsymbol{\Phi}_n \boldsymbol{\Phi}_1",
        read_back=r"\Phi_{n+1} = \dot{\Phi}_n + \Phi_n \Phi_1", scope="n = 1..8",
        evidence=[EXACT, SECOND, DRAKE],
    ),
    claim(
        "21.tensor", "21", SECTION_3, "ill-formed",
        printed=r"\boldsymbol{\Phi}_n = \boldsymbol{\Phi}_{n-1} \boldsymbol{\Phi}_1 + \left( \frac{d^{n-1}}{dt^{n-1}}"
        r" \boldsymbol{\Phi}_1 \right) + \sum_{k=1}^{n-2} \left[ \frac{d^k}{dt^{n-1}}"
        r" (\boldsymbol{\Phi}_{n-k-1} \boldsymbol{\Phi}_1) \right]",
        reading={
            "latex": r"\Phi_n = \Phi_{n-1} \Phi_1 + \left( \frac{d^{n-1}}{dt^{n-1}} \Phi_1 \right) + \sum_{k=1}^{n-2}"
            r" \left[ \frac{d^k}{dt^k} (\Phi_{n-k-1} \Phi_1) \right]",
            "verdict": "proved",
        },
        scope="n = 3..8", evidence=[EXACT, SECOND], inherits=["22"],
        note=r"The two orders of $\frac{d^k}{dt^{n-1}}$ do not match.",
    ),
    claim(
        "22", "22", SECTION_3, "unchecked", reason="No engine reads vect of a sum yet (sample).",
        printed=r"\boldsymbol{\varepsilon}^{[n]} = \operatorname{vect} \left\{ \boldsymbol{\Phi}_n \right\}",
    ),
    claim(
        "adjugate", "Sentence before (48)", SECTION_4, "conditional",
        statement=r"The adjugate $\Phi^*$ is the only tensor with this product.",
        printed=r"\Phi_n \Phi_n^* = (\det \Phi_n) \mathbf{I}",
        read_back=r"\Phi_n \Phi_n^* = \det \Phi_n \mathbf{I}",
        hypothesis=r"\det \Phi_n \neq 0",
        counterexample={
            "values": {r"\Phi": ["1", "0", "0", "0", "0", "0", "0", "0", "0"],
                       "X": ["0", "0", "0", "0", "0", "0", "0", "0", "1/2"]},
            "lhs": ["0"] * 9, "rhs": ["0"] * 9, "kinds": {r"\Phi": "tensor", "X": "tensor"}, "kind": "tensor"},
        evidence=[EXACT, SECOND],
    ),
    claim(
        "53.adjugate", "53", SECTION_4, "proved",
        printed=r"\Phi^* = \mathbf{S}^* - \widetilde{\mathbf{S}\mathbf{t}} + \mathbf{t} \otimes \mathbf{t}",
        evidence=[EXACT, SECOND],
    ),
    claim(
        "T4", "Theorem 4", SECTION_4, "proved", evidence=[EXACT],
        printed="Adjugate and determinant of a tensor from its symmetric part and its vector.",
        statement="Adjugate and determinant of a tensor from its symmetric part and its vector.",
    ),
    claim(
        "58.adjugate", "58", SECTION_4, "ill-formed",
        printed=r"\Phi_2^* = (\boldsymbol{\omega} \otimes \boldsymbol{\omega})^2 - \tilde{\boldsymbol{\omega}}^2"
        r" \dot{\boldsymbol{\omega}} + \dot{\boldsymbol{\omega}} \otimes \dot{\boldsymbol{\omega}}",
        reading={
            "latex": r"\Phi_2^* = (\omega \otimes \omega)^2 - \widetilde{\tilde{\omega}^2 \dot{\omega}}"
            r" + \dot{\omega} \otimes \dot{\omega}",
            "verdict": "proved",
        },
        evidence=[{"method": "types", "outcome": "ill-typed", "line": 1, "column": 47,
                   "found": "tensor − vector"}, SECOND],
        inherits=["59"],
    ),
    claim(
        "58.det", "58", SECTION_4, "proved", assume=[r"\omega \times \dot{\omega} \neq 0"], orders="n = 2..2",
        argued="it is only told", evidence=[EXACT, SECOND, DRAKE],
        printed=r"\det \Phi_2 = -(\boldsymbol{\omega} \times \dot{\boldsymbol{\omega}})^2",
    ),
    claim(
        "59", "59", SECTION_4, "refuted",
        printed=r"\Phi_2^{-1} = \frac{\tilde{\boldsymbol{\omega}}^2 \dot{\boldsymbol{\omega}}"
        r" - (\boldsymbol{\omega} \otimes \boldsymbol{\omega})^2 + \dot{\boldsymbol{\omega}} \otimes"
        r" \dot{\boldsymbol{\omega}}}{(\boldsymbol{\omega} \times \dot{\boldsymbol{\omega}})^2}",
        read_back=r"\Phi_2^{-1} = \frac{\tilde{\omega}^2 \dot{\omega} - (\omega \otimes \omega)^2 + \dot{\omega}"
        r" \otimes \dot{\omega}}{(\omega \times \dot{\omega})^2}",
        corrected={
            "latex": r"\Phi_2^{-1} = \frac{\widetilde{\tilde{\omega}^2 \dot{\omega}} - (\omega \otimes \omega)^2"
            r" - \dot{\omega} \otimes \dot{\omega}}{(\omega \times \dot{\omega})^2}",
            "verdict": "proved",
        },
        counterexample={
            "values": {r"\boldsymbol{\omega}": ["1", "0", "0"], r"\dot{\boldsymbol{\omega}}": ["0", "1", "-1/2"]},
            "lhs": ["0", "0", "1", "0", "-4/3", "0", "0", "0", "0"],
            "rhs": ["0", "0", "1", "0", "2/3", "0", "0", "0", "1"], "kind": "tensor"},
        evidence=[{"method": "residual modulo a 61-bit prime", "outcome": "non-zero", "points": 1}, SECOND],
        inherits=["61.det", "nowhere"],
    ),
    claim(
        "61.adjugate", "61", SECTION_4, "proved", evidence=[EXACT, SECOND],
        printed=r"\Phi_3^* = \frac{9}{4} \left[ (\boldsymbol{\omega} \otimes \dot{\boldsymbol{\omega}})^2 +"
        r" (\dot{\boldsymbol{\omega}} \otimes \boldsymbol{\omega})^2 + (\boldsymbol{\omega} \times"
        r" \dot{\boldsymbol{\omega}}) \otimes (\dot{\boldsymbol{\omega}} \times \boldsymbol{\omega}) \right]"
        r" - \widetilde{\mathbf{S}}_3 \mathbf{t}_3 + \mathbf{t}_3 \otimes \mathbf{t}_3",
        read_back=r"\Phi_3^* = \frac{9}{4} \left[ (\omega \otimes \dot{\omega})^2 + (\dot{\omega} \otimes \omega)^2"
        r" \right] + \mathbf{t}_3 \otimes \mathbf{t}_3",
    ),
    claim(
        "61.det", "61", SECTION_4, "refuted",
        printed=r"\det \Phi_3 = \frac{12(\mathbf{t}_3 \times \dot{\boldsymbol{\omega}})(\boldsymbol{\omega} \times"
        r" \mathbf{t}_3) + 27\boldsymbol{\omega} \cdot \dot{\boldsymbol{\omega}}(\boldsymbol{\omega} \times"
        r" \dot{\boldsymbol{\omega}})^2}{4}.",
        corrected={
            "latex": r"\det \Phi_3 = \frac{12(\mathbf{t}_3 \times \dot{\omega}) \cdot (\omega \times \mathbf{t}_3)"
            r" - 27\omega \cdot \ddot{\omega}(\omega \times \dot{\omega})^2}{4}",
            "verdict": "proved", "read_back": r"\det \Phi_3 = 0", "scope": None, "reason": None,
            "evidence": [EXACT, DRAKE],
        },
        counterexample={"values": {r"\omega": ["1", "0", "0"], r"\dot{\omega}": ["0", "1", "0"],
                                   r"\ddot{\omega}": ["0", "0", "1"]}, "lhs": ["-13/4"], "rhs": ["1/4"]},
        evidence=[EXACT, SECOND, DRAKE],
        note="A made-up erratum: 100% sample_text & <b>markup</b> that must be escaped.",
    ),
    claim(
        "63", "63", SECTION_4, "probable",
        printed=r"\begin{aligned} \Phi_4 &= \ddddot{\boldsymbol{\omega}} + \dddot{\tilde{\omega}}\dot{\tilde{\omega}} \\"
        r" \mathbf{t}_4 &= \dddot{\omega} + \ddot{\omega} \times \omega - 2\omega^2\dot{\omega} \end{aligned}",
        evidence=[{"method": "random points", "outcome": "zero", "points": 12, "error bound": "1e-18"}],
    ),
    claim(
        "67.w", "67", SECTION_4, "definition", evidence=[{"method": "types and weights", "outcome": "well-formed"}],
        printed=r"\mathbf{w} = \ddot{\boldsymbol{\omega}} - \boldsymbol{\omega} \times \dot{\boldsymbol{\omega}}"
        r" - \boldsymbol{\omega}^2\boldsymbol{\omega}",
    ),
    claim(
        "R5", "Remark 5", SECTION_5, "conditional", printed=r"\|\underline{\mathbf{u}}\| = 1",
        hypothesis=r"\operatorname{Re} \underline{\mathbf{u}} \neq \mathbf{0}",
    ),
    claim(
        "83", "83", SECTION_5, "proved", evidence=[EXACT, SECOND],
        printed=r"\underline{\mathbf{R}} = (\mathbf{I} + \varepsilon \tilde{\boldsymbol{\rho}}) \mathbf{R},"
        r" \quad \underline{\mathbf{R}} \in \underline{\mathbf{SO}}_3^{\mathbb{R}}",
    ),
    claim(
        "117", "117", SECTION_7, "definition",
        printed=r"\underline{\mathbf{R}} = {}^0\underline{\mathbf{R}}_1 \cdot {}^1\underline{\mathbf{R}}_2 \dots"
        r" {}^{m-1}\underline{\mathbf{R}}_m",
    ),
    claim(
        "133", "133", SECTION_7, "proved", scope="all n", evidence=[EXACT, SECOND],
        printed=r"\begin{aligned} {}_0\underline{\omega}_m^{(n)} &= \underline{\omega}_1^{[n]} + \dots +"
        r" \underline{\omega}_m^{[n]} + \\ &+ \sum_{p=2}^m \sum_{k=1}^n C_n^k \sum_{k_1+\dots+k_{p-1}=k}"
        r" C_n^{k_1, \dots, k_{p-1}} \underline{\Phi}_{k_1}(\underline{\omega}_1) \dots"
        r" \underline{\Phi}_{k_{p-1}}(\underline{\omega}_{p-1}) \underline{\omega}_p^{[n-k]}, \end{aligned}",
    ),
    claim(
        "134", "134", SECTION_7, "refuted",
        printed=r"\Phi_4 = a + b + c + d + e + f + g + h + k + l + m + n + o + \rho_1 \times \rho_2",
        corrected={
            "latex": r"\Phi_4 = a + b + c + d + e + f + g + h + k + l + m + n + o + (\omega \times \rho_3) \cdot"
            r" \frac{3 \dot{\omega} \times \ddot{\omega} + 2 \omega^2 \dot{\omega}}{(\omega \times \dot{\omega})^2}",
            "verdict": "proved",
        },
    ),
    claim(
        "L", "Lemma", SECTION_7, "ill-formed", printed=r"\underline{\omega} = \mystery{x} \cos",
        reading={"latex": r"\underline{\omega} = \cos x", "verdict": "definition"},
    ),
]  # fmt: skip


def sample(**citation: str) -> tuple[Paper, Sequence[ClaimResult]]:
    return report_of(CLAIMS, "Sample: kinematics of higher order", "10.0000/sample_1", **citation)
