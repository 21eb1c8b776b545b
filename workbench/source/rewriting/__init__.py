"""What a text writes, as the claim language has it: TeX for the eye, that of other tools, plain TeX."""

from workbench.source.rewriting.rewrite import argument, respelled

__all__ = ["argument", "respelled"]
