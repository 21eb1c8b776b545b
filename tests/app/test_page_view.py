"""What the page shows of a drafted text, beside its verdicts."""

from __future__ import annotations

from pathlib import Path

from workbench.app.pipeline.judged_files import judged_file
from workbench.app.servers.page.page_view import page_view


def test_assumptions_stand_in_the_order_of_their_numbers(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text("\n".join(rf"$$ \vec{{a}}_{{{n}}} \times \vec{{b}} = \vec{{c}} $$" for n in (10, 9, 1)))
    view = page_view(judged_file(path), path, path.read_text())
    labels = [each["label"] for each in view["assumptions"]]
    assert labels == [r"\vec{a}_{1}", r"\vec{a}_{9}", r"\vec{a}_{10}", r"\vec{b}", r"\vec{c}"]
