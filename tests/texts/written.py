"""Small texts in several formats, with any letters: for laws that no format and no letter may change."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Grade, Outcome, Verdict
from workbench.papers import load_paper
from workbench.papers.texts.text_paper import TextPaper

FORMATS = ("tex", "md", "rst")
#: Letters for two vectors, four scalars and a constant.
ALPHABETS = (
    {"a": "a", "b": "b", "f": "f", "g": "g", "h": "h", "x": "x", "m": "m"},
    {"a": "u", "b": r"\mathbf{w}", "f": r"\alpha", "g": "k", "h": r"\beta", "x": r"\phi", "m": "c"},
    {"a": r"\xi", "b": "r_1", "f": "s", "g": "y", "h": "z", "x": r"\psi", "m": r"\mu"},
)
KINDS = {"a": "vector", "b": "vector", "f": "scalar", "g": "scalar", "h": "scalar", "x": "scalar"}


def renamed(latex: str, letters: dict[str, str]) -> str:
    """The formula with other letters: <a> stands for one."""
    return re.sub(r"<(\w)>(?=([A-Za-z])?)", lambda m: letters[m[1]] + " " * bool(m[2]), latex)


def heading(title: str, form: str) -> str:
    return {"tex": f"\\section{{{title}}}", "md": f"# {title}", "rst": f"{title}\n{'=' * len(title)}"}[form]


def display(latex: str, form: str) -> str:
    shapes = {
        "tex": "\\begin{equation}\n%s\n\\end{equation}",
        "md": "$$\n%s\n$$",
        "rst": ".. math::\n\n   %s\n",
    }
    return shapes[form] % latex


def inline(latex: str, form: str) -> str:
    return f":math:`{latex}`" if form == "rst" else f"${latex}$"


def line_of(latex: str, text: str) -> str:
    """The place of a formula that stands on a line of its own, as a model names it."""
    return f"line {[line.strip() for line in text.splitlines()].index(latex) + 1}"


def text_of(parts: Sequence[str], form: str) -> str:
    body = "\n\n".join(parts) + "\n"
    return f"\\begin{{document}}\n{body}\\end{{document}}\n" if form == "tex" else body


def model_of(letters: dict[str, str], form: str, more: str = "", flags: str = "") -> str:
    symbols = [f"'{letters[mark]}' = {{ kind = '{kind}'{flags} }}" for mark, kind in KINDS.items()]
    symbols.append(f"'{letters['m']}' = {{ kind = 'scalar', constant = true }}")
    return f"source = 'p.{form}'\n[symbols]\n" + "\n".join(symbols) + f"\n{more}"


def paper_of(folder: Path, text: str, model: str, form: str) -> TextPaper:
    (folder / f"p.{form}").write_text(text)
    (folder / "p.toml").write_text(model)
    return load_paper(folder / "p.toml")


def verdicts(folder: Path, text: str, model: str, form: str = "md") -> list[Verdict]:
    """The verdicts on the displays of the text, in their order. model: with or without its `source`."""
    source = "" if model.lstrip().startswith("source") else f"source = 'p.{form}'\n"
    paper = paper_of(folder, text, source + model, form)
    assert not paper.faults
    return [result.verdict for result in judge_paper(paper, motions=False, jobs=1)]


def outcomes(folder: Path, text: str, model: str, form: str = "md") -> list[str]:
    """The outcomes of `verdicts`, as `told` gives them."""
    return [told(each) for each in verdicts(folder, text, model, form)]


def shown(*displays: str) -> str:
    """The displays as Markdown, one paragraph each."""
    return "\n\n".join(f"$$ {each} $$" for each in displays)


def symbols_of(kinds: dict[str, str]) -> str:
    """The table [symbols] of a model."""
    return "[symbols]\n" + "".join(f"'{name}' = '{kind}'\n" for name, kind in kinds.items())


def told(verdict: Verdict) -> str:
    """Returns the outcome, with "doubtful" for a refutation that is no error and "said" for a formula that claims
    nothing."""
    if verdict.outcome is Outcome.REFUTED and verdict.grade is not Grade.ERROR:
        return "doubtful"
    is_said = verdict.outcome is Outcome.DEFINITION and verdict.code is not None
    return "said" if is_said else str(verdict.outcome)


def doubts(verdict: Verdict) -> str:
    """Returns all that is said beside the outcome, without the dollar signs around formulas."""
    return "; ".join([verdict.reason or "", *verdict.unless]).replace("$", "")
