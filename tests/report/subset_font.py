"""Makes the math font of the reports from STIX Two Math: `python tests/report/subset_font.py STIX2Math.otf`.

It needs fonttools and brotli. The licence asks that a modified font has another name and keeps its notices."""

from __future__ import annotations

import copy
import sys
from pathlib import Path
from typing import Any

from workbench.report import mathml
from workbench.source.typeset import glyphs

FONT = Path(mathml.__file__).parent / "font" / "workbench-math.woff2"
#: What MathML has beside the table of symbols: spaces, the invisible signs, and what is written into text.
OTHERS = " \u00a0\u2061\u2062\u2063√‖∣≠±·×−–→⇒⇔“”%"
LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789ıȷ"


def characters() -> set[str]:
    """All characters that a formula of a report can hold."""
    plain = set(LETTERS) | set("".join(glyphs.SYMBOLS.values())) | set("".join(glyphs.GREEK.values()))
    plain |= set("".join(glyphs.ACCENTS.values())) | set(OTHERS)
    variants = {mathml.in_variant(letter, variant) for letter in plain for variant in mathml.VARIANTS}
    return plain | variants


def _stretch_spacing_accents(font: Any) -> None:
    """Lets ˜ and ˆ grow as their combining twins do: browsers stretch the former only."""
    variants, names = font["MATH"].table.MathVariants, font.getBestCmap()
    made = dict(zip(variants.HorizGlyphCoverage.glyphs, variants.HorizGlyphConstruction, strict=True))
    for spacing, combining in ((0x2DC, 0x303), (0x2C6, 0x302)):
        grown = copy.deepcopy(made[names[combining]])
        grown.MathGlyphVariantRecord[0].VariantGlyph = names[spacing]
        made[names[spacing]] = grown
    order = sorted(made, key=font.getGlyphID)
    variants.HorizGlyphCoverage.glyphs = order
    variants.HorizGlyphConstruction = [made[name] for name in order]
    variants.HorizGlyphCount = len(order)


def subset(source: Path, target: Path) -> None:
    """Writes the part of the font that the characters need, under the font's new name."""
    from fontTools import subset as cutter
    from fontTools.ttLib import TTFont

    font = TTFont(source)
    _stretch_spacing_accents(font)
    options = cutter.Options()
    options.flavor, options.layout_features = "woff2", ["ssty", "dtls", "flac", "ccmp"]
    options.name_IDs, options.name_languages, options.hinting = (
        [0, 1, 2, 3, 4, 5, 6, 7, 13, 14],
        [0x409],
        False,
    )
    options.desubroutinize = True
    work = cutter.Subsetter(options)
    work.populate(text="".join(sorted(characters())))
    work.subset(font)
    for number, name in {
        1: "Workbench Math",
        3: "Workbench Math",
        4: "Workbench Math",
        6: "WorkbenchMath",
    }.items():
        font["name"].setName(name, number, 3, 1, 0x409)
    top = font["CFF "].cff
    top.fontNames = ["WorkbenchMath"]
    top.topDictIndex[0].FullName = top.topDictIndex[0].FamilyName = "Workbench Math"
    cutter.save_font(font, str(target), options)


if __name__ == "__main__":
    subset(Path(sys.argv[1]), FONT)
