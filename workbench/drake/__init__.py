"""Drake: plants, reference motions, and the symbols that are bound to them.

What is this? The only package that imports pydrake, by gate.py. When do I come here? To add a quantity of
motions (quantities.py, bindings.py). What may it import? core. What checks it? tests/drake.
"""

from importlib import import_module
from typing import Any

#: The public names and where each is defined; it is imported at its first use.
_PLACES = {
    "CylindricalAxis": "workbench.drake.plants",
    "JointPath": "workbench.drake.joint_paths",
    "chain_motion": "workbench.drake.motions",
    "load_urdf": "workbench.drake.plants",
    "point_derivatives": "workbench.drake.references",
    "reference_motions": "workbench.drake.motions",
    "twist_derivatives": "workbench.drake.references",
}

__all__ = list(_PLACES)


def __getattr__(name: str) -> Any:
    if name in _PLACES:
        return getattr(import_module(_PLACES[name]), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
