"""Processes with limits, and the cache of earlier results.

What is this? A pool of processes that can be ended, and a store on disk with a checksum per entry. When do I
come here? To change the limits of a judgement, or what a cached result depends on. What may it import? core.
What checks it? tests/app/test_budget.py, tests/app/test_memory.py.
"""

from workbench.runtime.limits import STANDARD, Budget, OutOfBudget
from workbench.runtime.workers import Workers, interruptible, stop_if_asked

__all__ = ["STANDARD", "Budget", "OutOfBudget", "Workers", "interruptible", "stop_if_asked"]
