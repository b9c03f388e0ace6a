"""How Sphinx builds the site from the pages that `make docs` puts together."""

import household

project = "Household"
author = "the Household authors"
copyright = author
version = release = household.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "experiments.docs_tools.site.docstrings",
    "experiments.docs_tools.site.formulas",
]
exclude_patterns = ["_static"]
toc_object_entries = False  # hundreds of entries in the sidebar, copied to each page
suppress_warnings = ["ref.python"]  # classes of one name in two rooms are both shown

myst_enable_extensions = ["dollarmath", "fieldlist"]
myst_heading_anchors = 4  # headings can be linked to, named as on GitHub
default_role = "code"  # docstrings mark code as Markdown does

autodoc_default_options = {"members": True, "ignore-module-all": True}
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_class_signature = "mixed"
autodoc_preserve_defaults = True
napoleon_google_docstring = True
napoleon_numpy_docstring = False
napoleon_use_ivar = True
add_module_names = False
python_maximum_signature_line_length = 110

html_theme = "furo"
html_title = "Household"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_show_sphinx = False
html_show_sourcelink = False
html_copy_source = False
html_math_renderer = "drawn"
