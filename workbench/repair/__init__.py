"""The right formula where a printed one is false or ill-formed: found by search, proved by the judge."""

from workbench.core.callable_package import make_callable

make_callable(__name__, "workbench.app.api:repair")
