"""Runs the command line: `python -m workbench`."""

from workbench.app.commands.commands import main

if __name__ == "__main__":
    main(prog_name="workbench")
