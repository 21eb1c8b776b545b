"""The library is compiled once for each version of it, whatever an earlier run has left."""

import pytest

from workbench.certificates import coqc

#: What stands in its directory before: none, an empty one, a part of it, all of it.
LEFT = {
    "none": None,
    "empty": (),
    "without the last": coqc.LIBRARY[:-1],
    "without the first": coqc.LIBRARY[1:],
    "whole": coqc.LIBRARY,
}


@pytest.mark.parametrize("left", LEFT)
def test_the_library_is_compiled_once(left, tmp_path, monkeypatch):
    compiled = []

    def compile_all(place):
        compiled.append(place)
        for name in coqc.LIBRARY:
            (place / f"{name}.vo").touch()

    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(coqc, "_fingerprint", lambda names: "0" * 64)
    monkeypatch.setattr(coqc, "_compile", compile_all)
    if LEFT[left] is not None:
        place = coqc.memory() / ("0" * 16)
        place.mkdir(parents=True)
        for name in LEFT[left]:
            (place / f"{name}.vo").touch()
    places = {coqc.library() for _ in range(3)}
    assert len(compiled) == (left != "whole")
    assert [sorted(file.stem for file in place.iterdir()) for place in places] == [sorted(coqc.LIBRARY)]
    assert list(coqc.memory().iterdir()) == list(places)


def test_a_long_certificate_is_checked_by_itself(monkeypatch):
    short, long = "Theorem a : True.\n", "Theorem b : True.\n" + "(* *) " * 40
    monkeypatch.setattr(coqc, "recall", lambda text: None)
    monkeypatch.setattr(coqc, "LENGTH", 100)
    texts = [f"Import.\n{text}(* {i} *)" for i, text in enumerate((short, long, short, short, long))]
    batches = coqc.in_batches(texts)
    assert [text for batch in batches for text in batch] == texts
    assert [len(batch) for batch in batches] == [1, 1, 2, 1]


@pytest.mark.parametrize(
    ("said", "asked"),
    [
        (None, True),
        (coqc.Checked(True, (), "", 1.0), False),
        (coqc.Checked(False, (), "Error: it is false", 1.0), False),
        (coqc.Checked(False, (), f"{coqc.UNFINISHED} in 1 s", 1.0), True),
    ],
)
def test_an_unfinished_certificate_is_checked_again(monkeypatch, said, asked):
    text = "From Kin Require Import Dual.\n\nTheorem t : True.\n"
    monkeypatch.setattr(coqc, "recall", lambda text: said)
    assert coqc.in_batches([text]) == ([[text]] if asked else [])
