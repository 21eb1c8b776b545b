"""The pipeline: judges the claims of papers in worker processes, with the cache of earlier verdicts."""
