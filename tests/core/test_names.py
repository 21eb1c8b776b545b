"""Names of symbols."""

from __future__ import annotations

from itertools import permutations

import pytest

from workbench.core.names import Name
from workbench.language.naming.declarations import read_key

STYLES = ("\\underline", "\\hat", "\\boldsymbol", "\\mathrm", "\\mathsf")


@pytest.mark.parametrize("styles", list(permutations(STYLES, 2)), ids="".join)
def test_order_of_styles_is_that_of_the_printed_name(styles: tuple[str, str]) -> None:
    name = Name.styled(styles, "r")
    assert Name.styled(name.styles, "r") == name == Name.styled(reversed(styles), "r")
    assert read_key(str(name))[0] == name
