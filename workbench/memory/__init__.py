"""What earlier runs found, kept in a file."""
