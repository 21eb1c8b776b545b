"""The two engines against each other and against the rules of calculus, on random terms of every kind."""

from fractions import Fraction
from random import Random

import numpy as np
import pytest
from judge.random_terms import random_term

from workbench import check
from workbench.core.construct import apply, derivative, relation
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import take_inventory
from workbench.engines.inventory.parameters import parameters
from workbench.engines.jet.components import Value, beside
from workbench.engines.jet.jets import JetEngine
from workbench.engines.jet.rings import PointSource, RationalRing, ResidueRing, sample
from workbench.engines.jet.sympy_ring import SympyRing
from workbench.engines.polynomial.polynomial_engine import ExactEngine
from workbench.language.definition_entries import read_definitions
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read
from workbench.prover.decide.decide import Judge

FREE = Definitions()
KINDS = ("scalar", "vector", "tensor", "operator")


def engines_at_a_point(terms, seed):
    inventory = take_inventory(terms, FREE)
    ring = RationalRing((-2, -1, 1, 2, 3))
    point = sample(inventory, ring, Random(seed), lambda _: True)
    return ExactEngine(inventory, FREE), JetEngine(PointSource(ring, point), FREE), point


def value_at(engine, term, point):
    """The exact engine's polynomials at a point, its reciprocals divided out."""
    parts = engine.parts(engine.value(term))
    names = {q: n for q, n in engine._named.items()}
    values = {names[q]: v for q, v in point.items() if q in names}
    for name, denominator in engine.ring._reciprocals:
        below = engine.ring.at(denominator, values)
        if below == 0:
            raise ZeroDivisionError
        values[name] = 1 / below
    return [engine.ring.at(p, values) for p in parts]


@pytest.mark.parametrize("dual", [False, True])
@pytest.mark.parametrize("kind", KINDS)
def test_both_engines_give_the_same_value(kind, dual):
    compared = 0
    for seed in range(60):
        term = random_term(Random(f"{kind}{dual}{seed}"), kind, depth=2, dual=dual)
        exact, jets, point = engines_at_a_point([term], seed)
        try:
            expected = jets.components(term)
            got = value_at(exact, term, point)
        except (ZeroDivisionError, NotExact):
            continue
        got_real, expected_real = got, expected
        if len(got) != len(expected):  # one engine knows that a dual part is zero, the other carries it
            shorter, longer = sorted((got, expected), key=len)
            got_real, expected_real = longer[: len(shorter)], shorter
            if kind != "operator":
                assert not any(longer[len(shorter) :])
        assert got_real == expected_real, f"seed {seed}"
        compared += 1
    assert compared >= 30


#: What a symbol can be declared as.
SPECS = [
    *(
        {"kind": f"{dual}{kind}"}
        for kind in ("scalar", "vector", "tensor", "rotation")
        for dual in ("", "dual ")
    ),
    *({"kind": kind} for kind in ("transform", "hamilton quaternion", "matrix 2x3", "matrix 6x1")),
    *({"kind": kind, "unit": True} for kind in ("vector", "dual vector")),
    *({"kind": f"{dual}hamilton quaternion", "unit": True} for dual in ("", "dual ")),
    {"kind": "tensor", "symmetric": True},
    *({"kind": kind, "constant": True} for kind in ("scalar", "vector", "rotation", "transform")),
]


@pytest.mark.parametrize("spec", SPECS, ids=lambda spec: " ".join(map(str, spec.values())))
def test_both_engines_give_the_same_value_of_a_free_symbol(spec):
    (statement,) = read("x = x", SymbolTable().with_specs({"x": spec}))
    for order in range(4):
        term = derivative(statement.left, order)
        exact, jets, point = engines_at_a_point([term], order)
        assert value_at(exact, term, point) == jets.components(term)


def test_a_free_angle_has_a_circle_of_its_own_whatever_its_value():
    table = SymbolTable().with_specs({"x": {"kind": "scalar"}, "a": {"kind": "vector"}})
    (statement,) = read(r"x \cos x = \cos \|a\|", table)
    x, one = statement.left.arguments[0], (Fraction(5, 13), Fraction(12, 13))
    inventory = take_inventory([statement.left, statement.right], FREE)
    point = sample(inventory, RationalRing(), Random(1), lambda _: True)
    for parameter in point:
        if parameter.part == "circle":
            own = (Fraction(3, 5), Fraction(4, 5)) if parameter.symbol == x else one
            point[parameter] = own[parameter.component]
        else:  # ‖a‖ = x = 1
            point[parameter] = Fraction(parameter.component == 0)
    jets = JetEngine(PointSource(RationalRing(), point), FREE)
    assert jets.components(statement.left) == [Fraction(3, 5)] and jets.components(statement.right) == [
        one[0]
    ]


def test_the_dual_part_of_a_real_quantity_is_zero_at_zero_too():
    (statement,) = read(r"\operatorname{Du} x = 0", SymbolTable().with_specs({"x": {"kind": "scalar"}}))
    for value in (0, 3):
        point = {p: Fraction(value) for p in parameters(take_inventory([statement.left], FREE))}
        assert JetEngine(PointSource(RationalRing(), point), FREE).components(statement.left) == [0]


class Fractions(RationalRing):
    """The rationals without Python's integers."""

    def constant(self, numerator, denominator):
        return Fraction(numerator, denominator)

    def divide(self, a, b):
        return Fraction(a) / Fraction(b)

    def random(self, random):
        return Fraction(super().random(random))


@pytest.mark.parametrize("dual", [False, True])
@pytest.mark.parametrize("kind", KINDS)
def test_whole_numbers_stay_python_s_however_large(kind, dual):
    """NumPy's own integers would overflow unseen."""
    compared, largest = 0, 0
    for seed in range(30):
        term = random_term(Random(f"whole{kind}{dual}{seed}"), kind, depth=2, dual=dual)
        term = term if kind == "operator" else derivative(term, 1)
        inventory, found = take_inventory([term], FREE), []
        for ring in (RationalRing((-(10**11), 1, 10**11 + 1)), Fractions((-(10**11), 1, 10**11 + 1))):
            point = sample(inventory, ring, Random(seed), lambda _: True)
            try:
                found.append(JetEngine(PointSource(ring, point), FREE).components(term))
            except (ZeroDivisionError, NotExact):
                continue
        if len(found) == 2:
            assert found[0] == found[1] and {type(x) for x in found[0]} <= {int, Fraction}
            compared, largest = compared + 1, max(largest, *map(abs, found[0]))
    assert compared >= 10 and largest > 2**64


def test_whole_slopes_stay_python_s_however_large():
    table = SymbolTable().with_specs({"q": {"kind": "scalar"}, "f": {"kind": "scalar", "of": ["q"]}})
    (statement,) = read(r"\frac{d^2}{dt^2} \frac{\partial f}{\partial q} = 0", table)
    square = apply("mul", statement.left, statement.left)
    inventory, found = take_inventory([square], FREE), []
    for ring in (RationalRing((10**4, 10**4 + 1)), Fractions((10**4, 10**4 + 1))):
        point = sample(inventory, ring, Random(1), lambda _: True)
        found += JetEngine(PointSource(ring, point), FREE).components(square)
    assert found[0] == found[1] and found[0] > 2**64


@pytest.mark.parametrize("kind", ("scalar", "vector", "tensor"))
def test_leibniz_rule_in_both_engines(kind):
    products = {"scalar": ("mul", "scalar", "scalar"), "vector": ("cross", "vector", "vector")}
    head, left, right = products.get(kind, ("mul", "tensor", "tensor"))
    for seed in range(25):
        random = Random(f"leibniz{kind}{seed}")
        a, b = random_term(random, left, 1), random_term(random, right, 1)
        rule = relation(
            "=",
            derivative(apply(head, a, b), 1),
            apply("add", apply(head, derivative(a, 1), b), apply(head, a, derivative(b, 1))),
        )
        exact, jets, _ = engines_at_a_point([rule.left, rule.right], seed)
        try:
            assert all(p == 0 for p in exact.residuals(rule))
            assert not any(jets.differences(rule.left, rule.right))
        except ZeroDivisionError:
            continue


@pytest.mark.parametrize("dual", [False, True])
def test_sympy_ring_agrees_with_the_rationals(dual):
    for seed in range(25):
        term = random_term(Random(f"sympy{dual}{seed}"), "vector", depth=2, dual=dual)
        inventory = take_inventory([term], FREE)
        ring = SympyRing(inventory)
        try:
            symbolic = JetEngine(PointSource(ring, ring.point), FREE).components(term)
            rational = RationalRing((-2, -1, 1, 2, 3))
            point = sample(inventory, rational, Random(seed), lambda _: True)
            expected = JetEngine(PointSource(rational, point), FREE).components(term)
        except (ZeroDivisionError, NotExact):
            continue
        values = {str(spread(ring, ring.point[p].top)): v for p, v in point.items()}
        assert [_at(x, values) for x in symbolic] == expected


def spread(ring, p):
    return ring.polynomials.spread(p, ring.polynomials.many)


def _at(ratio, values):
    if isinstance(ratio, int):
        return ratio

    def evaluate(p):
        p = spread(ratio.ring, p)
        names = [str(g) for g in p.ring.gens]
        total = Fraction(0)
        for exponents, coefficient in p.terms():
            term = Fraction(int(coefficient.numerator), int(coefficient.denominator))
            for name, exponent in zip(names, exponents, strict=True):
                term *= values.get(name, Fraction(0)) ** exponent if exponent else 1
            total += term
        return total

    below = Fraction(1)
    for place, exponent in ratio.below.items():
        below *= evaluate(ratio.ring.denominators[place]) ** exponent
    return evaluate(ratio.top) / ratio.number / below


def test_the_normal_form_is_the_remainder_by_the_relations():
    """As SymPy divides, which is slower: spheres of all kinds, and roots of what holds other roots."""
    reduced = 0
    for seed in range(16):
        random = Random(f"normal{seed}")
        inventory = take_inventory([random_term(random, "tensor", 2, dual=True) for _ in range(3)], FREE)
        ring = SympyRing(inventory)
        a, b = random.sample(list(ring.point.values()), 2)
        ring.root(ring.root(a * a + 2) * 3 + b * b * Fraction(1, 2) + 1)
        relations = [spread(ring, p) for p in ring.relations]
        places = range(len(ring.polynomials.generators))
        squared = [i for i in places if any(r.degree(places[-1 - i]) > 0 for r in relations)]
        generators = ring.polynomials.generators
        for _ in range(8):
            p = ring.polynomials.integers.one
            for i in random.choices(squared, k=4):
                power = generators[i] ** random.randint(1, 3)
                p = p * (power * random.choice(generators) + random.randint(-2, 2))
            normal = ring.normal(p)
            assert spread(ring, normal) == spread(ring, p).rem(relations)
            reduced += normal != p
    assert reduced > 40


def test_residue_ring_is_a_field():
    ring, random = ResidueRing(), Random(5)
    for _ in range(200):
        a, b, c = (ring.random(random) for _ in range(3))
        assert (a + b) * c == a * c + b * c
        assert ring.divide(a, b) * b == a
        assert a - a == 0 and a * b == b * a


def test_points_lie_on_their_spheres():
    terms = [random_term(Random(f"sphere{i}"), "tensor", 2, dual=True) for i in range(20)]
    inventory = take_inventory(terms, FREE)
    for ring in (ResidueRing(), RationalRing((-2, -1, 0, 1, 2))):
        point = sample(inventory, ring, Random(3), lambda _: True)
        squares = {}
        for parameter, value in point.items():
            if parameter.part in ("unit", "quaternion", "circle"):
                key = (parameter.symbol, parameter.part)
                squares[key] = squares.get(key, ring.constant(0, 1)) + value * value
        assert squares and all(total == 1 for total in squares.values())


@pytest.mark.parametrize(
    ("latex", "outcome"),
    [
        ("P x = T x", "proved"),
        ("P P x = T^2 x", "proved"),
        (r"P (x + \dot{x}) - T \dot{x} = T x", "proved"),
        (r"\mathbf{D} (P x) = \dot{T} x + P \dot{x}", "proved"),
        (r"P x = \dot{T} x", "refuted"),
    ],
)
def test_a_tensor_is_an_operator_of_degree_0(latex, outcome):
    """Where an operator is defined by it, too."""
    kinds = SymbolTable.build({"T": {"kind": "tensor"}, "x": {"kind": "vector"}, "P": {"kind": "operator"}})
    definitions, table = read_definitions({"P": "T"}, kinds)
    (said,) = read(latex, table)
    assert Judge(definitions).judge(said).outcome == outcome


BLOCKS = [
    r"\begin{bmatrix} f & g \\ h & k \end{bmatrix}",
    r"\begin{bmatrix} f & 0 \\ g & k \end{bmatrix}",
    r"\begin{bmatrix} f & \underline{g} \\ 0 & k \end{bmatrix}",
    r"\begin{bmatrix} \underline{g} & 0 \\ f & k \end{bmatrix}",
    r"\begin{bmatrix} f & 0 & 0 & 0 \\ h & g & 0 & 0 \\ 0 & f & h & 0 \\ g & 0 & f & k \end{bmatrix}",
    r"\begin{bmatrix} T & x \\ 0 & f \end{bmatrix}",
]


@pytest.mark.parametrize("block", BLOCKS)
def test_the_inverse_of_a_matrix_of_entries(block):
    kinds = {"T": "tensor", "x": "vector", r"\underline{g}": "dual scalar", **dict.fromkeys("fghk", "scalar")}
    table = SymbolTable.build({name: {"kind": kind} for name, kind in kinds.items()})
    for product in (rf"{block}^{{-1}} {block}", rf"{block} {block}^{{-1}}"):
        for unit, outcome in ((r"\mathbf{I}", "conditional"), (r"2 \mathbf{I}", "refuted")):
            (said,) = read(f"{product} = {unit}", table)
            assert Judge(Definitions()).judge(said).outcome == outcome


def test_the_inverse_of_a_block_matrix_can_be_multiplied():
    block = r"\begin{bmatrix} \mathbf{R} & x \\ \mathbf{0} & 1 \end{bmatrix}"
    symbols = {"\\mathbf{R}": "rotation", "x": "vector"}
    assert check(rf"{block}^{{-1}} {block} = \mathbf{{I}}", symbols).outcome == "proved"
    assert check(rf"{block} {block}^{{-1}} = {block}", symbols).outcome == "refuted"


@pytest.mark.parametrize("equations", [("f = 1", "(f - 1) g = 0"), ("(f - 1) g = 0", "f = 1")])
def test_an_equation_that_another_makes_trivial_divides_nothing(equations):
    table = SymbolTable.build({letter: {"kind": "scalar"} for letter in "fg"})
    said, *given = (statement for latex in ("f g = g", *equations) for statement in read(latex, table))
    assert Judge(Definitions()).judge(said, given).outcome == "proved"


PLACE = SymbolTable.build(
    {"r": {"kind": "vector", "coordinate": True}}
    | {"T": {"kind": "tensor", "uniform": True}, "w": {"kind": "scalar", "constant": True}}
)


@pytest.mark.parametrize(
    ("latex", "count"),
    [
        (r"\operatorname{div}(T r) = \operatorname{trace} T", 1),
        (r"\operatorname{curl}(T r) = 2 \operatorname{vect} T", 3),
        (r"\operatorname{div}((T r) \times r) = 2 r \cdot \operatorname{vect} T", 1),
        (r"\cos(2 w t) = 1 - 2 \sin^2(w t)", 1),
        (r"\sin(3 w t) = 3 \sin(w t) - 4 \sin^3(w t)", 1),
        (r"\frac{d}{dt} \cos(2 w t) = -4 w \sin(w t) \cos(w t)", 1),
    ],
)
def test_the_second_engine_alone(latex, count):
    """Fields and angles, which it computes in ways of its own."""
    (claim,) = read(latex, PLACE)
    inventory = take_inventory([claim.left, claim.right], FREE)
    ring = ResidueRing()
    engine = JetEngine(PointSource(ring, sample(inventory, ring, Random(7), lambda _: True)), FREE)
    assert len(engine.components(claim.left)) == len(engine.components(claim.right)) == count
    assert not any(engine.differences(claim.left, claim.right))
    assert any(engine.differences(claim.left, apply("mul", claim.right, read("w = 2", PLACE)[0].right)))


def test_columns_stand_beside_each_other_in_both_parts():
    columns = [Value([np.array([i, i + 1, i + 2])], [np.array([10 * i, 0, i])]) for i in (1, 4)]
    together = beside(columns)
    assert together.re[0].tolist() == [[1, 4], [2, 5], [3, 6]]
    assert together.du[0].tolist() == [[10, 40], [0, 0], [1, 4]]
