"""The emitter: writes terms as Coq text."""
