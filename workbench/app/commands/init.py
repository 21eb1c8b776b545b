"""`workbench init`: writes a paper file to start from."""

from __future__ import annotations

from pathlib import Path

import click

from workbench.app.commands.judging_options import write_atomically
from workbench.app.commands.options import Unusable, reports_faults

STARTER = r"""# A rigid body: its symbols, and ten true claims. Change one, and see what workbench check says.
title = "A rigid body"

[symbols]
'R'           = { kind = "rotation" }               # from the body's frame to the fixed one
'\omega'      = { kind = "vector", weight = 1 }     # the angular velocity, in the fixed frame
'r'           = { kind = "vector", constant = true } # a point of the body, in its frame
'p'           = { kind = "vector" }                 # the body's origin, in the fixed frame
'a'           = { kind = "vector" }
'b'           = { kind = "vector" }
'c'           = { kind = "vector" }

[definitions]
'x'   = 'p + R r'                                   # the point, in the fixed frame
'\Omega' = '\dot{R} R^T'                            # the angular velocity as a skew tensor

[[claim]]
id = "orthogonal"
printed = 'R^T R = \mathbf{I}'

[[claim]]
id = "skew"
printed = '\Omega^T = -\Omega'

[[claim]]
id = "velocity"
printed = '\dot{x} = \dot{p} + \Omega R r'

[[claim]]
id = "velocity.point"
printed = '\dot{x} = \dot{p} + \Omega (x - p)'

[[claim]]
id = "acceleration"
printed = '\ddot{x} = \ddot{p} + (\dot{\Omega} + \Omega^2) (x - p)'

[[claim]]
id = "lengths"
printed = '(R r) \cdot (R r) = r \cdot r'

[[claim]]
id = "products"
printed = 'R (a \times b) = (R a) \times (R b)'

[[claim]]
id = "double"
printed = 'a \times (b \times c) = b (a \cdot c) - c (a \cdot b)'

[[claim]]
id = "euler"
printed = '\omega \times (\omega \times a) = \omega (\omega \cdot a) - \omega^2 a'

[[claim]]
id = "product"
printed = '\frac{d}{dt} (\omega \times a) = \dot{\omega} \times a + \omega \times \dot{a}'
"""


@click.command()
@click.argument("file", type=click.Path(path_type=Path), default="paper.toml")
@click.option("--force", is_flag=True, help="Write over a file that is there.")
@reports_faults
def init(file: Path, force: bool) -> None:
    """Write a paper file to start from: a rigid body, its symbols, and ten true claims."""
    if file.exists() and not force:
        raise Unusable(f"{file}: is there already; --force writes over it")
    write_atomically(file, STARTER)
    click.echo(f"{file}: ten claims; now: workbench check {file}")
