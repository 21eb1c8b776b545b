"""Proposals on a terminal: the difference in colours or in marks, the bar, and what an interrupt leaves."""

from __future__ import annotations

import io
import sys
from contextlib import contextmanager

import pytest
from click.testing import CliRunner
from rich.console import Console

from workbench import check
from workbench.app.commands import proposal_text as shown
from workbench.app.commands.commands import main
from workbench.app.commands.proposal_text import difference_text, proposed_lines, repair_lines, search_bar
from workbench.context.claim_parts import Sentence
from workbench.context.claims import Claim, Formula
from workbench.core.verdict import Outcome
from workbench.prover.results.proposed_form import Proposed
from workbench.repair.propose.proposal import Repair
from workbench.repair.propose.search_limits import Limits

PARTS = [{"same": "a ="}, {"printed": "", "proposed": "2"}, {"same": "b"}, {"printed": "+ c", "proposed": ""}]


def rendered(text, **options):
    stream = io.StringIO()
    Console(file=stream, width=200, **options).print(text, end="")
    return stream.getvalue()


def test_without_colours_the_difference_is_marked():
    assert rendered(difference_text(PARTS, coloured=False)) == "a = {+2+} b [-+ c-]"


def test_with_colours_it_is_not():
    text = difference_text(PARTS, coloured=True)
    assert text.plain == "a = 2 b + c"
    in_colour = rendered(text, force_terminal=True, color_system="standard", no_color=False)
    assert "\x1b[1;4;32m2\x1b[0m" in in_colour and "\x1b[9;31m+ c\x1b[0m" in in_colour


def test_a_formula_shows_its_repair_in_words_marks_and_markdown():
    found = check(r"a \times b = b \times a", symbols={"a": "vector", "b": "vector"}).repair()
    (first, *_) = found.proposals
    assert first.latex in str(found) and "{+" in str(found)
    assert r"{\color{green}{" in found._repr_markdown_() and first.edit in found._repr_markdown_()
    lines = [line.plain for line in repair_lines(found)]
    assert sum("difference" in line for line in lines) == len(found.proposals)


def test_a_formula_of_ours_for_a_sentence_is_no_printed_one():
    said = Claim("1", Formula("a = b"), None, sentence=Sentence(ours=True))
    proposed = [Proposed("a = c", "$b$ becomes $c$", list(PARTS), Outcome.PROVED)]
    lines = [line.plain.split() for line in proposed_lines(said, proposed, coloured=False)]
    assert lines[:3] == [["1"], ["our", "formula", "a", "=", "b"], ["proposed", "a", "=", "c"]]


def test_an_interrupted_search_says_so_and_keeps_what_it_has(monkeypatch):
    @contextmanager
    def impatient(name, limits):
        def tick(found):
            if found.candidates > 20:
                raise KeyboardInterrupt

        yield tick

    monkeypatch.setattr(shown, "search_bar", impatient)
    done = CliRunner().invoke(main, ["repair", "64.split"])
    assert done.exit_code == 1
    assert "the search was not finished" in done.stdout


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.mark.parametrize("stream", [Terminal, io.StringIO])
def test_the_bar_is_for_terminals(stream, monkeypatch):
    monkeypatch.setattr(sys, "stderr", stream())
    found = Repair(None, candidates=101)
    with search_bar("61", Limits(candidates=200)) as advance:
        advance(found)
    assert ("repairing 61" in sys.stderr.getvalue()) == (stream is Terminal)
