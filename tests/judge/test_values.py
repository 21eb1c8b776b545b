"""The judge against values: definitions with shifted indices, and identities transformed and mutated.

The evaluator shares nothing with the judge (see `tests/evaluator`): what is proved must hold at random points, and
what is refuted must fail at one.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from functools import partial
from itertools import product
from random import Random

import pytest
from evaluator.identities import IDENTITIES, TABLE
from evaluator.series import NotRead
from evaluator.values import World

from workbench.context.index_values import Orders
from workbench.core.construct import apply, derivative, number, rebuild, relation, symbol
from workbench.core.integer_instances import instantiate
from workbench.core.names import Name
from workbench.core.terms import Apply, IllFormed, Number, Relation, Symbol, Term, Zero
from workbench.core.verdict import Outcome, Verdict
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.assumptions import Unsatisfiable
from workbench.language.definition_entries import read_definitions
from workbench.language.definitions import Definitions
from workbench.language.reader import read
from workbench.prover.decide.decide import Judge
from workbench.runtime import STANDARD, OutOfBudget, Workers

Found = tuple[str, Verdict | None]


class Wrong(AssertionError):
    """A verdict that values contradict."""


def worlds(definitions: Definitions, count: int = 3) -> list[World]:
    return [World(definitions, seed, length=12 if len(definitions) else 7) for seed in range(count)]


def verdict_on(case: tuple[Judge, Relation, Orders | None]) -> Verdict | None:
    """None for what the judge leaves."""
    judge, statement, orders = case
    try:
        return judge.judge(statement, orders=orders)
    except (IllFormed, NotExact, Unsatisfiable):
        return None


@pytest.fixture(scope="module")
def aside() -> Iterator[Workers]:
    """Judges within the standard budget."""
    with Workers(verdict_on, STANDARD) as workers:
        yield workers


def said_by(
    found: list[World], statement: Relation, instances: list[dict], outcome: Outcome
) -> Iterator[bool | None]:
    """What the worlds say of it, up to the first that agrees with a refutation."""
    for world, n in product(found, instances):
        yield (said := world.holds(statement, n))
        if outcome == Outcome.REFUTED and said is False:
            return


def agreement(aside: Workers, judge: Judge, statement: Relation, orders: Orders | None = None) -> Found:
    """The outcome and its verdict; Wrong where values contradict it."""
    try:
        verdict = aside.call((judge, statement, orders))
    except OutOfBudget:
        return "out of budget", None
    if verdict is None:
        return "unchecked", None
    instances = list(orders.assignments()) if orders else [{}]
    try:
        values = list(said_by(worlds(judge.definitions), statement, instances, verdict.outcome))
    except NotRead:
        return "not evaluated", verdict
    wrong = {
        Outcome.PROVED: False in values or not any(values),
        Outcome.DEFINITION: False in values,
        Outcome.CONDITIONAL: False in values,
        Outcome.REFUTED: False not in values,
    }
    if wrong.get(verdict.outcome, False):
        raise Wrong(f"{verdict.outcome}: {verdict.read_back}: {values}")
    return str(verdict.outcome), verdict


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


def check_definitions(aside: Workers, random: Random) -> str:
    entries = random_definitions(random)
    definitions, table = read_definitions(entries, TABLE)
    first = random.randrange(0, 3)
    orders = Orders.parse(f"n = {first}..{first + 2}")
    said = random.choice([(key, body) for key, body in entries.items() if "n+" in key])
    own = rf"f {said[0]} = f \cdot ({said[1]})", rf"\frac{{d}}{{dt}} {said[0]} = \frac{{d}}{{dt}} ({said[1]})"
    (statement,) = read(random.choice((*CLAIMS, *own * 6)), table, ["n"])
    found, verdict = agreement(aside, Judge(definitions), statement, orders)
    if verdict is not None and (verdict.scope or "").startswith("all n"):
        least = int(verdict.scope.partition("≥")[2] or 0)
        for n in range(least, least + 6):  # all of them, not those of the range alone
            for world in worlds(definitions, 1):
                try:
                    holds = world.holds(statement, {"n": n})
                except NotRead:
                    continue
                if holds is False:
                    raise Wrong(f"{verdict.read_back} for n = {n}: {list(definitions)}")
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
        # what stands in an exponential stays: that of a product is out of budget, as a rule
        inside = {s for e in parts(left) if isinstance(e, Apply) and e.head == "exp" for s in e.walk()}
        free = [s for s in parts(left) if isinstance(s, Symbol) and s not in inside and not _bound(s)]
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


def check_identity(aside: Workers, random: Random) -> str:
    (claim,) = read(random.choice(IDENTITIES), TABLE)
    try:
        for _ in range(random.randrange(0, 3)):
            claim = transformed(random, claim)
        if random.random() < 0.6:
            claim = mutated(random, claim)
        claim = instantiate(claim, {})
    except IllFormed:
        return "ill-formed"
    if claim.left == claim.right or isinstance(claim.left, Zero):
        return "same"
    return agreement(aside, Judge(Definitions()), claim)[0]


def campaign(count: int, seed: int | str, one: Callable[[Random], str]) -> Counter[str]:
    """How many cases came out how; fails if one is wrong, with all that are."""
    found: Counter[str] = Counter()
    wrong = []
    for k in range(count):
        try:
            found[one(Random(f"{seed}/{k}"))] += 1
        except Wrong as error:
            wrong.append(f"case {seed}/{k}: {error}")
    assert not wrong, "\n".join(wrong)
    return found


def test_definitions_by_values(aside):
    found = campaign(30, 1, partial(check_definitions, aside))
    assert found["refuted"] > 10 and found["proved"] + found["conditional"] + found["definition"] >= 3, found


def test_identities_by_values(aside):
    found = campaign(40, 2, partial(check_identity, aside))
    assert found["refuted"] > 10 and found["proved"] > 10, found


# Each part is a campaign of its own: `-k "many_identities and 7"` runs the seventh again.


@pytest.mark.slow
@pytest.mark.parametrize("part", range(5))
def test_many_definitions_by_values(aside, part):
    print(campaign(300, f"definitions {part}", partial(check_definitions, aside)))


@pytest.mark.slow
@pytest.mark.parametrize("part", range(20))
def test_many_identities_by_values(aside, part):
    found = campaign(300, f"identities {part}", partial(check_identity, aside))
    print(found)
    assert found["unchecked"] + found["out of budget"] < 0.1 * found.total(), found
