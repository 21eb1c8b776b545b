"""The pages of the manual: read from the package, or generated; found by topic, or by words."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from workbench.guide.contents import PARTS

FOLDER = Path(__file__).parent
_HEADING = re.compile(r"^#+ +(.*)$", re.MULTILINE)
#: The most times that a word counts in one page of a search.
_MOST_TIMES = 5
_SENTENCE = re.compile(r"(.+?[.:])(?=\s|$)", re.DOTALL)


@dataclass(frozen=True)
class Page:
    """A page of the manual.

    Attributes:
        read: Returns its Markdown text.
        heading: Its title, if reading the page takes time.
    """

    topic: str
    part: str
    folder: str
    read: Callable[[], str]
    heading: str = ""

    @cached_property
    def text(self) -> str:
        return self.read()

    @property
    def title(self) -> str:
        if self.heading:
            return self.heading
        found = _HEADING.search(self.text)
        return found[1] if found else self.topic

    @property
    def summary(self) -> str:
        """The first sentence below the title."""
        body = _HEADING.sub("", self.text, count=1).strip()
        found = _SENTENCE.match(body)
        return " ".join(found[1].split()) if found else ""


def all_pages(generated: Sequence[Page]) -> list[Page]:
    """Returns the pages in the order of the contents. generated: those that are not files."""
    made = {page.topic: page for page in generated}
    pages = []
    for part, folder, order in PARTS:
        files = {path.stem: path for path in sorted((FOLDER / folder).glob("*.md"))}
        for topic in [*order, *(name for name in files if name not in order)]:
            if topic in files:
                pages.append(Page(topic, part, folder, _reader(files[topic])))
            elif topic in made:
                pages.append(made[topic])
    return pages


def find_page(topic: str, pages: Sequence[Page]) -> Page | None:
    """Returns the page on the topic; case, blanks and underscores do not count."""
    wanted = re.sub(r"[\s_]+", "-", topic.strip().casefold())
    return next((page for page in pages if page.topic == wanted), None)


def search(words: Sequence[str], pages: Sequence[Page]) -> list[tuple[Page, str]]:
    """Returns the pages that contain all words, the one with most of them first, each with a line.

    A word in a title counts most; in a long page it counts `_MOST_TIMES` times."""
    wanted = " ".join(words).casefold().split()
    found = []
    for page in pages:
        text = page.text.casefold()
        if all(word in text for word in wanted):
            weight = sum(
                min(text.count(word), _MOST_TIMES) + 20 * (word in page.title.casefold()) for word in wanted
            )
            found.append((weight, page))
    ordered = sorted(found, key=lambda each: -each[0])
    return [(page, _best_line(page.text, wanted)) for _, page in ordered]


def contents_text(pages: Sequence[Page]) -> str:
    """Returns the table of contents: each topic with its title."""
    lines = ["# The manual of the kinematics workbench", ""]
    width = max(len(page.topic) for page in pages)
    for part, group in _by_part(pages):
        lines += [part, *(f"  {page.topic:<{width}}  {page.title}" for page in group), ""]
    lines += [
        "workbench help TOPIC shows a page.",
        "workbench help CODE explains the code at the end of a message, as in WB-UNKNOWN-SYMBOL.",
        "workbench help --search WORDS lists the pages that contain the words.",
    ]
    return "\n".join(lines) + "\n"


def _by_part(pages: Sequence[Page]) -> Iterator[tuple[str, list[Page]]]:
    for part in dict.fromkeys(page.part for page in pages):
        yield part, [page for page in pages if page.part == part]


def _reader(path: Path) -> Callable[[], str]:
    return lambda: path.read_text(encoding="utf-8")


def _best_line(text: str, words: Sequence[str]) -> str:
    """Returns the line that contains most of the words."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return max(lines, key=lambda line: sum(word in line.casefold() for word in words), default="")
