"""Terms as Coq text."""
