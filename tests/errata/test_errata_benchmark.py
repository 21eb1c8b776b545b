"""The public misprints: a few in each run, all of them with --slow; each row as expected.json has it."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from errata_cases import HERE, SECONDS, cases, is_same_formula, measured
from errata_table import differences, expected, summary

from tests.errata.__main__ import main
from workbench.context.claims import Notation
from workbench.context.read_formulas import read_statement
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.papers.notation_tables import extended

CASES = cases()

#: Quick ones: a refuted text, an ill-formed one, one that only a figure decides, a quotient, a text in rst.
QUICK = ("IM1", "AH4", "SS1", "JZ1", "LMD2")


def test_case_has_source_licence_and_corrections() -> None:
    for case in CASES:
        keys = ("id", "source", "licence", "wrong", "decidable", "right_before", "right_after", "correction")
        assert all(case.about.get(key) for key in keys), case.name
        assert case.about["id"] == case.name
        (before,) = (path for path in case.folder.glob("before.*") if path.suffix != ".toml")
        (after,) = (path for path in case.folder.glob("after.*") if path.suffix != ".toml")
        assert before.suffix == after.suffix and before.read_text() != after.read_text()


def test_corrections_are_lines_of_both_texts() -> None:
    for case in CASES:
        texts = [
            "\n".join(p.read_text() for p in case.folder.glob(f"{n}.[rtm][sed][txs]*"))
            for n in ("before", "after")
        ]
        for each in case.about["correction"]:
            assert each["printed"] in texts[0] and each["corrected"] in texts[1], case.name


@pytest.mark.parametrize("name", QUICK)
def test_quick_case_is_as_expected(name: str) -> None:
    (case,) = (case for case in CASES if case.name == name)
    row, _ = measured(case, seconds=10 * SECONDS)
    assert not differences([row], expected(HERE, drafted=False))


@pytest.mark.parametrize(
    ("file", "text", "said"),
    [
        ("before.toml", "source = 'before.tex'\n[symbols]\n'x' = \"vektor\"\n", "vektor"),
        ("before.toml", "source = 'before.tex'\n[symbols\n", "before.toml"),
        ("after.toml", "source = 'none.tex'\n", "none.tex"),
        ("case.toml", "id = 'IM1'\n[[correction]\n", "line 2"),
    ],
)
def test_damaged_case_is_named_and_ends_the_command(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], file: str, text: str, said: str
) -> None:
    shutil.copytree(HERE / "IM1", tmp_path / "IM1")
    (tmp_path / "IM1" / file).write_text(text, encoding="utf-8")
    assert main([str(tmp_path)]) == 2
    printed = capsys.readouterr()
    assert "IM1" in printed.err and said in printed.err and not printed.out
    assert not (tmp_path / "expected.json").exists()


@pytest.mark.slow
@pytest.mark.parametrize("drafted", [False, True], ids=["with a model", "drafted"])
def test_all_cases_are_as_expected(drafted: bool, capsys: pytest.CaptureFixture[str]) -> None:
    rows = [measured(case, drafted)[0] for case in CASES]
    with capsys.disabled():
        print(f"\n{summary(rows)}")
    assert not differences(rows, expected(HERE, drafted))


@pytest.mark.parametrize(
    ("one", "other", "same"),
    [
        ("a = b + c", "a = c + b", True),
        ("a = b + c", "b + c = a", True),
        ("a - b = c", "a = b + c", True),
        ("a = 2 b", "a = b", False),
        ("a = b (c + a)", "a = b c + b a", True),
        ("a = 0", "b = 0", False),
    ],
)
def test_formulas_are_compared_by_their_sides(one: str, other: str, same: bool) -> None:
    specs = {name: {"kind": "scalar"} for name in "abc"}
    notation = extended(Notation(SymbolTable(), Definitions(), {}), specs)
    first, second = (read_statement(latex, notation, None)[0] for latex in (one, other))
    assert is_same_formula(first, second) is same
