"""What a judgement may cost, and the one way to run what may cost too much: in a process of its own."""

from workbench.budget.limits import STANDARD, Budget, OutOfBudget
from workbench.budget.workers import Workers

__all__ = ["STANDARD", "Budget", "OutOfBudget", "Workers"]
