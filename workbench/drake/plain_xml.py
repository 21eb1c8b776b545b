"""XML as URDF readers take it: prefixes are part of a name, regardless of namespaces."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from xml.parsers import expat

BAD_DECLARATION = re.compile(rb"^(\xef\xbb\xbf)?\s*<\?xml(?!\s+version\s*=)[^>]*\?>")


def parse_plain(text: bytes) -> ET.Element:
    """Returns the outermost element of an XML text; tags such as "joint" and "drake:joint" are kept as
    written.

    Namespaces need not be declared, and an XML declaration without a version is skipped. Raises ValueError
    for text that is no XML.
    """
    builder, parser = ET.TreeBuilder(), expat.ParserCreate()
    parser.StartElementHandler = builder.start
    parser.EndElementHandler = builder.end
    parser.CharacterDataHandler = builder.data
    parser.buffer_text = True
    try:
        parser.Parse(BAD_DECLARATION.sub(b"", text.lstrip()), True)
    except (expat.ExpatError, ValueError) as error:  # ValueError: an encoding that Python does not know
        raise ValueError(f"not XML: {error}") from None
    return builder.close()
