"""`workbench help`: contents, topics, codes, search, and what it says of a topic that is unknown."""

from __future__ import annotations

import pytest
from click.testing import CliRunner, Result

from workbench.app.commands.commands import main
from workbench.core.close_names import did_you_mean
from workbench.guide.contents import PARTS
from workbench.guide.generated import manual
from workbench.guide.message_page import all_codes, entries

PAGES = manual(main)


def help_of(*words: str) -> Result:
    return CliRunner().invoke(main, ["help", *words])


def test_contents_list_every_page() -> None:
    shown = help_of().output
    assert all(f"  {page.topic} " in shown for page in PAGES)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.topic)
def test_each_page_has_title_and_summary(page: object) -> None:
    assert page.title != page.topic and page.summary  # type: ignore[attr-defined]
    assert page.text.startswith(f"# {page.title}\n")  # type: ignore[attr-defined]


def test_topics_of_the_contents_are_pages() -> None:
    assert {topic for _, _, order in PARTS for topic in order} <= {page.topic for page in PAGES}


def test_topics_are_unique() -> None:
    topics = [page.topic for page in PAGES]
    assert len(set(topics)) == len(topics)


@pytest.mark.parametrize("written", ["model-keys", "Model keys", "model_keys"])
def test_topic_is_found_however_it_is_written(written: str) -> None:
    assert help_of(written).output.startswith("# Model keys")


def test_code_shows_its_entry() -> None:
    code = next(iter(all_codes()))
    assert help_of(code).output.startswith(f"# {code}")
    assert help_of(f"[{code.lower()}]").output == help_of(code).output


def test_command_shows_its_options() -> None:
    assert "--paper FILE" in help_of("verify").output


@pytest.mark.parametrize(("topic", "close"), [("model-kyes", "model-keys"), ("keys", "model-keys")])
def test_unknown_topic_names_the_closest(topic: str, close: str) -> None:
    result = help_of(topic)
    assert result.exit_code == 2 and f"Did you mean {close}" in result.output


def test_search_lists_pages_with_all_words() -> None:
    result = help_of("--search", "gradient", "row")
    assert result.exit_code == 0 and "model-keys: Model keys" in result.output


@pytest.mark.parametrize(
    ("words", "topic"), [("custom accent", "accents"), ("jacobian derivative", "derivatives")]
)
def test_search_takes_several_words_in_one_argument(words: str, topic: str) -> None:
    found = help_of("--search", words).output
    assert found == help_of("--search", *words.split()).output
    assert found.startswith(f"{topic}: ")


def test_search_without_result_exits_with_1() -> None:
    assert help_of("--search", "zyzzyva").exit_code == 1


def test_entries_of_messages_belong_to_codes() -> None:
    assert set(entries()) <= set(all_codes())


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("verfy", "Did you mean verify or certify?"),
        ("LIST", "Did you mean list?"),
        ("zzz", ""),
    ],
)
def test_close_names_make_a_question(name: str, hint: str) -> None:
    assert did_you_mean(name, ["verify", "certify", "list"]) == hint
