"""A first model for a text: kinds guessed, each with its reason; what is left to its author is asked."""

from workbench.ingest.ingest import Ingested, ingest
from workbench.ingest.model_file import model_text

__all__ = ["Ingested", "ingest", "model_text"]
