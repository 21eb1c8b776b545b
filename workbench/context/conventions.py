"""Table of the conventions of authors: the facts that each convention suggests, and their strength.

A hinted convention adds facts that hold together. A guessed one adds alternatives, each of which is tried
alone. The strengths are calibrated on texts: a hint makes hardly any false formula true.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from workbench.context import vector_figures
from workbench.context.facts import Context, Duration, Fact, Origin, Provider, Strength
from workbench.context.formula_subject import Subject, names_of
from workbench.context.free_symbols import free_in, terms_of
from workbench.context.property_statements import having, joined, meaning, of_length_one
from workbench.context.vector_figures import Made, named
from workbench.core.construct import apply, block, number, symbol
from workbench.core.operations import CIRCULAR
from workbench.core.properties import PROPERTIES
from workbench.core.terms import Apply, Derivative, Symbol, Zero, sides_of
from workbench.core.types import SCALAR
from workbench.language.naming.symbols import UNIT_LETTERS
from workbench.language.printing.printer import to_latex
from workbench.source.typeset.glyphs import WEIGHT_STYLES


@dataclass(frozen=True)
class Convention:
    """A convention of authors.

    Attributes:
        of_letters: Whether it depends on letters, accents or typefaces, so that renaming symbols may change
            it.
        duration: How long the facts hold.
        of_text: Whether a text that needs the facts in several formulas means them in all.
    """

    name: str
    strength: Strength
    of_letters: bool
    make: Callable[[Subject], Iterator[Made]]
    duration: Duration = Duration.ALWAYS
    of_text: bool = False

    def facts(self, subject: Subject) -> Iterator[Fact]:
        """Yields the facts that it suggests of the symbols of a claim."""
        if self.of_letters and not subject.letters:
            return
        for words, own, content in self.make(subject):
            if any(each.declaration.hidden or each.declaration.introduced for each in own):
                continue  # a symbol that only frames and definitions introduce is not the author's
            about = names_of([each.declaration for each in own])
            yield Fact(content, about, Origin(Provider.CONVENTION, words), self.strength, self.duration)


def conventional(subject: Subject) -> Context:
    """Returns the hinted facts and the guessed alternatives for the free symbols of a claim."""
    hints: list[Fact] = []
    guesses: list[tuple[Fact, ...]] = []
    for row in CONVENTIONS:
        if row.strength is Strength.HINTED:
            hints += row.facts(subject)
        else:
            guesses += ((fact,) for fact in row.facts(subject))
    return Context(tuple(hints), tuple(guesses))


def guesses_of_texts(subject: Subject) -> Iterator[Fact]:
    """Yields the guesses for a claim that a text means everywhere if several formulas need them."""
    return (fact for row in CONVENTIONS if row.of_text for fact in row.facts(subject))


def _hats(subject: Subject) -> Iterator[Made]:
    vectors = [each for each in subject.free if each.type.kind == "vector" and vector_figures.has_hat(each)]
    own = [each for each in vectors if not (each.declaration.unit or each.index)]
    if own:
        yield f"{named(own)}: a unit vector, as its hat says", own, having("unit", own)


def _identities(subject: Subject) -> Iterator[Made]:
    """Yields identity matrices by their letter. R R^T = I is meant so even if the model declares I an
    inertia.
    """
    written = [term for term in terms_of(subject.statement) if isinstance(term, Symbol)]
    for own in dict.fromkeys([*written, *subject.free]):
        is_meant = own.declaration.name.letter in UNIT_LETTERS and not (own.index or own.declaration.free)
        if is_meant and PROPERTIES["identity"].fits(own):
            yield f"${to_latex(own)}$: the identity, as its letter says", [own], having("identity", [own])


def _lengths(subject: Subject) -> Iterator[Made]:
    vectors = {
        vector_figures.unstyled(each): each
        for each in subject.free
        if each.type.kind == "vector" and not vector_figures.has_hat(each)
    }
    for own in _numbers(subject):
        if whole := vectors.get(vector_figures.unstyled(own)):
            words = f"${to_latex(own)}$: the length of ${to_latex(whole)}$"
            yield words, [own, whole], meaning(own, apply("norm", whole))


_BOLD = WEIGHT_STYLES | {"\\vec"}


def _typefaces(subject: Subject) -> Iterator[Made]:
    """Yields a vector or matrix in a plain typeface as the one that the text writes in bold."""
    bold = {}
    for declared in subject.symbols.symbols.values():
        plain = tuple(style for style in declared.name.styles if style not in _BOLD)
        if plain != declared.name.styles and not declared.indices:
            bold[replace(declared.name, styles=plain), declared.type] = declared
    for own in subject.free:
        meant = bold.get((own.declaration.name, own.type))
        if meant is not None and own.type != SCALAR and not own.index:
            whole = symbol(meant)
            yield f"${to_latex(own)}$: ${to_latex(whole)}$ in another typeface", [own], meaning(own, whole)


_PLACES = {"x": 0, "1": 0, "i": 0, "y": 1, "2": 1, "j": 1, "z": 2, "3": 2, "k": 2}


def _components(subject: Subject) -> Iterator[Made]:
    """Yields v_x as a component of v, and R_{12} of R, if both are in the claim and neither is defined."""
    declared = [each for each in subject.symbols.symbols.values() if not each.indices and not each.type.dual]
    for own in _numbers(subject):
        name = own.declaration.name
        at = "".join(name.sub).translate(str.maketrans("", "", ", {}"))
        if not at or any(letter not in _PLACES for letter in at):
            continue
        axes = [block([[number(int(k == _PLACES[letter]))] for k in range(3)]) for letter in at]
        for whole in declared:
            if whole.name.letter != name.letter or whole.name.sub or whole not in subject.declarations:
                continue
            words = f"${to_latex(own)}$: a component of ${whole.name}$"
            if whole.type.kind == "vector" and len(at) == 1:
                yield words, [own], meaning(own, apply("dot", axes[0], symbol(whole)))
            elif whole.type.kind == "tensor" and len(at) == 2:
                yield words, [own], meaning(own, apply("dot", axes[0], apply("mul", symbol(whole), axes[1])))


def _circles(subject: Subject) -> Iterator[Made]:
    """Yields c and s with the same scripts as the cosine and sine of one angle."""
    groups: dict[object, list[Symbol]] = {}
    for own in _numbers(subject):
        name = own.declaration.name
        if name.letter in ("c", "s", "C", "S"):
            groups.setdefault((name.letter.isupper(), name.sub, name.sup), []).append(own)
    for pair in groups.values():
        if len(pair) == 2:
            yield f"{named(pair)}: the cosine and sine of an angle", pair, of_length_one(pair)


def _under_roots(subject: Subject) -> Iterator[Made]:
    parts = [p for p in terms_of(subject.statement) if isinstance(p, Apply) and p.head in ("norm", "root")]
    own = [
        each
        for each in _numbers(subject)
        if each.declaration not in subject.moved and not each.declaration.positive
    ]
    if parts and own:
        yield f"{named(own)}: positive, beside a root or a length", own, having("positive", own)


def _flag(name: str) -> Callable[[Subject], Iterator[Made]]:
    """Returns a maker that gives a property to each symbol that may have it, and then to all of them."""

    def make(subject: Subject) -> Iterator[Made]:
        row = PROPERTIES[name]
        may = [s for s in subject.free if row.fits(s) and not s.index and not s.declaration.rotation]
        may = [s for s in may if not (row.flag and getattr(s.declaration, row.flag))]
        if name == "skew":  # a symmetric skew matrix is zero
            may = [s for s in may if not (s.declaration.symmetric or s.declaration.diagonal)]
        for own in [[each] for each in may] + [may] * (len(may) > 1):
            yield f"{named(own)}: {name}", own, having(name, own)

    return make


def _rests(under_rates: bool) -> Callable[[Subject], Iterator[Made]]:
    """Returns a maker that makes symbols without a written rate constant.

    A symbol under a written d/dt may be a missing term of the derivative. A symbol is left out if its
    constancy makes a rate vanish.
    """

    def make(subject: Subject) -> Iterator[Made]:
        if not subject.rates:
            return
        written = [part.body for part in terms_of(subject.statement) if isinstance(part, Derivative)]
        rated = {body.declaration for body in written if isinstance(body, Symbol)}
        inside = {p.declaration for body in written for p in body.symbols()} - rated
        may = [s for s in subject.free if not (s.declaration.constant or s.index or s.declaration in rated)]
        never = [s for s in may if s.declaration.name not in subject.moving and not s.declaration.rotation]
        own = never if under_rates else [s for s in never if s.declaration not in inside]
        still = {s.declaration for s in own}
        is_void = any(free_in([rate], subject.definitions) <= still for rate in subject.rates)
        if own and not is_void:
            yield f"{named(own)}: constant, as the text takes no rate", own, having("constant", own)
        here = [
            s for s in may if s.declaration in subject.written and s.declaration.name not in subject.ruled
        ]
        if (
            under_rates
            and here
            and not any(
                free_in([rate], subject.definitions) <= {s.declaration for s in here}
                for rate in subject.rates
            )
        ):
            constant = having("constant", here)
            words = f"{named(here)}: constant, as no rate is taken here"
            yield words, here, constant
            squares = [s for s in here if PROPERTIES["symmetric"].fits(s) and not s.declaration.symmetric]
            if squares:
                symmetric = joined([constant, having("symmetric", squares)])
                yield f"{words}, and {named(squares)} symmetric", here, symmetric

    return make


def _spins(subject: Subject) -> Iterator[Made]:
    """Yields vectors as the angular velocity of a frame, of which the formula has no symbol of the author."""
    own_symbols = {part for part in terms_of(subject.statement) if isinstance(part, Symbol)}
    for frame, spin in subject.symbols.frames.velocities.items():
        is_named = any(
            spin in (each, subject.definitions.lookup(each))
            for each in own_symbols
            if not each.declaration.hidden
        )
        for own in subject.free:
            if own.type == spin.type and not isinstance(spin, Zero) and not is_named:
                yield f"${to_latex(own)}$: the angular velocity of {frame}", [own], meaning(own, spin)


#: The letters of components of a quaternion or a vector without scripts.
_PLAIN = "wxyz"


def _of_length_one(subject: Subject) -> Iterator[Made]:
    """Yields unit sets: 2 to 4 numbers of one letter, the numbers x, y, z, w, or a number and a vector.

    An angle, of which a sine or cosine is taken, belongs to none.
    """
    turns = subject.definitions.reached(*sides_of(subject.statement))
    angles = {
        part for turn in turns if isinstance(turn, Apply) and turn.head in CIRCULAR for part in turn.symbols()
    }
    numbers = [each for each in _numbers(subject) if each not in angles]
    vectors = [s for s in subject.free if s.type.kind == "vector" and not s.declaration.unit]
    groups: dict[str, list[Symbol]] = {}
    for own in numbers:
        name = own.declaration.name
        is_plain = name.letter in _PLAIN and not name.sub
        groups.setdefault(_PLAIN if is_plain else name.letter, []).append(own)
    groups["of both"] = [*numbers, *vectors] if len(numbers) == len(vectors) == 1 else []
    for group in groups.values():
        if 1 < len(group) < 5:
            yield f"{named(group)}: of length 1 together", group, of_length_one(group)


def _small(subject: Subject) -> Iterator[Made]:
    heads = CIRCULAR | {"exp"}
    inside = {
        part
        for term in terms_of(subject.statement)
        if isinstance(term, Apply) and term.head in heads
        for part in term.walk()
    }
    own = [s for s in subject.free if s in inside and PROPERTIES["small"].fits(s) and not s.declaration.unit]
    if own:
        yield f"{named(own)}: small", own, having("small", own)


def _numbers(subject: Subject) -> list[Symbol]:
    return [own for own in subject.free if own.type == SCALAR and not own.index]


CONVENTIONS = (
    Convention("hat", Strength.HINTED, True, _hats),
    Convention("identity", Strength.HINTED, True, _identities),
    Convention("length", Strength.HINTED, True, _lengths),
    Convention("component", Strength.HINTED, True, _components),
    Convention("typeface", Strength.HINTED, True, _typefaces),
    Convention("circle", Strength.HINTED, True, _circles),
    Convention("positive", Strength.HINTED, False, _under_roots),
    Convention("never moved", Strength.HINTED, False, _rests(under_rates=False)),
    Convention("rotation", Strength.GUESSED, False, _flag("rotation"), of_text=True),
    Convention("unit", Strength.GUESSED, False, _flag("unit"), of_text=True),
    Convention("rests", Strength.GUESSED, False, _rests(under_rates=True)),
    Convention("symmetric", Strength.GUESSED, False, _flag("symmetric"), of_text=True),
    Convention("skew", Strength.GUESSED, False, _flag("skew"), of_text=True),
    Convention("orthogonal", Strength.GUESSED, False, _flag("orthogonal"), of_text=True),
    Convention("axes", Strength.GUESSED, True, vector_figures.axes),
    Convention("right angle", Strength.GUESSED, False, vector_figures.right_angles),
    Convention("coincident", Strength.GUESSED, False, vector_figures.coincident, Duration.INSTANT),
    Convention("turning", Strength.GUESSED, False, vector_figures.turning),
    Convention("spin", Strength.GUESSED, False, _spins),
    Convention("length one", Strength.GUESSED, False, _of_length_one, of_text=True),
    Convention("small", Strength.GUESSED, False, _small),
)
