r"""Section 8: the 3C manipulator, which the chapter leaves to the reader.

Of the lines x, y, z and the rates f, g, h of their joints no more is used than that x stays, ẏ = f x × y and
ż = (f x + g y) × z, and that they are unit lines: so each derivative of f x + g y + h z follows from the one
before by the product rule.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from proofs.theorems.chains import OF_A_PRODUCT
from workbench.kinematics.printed_chains import latex_3c
from workbench.language.goals.proofs import (
    AndIntroduction,
    Congruence,
    Cut,
    Instance,
    Introductions,
    Kernel,
    Proof,
    Proven,
)

Product = str | tuple["Product", "Product"]  # a letter, or the cross product of two
Addend = tuple[str, Product]  # a factor in f, g, h and what it is a factor of

_START: list[Addend] = [("f", "x"), ("g", "y"), ("h", "z")]
_RATES = {"y": [("f", ("x", "y"))], "z": [("f", ("x", "z")), ("g", ("y", "z"))]}
_NEW = {"y": "P", "z": "Q"}  # for ẏ and ż
_TWIST = "(f x + g y + h z)"
_JOINTS = (
    r"\forall f, g, h \in \underline{\mathbb{R}}^\mathbb{R}, x \in \underline{S}^2,"
    r" y \in \underline{S}^2^\mathbb{R}, z \in \underline{V}_3^\mathbb{R} :"
    r" \dot{y} = f x \times y \wedge \dot{z} = (f x + g y) \times z \Longrightarrow "
)


def _latex(product: Product) -> str:
    return product if isinstance(product, str) else rf"({_latex(product[0])}) \times ({_latex(product[1])})"


def _sum(addends: list[Addend]) -> str:
    return " + ".join(rf"({factor}) ({_latex(product)})" for factor, product in addends)


def _places(product: Product) -> Iterator[tuple[str, Callable[[Product], Product]]]:
    """For each y and z in it: the letter, and the product with another one at its place."""
    if isinstance(product, tuple):
        left, right = product
        for letter, replaced in _places(left):
            yield letter, lambda new, replaced=replaced: (replaced(new), right)
        for letter, replaced in _places(right):
            yield letter, lambda new, replaced=replaced: (left, replaced(new))
    elif product in _RATES:
        yield product, lambda new: new


def _differentiated(addends: list[Addend]) -> tuple[list[Addend], list[Addend]]:
    """The derivative, with P and Q for ẏ and ż; and with what these are."""
    by_letters: list[Addend] = []
    written_out: list[Addend] = []
    for factor, product in addends:
        own = (rf"\frac{{d}}{{dt}} [{factor}]", product)
        by_letters.append(own)
        written_out.append(own)
        for letter, replaced in _places(product):
            by_letters.append((factor, replaced(_NEW[letter])))
            written_out += [(rf"{factor} {rate}", replaced(new)) for rate, new in _RATES[letter]]
    return by_letters, written_out


def _derivative(order: int, of: str) -> str:
    return rf"\frac{{d^{order}}}{{dt^{order}}} {of}"


def _in_letters(formula: str) -> str:
    """The right side of a formula of the chapter, in the letters x, y, z and f, g, h."""
    right = re.sub(r"\\underline\{\\mathbf\{u\}\}_(\d)", lambda m: " xyz"[int(m[1])], formula).split(" = ")[1]
    return re.sub(
        r"(\\d*dot)?\{?\\underline\{\\omega\}\}?_(\d)",
        lambda m: f"{m[1]}{{{' fgh'[int(m[2])]}}}" if m[1] else " fgh"[int(m[2])],
        right,
    )


def _after(order: int) -> list[Addend]:
    addends = _START
    for _ in range(order):
        addends = _differentiated(addends)[1]
    return addends


def _by_the_product_rule(lines: Sequence[str]) -> Proof:
    """Each derivative is the last premise of the proof of the next one; all of them are the lines."""
    proof: Proof = AndIntroduction(
        *(Congruence(f"Y + ({line}) - ({_sum(_after(n))})", Y=Instance(n)) for n, line in enumerate(lines, 1))
    )
    for order in range(len(lines), 0, -1):
        before, expression = _sum(_after(order - 1)), _sum(_differentiated(_after(order - 1))[0])
        uses = {"P": Instance(0), "Q": Instance(0, part=1)}
        if order > 1:
            expression = rf"\dot{{Y}} - \frac{{d}}{{dt}} [{before}] + {expression}"
            uses["Y"] = Instance(-1)
        said = f"{_derivative(order, _TWIST)} = {_sum(_after(order))}"
        proof = Cut(said, Congruence(expression, **uses), proof)
    return Introductions(proof)


# the chain of the chapter, body by body

_R1, _R2, _R3, _R02, _R03 = (
    rf"{{}}^{before}\underline{{\mathbf{{R}}}}_{after}" for before, after in ("01", "12", "23", "02", "03")
)
_U1, _U2, _U3 = (rf"\underline{{\mathbf{{u}}}}_{i}" for i in (1, 2, 3))
_H1, _H2, _H3 = (rf"{{}}_{i}\underline{{\mathbf{{u}}}}_{i + 1}" for i in (0, 1, 2))
_W1, _W2, _W3 = (rf"\underline{{\omega}}_{i}" for i in (1, 2, 3))
_OMEGA = r"\underline{\boldsymbol{\omega}}"
_SUM = f"{_W1} {_U1} + {_W2} {_U2} + {_W3} {_U3}"
_LINE_3 = f"{_R1} ({_R2} {_H3})"
_TURNED = r"\forall Q \in \underline{SO}_3, x, y \in \underline{V}_3 : Q (x \times y) = (Q x) \times (Q y)"


def _spin(tensor: str) -> str:
    return rf"\operatorname{{vect}}(\frac{{d}}{{dt}} [{tensor}] ({tensor})^T)"


def _at(name: str, part: int = 0, back: bool = False) -> Instance:
    return Instance(_place(name), {}, part, back)


def _place(name: str) -> int:
    """The lines are premise 0."""
    return 1 + list(_FACTS).index(name)


def _rotation(of: str) -> str:
    return rf"{of} {of}^T = \mathbf{{I}} \wedge \det {of} = 1"


#: In this order each is a premise of those after it.
_FACTS: dict[str, str] = {
    "turned": _TURNED,
    "rotations": r"\forall P, S \in \underline{SO}_3, Q \in L(\underline{V}_3, \underline{V}_3) : Q = P S"
    r" \Rightarrow Q Q^T = \mathbf{I} \wedge \det Q = 1",
    "product": OF_A_PRODUCT,
    "u1": f"{_U1} = {_H1}",
    "u2": f"{_U2} = {_R1} {_H2}",
    "rotation 1": _rotation(_R1),
    "rotation 2": _rotation(_R2),
    "rotation 3": _rotation(_R3),
    "rate 1": rf"\dot{{{_R1}}} = {_W1} \widetilde{{{_H1}}} {_R1}",
    "rate 2": rf"\dot{{{_R2}}} = {_W2} \widetilde{{{_H2}}} {_R2}",
    "spin 1": f"{_spin(_R1)} = {_W1} {_H1}",
    "spin 2": f"{_spin(_R2)} = {_W2} {_H2}",
    "spin 3": f"{_spin(_R3)} = {_W3} {_H3}",
    "02": f"{_R02} = {_R1} {_R2}",
    "03": f"{_R03} = {_R02} {_R3}",
    "02 x": f"{_R02} {_H3} = {_LINE_3}",
    "u3 of 02": f"{_U3} = {_R02} {_H3}",
    "rotation 02": _rotation(_R02),
    "u3": f"{_U3} = {_LINE_3}",
    "turned line": rf"{_R1} ({_H2} \times ({_R2} {_H3})) = ({_R1} {_H2}) \times ({_LINE_3})",
    "moved": rf"\dot{{{_U3}}} = {_W1} {_H1} \times ({_LINE_3}) + {_W2} {_R1} ({_H2} \times ({_R2} {_H3}))",
    "lines": rf"\dot{{{_U2}}} = {_W1} {_U1} \times {_U2} \wedge"
    rf" \dot{{{_U3}}} = ({_W1} {_U1} + {_W2} {_U2}) \times {_U3}",
    "sum": f"{_OMEGA} = {_SUM}",
    "spin 02": f"{_spin(_R02)} = {_W1} {_U1} + {_W2} {_U2}",
    "spin 03": f"{_spin(_R03)} = {_OMEGA}",
}


def _is_a_rotation(name: str) -> Proof:
    return AndIntroduction(*(Congruence("Y", Y=_at(f"rotation {name}", part)) for part in (0, 1)))


def _two(fact: str, left: str, right: str, part: int = 0, **more: str) -> Instance:
    """What the fact says of the product of two rotations."""
    tensors = {"1": _R1, "2": _R2, "3": _R3, "02": _R02}
    members = {"P": left, "S": right}
    values = {**more, **{letter: tensors[name] for letter, name in members.items()}}
    are = {letter: _is_a_rotation(name) for letter, name in members.items()}
    return Instance(_place(fact), values, part, members=are)


#: How those follow that the judge does not see at once.
_BECAUSE: dict[str, Proof] = {
    "02 x": Congruence(f"X {_H3}", X=_at("02")),
    "rotations": Introductions(
        AndIntroduction(Congruence("X X^T", X=Instance(-1)), Congruence(r"\det X", X=Instance(-1)))
    ),
    "rotation 02": AndIntroduction(
        *(Congruence("Y", Y=_two("rotations", "1", "2", part, Q=_R02)) for part in (0, 1))
    ),
    "u3": Congruence(f"Y - {_R02} {_H3} + X", X=_at("02 x"), Y=_at("u3 of 02")),
    "turned line": Congruence(
        "X",
        X=Instance(_place("turned"), {"Q": _R1, "x": _H2, "y": f"{_R2} {_H3}"}, members=_is_a_rotation("1")),
    ),
    "moved": Congruence(
        rf"\dot{{X}} - \frac{{d}}{{dt}} [{_LINE_3}] + Y ({_R2} {_H3}) + {_R1} (Z {_H3})",
        X=_at("u3"),
        Y=_at("rate 1"),
        Z=_at("rate 2"),
    ),
    "lines": AndIntroduction(
        Kernel(using=()),
        Congruence(
            rf"X - {_W1} {_H1} \times ({_LINE_3}) - {_W2} {_R1} ({_H2} \times ({_R2} {_H3}))"
            rf" + {_W1} Y \times Z + {_W2} T - {_W2} ({_R1} {_H2}) \times ({_LINE_3}) + {_W2} S \times Z",
            X=_at("moved"),
            Y=_at("u1", back=True),
            Z=_at("u3", back=True),
            T=_at("turned line"),
            S=_at("u2", back=True),
        ),
    ),
    "spin 02": Congruence(
        rf"\operatorname{{vect}}(\dot{{Z}} Z^T) - {_spin(f'({_R1} {_R2})')} + Y - {_spin(_R1)} + S"
        rf" + {_R1} (T - {_spin(_R2)}) + {_W1} (X - {_H1}) + {_W2} (V - {_R1} {_H2})",
        Z=_at("02"),
        Y=_two("product", "1", "2"),
        S=_at("spin 1"),
        T=_at("spin 2"),
        X=_at("u1", back=True),
        V=_at("u2", back=True),
    ),
    "spin 03": Congruence(
        rf"\operatorname{{vect}}(\dot{{Z}} Z^T) - {_spin(f'({_R02} {_R3})')} + Y - {_spin(_R02)} + S"
        rf" + {_R02} (T - {_spin(_R3)}) + {_W3} (X - {_R02} {_H3}) + V - ({_SUM})",
        Z=_at("03"),
        Y=_two("product", "02", "3"),
        S=_at("spin 02"),
        T=_at("spin 3"),
        X=_at("u3 of 02", back=True),
        V=_at("sum", back=True),
    ),
}


def _having(then: Proof) -> Proof:
    for name in reversed(_FACTS):
        then = Cut(_FACTS[name], _BECAUSE.get(name, Kernel(using=())), then)
    return then


def _closed_form(expanded: bool) -> Proven:
    lines = [_in_letters(formula) for formula in latex_3c(expanded)[1:]]
    said = r" \wedge ".join(f"{_derivative(n, _TWIST)} = {line}" for n, line in enumerate(lines, 1))
    values = {"f": _W1, "g": _W2, "h": _W3, "x": _U1, "y": _U2, "z": _U3}
    steps = [
        Congruence(
            rf"{_derivative(n, 'X')} + Y - {_derivative(n, f'({_SUM})')}",
            X=_at("sum"),
            Y=Instance(0, values, part=n - 1, members=Kernel(using=())),
        )
        for n in (1, 2, 3)
    ]
    parts = AndIntroduction(Congruence("Y", Y=_at("spin 03")), Congruence("Y", Y=_at("sum")), *steps)
    return Proven(Cut(_JOINTS + said, _by_the_product_rule(lines), _having(parts)))


THEOREMS = {"closed_form_3c": _closed_form(False), "closed_form_3c_expanded": _closed_form(True)}
