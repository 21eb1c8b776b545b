"""A first model for a text: kinds of symbols with reasons, and questions to the author.

What is this? `inference` infers the kinds of symbols from formulas, other modules read sentences and propose
notation, frames and definitions; `model_file` writes the model. When do I come here? To draft more of a
model. What may it import? What papers may, and papers itself. What checks it? tests/ingest.
"""

from workbench.papers.drafting.draft_model import Ingested, ingest
from workbench.papers.drafting.drafted_texts import meant
from workbench.papers.drafting.model_file import model_text

__all__ = ["Ingested", "ingest", "meant", "model_text"]
