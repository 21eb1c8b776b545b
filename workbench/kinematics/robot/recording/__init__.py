"""Recordings of a motion: derivatives with stated errors, breaks and peaks."""
