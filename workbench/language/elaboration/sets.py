"""Sets: the kind of their members, and the equations that characterize them.

    \\mathbb{R}  V_3  L(V_3, V_3)  SO_3  \\mathfrak{so}_3  S^2  SE_3  \\mathcal{M}_{n \\times m}(\\mathbb{R})

underlined for those with dual parts. A superscript ℝ, for functions of time, has no meaning at one instant.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import TypeCode
from workbench.core.construct import apply, identity, number, relation, zero
from workbench.core.formula_errors import Fault
from workbench.core.names import Name
from workbench.core.terms import Apply, Block, IllFormed, Relation, Symbol, Term, Zero
from workbench.core.types import SCALAR, TENSOR, VECTOR, Declaration, Type
from workbench.language.elaboration.ranges import set_name
from workbench.language.grammar.syntax import (
    Bracket,
    Group,
    Infix,
    Leaf,
    Node,
    Product,
    Scripted,
    Styled,
    core,
    unstyled,
)
from workbench.language.naming.spelling import Scripts, Spelling, spell
from workbench.language.naming.symbols import SymbolTable

_STYLES = ("mathbf", "mathbb", "mathrm", "mathcal", "mathfrak", "mathsf", "boldsymbol", "underline")


@dataclass(frozen=True)
class Members:
    """name: of the set.   type: of its members.   trait: "", rotation, skew, unit or displacement."""

    name: str
    type: Type
    trait: str = ""

    def conditions(self, term: Term) -> list[Relation]:
        """Returns the equations that make the term a member; none if its kind or declaration implies it.

        Raises IllFormed if it has another kind, NotImplementedError if it is not recognizably composed of R
        and p.
        """
        if term.type.with_dual(False) != self.type.with_dual(False):
            raise IllFormed(TypeCode.MEMBER_OF_ANOTHER_TYPE(name=self.name, type=self.type, type_2=term.type))
        found = []
        if term.type.dual and not self.type.dual:
            found.append(relation("=", apply("du", term), zero(term.type.with_dual(False))))
        match self.trait:
            case "rotation" if not (isinstance(term, Symbol) and term.declaration.rotation):
                found.append(relation("=", apply("mul", term, apply("transpose", term)), identity()))
                found.append(relation("=", apply("det", term), number(1)))
            case "skew" if not (isinstance(term, Apply) and term.head in ("skew", "antisymmetric")):
                found.append(relation("=", apply("transpose", term), apply("neg", term)))
            case "unit" if not (isinstance(term, Symbol) and term.declaration.unit):
                found.append(relation("=", apply("dot", term, term), number(1)))
            case "displacement" if not (isinstance(term, Symbol) and term.declaration.transform):
                found += replace(self, type=TENSOR, trait="rotation").conditions(_rotation_of(term))
        return found

    def letter(self, name: Name) -> Declaration:
        """Returns the declaration of a letter for an arbitrary member."""
        return Declaration(name, self.type).with_flags(
            constant=True,
            unit=self.trait == "unit",
            rotation=self.trait == "rotation",
            transform=self.trait == "displacement",
        )


_KNOWN = {
    "R": (SCALAR, ""),
    "V_3": (VECTOR, ""),
    "V": (VECTOR, ""),
    "E_3": (VECTOR, ""),
    "SO_3": (TENSOR, "rotation"),
    "so_3": (TENSOR, "skew"),
    "S_2": (VECTOR, "unit"),
    "SE_3": (Type(4, 4), "displacement"),
}


def members_of(where: Node) -> Members | None:
    """Returns the members of the set; None for an unknown set. Raises Fault if it is not a set."""
    match where:
        case Product(items=(Leaf() | Styled() | Scripted() as head, Bracket(kind="(", parts=parts))):
            found = _of_family(head, parts)
            if found is not None:
                return found
    name = set_name(where)
    squeezed = name
    for style in _STYLES:
        squeezed = squeezed.replace(f"\\{style}", "")
    squeezed = squeezed.replace("^{{R}}", "").translate(str.maketrans("^", "_", "{} "))
    size = re.fullmatch(r"R_([1-9]\d?)(?:\\times([1-9]\d?))?", squeezed)
    known = (Type(int(size[1]), int(size[2] or 1)), "") if size else _KNOWN.get(squeezed)
    if known is None:
        return None
    type_, trait = known
    shown = re.sub(r"^([A-Za-z]{2,})_\{(\d)\}$", r"\1(\2)", name)  # SO(3)
    return Members(shown, type_.with_dual("\\underline" in name), trait)


def _of_family(head: Node, parts: tuple[Node, ...]) -> Members | None:
    """Returns the members of L(V, V), the linear maps of vectors, and of M_{n×m}(ℝ); else None."""
    letter = head.nucleus if isinstance(head, Scripted) else head
    plain = letter
    while isinstance(plain, Styled | Group):
        plain = plain.body if isinstance(plain, Styled) else plain.parts[0]
    found = [members_of(part) for part in parts]
    inner = [members for members in found if members is not None]
    if len(inner) < len(found) or not isinstance(plain, Leaf):
        return None
    dual = inner[0].type.dual
    if plain.text == "L" and [m.type.with_dual(False) for m in inner] == [VECTOR, VECTOR]:
        return Members(f"L({inner[0].name}, {inner[1].name})", TENSOR.with_dual(dual))
    match head:
        case Scripted(sub=sub) if plain.text == "M" and len(inner) == 1 and inner[0].type.kind == "scalar":
            match core(sub):
                case Product(items=(Leaf(text=rows), Infix(operator="×"), Leaf(text=columns))):
                    if rows.isdigit() and columns.isdigit() and 0 < int(rows) * int(columns) <= 100:
                        name = f"\\mathcal{{M}}_{{{rows} \\times {columns}}}({inner[0].name})"
                        return Members(name, Type(int(rows), int(columns)).with_dual(dual))
    return None


def _rotation_of(term: Term) -> Term:
    match term:
        case Block(entries=((rotation, _), (Zero(), last))) if last == number(1):
            return rotation
    raise NotImplementedError("a displacement that is not written as [R p; 0 1]")


def bound_letter(table: SymbolTable, node: Node, members: Members) -> tuple[SymbolTable, Symbol] | None:
    """Returns the table with the letter as an arbitrary member of the set; None if the node is not a letter.

    Raises Fault for a defined letter.
    """
    name = letter_name(node)
    if name is None:
        return None
    if name in table.defined.members or name in table.notations.constants:
        raise Fault(SyntaxCode.DEFINED_CANNOT_ANY_MEMBER(name=name, name_2=members.name), node.at)
    declaration = members.letter(name)
    return table.with_symbol(declaration), Symbol(declaration.type, None, declaration)


def letter_name(node: Node) -> Name | None:
    """Returns the name of a letter with its fonts and its subscript; None for other nodes."""
    spelling = letter_spelling(node)
    return None if spelling is None else spelling.exact


def letter_spelling(node: Node) -> Spelling | None:
    """Returns a letter with its fonts and its subscript as written; None for other nodes."""
    scripted = node if isinstance(node, Scripted) else Scripted(node.at, node)
    if scripted.factorial or scripted.sup is not None:
        return None
    styles, letter = unstyled(scripted.nucleus)
    if not isinstance(letter, Leaf) or letter.kind != "LETTER":
        return None
    scripts = Scripts(sub=scripted.sub, primes=scripted.primes)
    return spell(Name.styled(styles, letter.text), scripts, ())
