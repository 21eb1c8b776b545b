"""The rules of inference: the only functions that make a `proved` verdict.

After the kernel of HOL Light: `Verdict` refuses the outcome `proved` without a token of this module. A rule
asks for what it concludes from, and raises Unproved where that is missing. A verdict leaves the process only
under a seal, and comes back through `Seal` or `pickle`, which check it.
"""

from __future__ import annotations

import copyreg
import hmac
import json
import pickle
from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from typing import Any

from workbench.core.proof import PROCESS_SECRET, Unproved, take_maker
from workbench.core.verdict import Evidence, Outcome, Verdict

__all__ = ["Seal", "agreement", "conclusion", "equal_terms", "generalization"]

_make = take_maker(__name__)

#: What a rule may conclude from.
_PREMISES = frozenset({Outcome.PROVED, Outcome.DEFINITION})


def agreement(one: Evidence, other: Evidence, evidence: Sequence[Evidence]) -> Verdict:
    """Returns `proved` for what two engines find independently of each other. evidence: with both of them."""
    if one.method == other.method or one not in evidence or other not in evidence:
        raise Unproved(f"expected the evidence of two engines, got {one.method!r} and {other.method!r}")
    return _proved("agreement of two engines", None, evidence)


def equal_terms(evidence: Evidence) -> Verdict:
    """Returns `proved` for all values of the integers, where both sides have the same normal form."""
    return _proved("equal normal forms", "all", [evidence])


def conclusion(
    rule: str, premises: Sequence[Verdict], evidence: Sequence[Evidence], scope: str | None = None
) -> Verdict:
    """Returns `proved` by a rule whose premises are all shown. Raises Unproved if one is not, or if there is
    no evidence."""
    missing = [premise for premise in premises if premise.outcome not in _PREMISES]
    if missing or not evidence:
        got = missing[0].outcome if missing else "nothing"
        raise Unproved(f"{rule}: expected premises that are proved, got {got}")
    return _proved(rule, scope, evidence)


def generalization(verdict: Verdict, scope: str | None, evidence: Sequence[Evidence]) -> Verdict:
    """Returns the verdict for the integers of a scope, which only the rules may change of a `proved` one."""
    if verdict.outcome != Outcome.PROVED:
        return replace(verdict, scope=scope, evidence=tuple(evidence))
    proof = _make("generalization", scope)
    return replace(verdict, scope=scope, evidence=tuple(evidence), proof=proof)


def _proved(rule: str, scope: str | None, evidence: Sequence[Evidence]) -> Verdict:
    return Verdict(Outcome.PROVED, scope=scope, evidence=tuple(evidence), proof=_make(rule, scope))


class Seal:
    """Sends verdicts as JSON values to whoever has the same secret, and reads them back."""

    def __init__(self, secret: bytes) -> None:
        self._secret = secret

    def closed(self, key: str, verdict: Verdict) -> dict[str, Any]:
        """Returns the verdict as JSON values, of a `proved` one with a seal. key: what it is a verdict on."""
        data = verdict.to_dict()
        if verdict.proof is None:
            return data
        data["rule"] = verdict.proof.rule
        return data | {"seal": self._of(key, data)}

    def opened(self, key: str, data: Mapping[str, Any]) -> Verdict:
        """Returns the verdict. Raises Unproved if it is `proved` and its seal is not the one of this secret,
        key and verdict; KeyError, ValueError or TypeError for what is no verdict."""
        own = dict(data)
        if own.get("outcome") != Outcome.PROVED:
            return Verdict.from_dict(own)
        if not hmac.compare_digest(str(own.pop("seal", "")), self._of(key, own)):
            raise Unproved("the seal of a proved verdict is missing or wrong")
        rule = own.pop("rule")
        return Verdict.from_dict(own, _make(rule, own["scope"]))

    def _of(self, key: str, data: Mapping[str, Any]) -> str:
        text = json.dumps([key, data], sort_keys=True)
        return _mac(self._secret, text.encode())


def _mac(secret: bytes, message: bytes) -> str:
    return hmac.new(secret, message, "sha256").hexdigest()


def _reduced(verdict: Verdict) -> tuple[Any, tuple[Any, ...]]:
    """Returns how pickle sends a verdict to a process of this one's family."""
    values = {each.name: getattr(verdict, each.name) for each in fields(verdict)}
    proof = values.pop("proof")
    if proof is None:
        return Verdict, tuple(values.values())
    content = pickle.dumps((proof.rule, values))
    return _restored, (content, _mac(PROCESS_SECRET, content))


def _restored(content: bytes, seal: str) -> Verdict:
    if not hmac.compare_digest(seal, _mac(PROCESS_SECRET, content)):
        raise Unproved("the seal of a proved verdict is missing or wrong")
    rule, values = pickle.loads(content)
    return Verdict(**values, proof=_make(rule, values["scope"]))


copyreg.pickle(Verdict, _reduced)
