"""A paper's claims become results: each form gets a verdict; the claim passes if they are those expected."""
