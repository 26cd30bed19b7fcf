"""Sphinx over the pages that scripts/docs has laid together in build/docs/source."""

import os

project = "raceway"
author = copyright = "the raceway authors"
version = release = os.environ["RACEWAY_VERSION"]

extensions = ["myst_parser", "nbsphinx", "sphinx.ext.autodoc", "numpydoc", "sphinx_copybutton"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
exclude_patterns = ["_static"]

smartquotes = False  # "mineral" and --json are typed as they stand

html_theme = "furo"
html_title = f"raceway {version}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sourcelink = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#1a5f8a", "color-brand-content": "#1a5f8a"},
    "dark_css_variables": {"color-brand-primary": "#7fb8de", "color-brand-content": "#7fb8de"},
}

myst_heading_anchors = 6
suppress_warnings = ["myst.header"]  # a notebook or a page may begin at any level

# Executed before, by scripts/run_notebooks.py.
nbsphinx_execute = "never"
nbsphinx_requirejs_path = ""
mathjax_path = "mathjax.js"  # of no page: formulas are text

autodoc_typehints = "none"  # signatures would run over three lines; the sections say the types
autodoc_member_order = "bysource"
autodoc_default_options = {"members": True, "inherited-members": "Mapping,BaseException,RuntimeError,ValueError,UserWarning"}
numpydoc_show_class_members = False
numpydoc_xref_param_type = False


def setup(app):
    """nbsphinx asks for MathJax, from a network, where no page has an equation."""

    def without_mathjax(app, page, template, context, doctree):
        context["script_files"] = [one for one in context["script_files"] if "mathjax" not in str(one)]

    app.connect("html-page-context", without_mathjax, priority=900)


copybutton_prompt_text = "$ "
copybutton_only_copy_prompt_lines = True
highlight_language = "none"
