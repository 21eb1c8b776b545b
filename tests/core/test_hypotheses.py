"""Conditions of verdicts: which parts are formulas is known, whatever stands in the words."""

from __future__ import annotations

import json

from hypothesis import given
from hypothesis import strategies as st

from workbench.core.hypotheses import Hypothesis, Phrase
from workbench.report.mixed_prose import runs_of

LATEX = st.text(alphabet="ab=0{}_^ ", min_size=1).filter(str.strip)
WORDS = st.sampled_from(["the axis is fixed", "“r is constant”", "$r$ is constant", "(5)"])
PHRASES = st.one_of(LATEX.map(Phrase), WORDS.map(lambda words: Phrase(words, is_words=True)))


@given(st.lists(PHRASES, min_size=1, unique=True))
def test_formulas_of_a_condition_are_mathematics(phrases: list[Phrase]) -> None:
    found = Hypothesis.together([Hypothesis(tuple(phrases))], *phrases)
    assert found.phrases == tuple(phrases)
    assert Hypothesis.from_list(json.loads(json.dumps(found.to_list()))) == found
    whole = ", ".join(each.text for each in phrases)
    if not found.has_words:
        assert (str(found), found.prose) == (whole, f"${whole}$")
        return
    assert str(found) == found.prose
    expected = ", ".join(each.text if each.is_words else f"${each.text}$" for each in phrases)
    assert runs_of(found.prose) == runs_of(expected)
