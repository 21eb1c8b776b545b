"""The command line: one module for each command. command_table.py lists them all."""
