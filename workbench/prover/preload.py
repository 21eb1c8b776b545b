"""Preloading of the modules that the judge otherwise imports on first use."""


def load_engines() -> None:
    """Imports the engines once in this process, so that forked processes need not do it."""
    import workbench.engines.jet.consequences
    import workbench.engines.jet.drake_ring
    import workbench.engines.jet.sympy_ring
    import workbench.prover.decide.decide
    import workbench.prover.motions.motion_check
    import workbench.prover.motions.statements_on_motions  # noqa: F401
