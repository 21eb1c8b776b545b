"""The judge against values: definitions with shifted indices, and identities transformed and mutated.

The evaluator shares nothing with the judge (see `tests/evaluator`): what is proved must hold at random points, and
what is refuted must fail at one.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from random import Random

import pytest
from evaluator.series import NotRead
from evaluator.values import World

from workbench.judge.kernel.judge import Judge
from workbench.judge.subject.assumptions import Unsatisfiable
from workbench.judge.subject.inventory import NotExact
from workbench.judge.verdict import Outcome
from workbench.language.construct import apply, derivative, number, rebuild, relation, symbol
from workbench.language.defining import read_definitions
from workbench.language.definitions import Definitions
from workbench.language.instances import instantiate
from workbench.language.names import Name
from workbench.language.reader import read
from workbench.language.symbols import SymbolTable
from workbench.language.terms import Apply, IllFormed, Number, Relation, Symbol, Term, Zero
from workbench.papers.orders import Orders

TABLE = replace(
    SymbolTable.build(
        {
            **{name: {"kind": "vector"} for name in ("a", "b", "x", "a_n")},
            **{name: {"kind": "scalar"} for name in ("f", "g", "s_n", "k_{m,n}", r"\alpha")},
            **{name: {"kind": "tensor"} for name in ("T", "S")},
            "R": {"kind": "rotation"},
            "u": {"kind": "vector", "unit": True},
            "c": {"kind": "vector", "constant": True},
            r"\underline{a}": {"kind": "dual vector"},
            r"\underline{b}": {"kind": "dual vector"},
            **{name: {"kind": "hamilton quaternion"} for name in ("p", "q", "r")},
            r"\underline{q}": {"kind": "dual hamilton quaternion"},
            "e": {"kind": "hamilton quaternion", "unit": True},
            r"\underline{e}": {"kind": "dual hamilton quaternion", "unit": True},
            **{name: {"kind": "transform"} for name in ("G", "H")},
            "J": {"kind": "tensor", "symmetric": True},
            "L": {"kind": "tensor", "diagonal": True},
            "M": {"kind": "matrix 6×6"},
            "N": {"kind": "matrix 2×4"},
            **{name: {"kind": "matrix 6×1"} for name in ("V", "W")},
            **{name: {"kind": "scalar"} for name in ("y", "z", r"\theta")},
            "w": {"kind": "vector"},
            r"\omega": {"kind": "scalar", "constant": True},
            "A": {"kind": "scalar", "of": ["y", "z"]},
            "B": {"kind": "vector", "of": ["y", r"\theta"]},
            "C": {"kind": "scalar", "of": ["w", "t"]},
            "D": {"kind": "vector", "of": ["w"]},
        }
    ),
    gradient="row",
)

IDENTITIES = r"""
a \times b = -b \times a
a \times (b \times x) = (a \cdot x) b - (a \cdot b) x
\tilde{a} b = a \times b
\tilde{a}^2 = a \otimes a - a^2 \mathbf{I}
(T S)^T = S^T T^T
\operatorname{trace}(T S) = \operatorname{trace}(S T)
\det(T S) = \det T \det S
T T^* = (\det T) \mathbf{I}
T^* T = (\det T) \mathbf{I}
R^T R = \mathbf{I}
R (a \times b) = (R a) \times (R b)
R \tilde{a} R^T = \widetilde{R a}
\operatorname{vect} T \times a = \operatorname{skew} T a
\operatorname{vect}(a \otimes b) = -\frac{1}{2} a \times b
\operatorname{sym} T + \operatorname{skew} T = T
\operatorname{trace} \tilde{a} = 0 f
(a, b, x) = (b, x, a)
(a, b, x) = a \cdot (b \times x)
(a \times b)^2 = a^2 b^2 - (a \cdot b)^2
u^2 = 1
u \cdot \dot{u} = 0 f
\frac{d}{dt}(a \cdot b) = \dot{a} \cdot b + a \cdot \dot{b}
\frac{d}{dt}(T a) = \dot{T} a + T \dot{a}
\frac{d}{dt}(T S) = \dot{T} S + T \dot{S}
\frac{d^2}{dt^2}(f a) = \ddot{f} a + 2 \dot{f} \dot{a} + f \ddot{a}
\dot{R} R^T = -R \dot{R}^T
\sin^2 \alpha + \cos^2 \alpha = 1
\frac{d}{dt} \sin \alpha = \dot{\alpha} \cos \alpha
\frac{f + g}{f} = 1 + \frac{g}{f}
\frac{d}{dt} \frac{f}{g} = \frac{\dot{f} g - f \dot{g}}{g^2}
f^3 - g^3 = (f - g)(f^2 + f g + g^2)
\tilde{a} T + T^T \tilde{a} + \tilde{a}^T \mathbf{I} = \tilde{a} T + T^T \tilde{a} - \tilde{a}
\operatorname{Du}(\underline{a} \cdot \underline{b}) = \operatorname{Re} \underline{a} \cdot \operatorname{Du} \underline{b} + \operatorname{Du} \underline{a} \cdot \operatorname{Re} \underline{b}
\underline{a} \times \underline{b} = -\underline{b} \times \underline{a}
(a \otimes b) T = a \otimes (T^T b)
\dot{c} = 0 c
\sin \alpha = 2 \sin \frac{\alpha}{2} \cos \frac{\alpha}{2}
\cos \frac{\alpha}{3} = 4 \cos^3 \frac{\alpha}{9} - 3 \cos \frac{\alpha}{9}
\frac{d}{dt} \sin \frac{\alpha}{2} = \frac{1}{2} \dot{\alpha} \cos \frac{\alpha}{2}
\tan \alpha \cos \alpha = \sin \alpha
\frac{1}{\cos^2 \alpha} = 1 + \tan^2 \alpha
\|q\| = \sqrt{(\operatorname{Sc} q)^2 + \operatorname{Vec} q \cdot \operatorname{Vec} q}
\frac{d}{dt} (\sqrt{f^2 + g^2}) \sqrt{f^2 + g^2} = f \dot{f} + g \dot{g}
(p q) r = p (q r)
(p + q) r = p r + q r
(p q)^* = q^* p^*
(p q)^{-1} = q^{-1} p^{-1}
q q^* = \|q\|^2
\|p q\|^2 = \|p\|^2 \|q\|^2
\operatorname{quat}(f, a) \operatorname{quat}(g, b) = \operatorname{quat}(f g - a \cdot b, f b + g a + a \times b)
q = \begin{bmatrix} \operatorname{Sc} q \\ \operatorname{Vec} q \end{bmatrix}
\operatorname{Sc} (p q) = \operatorname{Sc} (q p)
\operatorname{Vec} (q a q^*) \cdot \operatorname{Vec} (q b q^*) = \|q\|^4 (a \cdot b)
\frac{d}{dt}(p q) = \dot{p} q + p \dot{q}
e^* = e^{-1}
\operatorname{Sc} (\dot{e} e^*) = 0 f
\dot{e} e^* = -e (\dot{e})^*
\operatorname{Vec} (e a e^*) \times \operatorname{Vec} (e b e^*) = \operatorname{Vec} (e (a \times b) e^*)
\underline{e} \, \underline{e}^* = 1
(\underline{q} p)^* = p^* \underline{q}^*
p^3 = p p^2
J^T = J
L^T = L
\dot{J} = \dot{J}^T
a \cdot (J b) = b \cdot (J a)
\operatorname{trace} (J \tilde{a}) = 0 f
\det H = 1
H^{-1} \dot{H} + \frac{d}{dt} (H^{-1}) H = 0 H
M V \cdot W = V \cdot (M^T W)
N^T = (\mathbf{I} N)^T
\frac{d}{dt} (M V) = \dot{M} V + M \dot{V}
\operatorname{trace} (V W^T) = V \cdot W
V^2 W = (V \cdot V) W
\begin{bmatrix} \cos \alpha & -\sin \alpha \\ \sin \alpha & \cos \alpha \end{bmatrix} \begin{bmatrix} \cos \alpha & \sin \alpha \\ -\sin \alpha & \cos \alpha \end{bmatrix} = \begin{bmatrix} 1 & 0 \\ 0 & 1 \end{bmatrix}
\begin{bmatrix} 0 & -f & g \\ f & 0 & -s_1 \\ -g & s_1 & 0 \end{bmatrix} a = \begin{bmatrix} s_1 \\ g \\ f \end{bmatrix} \times a
\begin{bmatrix} f & g \\ s_1 & s_2 \end{bmatrix} \begin{bmatrix} a \\ b \end{bmatrix} = \begin{bmatrix} f a + g b \\ s_1 a + s_2 b \end{bmatrix}
\det \begin{bmatrix} f & g \\ s_1 & s_2 \end{bmatrix} = f s_2 - g s_1
\dot{A} = \frac{\partial A}{\partial y} \dot{y} + \frac{\partial A}{\partial z} \dot{z}
\dot{C} = \frac{\partial C}{\partial w} \dot{w} + \frac{\partial C}{\partial t}
\dot{D} = \frac{\partial D}{\partial w} \dot{w}
\frac{\partial \dot{A}}{\partial y} = \frac{d}{dt} \frac{\partial A}{\partial y}
\frac{\partial \dot{B}}{\partial \dot{y}} = \frac{\partial B}{\partial y}
\frac{d}{dt} \frac{\partial \dot{A}}{\partial \dot{z}} = \frac{\partial \dot{A}}{\partial z}
\frac{\partial \ddot{B}}{\partial \dot{y}} = 2 \frac{\partial \dot{B}}{\partial y}
\frac{\partial (A \sin \theta)}{\partial \theta} = A \cos \theta
\frac{\partial (B \cos \theta)}{\partial \theta} = \frac{\partial B}{\partial \theta} \cos \theta - B \sin \theta
\frac{\partial}{\partial \theta} \sin \frac{\theta}{2} = \frac{1}{2} \cos \frac{\theta}{2}
\frac{\partial (C D)}{\partial w} = D \frac{\partial C}{\partial w} + C \frac{\partial D}{\partial w}
\frac{\partial (w \cdot w)}{\partial w} = 2 w^T
\frac{\partial (w \times D)}{\partial w} = \tilde{w} \frac{\partial D}{\partial w} - \tilde{D}
\frac{\partial \|w\|}{\partial w} \|w\| = w^T
\frac{d}{dt} (t a) = a + t \dot{a}
\frac{d}{dt} \sin(\omega t + \alpha) = (\omega + \dot{\alpha}) \cos(\omega t + \alpha)
\cos(f g + \alpha) = \cos(f g) \cos \alpha - \sin(f g) \sin \alpha
\sin(f g) = 2 \sin \frac{f g}{2} \cos \frac{f g}{2}
\frac{\partial}{\partial y} \cos(\omega y) = -\omega \sin(\omega y)
\frac{\partial}{\partial y} \sin A = \frac{\partial A}{\partial y} \cos A
\exp(\tilde{a}) a = a
\exp(\tilde{a}) (\exp(\tilde{a}))^T = \mathbf{I}
\exp(\alpha \tilde{u}) = \mathbf{I} + \sin \alpha \tilde{u} + (1 - \cos \alpha) \tilde{u}^2
\exp(\tilde{a}) \exp(2 \tilde{a}) = \exp(3 \tilde{a})
\det \exp(\tilde{a}) = 1
\exp(\tilde{a}) \tilde{b} (\exp(\tilde{a}))^T = \widetilde{\exp(\tilde{a}) b}
\|a\|^2 \exp(\tilde{a}) = a^2 \mathbf{I} + \|a\| \sin(\|a\|) \tilde{a} + (1 - \cos(\|a\|)) \tilde{a}^2
\exp(\alpha \operatorname{quat}(0, u)) = \cos \alpha + u \sin \alpha
\|\exp(\operatorname{quat}(0, a))\| = 1
\exp(\operatorname{quat}(0, \frac{a}{2})) b (\exp(\operatorname{quat}(0, \frac{a}{2})))^* = \operatorname{quat}(0, \exp(\tilde{a}) b)
(\exp(\operatorname{quat}(0, a)))^* = \exp(-\operatorname{quat}(0, a))
\frac{d}{dt} \exp(\alpha \tilde{u}) = \dot{\alpha} \tilde{u} \exp(\alpha \tilde{u}) + \sin \alpha \tilde{\dot{u}} + (1 - \cos \alpha) (\tilde{\dot{u}} \tilde{u} + \tilde{u} \tilde{\dot{u}})
\begin{bmatrix} J & \tilde{a} \\ -\tilde{a} & L \end{bmatrix}^T = \begin{bmatrix} J & \tilde{a} \\ -\tilde{a} & L \end{bmatrix}
""".strip().splitlines()  # fmt: skip


def worlds(definitions: Definitions, count: int = 3) -> list[World]:
    return [World(definitions, seed, length=12 if len(definitions) else 7) for seed in range(count)]


def agrees(judge: Judge, statement, orders: Orders | None = None) -> str:
    """The outcome, or "unchecked" for what the judge leaves; fails where values contradict it."""
    try:
        verdict = judge.judge(statement, orders=orders)
    except (IllFormed, NotExact, Unsatisfiable):
        return "unchecked"
    instances = list(orders.assignments()) if orders else [{}]
    try:
        values = [world.holds(statement, n) for world in worlds(judge.definitions) for n in instances]
    except NotRead:
        return "not evaluated"
    wrong = {
        Outcome.PROVED: False in values or not any(values),
        Outcome.DEFINITION: False in values,
        Outcome.CONDITIONAL: False in values,
        Outcome.REFUTED: False not in values,
    }
    assert not wrong.get(verdict.outcome, False), f"{verdict.outcome}: {verdict.read_back}: {values}"
    return str(verdict.outcome)


# definitions


def random_definitions(random: Random) -> dict[str, str]:
    """Definitions of s_n and a_n, each with some base members, a shift, and perhaps a recurrence."""
    entries = {}
    for family, bodies, bases in (
        ("s", ("f s_{n}", "s_{n} + g", "g", "n f", "f^n", r"\dot{s}_{n}"), ("2", "f", "g + 1")),
        ("a", (r"b \times a_{n}", r"\dot{a}_{n} + f a_{n}", "x^{(n)}", "n x", "T a_{n}"), ("b", "x", "f b")),
    ):
        shift = random.randrange(1, 3)
        for k in random.sample(range(5), random.randrange(0, 3)):
            entries[f"{family}_{k}"] = random.choice(bases)
        entries[f"{family}_{{n+{shift}}}"] = random.choice(bodies)
    return entries


CLAIMS = (
    "s_n f = f", r"s_{n+1} + g = f s_n + g", r"\dot{a}_n = a_{n+1}", "a_{n+1} = x^{(n)}", "s_n = n f",
    r"a_{n+1} + b = b \times a_n + b", r"a_n \cdot b = 0", r"s_{n+1} - s_n = g", r"f a_{n+2} = f T a_{n+1}",
    r"\sum_{k=0}^{n} s_k = s_{n+1} f", r"\frac{s_n}{s_n} f = f", r"s_{n+1} f^n = s_1 f^{2 n}", "s_{n+2} = s_{n+1} f",
)  # fmt: skip


def check_definitions(random: Random) -> str:
    entries = random_definitions(random)
    definitions, table = read_definitions(entries, TABLE)
    first = random.randrange(0, 3)
    orders = Orders.parse(f"n = {first}..{first + 2}")
    said = random.choice([(key, body) for key, body in entries.items() if "n+" in key])
    own = rf"f {said[0]} = f \cdot ({said[1]})", rf"\frac{{d}}{{dt}} {said[0]} = \frac{{d}}{{dt}} ({said[1]})"
    (statement,) = read(random.choice((*CLAIMS, *own * 6)), table, ["n"])
    judge = Judge(definitions)
    found = agrees(judge, statement, orders)
    verdict = None if found == "unchecked" else judge.judge(statement, orders=orders)
    if verdict is not None and (verdict.scope or "").startswith("all n"):
        least = int(verdict.scope.partition("≥")[2] or 0)
        for n in range(least, least + 6):  # all of them, not those of the range alone
            for world in worlds(definitions, 1):
                try:
                    holds = world.holds(statement, {"n": n})
                except NotRead:
                    continue
                assert holds is not False, f"{verdict.read_back} for n = {n}: {list(definitions)}"
    return found


# identities


def replaced(term: Term, old: Term, new: Term) -> Term:
    if term == old:
        return new
    children = tuple(replaced(child, old, new) for child in term.children)
    return term if children == term.children else rebuild(term, children)


def parts(term: Term) -> list[Term]:
    return list(dict.fromkeys(term.walk()))


def transformed(random: Random, claim: Relation) -> Relation:
    """Another identity that follows from this one."""
    left, right = claim.left, claim.right

    def substituted() -> Relation:
        free = [s for s in parts(left) if isinstance(s, Symbol) and not _bound(s)]
        old = random.choice(free or [left])
        new = _like(random, old)
        return relation("=", *(replaced(side, old, new) for side in (left, right)))

    def scaled() -> Relation:
        f = symbol(TABLE.symbols[Name(random.choice("fg"))])
        return relation("=", apply("mul", f, left), apply("mul", f, right))

    def differentiated() -> Relation:
        return relation("=", derivative(left, 1), derivative(right, 1))

    def added() -> Relation:
        more = _like(random, left)
        return relation("=", apply("add", left, more), apply("add", more, right))

    return random.choice((substituted, substituted, scaled, differentiated, added))()


def _bound(s: Symbol) -> bool:
    declaration = s.declaration
    is_formed = declaration.rotation or declaration.transform or declaration.symmetric or declaration.diagonal
    is_tied = declaration.independent or declaration.of or declaration.clock
    return (
        is_formed
        or is_tied
        or declaration.unit
        or declaration.constant
        or declaration.name == Name(r"\alpha")
    )


def _like(random: Random, term: Term) -> Term:
    def sym(name: str) -> Term:
        return symbol(TABLE.symbols[Name(name)])

    choices: dict[str, list[Callable[[], Term]]] = {
        "scalar": [lambda: apply("mul", sym("f"), sym("g")), lambda: apply("dot", sym("a"), sym("x"))],
        "vector": [lambda: apply("cross", sym("x"), sym("b")), lambda: apply("mul", sym("S"), sym("x"))],
        "quaternion": [lambda: apply("mul", sym("r"), sym("p")), lambda: apply("conjugate", sym("q"))],
        "tensor": [lambda: apply("mul", sym("S"), sym("T")), lambda: apply("skew", sym("x"))],
    }
    return random.choice(choices.get(term.type.kind, [lambda: term]))()


def mutated(random: Random, claim: Relation) -> Relation:
    """The claim with one thing changed in it; most often it is false then."""
    old = random.choice(parts(claim.right))
    ways: list[Callable[[], Term]] = [lambda: apply("mul", number(2), old), lambda: apply("neg", old)]
    if isinstance(old, Apply) and old.head in ("mul", "cross", "dot", "add", "outer"):
        ways += [lambda: rebuild(old, tuple(reversed(old.children)))] * 3
    if isinstance(old, Apply) and old.head in ("conjugate", "inverse", "transpose"):
        ways += [lambda: old.arguments[0]] * 3
    if isinstance(old, Apply) and old.head == "add":
        ways.append(lambda: old.arguments[0])
    if isinstance(old, Symbol):
        alike = [symbol(d) for d in TABLE.symbols.values() if d.type == old.type and not d.indices]
        ways += [lambda: random.choice(alike)] * 3
    if isinstance(old, Number):
        ways.append(lambda: number(old.value + 1))
    new = random.choice(ways)()
    return relation("=", claim.left, replaced(claim.right, old, new))


def check_identity(random: Random, judge: Judge) -> str:
    text = random.choice(IDENTITIES)
    (claim,) = read(text, TABLE)
    try:
        for _ in range(0 if r"\exp(\tilde" in text or r"\exp(\op" in text else random.randrange(0, 3)):
            claim = transformed(random, claim)
        if random.random() < 0.6:
            claim = mutated(random, claim)
        claim = instantiate(claim, {})
    except IllFormed:
        return "ill-formed"
    if claim.left == claim.right or isinstance(claim.left, Zero):
        return "same"
    return agrees(judge, claim)


def campaign(count: int, seed: int, one: Callable[[Random], str]) -> Counter[str]:
    found: Counter[str] = Counter()
    for k in range(count):
        found[one(Random(f"{seed}/{k}"))] += 1
    return found


def test_definitions_by_values():
    found = campaign(30, 1, check_definitions)
    assert found["refuted"] > 10 and found["proved"] + found["conditional"] + found["definition"] >= 3, found


def test_identities_by_values():
    judge = Judge(Definitions())
    found = campaign(40, 2, lambda random: check_identity(random, judge))
    assert found["refuted"] > 10 and found["proved"] > 10, found


@pytest.mark.slow
def test_many_definitions_by_values():
    print(campaign(1500, 3, check_definitions))


@pytest.mark.slow
def test_many_identities_by_values():
    judge = Judge(Definitions())
    found = campaign(6000, 4, lambda random: check_identity(random, judge))
    print(found)
    assert found["unchecked"] < 0.1 * found.total(), found
