"""The symbols of formulas with two readings."""

from workbench.language.naming.symbols import SymbolTable

KINDS = {
    "a": "vector",
    "b": "vector",
    "c": "vector",
    "u": "vector",
    "S": "tensor",
    "T": "tensor",
    "s": "scalar",
    r"\alpha": "scalar",
    r"\beta": "scalar",
    r"\omega": "vector",
    "a_n": "vector",
    r"\mathbf{a}^{[n]}": "vector",
    r"\omega_{01}": "vector",
    r"\omega_n": "vector",
    r"v_{rel}": "vector",
    r"v_{\mathrm{n}}": "vector",
    r"v_{\text{rot}}": "vector",
}
TABLE = SymbolTable.build({name: {"kind": kind} for name, kind in KINDS.items()})
