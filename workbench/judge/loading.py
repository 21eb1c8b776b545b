"""The engines loaded ahead: what imports the judge alone imports each of them on first use."""


def load_engines() -> None:
    """Here, once, and not in each process that is forked from this one."""
    import workbench.judge.evidence.motion_check
    import workbench.judge.evidence.truth
    import workbench.judge.kernel.judge
    import workbench.judge.second.consequences
    import workbench.judge.second.drake_ring
    import workbench.judge.second.sympy_ring  # noqa: F401
