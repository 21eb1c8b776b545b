"""The page that `workbench serve` shows."""
