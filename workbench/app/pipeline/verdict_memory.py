"""The cache of verdicts, opened for one run."""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbench.app.pipeline.verdict_keys import Memory


def memory_of_verdicts(wanted: bool) -> AbstractContextManager[Memory | None]:
    """Returns the cache of verdicts as a context; None in it if it is not wanted."""
    if not wanted:
        return nullcontext()
    from workbench.app.pipeline.verdict_keys import Memory
    from workbench.runtime.store import standard

    return standard(Memory)
