# SPDX-License-Identifier: Apache-2.0
"""HTML pages of reports, with their templates, style and script."""
