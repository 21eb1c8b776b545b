"""The manual: Markdown pages, pages generated from tables, and the search in them.

What is this? `contents` orders the pages, `pages` reads them, the `*_page` modules generate the reference.
`workbench help` shows the pages on a terminal; `docs_source` writes them for Sphinx. When do I come here? To
write a page (a Markdown file, and its topic in contents.py) or the text of a message (messages.toml). What
may it import? core, and the public Python API, which it documents. What checks it? tests/guide, which also
runs the examples.
"""
