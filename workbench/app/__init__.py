"""The application: load, judge, repair, report, and the places where people use them.

What is this? `pipeline` runs the claims of papers, with the cache and the worker processes; `commands` is the
command line; `servers` are the editor, the assistant and watching; `api` and `checked` are the Python API.
When do I come here? To add a command or an option. What may it import? Everything. What checks it?
tests/app/test_cli.py, tests/app/test_commands.py, tests/app/test_listing.py.
"""
