"""How the pages of the Python package are made: scripts/python-docs."""

import plumbline

project = "Plumbline"
copyright = "the Plumbline authors, GPL-3.0-or-later"
version = release = plumbline.__version__

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "numpydoc",
]
templates_path = ["_templates"]
html_theme = "pydata_sphinx_theme"
html_title = "Plumbline"
html_theme_options = {"show_toc_level": 2, "navigation_with_keys": False}
html_show_sourcelink = False

# Notebooks are run whenever the pages are made, and fail them where a cell fails.
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 120
nb_execution_show_tb = True
myst_enable_extensions = ["dollarmath"]
# What a notebook shows of an object: its page or picture, else its text.
nb_mime_priority_overrides = [("html", "text/html", 0), ("html", "image/svg+xml", 1)]

autosummary_generate = True
autodoc_typehints = "none"
autoclass_content = "class"
numpydoc_show_class_members = False
numpydoc_class_members_toctree = False
# No inventories of other projects are loaded, so that pages are made offline: only names of this
# one must be there.
nitpick_ignore_regex = [("py:.*", r"(?!plumbline\b).*")]
