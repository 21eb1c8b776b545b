"""The engines loaded ahead: what imports the judge alone imports each of them on first use."""


def load_engines() -> None:
    """Here, once, and not in each process that is forked from this one."""
    import workbench.engines.jet.consequences
    import workbench.engines.jet.drake_ring
    import workbench.engines.jet.sympy_ring  # noqa: F401
