"""Commands that print one of their arguments as it stands: frames, colours, sizes."""

from __future__ import annotations

_BARE = "boxed fbox Aboxed mathrel mathbin mathord smash bbox tcboxmath ovalbox shadowbox"

#: Commands that colour, frame, scale or space their argument: the number of arguments before it.
WRAPPERS = {
    **dict.fromkeys(_BARE.split(), 0),
    **dict.fromkeys(("textcolor", "colorbox", "mathcolor", "scalebox", "raisebox", "parbox"), 1),
    **dict.fromkeys(("resizebox", "fcolorbox"), 2),
}
#: Those that set words: a formula in them stands between dollars.
OF_WORDS = frozenset({"parbox", "resizebox", "scalebox", "raisebox", "fcolorbox"})
MATH_SHIFTS = frozenset({"$", "\\(", "\\)", "\\[", "\\]"})
