"""Eqs. (132) and (133) in noncommuting letters: what holds there holds for the dual twists of any chain.

The letter (i, k) is the tensor ω̲̃ᵢ^[k] of body i, k times differentiated in the frame in which Ω̲ᵢ is and
seen from C₀. A twist ω̲ₚ^[k] is a letter too, which only ends words: (p, k) with p negative. As the frame of
ω̲ᵢ moves with the twist Σ_{j<i} ω̲ⱼ,

    d/dt ω̲̃ᵢ^[k] = ω̲̃ᵢ^[k+1] + Σ_{j<i} (ω̲̃ⱼ ω̲̃ᵢ^[k] − ω̲̃ᵢ^[k] ω̲̃ⱼ),    d/dt ω̲ₚ^[k] = ω̲ₚ^[k+1] + Σ_{j<p} ω̲̃ⱼ ω̲ₚ^[k].

With these the left sides are differentiated, one time after another; the right sides are what is printed,
with a coefficient to choose.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from functools import cache
from itertools import product
from math import comb, factorial

Letter = tuple[int, int]
#: A polynomial with integer coefficients: word → coefficient.
Words = Counter
#: coefficient(n, (k₁, …)) of the product Φ̲ₖ₁ … in the n-th derivative.
Coefficient = Callable[[int, tuple[int, ...]], int]


def multinomial(n: int, parts: tuple[int, ...]) -> int:
    """k!/(k₁! k₂! …) with k = Σ kᵢ, whatever n is: what the coefficient must be."""
    value = factorial(sum(parts))
    for part in parts:
        value //= factorial(part)
    return value


def printed_multinomial(n: int, parts: tuple[int, ...]) -> int:
    """n!/(k₁! k₂! …) with the n of the order, as the text below (132) says."""
    return multinomial(n, parts) * factorial(n) // factorial(sum(parts))


def total_Phi(bodies: int, order: int) -> Words:
    """Φ̲ₖ(ω̲₁ + … + ω̲_bodies) by (130), d/dt being the derivative in C₀."""
    words = Words({(): 1})
    for _ in range(order):
        following = _times(words, Words({((i, 0),): 1 for i in range(1, bodies + 1)}))
        following.update(_derivative(words))
        words = _nonzero(following)
    return words


def products_of_Phi(bodies: int, order: int, coefficient: Coefficient, n: int) -> Words:
    """The right side of (132): the sum over k₁ + k₂ + … = order."""
    total = Words()
    for parts in product(range(order + 1), repeat=bodies):
        if sum(parts) == order:
            words = Words({(): coefficient(n, parts)})
            for i, part in enumerate(parts, start=1):
                words = _times(words, _own_Phi(i, part))
            total.update(words)
    return _nonzero(total)


def derivatives_of_twist(body: int, order: int) -> Iterator[Words]:
    """ω̲ₚ and its time derivatives in C₀, one by one."""
    words = Words({((-body, 0),): 1})
    yield words
    for _ in range(order):
        words = _derivative(words)
        yield words


def closed_form(body: int, n: int, coefficient: Coefficient) -> Words:
    """The addends of (133) that end with a derivative of ω̲ₚ."""
    total = Words({((-body, n),): 1})
    for k in range(1, n + 1 if body > 1 else 1):
        words = products_of_Phi(body - 1, k, coefficient, n)
        total.update({(*word, (-body, n - k)): comb(n, k) * c for word, c in words.items()})
    return _nonzero(total)


@cache
def _own_Phi(body: int, order: int) -> Words:
    """Φ̲ₖ(ω̲ᵢ) of (134)–(135): the recurrence (130) with the derivative [1]."""
    if order == 0:
        return Words({(): 1})
    below = _own_Phi(body, order - 1)
    words = _times(below, Words({((body, 0),): 1}))
    for word, c in below.items():
        for place, (i, k) in enumerate(word):
            words[*word[:place], (i, k + 1), *word[place + 1 :]] += c
    return _nonzero(words)


def _times(a: Words, b: Words) -> Words:
    words = Words()
    for left, c in a.items():
        for right, d in b.items():
            words[left + right] += c * d
    return words


def _derivative(words: Words) -> Words:
    total = Words()
    for word, c in words.items():
        for place, letter in enumerate(word):
            before, after = word[:place], word[place + 1 :]
            for rate, sign in _rate(letter):
                total[before + rate + after] += sign * c
    return _nonzero(total)


@cache
def _rate(letter: Letter) -> list[tuple[tuple[Letter, ...], int]]:
    i, k = letter
    turns = [((j, 0), letter) for j in range(1, abs(i))]
    rate = [(((i, k + 1),), 1), *((turn, 1) for turn in turns)]
    return rate if i < 0 else [*rate, *((turn[::-1], -1) for turn in turns)]


def _nonzero(words: Words) -> Words:
    return Words({word: c for word, c in words.items() if c})
