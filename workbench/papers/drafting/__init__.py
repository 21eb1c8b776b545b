"""A first model for a text: kinds guessed, each with its reason; what is left to its author is asked."""

from workbench.papers.drafting.draft_model import Ingested, ingest
from workbench.papers.drafting.model_file import model_text

__all__ = ["Ingested", "ingest", "model_text"]
