"""From a statement to its verdict. The rooms, each of which knows only those before it:

    verdict     what comes out
    subject     what a statement is about: its free symbols and the parameters they depend on
    first       the engine that proves: polynomials with a derivation, in FLINT
    second      the engine that checks: lists of derivatives over any ring, SymPy's on Python integers first
    evidence    points and motions: what shows that a statement is false, and what vetoes a proof
    kernel      what asks the engines, and turns their answers into a verdict
    theorems    what more than one identity says

A `proved` rests on subject, kernel and both engines agreeing; `workbench help trust` lists the files.
"""

from workbench.core.callable_package import make_callable

make_callable(__name__, "workbench.api:judge")
