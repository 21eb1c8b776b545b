"""The right formula where a printed one is false or ill-formed: found by search, proved by the judge."""
