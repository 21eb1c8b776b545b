"""XML as URDF readers take it: prefixes are part of a name, regardless of namespaces."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from xml.parsers import expat

COMMENT = re.compile(rb"<!--.*?-->", re.DOTALL)
BAD_DECLARATION = re.compile(rb"^(\xef\xbb\xbf)?\s*<\?xml(?!\s+version\s*=)[^>]*\?>")


def parse_plain(text: bytes) -> ET.Element:
    """Returns the outermost element of an XML text; tags such as "joint" and "drake:joint" are kept as
    written.

    Namespaces need not be declared, an XML declaration without a version is skipped, and a comment ends at
    the first "-->" whatever it holds. Raises ValueError for text that is no XML.
    """
    text = BAD_DECLARATION.sub(b"", text.lstrip())
    try:
        return _parsed(text)
    except (expat.ExpatError, ValueError) as error:  # ValueError: an encoding that Python does not know
        try:
            return _parsed(COMMENT.sub(b"", text))
        except (expat.ExpatError, ValueError):
            raise ValueError(f"not XML: {error}") from None


def _parsed(text: bytes) -> ET.Element:
    builder, parser = ET.TreeBuilder(), expat.ParserCreate()
    parser.StartElementHandler = builder.start
    parser.EndElementHandler = builder.end
    parser.CharacterDataHandler = builder.data
    parser.buffer_text = True
    parser.Parse(text, True)
    return builder.close()
