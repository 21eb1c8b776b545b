"""The site of the manual: it builds without a warning, and every internal link leads somewhere."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from workbench.app.commands.commands import main
from workbench.guide.docs_source import MENTION, write_source
from workbench.guide.generated import manual

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"


def built(source: Path) -> subprocess.CompletedProcess[str]:
    """Builds the site, a warning being an error."""
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html"]
    return subprocess.run([*command, str(source), str(source / "_build")], capture_output=True, text=True)


def test_source_has_every_page(tmp_path: Path) -> None:
    written = write_source(tmp_path, main, NOTEBOOKS)
    index = (tmp_path / "index.md").read_text(encoding="utf-8")
    assert len(written) == len(manual(main)) and all(f"/{path.stem}\n" in index for path in written)
    assert all(f"notebooks/{path.stem}\n" in index for path in NOTEBOOKS.glob("*.ipynb"))


def test_pages_name_pages_that_exist() -> None:
    pages = manual(main)
    known = {page.topic for page in pages} | {"CODE", "TOPIC"}
    assert {topic for page in pages for topic in MENTION.findall(page.text)} <= known


@pytest.mark.slow
def test_site_builds_without_warnings(tmp_path: Path) -> None:
    pytest.importorskip("myst_nb")
    words = ["help", "--site", str(tmp_path), "--notebooks", str(NOTEBOOKS)]
    assert CliRunner().invoke(main, words).exit_code == 0
    done = built(tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "_build" / "reference" / "messages.html").is_file()


@pytest.mark.slow
def test_broken_link_fails_the_build(tmp_path: Path) -> None:
    pytest.importorskip("myst_nb")
    write_source(tmp_path, main)
    page = tmp_path / "howto" / "frames.md"
    page.write_text(page.read_text(encoding="utf-8") + "\n[nowhere](nowhere.md)\n", encoding="utf-8")
    assert built(tmp_path).returncode != 0
