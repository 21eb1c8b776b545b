"""What a text says of a motion by a law holds for its later formulas, and excuses those before it."""

from pathlib import Path

import pytest

from tests.texts.written import doubts, shown, told, verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome, Verdict
from workbench.papers.load import load_paper

KINDS = """
x = "scalar"
y = "scalar"
F = "scalar"
m = { kind = "scalar", constant = true, positive = true }
c = { kind = "scalar", constant = true }
p = { kind = "scalar", positive = true }
k = { kind = "scalar", constant = true }
'\\mu' = { kind = "scalar", constant = true }
'\\vec r' = "vector"
'\\vec v' = "vector"
'\\vec h' = "vector"
'\\vec \\omega' = "vector"
'\\vec L' = "vector"
J = { kind = "tensor", symmetric = true, constant = true }
[definitions]
'\\vec v' = '\\dot{\\vec r}'
'\\vec h' = '\\vec r \\times \\vec v'
"""
ENERGY = r"\frac{d}{dt} (\frac{1}{2} m \dot x^2 + \frac{1}{2} k x^2)"
KEPLER = r"\ddot{\vec r} = -\frac{\mu}{\|\vec r\|^3} \vec r"
EULER = r"J \dot{\vec\omega} + \vec\omega \times J \vec\omega = \vec L"


def judged(folder: Path, *displays: str, more: str = "") -> list[Verdict]:
    return verdicts(folder, shown(*displays), f"[symbols]{KINDS}{more}")


#: A law, what follows from it, and what does not.
FOLLOWING = [
    (r"m \ddot x = -k x", f"{ENERGY} = 0", f"{ENERGY} = k x \\dot x"),
    (r"m \ddot x = F", r"\ddot x = \frac{F}{m}", r"\ddot x = \frac{F}{m} + c"),
    (r"m \ddot x = -k x - c \dot x", f"{ENERGY} = -c \\dot x^2", f"{ENERGY} = c \\dot x^2"),
    (r"\ddot x = c \dot x", r"x^{(3)} = c^2 \dot x", r"x^{(3)} = c \dot x"),
    (KEPLER, r"\dot{\vec h} = 0", r"\ddot{\vec h} = \vec h"),
    (KEPLER, r"\frac{d}{dt} (\frac{1}{2} \vec v^2 - \frac{\mu}{\|\vec r\|}) = 0", r"\frac{d}{dt} (\frac{1}{2} \vec v^2 + \frac{\mu}{\|\vec r\|}) = 0"),
    (EULER, r"\frac{d}{dt} (\frac{1}{2} \vec\omega \cdot J \vec\omega) = \vec\omega \cdot \vec L", r"\frac{d}{dt} (\frac{1}{2} \vec\omega \cdot J \vec\omega) = 2 \vec\omega \cdot \vec L"),
]  # fmt: skip


@pytest.mark.parametrize(("law", "follows", "does_not"), FOLLOWING)
def test_consequences_of_an_earlier_law_are_conditional(
    tmp_path: Path, law: str, follows: str, does_not: str
) -> None:
    stated, held, failed = judged(tmp_path, law, follows, does_not)
    assert told(stated) == "said"
    assert held.outcome is Outcome.CONDITIONAL and "(L1)" in held.reason and held.hypothesis
    assert failed.outcome not in (Outcome.PROVED, Outcome.CONDITIONAL)


#: A law, and the rate of a momentum that follows from it, with a false form and one that says something new.
RATES_OF_MOMENTA = [
    (r"\ddot x + \sin x = 0", r"\dot x", r"-\sin x", r"\sin x", r"F - \sin x"),
    (r"\ddot x = -k x", r"\dot x", r"-k x", r"k x", r"-c x"),
    (r"m \ddot x = -k x", r"m \dot x", r"-k x", r"-\frac{k}{m} x", r"-k y"),
    (r"m \ddot x = -k x - c \dot x", r"m \dot x", r"-k x - c \dot x", r"k x - c \dot x", r"F - c \dot x"),
    (r"m \ddot x = F", r"m \dot x", r"F", r"m F", r"-k x"),
]


@pytest.mark.parametrize(("law", "momentum", "right", "false", "new"), RATES_OF_MOMENTA)
def test_a_rate_of_a_defined_symbol_is_a_claim_beside_a_law(
    tmp_path: Path, law: str, momentum: str, right: str, false: str, new: str
) -> None:
    """A warning, since it may be of another motion; one with a new symbol, or without one of the law, is a law."""
    found = [
        judged(tmp_path, law, f"\\dot f = {side}", more=f"f = '{momentum}'") for side in (right, false, new)
    ]
    assert {told(stated) for stated, _ in found} == {"said"}
    (_, held), (_, failed), (_, other) = found
    assert held.outcome is Outcome.CONDITIONAL and "(L1)" in held.reason
    assert failed.outcome is Outcome.REFUTED and "(L1)" in doubts(failed)
    assert told(other) == "said"


def test_a_law_of_each_rate_is_the_last_one_before(tmp_path: Path) -> None:
    laws = [r"\ddot x = -k x", r"\ddot x = -c x", r"\ddot y = k y"]
    *_, of_the_second, of_the_first, of_both = judged(
        tmp_path,
        *laws,
        r"\frac{d}{dt} (\dot x^2 + c x^2) = 0",
        r"\frac{d}{dt} (\dot x^2 + k x^2) = 0",
        r"\frac{d}{dt} (\dot x \dot y) = k y \dot x - c x \dot y",
    )
    assert of_the_second.outcome is of_both.outcome is Outcome.CONDITIONAL
    assert of_the_first.outcome is not Outcome.REFUTED
    assert "-k x" not in str(of_both.hypothesis)


def test_a_law_that_inverts_a_matrix_follows_and_leads_nowhere(tmp_path: Path) -> None:
    solved = r"\dot{\vec\omega} = J^{-1} (\vec L - \vec\omega \times J \vec\omega)"
    energy = r"\frac{d}{dt} (\frac{1}{2} \vec\omega \cdot J \vec\omega) = \vec\omega \cdot \vec L"
    _, follows, by_the_first = judged(tmp_path, EULER, solved, energy)
    assert follows.outcome is by_the_first.outcome is Outcome.CONDITIONAL
    assert "(L1)" in by_the_first.reason


def test_a_law_may_stand_in_a_sentence(tmp_path: Path) -> None:
    held, false = verdicts(
        tmp_path,
        "Let $R$ turn with $\\dot R = R \\tilde w$.\n\n$$ \\frac{d}{dt} (R v) = R (\\dot v + w \\times v) $$\n\n"
        "$$ \\frac{d}{dt} (R v) = R (\\dot v - w \\times v) $$",
        "source = 'p.md'\n[symbols]\nR = 'rotation'\nw = 'vector'\nv = 'vector'\n",
    )
    assert held.outcome is Outcome.CONDITIONAL and "line 1" in held.reason
    assert false.outcome not in (Outcome.PROVED, Outcome.CONDITIONAL)


def test_a_rate_and_a_higher_one_have_laws_each(tmp_path: Path) -> None:
    *_, held = judged(tmp_path, r"\dot x = F", r"\ddot x = \dot F", r"\dot x \ddot x = F \dot F")
    assert held.outcome is Outcome.CONDITIONAL


def test_two_laws_for_one_rate_contradict_nothing(tmp_path: Path) -> None:
    """They are of two motions; the later one is not false."""
    for each in judged(tmp_path, r"\ddot x = -k x", r"\ddot x = -k x - c \dot x", r"\ddot x = k"):
        assert told(each) == "said"


def test_claims_that_a_law_may_imply_are_not_refuted(tmp_path: Path) -> None:
    """In motion without a torque, which words alone say, or by a law that stands behind."""
    rest = r"\frac{d}{dt} (\vec\omega \cdot J \vec\omega) = 0"
    for displays in ([EULER, rest], [rest, EULER]):
        found = judged(tmp_path, *displays)[displays.index(rest)]
        assert told(found) != "refuted"


def test_claims_false_under_every_law_are_refuted(tmp_path: Path) -> None:
    *_, false = judged(tmp_path, r"\ddot x + x^2 = 0", r"\frac{d}{dt} (x \dot x \dot x) = \dot x^3")
    assert false.outcome is Outcome.REFUTED
    alone, *_ = judged(tmp_path, r"\frac{d}{dt} (m \dot x \dot x) = m \ddot x")
    assert alone.outcome is Outcome.REFUTED


FRAMES = """
[frames]
base = "N"
names = ["B"]
dot = "B"
"""
MOMENTUM = r"\frac{{}^N d}{dt} (J \vec\omega) = J \dot{\vec\omega} + \vec\omega \times J \vec\omega"


def test_constants_have_no_rate_in_the_frame_of_the_dot(tmp_path: Path) -> None:
    turning = "'{}^F\\vec\\omega^G' = 'angular velocity of G in F'\n"
    told = MOMENTUM.replace(r"\vec\omega", r"{}^N\vec\omega^B")
    displays = (told, told.replace("= J", "= 2 J"), r"\dot J = 0", r"\frac{d}{dt} (J J) = 0")
    held, false, still, _ = found = judged(tmp_path, *displays, more=FRAMES + turning)
    assert held.outcome is Outcome.PROVED and false.outcome is Outcome.REFUTED
    assert still.outcome is not Outcome.REFUTED and "in which frame" in found[-1].reason


def test_a_vector_may_be_the_angular_velocity_of_a_frame(tmp_path: Path) -> None:
    meant, false = judged(tmp_path, MOMENTUM, MOMENTUM.replace("= J", "= 2 J"), more=FRAMES)
    assert told(meant) == "doubtful" and "the angular velocity" in doubts(meant)
    assert false.outcome is Outcome.REFUTED


def test_a_vector_of_components_that_nothing_defines_may_be_any(tmp_path: Path) -> None:
    """The law d/dt H = M with M along the axes of a frame was refuted at M = 0."""
    axes = "axes = { B = ['\\hat b_x', '\\hat b_y', '\\hat b_z'] }\n"
    frames = FRAMES.replace('dot = "B"', 'dot = "N"')
    known = "'\\vec M' = 'x \\hat b_x + y \\hat b_y + F \\hat b_z'\n'\\vec u' = 'c \\hat b_x'\n"
    law, false = judged(
        tmp_path,
        r"\frac{d}{dt} (c \hat b_x + k \hat b_y) = \vec M",
        r"\dot{\vec u} = 2 \vec u",
        more=known + frames + axes,
    )
    assert told(law) == "said"
    assert false.outcome is Outcome.REFUTED


def test_a_fact_on_a_rate_does_not_replace_its_law(tmp_path: Path) -> None:
    laws = [
        r"\dot x = k y",
        r"\dot y = -k x",
        r"x \dot x = k x y",
        r"x \ddot x + \dot x^2 = k y \dot x - k^2 x^2",
    ]
    *_, followed, reversed_ = judged(tmp_path, *laws, r"\ddot x = -k^2 x", r"\ddot x = k^2 x")
    assert followed.outcome is Outcome.CONDITIONAL and "(L3)" in followed.reason
    assert told(reversed_) == "refuted"


def test_definitions_of_the_text_are_named_without_laws(tmp_path: Path) -> None:
    *_, found = judged(tmp_path, r"\ddot x = -k x", r"F = \frac{1}{2} \dot x^2", r"\dot F = \dot x \ddot x")
    assert found.outcome is Outcome.CONDITIONAL and "(L3)" in found.reason


def test_the_law_of_a_positive_number_is_not_that_of_its_root(tmp_path: Path) -> None:
    (stated,) = judged(tmp_path, r"p \dot p = x")
    assert told(stated) == "said"


def test_only_the_laws_that_it_takes_are_named(tmp_path: Path) -> None:
    laws = [r"\dot x = k y", r"\ddot y = c x \dot x", r"m \dot y = F - c y"]
    *_, found = judged(tmp_path, *laws, r"\frac{d}{dt} (x^2 y) = 2 k x y^2 + x^2 \dot y")
    assert found.outcome is Outcome.CONDITIONAL and str(found.hypothesis) == r"\dot{x} = k y"


CART = r"""
source = "p.md"
[symbols]
x = "scalar"
F = "scalar"
'\theta' = "scalar"
M = { kind = "scalar", constant = true, positive = true }
m = { kind = "scalar", constant = true, positive = true }
l = { kind = "scalar", constant = true, positive = true }
g = { kind = "scalar", constant = true }
[definitions]
E = '\frac{1}{2} (M + m) \dot x^2 + m l \dot x \dot\theta \cos\theta + \frac{1}{2} m l^2 \dot\theta^2 + m g l \cos\theta'
"""
CART_POLE = [
    r"\ddot\theta = \frac{g \sin\theta - \ddot x \cos\theta}{l}",
    r"(M + m) \ddot x + m l \ddot\theta \cos\theta - m l \dot\theta^2 \sin\theta = F",
    r"\ddot x = \frac{F + m l \dot\theta^2 \sin\theta - m g \sin\theta \cos\theta}{M + m \sin^2\theta}",
    r"\ddot\theta = \frac{(M + m) g \sin\theta - F \cos\theta - m l \dot\theta^2 \sin\theta \cos\theta}{l (M + m \sin^2\theta)}",
    r"\dot E = F \dot x",
]


def test_a_cart_and_its_pole(tmp_path: Path) -> None:
    (tmp_path / "p.toml").write_text(CART)
    for sign in ("", "-"):
        rows = [*CART_POLE[:-1], f"{CART_POLE[-1].replace('F', sign + 'F')}"]
        (tmp_path / "p.md").write_text("\n\n".join(f"$$ {each} $$" for each in rows))
        first, second, *found, power = (r.verdict for r in judge_paper(load_paper(tmp_path / "p.toml")))
        assert told(first) == told(second) == "said"
        assert [each.outcome for each in found] == [Outcome.CONDITIONAL] * 2
        assert (power.outcome is Outcome.CONDITIONAL) == (not sign)


@pytest.mark.parametrize("word", [r"= \text{const.}", r"\equiv \mathrm{const}", r"= \mbox{constant}"])
def test_symbols_stated_constant_have_no_rate(tmp_path: Path, word: str) -> None:
    law, kept = r"\ddot y = k x \dot x", rf"\dot y - \frac{{k}}{{2}} x^2 {word}"
    _, found, steps, rest = judged(tmp_path, law, kept, rf"c + c = 2 c {word}")
    assert (found.outcome, str(found.hypothesis)) == (Outcome.CONDITIONAL, r"\ddot{y} = k x \dot{x}")
    assert found.read_back.endswith("= 0")
    assert steps.outcome is rest.outcome is Outcome.PROVED
    _, lost = judged(tmp_path, law, kept.replace("k", "2 k"))
    assert lost.outcome not in (Outcome.CONDITIONAL, Outcome.PROVED)


def test_const_without_a_left_side_states_nothing(tmp_path: Path) -> None:
    for row in (r"\equiv \text{const}", r"x \equiv\equiv \text{const}"):
        assert all(told(found) != "refuted" for found in judged(tmp_path, "x = y", row)[1:])
