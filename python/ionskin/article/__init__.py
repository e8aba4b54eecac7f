# SPDX-License-Identifier: Apache-2.0
"""The article whose case ionskin began with: its case, its figures and its claims, judged on the data."""
