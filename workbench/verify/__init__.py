"""A paper's claims become results: each form gets a verdict; the claim passes if they are those expected."""

from workbench.verify.claims import ClaimResult, PaperJudge, judge_paper

__all__ = ["ClaimResult", "PaperJudge", "judge_paper"]
