"""What a text includes is read, or a warning says where it is left out and what to do."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench.source.documents import Text, read_text


def _read(tmp_path: Path, content: str, name: str = "p.tex") -> Text:
    (tmp_path / "text" / "inner").mkdir(parents=True, exist_ok=True)
    (tmp_path / "outside.tex").write_text(r"\[ a = b \]")
    (tmp_path / "text" / "beside.tex").write_text(r"\[ a = b \]")
    (tmp_path / "text" / "inner" / "deeper.tex").write_text(r"\[ a = b \]")
    path = tmp_path / "text" / name
    path.write_text(content.replace("FOLDER", str(tmp_path)))
    return read_text(path)


def _displays(text: Text) -> list[str]:
    return ["".join(display.latex.split()) for display in text.displays]


BESIDE = [
    r"\input{beside}", r"\input{beside.tex}", r"\input beside ", r'\input{"beside"}', r"\include{beside}", r"\subfile{beside}",
    r"\subfileinclude{beside}", r"\import{inner/}{deeper}", r"\subimport{inner/}{deeper}", r"\includefrom{inner/}{deeper}",
    r"\newcommand{\folder}{inner}\input{\folder/deeper}", r"\InputIfFileExists{beside}{}{\[ c = d \]}", r"\input{inner/../beside}",
]  # fmt: skip


@pytest.mark.parametrize("written", BESIDE)
def test_a_file_below_the_text_is_read(tmp_path: Path, written: str) -> None:
    text = _read(tmp_path, rf"{written} \[ c = c \]")
    assert _displays(text) == ["a=b", "c=c"] and text.warnings == []


@pytest.mark.parametrize("where", ["../outside", "../outside.tex", "FOLDER/outside", "FOLDER/outside.tex"])
@pytest.mark.parametrize("command", ["input", "include", "subfile", "subfileinclude"])
def test_a_file_outside_is_read_with_a_warning(tmp_path: Path, command: str, where: str) -> None:
    text = _read(tmp_path, f"Text.\n\\{command}{{{where}}} \\[ c = c \\]")
    assert _displays(text) == ["a=b", "c=c"]
    (warning,) = text.warnings
    assert "p.tex:2:" in str(warning)
    assert "outside" in warning.message and "copy it beside the text" in warning.message


@pytest.mark.parametrize("folder", ["../", "FOLDER/"])
@pytest.mark.parametrize("command", ["import", "subimport", "includefrom", "inputfrom", "subincludefrom"])
def test_a_folder_outside_is_read_with_a_warning(tmp_path: Path, command: str, folder: str) -> None:
    text = _read(tmp_path, f"\\{command}{{{folder}}}{{outside}} \\[ c = c \\]")
    assert _displays(text) == ["a=b", "c=c"]
    assert "it is read, but copy it beside the text" in text.warnings[0].message


@pytest.mark.parametrize("where", ["../gone", "FOLDER/gone", "gone", "~/gone", "$HOME/gone", r"\dir/gone"])
@pytest.mark.parametrize("command", ["input", "include", "subfile"])
def test_a_missing_file_is_reported(tmp_path: Path, command: str, where: str) -> None:
    text = _read(tmp_path, f"Text.\n\\{command}{{{where}}} \\[ c = c \\]")
    assert _displays(text) == ["c=c"]
    assert (
        text.warnings[0].line == 2
        and "gone' beside this one; what it holds is not judged" in text.warnings[0].message
    )


def test_a_missing_style_in_a_folder_is_reported(tmp_path: Path) -> None:
    text = _read(tmp_path, r"\usepackage{../gone}\usepackage{amsmath}\[ c = c \]")
    assert [warning.message for warning in text.warnings] == ["no style or class '../gone' beside this one"]


NOT_READ = [
    ("p.rst", ".. include:: {}\n\n.. math:: c = c\n"),
    ("p.md", "```{{include}} {}\n```\n\n$$c = c$$\n"),
    ("p.md", ":::{{include}} {}\n:::\n\n$$c = c$$\n"),
    ("p.md", "{{{{#include {}}}}}\n\n$$c = c$$\n"),
    ("p.qmd", "{{{{< include {} >}}}}\n\n$$c = c$$\n"),
    ("p.md", '--8<-- "{}"\n\n$$c = c$$\n'),
    ("p.md", "{{% include_relative {} %}}\n\n$$c = c$$\n"),
]


@pytest.mark.parametrize(
    ("where", "what_to_do"),
    [
        ("../outside.tex", "check that file by itself"),
        ("gone.md", "no such file"),
        ("/gone.md", "no such file"),
    ],
)
@pytest.mark.parametrize(("name", "written"), NOT_READ)
def test_an_include_outside_of_tex_is_reported(
    tmp_path: Path, name: str, written: str, where: str, what_to_do: str
) -> None:
    text = _read(tmp_path, f"Text.\n\n{written.format(where)}", name)
    assert _displays(text) == ["c=c"]
    (warning,) = text.warnings
    assert warning.line == 3 and repr(where) in warning.message and what_to_do in warning.message
