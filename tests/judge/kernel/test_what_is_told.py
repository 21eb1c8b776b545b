"""All that a verdict tells: what was decided, why, under which hypothesis, for which n, and the point at which it fails."""

import pytest

from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read
from workbench.prover.decide.decide import Judge

TABLE = SymbolTable.build(
    {
        **{name: {"kind": "scalar"} for name in "fgh"},
        **{name: {"kind": "vector"} for name in "abc"},
        "T": {"kind": "tensor"},
        "u": {"kind": "vector", "unit": True},
        r"\delta": {"kind": "scalar", "small": True},
    }
)

#: A claim, its premises and its hypothesis: outcome, reason, hypothesis and scope; the point, left and right side.
TOLD = {
    ("f g = g", (), "f = 1"): (
        ("conditional", "holds under a hypothesis that the text does not state", "f = 1", None),
        ({"f": "0", "g": "1"}, "0", "1"),
    ),
    ("f g = g", (), "f = 2"): (
        ("refuted", None, None, None),
        ({"f": "2", "g": "1"}, "2", "1"),
    ),
    ("f = g", (), "f = g + 1"): (
        ("refuted", None, None, None),
        ({"f": "1", "g": "0"}, "1", "0"),
    ),
    (r"f^2 + g^2 = 0 \Rightarrow f = 0", (), "f = 0"): (
        ("unchecked", "no witness against the bare statement was found", None, None),
        None,
    ),
    (r"\frac{f g}{f} = g", (), None): (
        (
            "conditional",
            "the denominator f can vanish, and nothing that the claim assumes excludes it",
            None,
            None,
        ),
        ({"f": "0", "g": "0"}, "undefined", "0"),
    ),
    (r"\frac{f g}{f} = g", (r"f \neq 0",), None): (
        ("proved", None, None, None),
        None,
    ),
    (r"\frac{f g}{f} = g", ("f^3 = 0",), None): (
        (
            "unchecked",
            "no point was found where the assumptions hold and no denominator vanishes",
            None,
            None,
        ),
        None,
    ),
    (r"\frac{f g}{f^2 + f g + g^2} = \frac{g f}{f^2 + f g + g^2}", (), None): (
        (
            "conditional",
            "the denominator f^{2} + f g + g^{2} can vanish, and nothing that the claim assumes excludes it",
            None,
            None,
        ),
        ({"f": "0", "g": "0"}, "undefined", "undefined"),
    ),
    (r"\frac{f g}{f^2 - f + 1} = \frac{g f}{f^2 - f + 1}", (), None): (
        (
            "unchecked",
            "the denominator f^{2} - f + 1 is not seen to be non-zero, and no point was found where it vanishes",
            None,
            None,
        ),
        None,
    ),
    (r"\frac{f^2 + f + 7}{f^2 + f + 7} = 1", (), None): (
        (
            "unchecked",
            "the denominator f^{2} + f + 7 is not seen to be non-zero, and no point was found where it vanishes",
            None,
            None,
        ),
        None,
    ),
    (r"\dot{a} = \dot{b}", (), None): (
        (
            "unchecked",
            r"states a law for \dot{a}, which nothing here defines; to use it, assume or define \dot{a}",
            None,
            None,
        ),
        None,
    ),
    (r"\ddot{a} = f b", (), None): (
        (
            "unchecked",
            r"states a law for \ddot{a}, which nothing here defines; to use it, assume or define \ddot{a}",
            None,
            None,
        ),
        None,
    ),
    (r"f^2 + g^2 = 0 \Rightarrow f = 0", (), None): (
        (
            "unchecked",
            "the residual is not 0 in the exact ring, but no small counterexample was found",
            None,
            None,
        ),
        None,
    ),
    ("f^4 + 1 = 0", (), None): (
        ("refuted", None, None, None),
        ({"f": "0"}, "1", "0"),
    ),
    (r"\sin f = f", (), None): (
        ("refuted", None, None, None),
        ({"f": "1"}, "0.841471", "1"),
    ),
    (r"f \neq g", (), None): (
        ("refuted", None, None, None),
        ({"f": "0", "g": "0"}, "0", "0"),
    ),
    (r"f^2 + 1 \neq 0", (), None): (
        ("unchecked", "no zero was found and none was excluded", None, None),
        None,
    ),
    (r"f + 1 \neq f", (), None): (
        ("proved", None, None, None),
        None,
    ),
    (r"\frac{f + 1}{g} \neq \frac{f}{g}", (), None): (
        ("unchecked", "the denominator g can vanish", None, None),
        None,
    ),
    (r"\frac{f g + g}{g} \neq f", (), None): (
        ("unchecked", "no zero was found and none was excluded", None, None),
        None,
    ),
    ("f = f", (), None): (
        ("unchecked", "both sides are the same term, so nothing is tested", None, None),
        None,
    ),
    (r"\sin \delta \approx \delta", (), None): (
        ("proved", None, None, r"to first order in \delta"),
        None,
    ),
    (r"\cos \delta \approx \delta", (), None): (
        ("refuted", None, None, None),
        ({r"\delta": "0"}, "1", "0 0"),
    ),
    (r"\sin \delta \approx 2 \delta", (), None): (
        ("refuted", None, None, None),
        ({r"\delta": "1"}, "0 1", "0 2"),
    ),
    (r"f = 1 \Rightarrow \dot{f} = 0", (), None): (
        (
            "unchecked",
            "false if the condition holds at one instant only; if it lasts, state its derivatives too",
            None,
            None,
        ),
        None,
    ),
    (r"f^2 = -1 \Leftrightarrow g^2 = -1", (), None): (
        ("unchecked", "nothing satisfies one of its sides", None, None),
        None,
    ),
    ("e^{f} e^{g} = e^{f+g}", (), None): (
        ("proved", None, None, None),
        None,
    ),
    ("e^{f} e^{g} = e^{f g}", (), None): (
        ("refuted", None, None, None),
        ({"f": "1", "g": "1"}, "7.38906", "2.71828"),
    ),
    (r"f = \arccos g", (r"\cos f = g",), None): (
        (
            "conditional",
            "holds on the principal branch, which the text does not state",
            r"0 \leq f \leq \pi",
            None,
        ),
        ({"f": "76"}, "76", r"an angle with 0 \leq f \leq \pi"),
    ),
    (r"a = 0 \Rightarrow \exp(\tilde{a}) = 2 \mathbf{I}", (), None): (
        (
            "unchecked",
            "under the equations something may be 0 at which a sine or an exponential is a limit here",
            None,
            None,
        ),
        None,
    ),
    (r"\|a\| = f", (), None): (
        ("refuted", None, None, None),
        ({"a": "0 0 0", "f": "1"}, "0", "1"),
    ),
    (r"\frac{f}{f - f} = 1", (), None): (
        ("unchecked", "a denominator is identically zero", None, None),
        None,
    ),
    (r"\min_{a \in V_3} \|a\| = g", (), None): (
        ("refuted", "a norm is not negative", None, None),
        ({"a": "0 0 0", "g": "-1"}, "0", "-1"),
    ),
    (r"\max_{a \in V_3} a^2 = 1", (), None): (
        ("refuted", "there it is more than what is said to be the greatest value", None, None),
        ({"a": "0 1 1"}, "2", "1"),
    ),
    (r"\max_{h \in \mathbb{R}} (2 f h - h^2) = g", (), None): (
        ("refuted", "there it is more than what is said to be the greatest value", None, None),
        ({"f": "0", "h": "0", "g": "-1"}, "0", "-1"),
    ),
    (r"\min_{a \in V_3} a \cdot T a = 0", (), None): (
        ("refuted", "there it is less than what is said to be the least value", None, None),
        ({"a": "1 0 0", "T": "-1 0 0 0 0 0 0 0 0"}, "-1", "0"),
    ),
    (r"\min_{a \in V_3} \|a - b\| = g^2", (), None): (
        (
            "refuted",
            "there it is less than what is said to be the least value; the two sides are given as squares",
            None,
            None,
        ),
        ({"a": "0 0 0", "b": "0 0 0", "g": "1"}, "0", "1"),
    ),
    (r"\min_{a \in V_3} (a^2 + 2 a \cdot b) = 0", (), None): (
        ("refuted", "there it is less than what is said to be the least value", None, None),
        ({"a": "1 0 0", "b": "-1 0 0"}, "-1", "0"),
    ),
    (r"\min_{h \in \mathbb{R}} (f h + g) = g", (), None): (
        ("refuted", "there it is less than what is said to be the least value", None, None),
        ({"f": "1", "h": "-1", "g": "0"}, "-1", "0"),
    ),
    (r"\min_{h \in \mathbb{R}} \|f h + 3\| = 0", (), None): (
        ("refuted", "the least value is another one; the two sides are given as squares", None, None),
        ({"f": "0"}, "9", "0"),
    ),
    (r"\min_{a \in V_3} \|a\|^3 = 0", (), None): (
        (
            "unchecked",
            "a minimum or maximum of what is neither a norm of linear terms nor quadratic",
            None,
            None,
        ),
        None,
    ),
    (r"\min_{a \in V_3} a^4 = 0", (), None): (
        (
            "unchecked",
            "a minimum or maximum of what is neither a norm of linear terms nor quadratic",
            None,
            None,
        ),
        None,
    ),
    (r"\min_{a, b, c \in V_3} (a^2 + b^2 + c^2) = 0", (), None): (
        ("unchecked", "a minimum or maximum over more than 6 numbers", None, None),
        None,
    ),
    (r"\max_{a \in V_3} \|a\| = f", (), None): (
        ("unchecked", "a greatest norm", None, None),
        None,
    ),
    (r"\min_{u, f} (f + u \cdot a) = 0", (), None): (
        ("unchecked", "a minimum or maximum over unit vectors and more", None, None),
        None,
    ),
    (r"\min_{u} (u \cdot a)^2 = 0", (), None): (
        ("unchecked", "over unit vectors a minimum or maximum of what is linear in them", None, None),
        None,
    ),
    (r"\min_{u} u \cdot a = -\|a\|", (), None): (
        ("proved", None, None, None),
        None,
    ),
    (r"\min_{u} u \cdot a = \|a\|", (), None): (
        ("refuted", None, None, None),
        ({"a": "1 0 0"}, "-1", "1"),
    ),
    (r"\min_{a \in V_3} (a + b)^2 = 0", (), None): (
        ("proved", None, None, None),
        None,
    ),
    (r"\max_{a \in V_3} (1 - (a + b)^2) = 1", (), None): (
        ("proved", None, None, None),
        None,
    ),
    (r"\max_{a \in V_3} (1 - (a + b)^2) = 2", (), None): (
        ("refuted", "the greatest value is another one", None, None),
        ({"b": "0 0 0"}, "1", "2"),
    ),
}


@pytest.mark.parametrize("case", TOLD, ids=lambda case: case[0])
def test_what_is_told(case):
    (latex, premises, hypothesis), (said, example) = case, TOLD[case]
    (claim,), assume = read(latex, TABLE), [read(premise, TABLE)[0] for premise in premises]
    under = None if hypothesis is None else read(hypothesis, TABLE)[0]
    found = Judge(Definitions()).judge(claim, assume, under)
    assert (found.outcome, found.reason, found.hypothesis, found.scope) == said
    assert found.read_back == to_latex(claim)
    point = found.counterexample
    shown = point and (
        {key: " ".join(x) for key, x in point.values.items()},
        " ".join(point.left),
        " ".join(point.right),
    )
    assert shown == example
