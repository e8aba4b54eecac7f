# SPDX-License-Identifier: Apache-2.0
"""Sphinx configuration. `make docs` builds from a copy of this folder that holds the generated pages too."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent / "extensions"))

project = "ionskin"
author = "The ionskin contributors"
copyright = author
extensions = ["myst_parser", "mathml"]
myst_enable_extensions = ["dollarmath", "colon_fence", "deflist"]
myst_heading_anchors = 3
html_math_renderer = "mathml"
html_theme = "furo"
html_title = "ionskin"
html_static_path = ["style"]
html_css_files = ["docs.css"]
html_copy_source = False
html_show_copyright = False
html_show_sphinx = False
exclude_patterns = ["_build", "generate", "extensions"]
highlight_language = "none"
pygments_style = "default"
nitpicky = True
