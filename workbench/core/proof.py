"""The token that a verdict needs to be `proved`.

The class is abstract, after the type `thm` of HOL Light: its constructor raises, and so does a subclass.
`take_maker` gives the function that makes tokens to the first caller only: the inference rules of the prover.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable
from typing import Final, NoReturn, final
from weakref import WeakSet


class Unproved(ValueError):
    """A verdict claims to be `proved`, and no inference rule has made it."""


@final
class Proof:
    """A token made by an inference rule. rule: its name; scope: that of the verdict."""

    __slots__ = ("__weakref__", "rule", "scope")
    rule: str
    scope: str | None

    def __new__(cls, *_: object, **__: object) -> Proof:
        raise Unproved("a Proof is made by the rules of workbench.prover.decide.inference only")

    def __init_subclass__(cls) -> None:
        raise Unproved("a Proof has no subclasses")

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise Unproved("a Proof is not changed")

    def __reduce__(self) -> NoReturn:
        raise Unproved("a Proof is sent with its verdict, under a seal")


_genuine: WeakSet[Proof] = WeakSet()
_takers: list[str] = []

#: For seals between this process and those that are forked from it.
PROCESS_SECRET: Final = secrets.token_bytes(32)


def is_genuine(proof: object) -> bool:
    """Returns whether an inference rule has made the token in this process."""
    return type(proof) is Proof and proof in _genuine


def take_maker(taker: str) -> Callable[[str, str | None], Proof]:
    """Returns the function that makes tokens, from a rule's name and a scope. Raises Unproved for the second
    time that it is asked for."""
    if _takers:
        raise Unproved(f"{taker}: the tokens are made by {_takers[0]} only")
    _takers.append(taker)

    def make(rule: str, scope: str | None) -> Proof:
        proof = object.__new__(Proof)
        object.__setattr__(proof, "rule", rule)
        object.__setattr__(proof, "scope", scope)
        _genuine.add(proof)
        return proof

    return make
