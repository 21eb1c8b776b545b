"""The manual: Markdown pages, pages generated from tables, and the search in them.

Come here to read or to build the manual. `contents` orders the pages, `pages` reads them, `*_page` modules
generate the reference. `workbench help` shows the pages on a terminal; `docs_source` writes them for Sphinx.
tests/guide runs their examples."""
