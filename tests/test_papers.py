"""Paper files: what a good one gives, and the one message that each bad one gets."""

from __future__ import annotations

import time
from pathlib import Path

import pytest
from bad_papers import BAD_PAPERS, GOOD_CLAIM, HEAD, SYMBOL_FAULTS, BadPaper, claim
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from workbench.context.index_values import orders_within
from workbench.core.names import Name
from workbench.core.verdict import Outcome
from workbench.language.goals.proofs import Kernel, Proven
from workbench.papers import InstalledPaper, Orders, PaperError, load_paper, merge

PAPERS = Path(__file__).parent / "papers"


@pytest.fixture
def paper_of(tmp_path):
    def load(text: str, name: str = "paper.toml"):
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return load_paper(path)

    return load


def write(directory: Path, **texts: str) -> list[Path]:
    paths = [directory / f"{name}.toml" for name in texts]
    for path, text in zip(paths, texts.values(), strict=True):
        path.write_text(text, encoding="utf-8")
    return paths


# faults


@pytest.mark.parametrize("bad", BAD_PAPERS + SYMBOL_FAULTS, ids=lambda bad: bad.name)
def test_a_bad_paper_gets_one_message_that_points_at_the_fault(bad: BadPaper, tmp_path):
    path = tmp_path / "bad.toml"
    path.write_bytes(bad.content.encode())
    start = time.perf_counter()
    with pytest.raises(PaperError) as caught:
        load_paper(path)
    assert time.perf_counter() - start < 5
    assert caught.value.__cause__ is None
    (error,) = [fault for fault in caught.value.faults if (fault.line, fault.column) == bad.place][:1]
    assert str(error).startswith(f"{path}:{error.line}:{error.column}: ")
    assert bad.says in error.message
    assert len(str(error)) < 1000


#: Where each stands in a file, and lines with one fault each: none of them follows from another.
FAULTY = (
    ("top", "titel = 'x'«", "did you mean title?"),
    ("top", "section = 7«", "expected a string"),
    ("symbols", "'\\alpha' = { kind = 'vektor' }«", "kind is 'vektor'"),
    ("symbols", "'\\beta' = { kind = 'vector', wieght = 1 }«", "wieght"),
    ("symbols", "'\\gamma' = { kind = 'vector', aliases = ['\\rho'] }«", "declared twice"),
    ("definitions", "'\\delta' = '\\rho \\rho'«", "vectors beside"),
    ("definitions", "'\\eta' = '\\rho + \\nowhere'«", "\\nowhere"),
    ("notation", "'x^\\wedge' = { where = { x = 'vectr' }, means = 'x' }«", "vectr"),
    ("conventions", "gradient = 'up'«", "conventions"),
    ("claims", "[[claim]]\nid = 'a'\nprintd = '\\rho = \\rho'«", "did you mean printed?"),
    ("claims", "[[claim]]\nid = 'b'\nprinted = '\\rho = \\psi'«", "\\psi"),
    ("claims", "[[claim]]\nid = 'c d'«\nprinted = '\\rho = \\rho'", "without blanks"),
    ("claims", "[[claim]]\nid = '1'«\nprinted = '\\rho = \\rho'", "used twice"),
    ("claims", "[[claim]]\nid = 'e'\nprinted = '\\rho = \\rho'\norders = 3«", "expected a string"),
    ("claims", "[[claim]]\nid = 'f'\nprinted = '\\rho = \\rho'\nassume = ['{']«", "never closed"),
    ("claims", "[[claim]]\nid = 'g'\nprinted = '\\rho = \\rho'\ninherits = ['nowhere']«", "no claim"),
)


@given(st.sets(st.sampled_from(range(len(FAULTY))), min_size=1))
@settings(max_examples=25, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_all_faults_are_reported_at_once(tmp_path, chosen):
    parts = {"top": ["title = 'A paper'"], "symbols": ["'\\rho' = { kind = 'vector' }"]}
    parts["claims"] = ["[[claim]]\nid = '1'\nprinted = '\\rho \\times \\rho = 0'"]
    for place in sorted(chosen):
        parts.setdefault(FAULTY[place][0], []).append(FAULTY[place][1])
    lines = list(parts["top"])
    for name in ("symbols", "definitions", "notation", "conventions"):
        lines += [f"[{name}]", *parts[name]] if name in parts else []
    text = "\n".join([*lines, *parts["claims"]])
    marked = [number for number, line in enumerate(text.split("\n"), 1) if "«" in line]
    path = tmp_path / "many.toml"
    path.write_text(text.replace("«", ""))
    with pytest.raises(PaperError) as caught:
        load_paper(path)
    faults = caught.value.faults
    assert [fault.line for fault in faults] == marked
    said = sorted(FAULTY[place][2] for place in chosen)
    assert all(any(each in fault.message for fault in faults) for each in said)


def test_consequences_of_a_fault_are_not_reported(tmp_path):
    head = "title = 'x'\n[symbols]\n'a' = { kind = 'vektor' }\n'b' = 'vector'\n[definitions]\n'c' = 'a + b'\n"
    path = tmp_path / "follows.toml"
    path.write_text(f"{head}[[claim]]\nid = '1'\nprinted = 'c \\times a = b'\n")
    with pytest.raises(PaperError) as caught:
        load_paper(path)
    assert [fault.line for fault in caught.value.faults] == [3]


def test_bytes_that_are_not_utf8_are_placed(tmp_path):
    path = tmp_path / "latin.toml"
    path.write_bytes("title = 'x'\n# Müller\n".encode("latin-1"))
    with pytest.raises(PaperError, match=r"latin\.toml:2:4: byte 0xfc is not UTF-8"):
        load_paper(path)


@pytest.mark.parametrize(
    ("make", "says"),
    [(Path.mkdir, "is a directory; expected a TOML file"), (lambda path: None, "no such file")],
    ids=["a directory", "no file"],
)
def test_unreadable_paths_are_rejected(make, says, tmp_path):
    path = tmp_path / "thing.toml"
    make(path)
    with pytest.raises(PaperError) as caught:
        load_paper(path)
    assert str(caught.value) == f"{path}: {says}"


LATER = "notation = 'shared.toml'\n\n[[claim]]\nid = '{id}'\nprinted = '{printed}'\n"
TWO_LINES = r"\begin{aligned} \omega &= \omega \\ \omega &= 0 \end{aligned}"


@pytest.fixture
def two_files(tmp_path):
    (tmp_path / "shared.toml").write_text("title = 'x'\n[symbols]\n'\\omega' = { kind = 'vector' }\n")
    one = tmp_path / "one.toml"
    one.write_text(LATER.format(id="1", printed=r"\omega = \omega") + "inherits = ['2', '2.1', '3']\n")
    two = tmp_path / "two.toml"
    two.write_text(
        LATER.format(id="2", printed=TWO_LINES)
        + LATER.format(id="3", printed=r"\omega = 0").partition("\n\n")[2]
    )
    return one, two


def test_a_single_file_may_name_claims_of_sibling_files(two_files):
    assert load_paper(two_files[0]).claims[0].inherits == ("2.1", "2.2", "2.1", "3")
    assert load_paper(two_files[0]).claims[0].inherits == merge(two_files).claims[0].inherits


def test_an_heir_that_no_file_of_the_paper_has_is_an_error(two_files):
    one, two = two_files
    one.write_text(one.read_text().replace("'3'", "'4'"))
    with pytest.raises(
        PaperError, match=r"one\.toml:6:25: inherits: no claim has the id '4', here or in two\.toml$"
    ):
        load_paper(one)
    two.write_text("[[claim")
    with pytest.raises(PaperError, match=r"one\.toml:6:13: inherits: no claim has the id '2'$"):
        load_paper(one)


def test_an_heir_in_a_file_of_another_notation_is_an_error(two_files):
    one, two = two_files
    two.write_text(two.read_text().replace("shared", "other"))
    with pytest.raises(PaperError, match="no claim has the id '2'"):
        load_paper(one)


def test_a_chapter_file_alone_may_name_heirs_of_any_other():
    from workbench.papers.installed_papers import installed
    from workbench.papers.sibling_files import claim_ids, sisters_of

    files = installed("chapter").files
    known = claim_ids(sisters_of(files[0]))
    assert {path.resolve() for path in files[1:]} <= set(sisters_of(files[0]))
    claims = [claim.id for claim in merge(files[1:]).claims]
    assert claims == [part for name in dict.fromkeys(claims) for part in known[name]]


def test_a_huge_file_is_not_read(tmp_path):
    path = tmp_path / "huge.toml"
    path.write_bytes(b"# " + b"x" * 5_000_000)
    with pytest.raises(PaperError, match="larger than"):
        load_paper(path)


SOURCES = [path.read_text(encoding="utf-8") for path in sorted(PAPERS.glob("*.toml"))]
PIECES = [*"'\"[]{}\\\n=,\0é&", "\\omega", "[[claim]]", "1..3"]
cuts = st.tuples(st.floats(0, 1), st.integers(0, 12), st.sampled_from(["", *PIECES]))


def damaged(source: str, cuts: list[tuple[float, int, str]]) -> str:
    for where, length, piece in cuts:
        start = int(where * len(source))
        source = source[:start] + piece + source[start + length :]
    return source


def assert_read_or_refused(text: str, path: Path) -> None:
    path.write_bytes(text.encode())
    start = time.perf_counter()
    try:
        assert load_paper(path).claims
    except PaperError as error:
        assert "\n" not in str(error)
        assert error.line is not None and 1 <= error.line <= text.count("\n") + 1
    assert time.perf_counter() - start < 5


@given(st.sampled_from(SOURCES), st.lists(cuts, min_size=1, max_size=4))
@settings(max_examples=150, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_a_damaged_paper_is_read_or_refused_in_one_line(tmp_path, source, cuts):
    assert_read_or_refused(damaged(source, cuts), tmp_path / "damaged.toml")


@pytest.mark.slow
@given(st.sampled_from(SOURCES), st.lists(cuts, min_size=1, max_size=6))
@settings(max_examples=20_000, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_many_damaged_papers(tmp_path, source, cuts):
    assert_read_or_refused(damaged(source, cuts), tmp_path / "damaged.toml")


def test_a_name_with_nul_is_refused():
    with pytest.raises(PaperError, match=r"cannot be read: embedded null byte"):
        load_paper("a\0b.toml")


def test_notations_that_refer_to_each_other(tmp_path):
    paper, *_ = write(
        tmp_path,
        paper=f"title = 'x'\nnotation = 'one.toml'\n{GOOD_CLAIM}",
        one="notation = 'two.toml'\n",
        two="notation = 'one.toml'\n",
    )
    with pytest.raises(PaperError, match=r"two\.toml:1:12: notation: one\.toml refers back to itself"):
        load_paper(paper)


def test_a_notation_file_holds_no_claims(tmp_path):
    paper, _ = write(tmp_path, paper=f"title = 'x'\nnotation = 'n.toml'\n{GOOD_CLAIM}", n=HEAD + GOOD_CLAIM)
    with pytest.raises(PaperError, match=r"n\.toml:\d+:1: unknown key 'claim'"):
        load_paper(paper)


def test_a_symbol_that_the_notation_declares_already(tmp_path):
    paper, _ = write(tmp_path, paper=f"{HEAD}{GOOD_CLAIM}".replace("[sym", "notation='n.toml'\n[sym"), n=HEAD)
    with pytest.raises(PaperError, match=r"paper\.toml:4:1: .* is declared in n\.toml too"):
        load_paper(paper)


def test_ids_are_unique_over_all_files(tmp_path):
    paths = write(tmp_path, a=HEAD + GOOD_CLAIM, b=HEAD + GOOD_CLAIM)
    with pytest.raises(PaperError, match=r"b\.toml:7:6: id '1' is used twice"):
        merge(paths)


# what a good file gives


def test_sections_share_a_notation_and_keep_their_own(tmp_path):
    section = "notation = 'n.toml'\nsection = '{0}'\n[symbols]\n'\\alpha' = {{ kind = '{1}' }}\n[[claim]]\n"
    section += "id = '{0}'\nprinted = '\\omega \\times \\alpha = - \\alpha \\times \\omega'\n"
    write(tmp_path, n=HEAD)
    paths = write(tmp_path, a=section.format("4.1", "vector"), b=section.format("4.2", "scalar"))
    paper = merge(paths)
    assert paper.title == "A paper" and paper.paths == tuple(paths)
    assert [(c.id, c.section) for c in paper.claims] == [("4.1", "4.1"), ("4.2", "4.2")]
    assert paper.claims[0].printed.statement is not None
    assert "scalar" in paper.claims[1].printed.ill_formed
    assert Name("\\alpha") not in paper.symbols.symbols
    (alone,) = write(
        tmp_path,
        c="title = 'x'\n[symbols]\na = { kind = 'vector' }\n" + "[[claim]]\nid='c'\nprinted='a = a'\n",
    )
    assert merge([alone, *paths]).symbols == paper.symbols


LINES = r"""id = "1"
inherits = ["1", "2"]
printed = '''
\begin{aligned}
\omega \times \rho &= -\rho \times \omega \\
                   &\quad + \omega - \omega, \\
\omega \cdot \rho &= \rho \cdot \omega
\end{aligned}'''
[[claim]]
id = "2"
printed = '\omega = \omega'
"""


def test_each_line_of_a_formula_is_a_claim(paper_of):
    paper = paper_of(claim(LINES))
    assert [c.id for c in paper.claims] == ["1.1", "1.2", "2"]
    assert paper.claims[0].inherits == ("1.1", "1.2", "2")
    assert paper.claims[1].printed.latex == r"\omega \cdot \rho  = \rho \cdot \omega"
    assert all(c.printed.statement is not None for c in paper.claims)
    assert [c.line for c in paper.claims] == [5, 5, 14]


def test_readings_and_corrections_go_line_by_line(paper_of):
    lines = r"'\begin{aligned} a &= b \\ b &= a \end{aligned}'"
    paper = paper_of(
        f"title = 'x'\n[symbols]\na = {{ kind = 'vector' }}\nb = {{ kind = 'vector' }}\n[[claim]]\nid = '1'\n"
        f"printed = {lines}\ncorrected = {lines}\n"
    )
    assert [c.corrected.latex for c in paper.claims] == ["a  = b", "b  = a"]


@pytest.mark.parametrize(
    ("keys", "expected"),
    [
        ("", Outcome.PROVED),
        ("corrected = '\\omega = \\omega'", Outcome.REFUTED),
        ("reading = '\\omega = \\omega'", Outcome.ILL_FORMED),
        ("reading = '\\omega = \\omega'\ncorrected = '\\omega = \\omega'", Outcome.ILL_FORMED),
        ("hypothesis = '\\omega \\neq 0'", Outcome.CONDITIONAL),
    ],
)
def test_the_keys_say_what_is_expected(keys, expected, paper_of):
    paper = paper_of(claim(f"id = 'x'\nprinted = '\\omega = 2\\omega'\n{keys}"))
    assert paper.claims[0].expected == expected


def test_ill_typed_as_printed_is_a_verdict_and_no_fault(paper_of):
    paper = paper_of(claim(r"id = 'x'" "\n" r"printed = '\omega = \omega \omega'"))
    assert "juxtaposition" in paper.claims[0].printed.ill_formed


def test_unreadable_formulas_get_a_verdict_only_with_a_reading(paper_of):
    paper = paper_of(claim("id = 'x'\nprinted = '\\omega = \\psi'\nreading = '\\omega = \\omega'"))
    assert "unknown symbol" in paper.claims[0].printed.ill_formed


def test_theorems_come_from_the_installed_paper_alone(tmp_path, monkeypatch):
    told = "id = 'T'\ntheorem = 'unique'\nstatement = 'It is itself.'\ngoal = '\\omega = \\omega'"
    (path,) = write(tmp_path, p=f"{HEAD}[[claim]]\n{told}\n")
    paper = InstalledPaper((path,), {"unique": Proven(Kernel())})
    assert merge(paper.files, paper.theorems).claims[0].proof.theorem == "unique"
    with pytest.raises(PaperError, match="none is installed for this file"):
        load_paper(path)


@pytest.mark.parametrize("key", ["theorem = 'unique'", "argued = 'In words.'"])
def test_a_proof_and_what_joins_it_need_a_goal(paper_of, key):
    with pytest.raises(PaperError, match="expected a goal beside it"):
        paper_of(claim(f"id = 'x'\n{key}\nstatement = 'One.'\nprinted = '\\omega = \\omega'"))


def test_the_hypothesis_of_a_formula_is_a_formula(paper_of):
    with pytest.raises(PaperError, match="hypothesis"):
        paper_of(claim("id = 'x'\nprinted = '\\omega = \\omega'\nhypothesis = '\\text{always}'"))


# orders


def test_orders_are_read_back():
    for text in ("n = 1..8", "m = 1..3, n = 1..4", "k_1 = 0..2"):
        assert str(Orders.parse(text)) == text


def test_orders_assign_every_combination_once():
    values = list(Orders.parse("m = 1..3, n = 0..4").assignments())
    assert len(values) == 15 == len({tuple(v.items()) for v in values})
    assert {v["m"] for v in values} == {1, 2, 3} and {v["n"] for v in values} == set(range(5))


FAMILY = r"""title = 'x'
[symbols]
'\Phi_n' = { kind = 'tensor' }
[[claim]]
id = 'x'
printed = '\operatorname{tr} \Phi_n = \operatorname{tr} \Phi_n^T, %s'
"""


def test_orders_that_the_formula_states_are_the_default(paper_of):
    orders = paper_of(FAMILY % r"n \geq 2").claims[0].orders
    assert [v["n"] for v in orders.assignments()] == [2, 3, 4, 5, 6]


def test_orders_must_stay_in_the_stated_range(paper_of):
    with pytest.raises(PaperError, match=r"paper\.toml:7:10: orders: n = 0\.\.3 leaves the range"):
        paper_of(FAMILY % r"n \geq 1" + "orders = 'n = 0..3'\n")


def test_range_that_holds_no_value_is_refused():
    from workbench.core.integer_expressions import Linear
    from workbench.language.reader import Range

    with pytest.raises(ValueError, match="no values lie within the ranges"):
        orders_within(None, [Range("n", Linear(3), Linear(1))])


def test_orders_of_one_variable_bounded_by_another():
    from workbench.core.integer_expressions import Linear
    from workbench.language.reader import Range

    stated = [Range("k", Linear(1), Linear.variable("n"))]
    orders = orders_within(Orders.parse("k = 1..3, n = 1..3"), stated)
    assert [(v["k"], v["n"]) for v in orders.assignments()] == [
        (1, 1),
        (1, 2),
        (1, 3),
        (2, 2),
        (2, 3),
        (3, 3),
    ]
    assert str(orders) == "k = 1..3, n = 1..3, k ≤ n"
    with pytest.raises(ValueError, match="values for n"):
        orders_within(Orders.parse("k = 1..3"), stated)
