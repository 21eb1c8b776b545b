"""Fingerprint of everything that cached results depend on: the workbench's code and its libraries'
versions."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from functools import cache
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path


def digest(text: str) -> str:
    return sha256(text.encode()).hexdigest()


def code_digest(packages: Iterable[str], rests_on: Iterable[str]) -> str:
    """Returns a digest of the code of the packages, and of the versions of Python and of the libraries."""
    code = [(name, _code_of(name)) for name in packages]
    return digest(repr((code, [(name, version(name)) for name in rests_on], sys.version_info[:2])))


@cache
def _code_of(package: str) -> str:
    """Returns a digest of the package's sources, including its grammars, in the order of their names."""
    file = sys.modules[package].__file__
    assert file is not None, f"{package} has no __init__.py"
    root = Path(file).parent
    digest = sha256()
    for path in sorted((*root.rglob("*.py"), *root.rglob("*.lark"))):
        digest.update(f"{path.relative_to(root)}\n".encode() + path.read_bytes())
    return digest.hexdigest()
