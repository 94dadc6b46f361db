"""Make the math font that pages carry: a subset of STIX Two Math as WOFF2.

Browsers stretch brackets only with a font that has an OpenType MATH table, and few machines have one. The font is
published under the SIL Open Font License; a copy comes inside the package `ziamath`. To make the subset again, in an
environment of its own:

    pip install fonttools brotli ziamath
    python tools/subset_font.py

or name another copy: `python tools/subset_font.py STIXTwoMath-Regular.ttf`. The result is the same, byte for byte,
for the same font and the same fonttools. The pages use the file in templates/html/fonts as it is; nothing of this
is needed to run the program.
"""

from __future__ import annotations

import sys
from importlib.util import find_spec
from pathlib import Path

from fontTools.misc.transform import Scale
from fontTools.pens.transformPen import TransformPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

TARGET = Path(__file__).parent.parent / "templates" / "html" / "fonts" / "solve-math.woff2"

LATIN = [*range(0x20, 0x7F), *range(0xA0, 0x100)]
GREEK = [*range(0x391, 0x3AA), *range(0x3B1, 0x3CA), 0x3D1, 0x3D5, 0x3D6, 0x3F1, 0x3F5]
ACCENTS = [*range(0x300, 0x30D), 0x338, 0x20D7, 0x20DB, 0x2C6, 0x2C7, 0x2D8, 0x2D9, 0x2DC, 0x131, 0x237]
PUNCTUATION = [0x2009, 0x2010, 0x2013, 0x2014, 0x2016, 0x2018, 0x2019, 0x201C, 0x201D, 0x2026, 0x2032, 0x2033, 0x2034]
SCRIPT_AND_BLACKBOARD = [
    *[0x2102, 0x210B, 0x210E, 0x210F, 0x2110, 0x2111, 0x2112, 0x2113, 0x2115, 0x2119, 0x211A, 0x211B, 0x211C, 0x211D],
    *[0x2124, 0x212C, 0x2130, 0x2131, 0x2133, *range(0x1D49C, 0x1D4B6), *range(0x1D538, 0x1D552)],
]
LETTERS = [
    *range(0x1D400, 0x1D49C),  # bold, italic, bold italic Latin
    *range(0x1D6A4, 0x1D7CC),  # dotless i and j, bold, italic, bold italic Greek
    *range(0x1D7CE, 0x1D7D8),  # bold digits
]
OPERATORS = [
    *[0x2190, 0x2191, 0x2192, 0x2193, 0x2194, 0x21A6, 0x21D0, 0x21D2, 0x21D4, 0x21CC, 0x27F5, 0x27F6],
    *[0x2200, 0x2202, 0x2203, 0x2205, 0x2206, 0x2207, 0x2208, 0x2209, 0x220B, 0x220F, 0x2211, 0x2212, 0x2213],
    *[0x2217, 0x2218, 0x221A, 0x221D, 0x221E, 0x2220, 0x2223, 0x2225, 0x2227, 0x2228, 0x2229, 0x222A, 0x222B, 0x222C],
    *[0x222E, 0x2234, 0x2235, 0x223C, 0x2243, 0x2245, 0x2248, 0x2254, 0x225C, 0x2260, 0x2261, 0x2264, 0x2265, 0x226A],
    *[0x226B, 0x227A, 0x227B, 0x227C, 0x227D, 0x2282, 0x2283, 0x2286, 0x2287, 0x2295, 0x2297, 0x22A4, 0x22A5, 0x22BA],
    *[0x22C2, 0x22C3, 0x22C5, 0x22C6, 0x22EE, 0x22EF, 0x22F1, 0x2A7D, 0x2A7E, 0x2061, 0x2062, 0x2020],
]
FENCES = [*range(0x2308, 0x230C), 0x27E8, 0x27E9, 0x23DE, 0x23DF, 0x203E]

REPERTOIRE = [
    *(LATIN + GREEK + ACCENTS + PUNCTUATION),
    *(SCRIPT_AND_BLACKBOARD + LETTERS + OPERATORS + FENCES),
]

WIDEST_ROOT = 900
"""Width of a root sign of any height, in thousandths of an em: Chromium makes room for the widest beside every root."""


def narrow_roots(font: TTFont) -> None:
    """Narrow the tall variants and the pieces of the root sign to the width above."""
    variants = font["MATH"].table.MathVariants
    construction = variants.VertGlyphConstruction[variants.VertGlyphCoverage.glyphs.index(font.getBestCmap()[0x221A])]
    names = [record.VariantGlyph for record in construction.MathGlyphVariantRecord]
    names += [record.glyph for record in construction.GlyphAssembly.PartRecords]
    glyphs = font.getGlyphSet()
    for name in names:
        width, left = font["hmtx"][name]
        factor = min(1.0, WIDEST_ROOT / width)
        pen = TTGlyphPen(glyphs)
        glyphs[name].draw(TransformPen(pen, Scale(factor, 1)))
        font["glyf"][name] = pen.glyph()
        font["hmtx"][name] = (round(width * factor), round(left * factor))


def subset(font: Path, target: Path) -> int:
    """Write the subset and return its size in bytes. Variants of stretchy glyphs stay, by way of the MATH table."""
    options = Options()
    options.flavor = "woff2"
    options.layout_features = ["ssty", "dtls", "mark", "mkmk", "kern"]
    options.hinting = False
    options.glyph_names = False
    options.name_IDs = [0, 1, 2, 4, 5, 6, 7, 13, 14]  # the licence stays with the font
    options.recalc_timestamp = False
    options.drop_tables += ["DSIG"]
    with TTFont(font, recalcTimestamp=False) as source:
        narrow_roots(source)
        source["OS/2"].fsSelection |= 1 << 7  # lines of text as high on Windows as elsewhere
        subsetter = Subsetter(options)
        subsetter.populate(unicodes=REPERTOIRE)
        subsetter.subset(source)
        source.flavor = "woff2"
        target.parent.mkdir(parents=True, exist_ok=True)
        source.save(target)
    return target.stat().st_size


def installed() -> Path:
    """Return the copy of the font that ziamath carries; exits with a hint where it is missing."""
    spec = find_spec("ziamath")
    if spec is None or spec.origin is None:
        sys.exit("install ziamath, or name a copy of STIXTwoMath-Regular.ttf")
    return Path(spec.origin).parent / "fonts" / "STIXTwoMath-Regular.ttf"


if __name__ == "__main__":
    size = subset(Path(sys.argv[1]) if len(sys.argv) > 1 else installed(), TARGET)
    print(f"{TARGET.name}: {size / 1024:.0f} KB")
