"""Configuration of the documentation: ``sphinx-build docs docs/_build``."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parents[1]))

from symnav import __version__

project = "symnav"
author = "The symnav authors"
project_copyright = "2026, The symnav authors"
version = release = __version__

extensions = ["myst_parser", "sphinx.ext.mathjax", "reference_pages"]
exclude_patterns = [
    "_build", "performance-results.md", "embedded-results.md", "_generated/rounding_table.md",
]  # fmt: skip
myst_enable_extensions = ["amsmath", "attrs_inline", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3

html_theme = "furo"
html_title = f"symnav {__version__}"
html_theme_options = {"source_edit_link": ""}
nitpicky = True
