"""What a text writes, as the claim language has it: TeX for the eye, that of other tools, plain TeX."""

from workbench.papers.respell.respelling import argument, respelled

__all__ = ["argument", "respelled"]
