"""Runs the claims of papers: each form gets a verdict; the claim passes if they are those expected."""
