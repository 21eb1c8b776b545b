"""What the claim files call printed is what the chapter prints, white space and alignment marks aside."""

import re
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
CHAPTER = ROOT.parent / "shared" / "chapter.md"
FILES = sorted((ROOT / "proofs" / "chapter").glob("[0-9]*.toml"))

pytestmark = pytest.mark.skipif(not CHAPTER.is_file(), reason="the chapter's text is not beside the checkout")


def squeezed(latex: str) -> str:
    return re.sub(r"\s|&|\\,", "", latex)


@pytest.mark.parametrize("file", FILES, ids=lambda f: f.stem)
def test_printed_forms_are_verbatim(file):
    text = squeezed(CHAPTER.read_text(encoding="utf-8"))
    claims = tomllib.loads(file.read_text(encoding="utf-8"))["claim"]
    printed = {claim["id"]: claim["printed"].strip("“”") for claim in claims if "printed" in claim}
    assert printed
    missing = [name for name, latex in printed.items() if squeezed(latex).rstrip(".,") not in text]
    assert not missing, (
        f"not in the chapter: {', '.join(missing)}; what is ours stands under `formula` or `goal`"
    )


def test_a_changed_sign_would_be_seen():
    text = squeezed(CHAPTER.read_text(encoding="utf-8"))
    assert squeezed(r"\det \Phi_2 = -(\boldsymbol{\omega} \times \dot{\boldsymbol{\omega}})^2") in text
    assert squeezed(r"\det \Phi_2 = +(\boldsymbol{\omega} \times \dot{\boldsymbol{\omega}})^2") not in text
