"""The documentation site: what is put together before Sphinx builds it."""
