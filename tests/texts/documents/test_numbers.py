"""Equation numbers are those that LaTeX gives. The figures here are pdflatex's own (texlive 2022), by \\newlabel."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from workbench.source.documents import read_text

ARTICLE = r"""
\documentclass{article}
\usepackage{amsmath,amsthm}
\newtheorem{thm}{Theorem}[section]
\newcommand{\beq}{\begin{equation}}\newcommand{\eeq}{\end{equation}}
\newenvironment{eqn}[1][x]{\begin{equation}\label{env:#1}}{\end{equation}}
\newcommand\numberthis{\addtocounter{equation}{1}\tag{\theequation}}
\begin{document}
\section{A}
\begin{equation}\label{e1} a=b \end{equation}
\begin{thm}\label{t1} x \begin{equation}\label{e2} a=b \end{equation}\end{thm}
\begin{align} a&=b \label{al1}\\ c&=d \notag \\ e&=f \label{al2} \\ g &= h \tag{T}\label{al3}\\ i&=j\label{al4}\end{align}
\begin{align*} a&=b \\ c&=d \numberthis \label{nt1} \end{align*}
\begin{subequations}\label{sub}\begin{align} a&=b\label{s1}\\c&=d\label{s2}\end{align}\begin{equation}\label{s3} x \end{equation}\end{subequations}
\begin{equation}\label{after} x \end{equation}
\begin{gather} a=b\label{g1}\\ c=d\nonumber\\ e\label{g2}\end{gather}
\begin{multline}\label{m1} a \\ b \\ c\end{multline}
\begin{eqnarray} a&=&b\label{ea1}\\ c&=&d\nonumber\\ e&=&f\label{ea2}\end{eqnarray}
\begin{alignat}{2} a&=b&\quad c&=d\label{aa1}\\ a&=b&\quad c&=d\label{aa2}\end{alignat}
\begin{equation}\begin{split} a&=b\\&=c\end{split}\label{sp1}\end{equation}
\begin{align} a&=b\label{i1}\\ \intertext{and so} c&=d\label{i2}\end{align}
\beq\label{beq} x\eeq
\begin{eqn}[q] y \end{eqn}
\[ a = b \tag{T1}\label{tag1} \]
\setcounter{equation}{40}
\begin{equation}\label{set} a\end{equation}
\numberwithin{equation}{section}
\begin{equation}\label{nw} a\end{equation}
\section{B}
\begin{equation}\label{nw2} a\end{equation}
\subsection{B1}\label{secb1}
\renewcommand{\theequation}{S\arabic{equation}}
\begin{align} a\label{ta}\\ b\label{tb}\\ \end{align}
\begin{equation}\label{last} a\end{equation}
\appendix
\section{App}\label{app}
\renewcommand{\theequation}{\thesection.\roman{equation}}
\begin{equation}\label{ap1} a\end{equation}
% \begin{equation}\label{comment} a\end{equation}
\begin{verbatim}
\begin{equation}\label{verbatim} a\end{equation}
\end{verbatim}
\iffalse \begin{equation}\label{false} a\end{equation} \fi
\verb|\begin{equation}\label{verb}|
\begin{equation}\label{end} a\end{equation}
\end{document}
\begin{equation}\label{beyond} a\end{equation}
"""
ARTICLE_NUMBERS = {
    "e1": "1", "t1": "1.1", "e2": "2", "al1": "3", "al2": "4", "al3": "T", "al4": "5", "nt1": "6", "sub": "7",
    "s1": "7a", "s2": "7b", "s3": "7c", "after": "8", "g1": "9", "g2": "10", "m1": "11", "ea1": "12",
    "ea2": "13", "aa1": "14", "aa2": "15", "sp1": "16", "i1": "17", "i2": "18", "beq": "19", "env:q": "20",
    "tag1": "T1", "set": "41", "nw": "1.42", "nw2": "2.1", "secb1": "2.1", "ta": "S2", "tb": "S3", "last": "S5",
    "app": "A", "ap1": "A.i", "end": "A.ii",
}  # fmt: skip

REPORT = r"""
\documentclass{report}
\usepackage{amsmath,mathtools,IEEEtrantools}
\begin{document}
\begin{equation}\label{e0} a\end{equation}
\chapter{One}
\begin{equation}\label{e1} a\end{equation}
\section{s}\label{s1}
\begin{IEEEeqnarray}{rCl} a&=&b\label{i1}\\ c&=&d\IEEEyessubnumber\label{i2}\\ e&=&f\IEEEyessubnumber\label{i3}\\ g&=&h\IEEEnonumber\\ k&=&l\label{i4}\end{IEEEeqnarray}
\chapter{Two}
\begin{subequations}\begin{gather} a\label{a1}\\ b\label{a2}\end{gather}\end{subequations}
\counterwithout{equation}{chapter}
\begin{equation}\label{cw} a\end{equation}
\begin{subeqnarray} a&=&b\label{se1}\\ c&=&d\label{se2}\end{subeqnarray}
\appendix
\chapter{A}
\begin{equation}\label{ca} a\end{equation}
\end{document}
"""
REPORT_NUMBERS = {
    "e0": "1", "e1": "1.1", "s1": "1.1", "i1": "1.2", "i2": "1.2a", "i3": "1.2b", "i4": "1.3", "a1": "2.1a",
    "a2": "2.1b", "cw": "2", "se1": "3a", "se2": "3b", "ca": "4",
}  # fmt: skip


AMSBOOK = r"""
\documentclass{amsbook}
\usepackage{amsmath}
\begin{document}
\frontmatter
\chapter{F}
\begin{equation}\label{f1} a\end{equation}
\mainmatter
\chapter{A}
\section{S}
\begin{equation}\label{a1} a\end{equation}
\numberwithin{equation}{section}
\begin{equation}\label{a2} a\end{equation}
\appendix
\begin{equation}\label{b1} a\end{equation}
\chapter{B}
\begin{equation}\label{b2} a\end{equation}
\section{T}
\begin{equation}\label{b3} a\end{equation}
\end{document}
"""
AMSBOOK_NUMBERS = {"f1": "1", "a1": "2", "a2": "1.3", "b1": "0.4", "b2": "0.1", "b3": "1.1"}

SCRBOOK = r"""
\documentclass{scrbook}
\usepackage{amsmath}
\begin{document}
\begin{equation}\label{f0} a\end{equation}
\chapter{A}
\begin{equation}\label{a1} a\end{equation}
\appendix
\begin{equation}\label{b1} a\end{equation}
\chapter{B}
\begin{equation}\label{b2} a\end{equation}
\end{document}
"""
SCRBOOK_NUMBERS = {"f0": "0.1", "a1": "1.1", "b1": ".2", "b2": "A.1"}

DEPTH = r"""
\documentclass{article}
\usepackage{amsmath}
\numberwithin{equation}{subsection}
\setcounter{secnumdepth}{1}
\begin{document}
\section{A}
\subsection{B}
\begin{equation}\label{a1} a\end{equation}
\setcounter{secnumdepth}{2}
\subsection{B}
\begin{equation}\label{a2} a\end{equation}
\appendix
\begin{equation}\label{a3} a\end{equation}
\section{C}
\begin{equation}\label{a4} a\end{equation}
\end{document}
"""
DEPTH_NUMBERS = {"a1": "1.0.1", "a2": "1.1.1", "a3": ".0.2", "a4": "A.0.1"}

#: One body for many classes: what each prints, and what its starred sections, front matter and appendix do.
SECTIONED = r"""
\begin{equation}\label{e0} a\end{equation}
\section{A}\label{s1}
\begin{equation}\label{e1} a\end{equation}
\subsection{B}\label{s2}\subsubsection{C}\label{s3}
\section*{D}\subsection{E}\label{s4}
\begin{equation}\label{e2} a\end{equation}
\section{F}\label{s5}
\appendix
\begin{equation}\label{e3} a\end{equation}
\section{G}\label{s6}
\begin{equation}\label{e4} a\end{equation}
\end{document}
"""
CHAPTERS = r"""
\frontmatter
\begin{equation}\label{e0} a\end{equation}
\chapter{A}\section{B}
\begin{equation}\label{e1} a\end{equation}
\mainmatter\chapter{C}\label{c1}\section{D}
\begin{equation}\label{e2} a\end{equation}
\section*{D}\subsection{E}
\begin{equation}\label{e3} a\end{equation}
\backmatter\chapter{F}
\begin{equation}\label{e4} a\end{equation}
\end{document}
"""
ONE_APPENDIX = r"""
\section{One}\label{s1}
\appendix
\begin{equation}a\label{e1}\end{equation}
\section{Proof}\label{s2}
\subsection{Sub}\label{s3}\subsection{Sub}\label{s4}\subsubsection{Sub}\label{s5}
\begin{equation}a\label{e2}\end{equation}
\section{Another}\label{s6}
\end{document}
"""
UNNUMBERED = r"""
\chapter{One}\label{c1}
\section{A}\subsection{B}\label{s1}
\begin{equation}a\label{e1}\end{equation}
\section*{C}\label{s2}
\chapter*{D}\label{c2}
\setsecnumdepth{subsection}\section{E}\label{s3}\subsection{F}\label{s4}
\setsecnumdepth{chapter}\section{G}\label{s5}
\begin{equation}a\label{e2}\end{equation}
\appendix\chapter{H}\label{c3}\section{I}\label{s6}
\begin{equation}a\label{e3}\end{equation}
\backmatter\chapter{J}\section{K}\label{s7}
\end{document}
"""
OF_NOTHING = r"\counterwithout{equation}{section}\begin{equation}\label{e1} a\end{equation}\end{document}"


def of_class(name: str, body: str, numbers: str, preamble: str = "") -> tuple[str, dict[str, str]]:
    """`numbers`: those of the labels in their order."""
    text = rf"\documentclass{{{name}}}\usepackage{{amsmath}}{preamble}\begin{{document}}{body}"
    return text, dict(zip(re.findall(r"\\label\{(\w+)\}", body), numbers.split(","), strict=True))


WITHIN = r"\numberwithin{equation}{section}"
CLASSES = {
    "beamer": of_class("beamer", SECTIONED, "0.1,1,1.1,1,1,1,2.1,3,3.1,4,4.1", WITHIN),
    "scrartcl": of_class("scrartcl", SECTIONED, "0.1,1,1.1,1.1,1.1.1,1.1,1.1,2,.1,A,A.1", WITHIN),
    "elsarticle": of_class("elsarticle", SECTIONED, "1,1,2,1.1,1.1.1,1.2,3,2,.1,A,A.1"),
    "llncs": of_class("llncs", SECTIONED, "1,1,2,1.1,1.1,1.2,3,2,4,A,5"),
    "scrbook": of_class("scrbook", CHAPTERS, "1,1,1,1.1,1.2,1"),
    "amsbook": of_class("amsbook", CHAPTERS, "1,2,2,3,4,5"),
    "memoir": of_class("memoir", CHAPTERS, "1,2,1,1.1,1.2,1.3"),
    "revtex4-2": of_class("revtex4-2", SECTIONED, "1,I,2,I A,I A 1,I B,3,II,4,A,A1"),
    "memoir without numbers": of_class(
        "memoir", UNNUMBERED, "1,1.1,1.1,1.1,1.1,1.2,1.2.1,1.2.1,1.2,A,A,A.1,A"
    ),
    "counterwithout": of_class("article", OF_NOTHING, "1"),
    "IEEEtran with one appendix": of_class("IEEEtran", ONE_APPENDIX, "I,1,A,A,B,B1,2,B1"),
    "IEEEtran": of_class("IEEEtran", SECTIONED, "1,I,2,I-A,I-A1,I-B,3,II,4,A,5"),
}

DOCUMENTS = {
    "article": (ARTICLE, ARTICLE_NUMBERS),
    "report": (REPORT, REPORT_NUMBERS),
    "amsbook": (AMSBOOK, AMSBOOK_NUMBERS),
    "scrbook": (SCRBOOK, SCRBOOK_NUMBERS),
    "depth": (DEPTH, DEPTH_NUMBERS),
}


@pytest.mark.parametrize(("text", "numbers"), (DOCUMENTS | CLASSES).values(), ids=DOCUMENTS | CLASSES)
def test_every_label_has_the_number_that_latex_gives(
    tmp_path: Path, text: str, numbers: dict[str, str]
) -> None:
    path = tmp_path / "paper.tex"
    path.write_text(text)
    assert read_text(path).labels == numbers


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="no pdflatex")
@pytest.mark.parametrize(("text", "numbers"), (DOCUMENTS | CLASSES).values(), ids=DOCUMENTS | CLASSES)
def test_pdflatex_agrees(tmp_path: Path, text: str, numbers: dict[str, str]) -> None:
    path = tmp_path / "paper.tex"
    path.write_text(text)
    command = ["pdflatex", "-draftmode", "-interaction=batchmode", path.name]
    done = subprocess.run(command, cwd=tmp_path, check=False, capture_output=True, timeout=120)
    if b".cls' not found" in done.stdout + path.with_suffix(".log").read_bytes():
        pytest.skip("this class is not installed")
    aux = re.sub(r"\\mbox\s*\{(.*?)\}", r"\1", path.with_suffix(".aux").read_text())
    aux = re.sub(r"\\M@TitleReference |Appendix \\nobreakspace\s*\{\}", "", aux)
    told = re.findall(r"\\newlabel\{([^}]*)\}\{\{\{?([^{}]*)\}", aux.replace(r"\,", " "))
    assert {label: number for label, number in told if label in numbers} == numbers


def test_a_document_that_includes_itself_is_read_once(tmp_path: Path) -> None:
    (tmp_path / "a.tex").write_text(r"\[ a = b \]\input{b}")
    (tmp_path / "b.tex").write_text(r"\[ c = d \]\input{a}\input{b}")
    text = read_text(tmp_path / "a.tex")
    assert [display.latex for display in text.displays] == ["a = b", "c = d"]
    assert ["includes itself" in warning.message for warning in text.warnings] == [True, True]
