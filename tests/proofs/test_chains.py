"""Section 7 beside words, poses in whole numbers and Drake's chains: (119), (132) and (133) expanded."""

from collections import Counter
from math import factorial
from random import Random

import numpy as np
import pytest

from tests.proofs import chain_poses, chain_words
from tests.proofs.chain_expansions import (
    DRAKE_TOLERANCE,
    relative_twists_in_drake,
    relative_twists_on_poses,
    tensors_in_words,
    twists_in_drake,
    twists_in_words,
    twists_on_poses,
)
from tests.proofs.chain_words import (
    closed_form,
    derivatives_of_twist,
    multinomial,
    printed_multinomial,
    products_of_Phi,
    total_Phi,
)
from workbench.kinematics.cylindrical_chains import latex_2c, latex_3c
from workbench.papers.load import find_paper


def random_words(draw: Random) -> Counter:
    letters = [(i, k) for i in (1, 2, 3) for k in (0, 1)]
    return Counter({tuple(draw.choices(letters, k=draw.randint(0, 3))): draw.randint(1, 5) for _ in range(4)})


def total(*addends: Counter) -> Counter:
    result = Counter()
    for words in addends:
        result.update(words)
    return chain_words._nonzero(result)


@pytest.mark.parametrize("seed", range(20))
def test_words_are_differentiated_by_leibniz(seed):
    draw = Random(seed)
    a, b = random_words(draw), random_words(draw)
    times, derive = chain_words._times, chain_words._derivative
    assert derive(times(a, b)) == total(times(derive(a), b), times(a, derive(b)))


@pytest.mark.parametrize("order", range(6))
def test_one_twist_has_one_tensor(order):
    """For the first body d/dt is the derivative [1], so that both meanings of Φ agree."""
    assert total_Phi(1, order) == chain_words._own_Phi(1, order)


@pytest.mark.parametrize("order", range(1, 7))
def test_number_of_words(order):
    """Φₖ of one twist has 2ᵏ⁻¹ words, and its coefficients add up to Bell's number."""
    words = chain_words._own_Phi(1, order)
    assert len(words) == 2 ** (order - 1)
    assert sum(words.values()) == bell(order)


def bell(n: int) -> int:
    """Set partitions: with all ω̃^[k] = 1, R = exp(eᵗ − 1) and R⁽ⁿ⁾(0) is Bell's number."""
    row = [1]
    for _ in range(n - 1):
        following = [row[-1]]
        for entry in row:
            following.append(following[-1] + entry)
        row = following
    return row[-1]


@pytest.mark.parametrize("n", range(2, 5))
@pytest.mark.parametrize("body", range(2, 5))
def test_printed_coefficient_fails_from_order_2_on(body, n):
    derivative = list(derivatives_of_twist(body, n))[n]
    assert derivative == closed_form(body, n, multinomial)
    assert derivative != closed_form(body, n, printed_multinomial)


def test_printed_coefficient_is_right_where_n_is_k():
    for parts in ((1, 2), (0, 3), (1, 1, 1)):
        assert printed_multinomial(3, parts) == multinomial(3, parts)
    assert printed_multinomial(4, (1, 0)) == factorial(4)


@pytest.mark.parametrize("k", range(2, 5))
def test_order_of_the_factors_matters(k):
    reversed_words = Counter({word[::-1]: c for word, c in products_of_Phi(2, k, multinomial, k).items()})
    assert total_Phi(2, k) != reversed_words


def test_poses_notice_one_wrong_number(monkeypatch):
    first, (relative, poses) = chain_poses._integer_chain(2, 3)
    wrong = [pose.copy() for pose in poses]
    wrong[2][0, 3] += 1
    monkeypatch.setattr(chain_poses, "_integer_chain", lambda bodies, order: [first, (relative, wrong)])
    residuals = list(chain_poses.rational_residuals(2, range(4), multinomial))
    assert [bool(r.any()) for r in residuals] == [False, True, True, True]


def test_drake_and_words_refuse_the_same_coefficient():
    worst = [np.abs(r).max() for r in chain_poses.drake_residuals((2,), printed_multinomial)]
    assert min(worst) > 1e6 * DRAKE_TOLERANCE


EXPANSIONS = (tensors_in_words, twists_in_words, twists_on_poses, twists_in_drake)


@pytest.mark.parametrize("expansion", EXPANSIONS)
def test_expansions_hold_only_with_multinomial_coefficients(expansion):
    right, wrong = list(expansion(multinomial)), list(expansion(printed_multinomial))
    assert right and all(right)
    assert not all(wrong)


@pytest.mark.parametrize("sums", [relative_twists_on_poses, relative_twists_in_drake])
def test_twists_add_up_once_they_are_turned_to_one_frame(sums):
    turned, as_they_are = list(sums(turned=True)), list(sums(turned=False))
    assert turned and all(turned)
    assert not all(as_they_are)


@pytest.mark.parametrize("expansion", [tensors_in_words, twists_in_words])
def test_words_notice_a_wrong_tensor(expansion, monkeypatch):
    """Φ₂ with ω̃² left out."""
    right = chain_words._own_Phi

    def wrong(body, order):
        words = right(body, order)
        return Counter({w: c for w, c in words.items() if w != ((body, 0), (body, 0))})

    monkeypatch.setattr(chain_words, "_own_Phi", wrong)
    assert not all(expansion(multinomial))


@pytest.mark.parametrize("expansion", [twists_on_poses, twists_in_drake])
def test_poses_notice_a_wrong_tensor(expansion, monkeypatch):
    right = chain_poses._Phi

    def wrong(rates, order):
        return [p if k != 2 else p - rates[0] @ rates[0] for k, p in enumerate(right(rates, order))]

    monkeypatch.setattr(chain_poses, "_Phi", wrong)
    assert not all(expansion(multinomial))


def test_the_claims_state_the_closed_forms_that_are_printed():
    goals = {claim.id: claim.proof.goal.latex for claim in find_paper().claims if claim.proof.goal}
    for name, expanded in (("3C", False), ("3C.expanded", True)):
        for formula in latex_3c(expanded):
            assert formula in goals[name]
    assert len(latex_2c()) == 4
