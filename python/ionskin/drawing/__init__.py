# SPDX-License-Identifier: Apache-2.0
"""Figures and what they are drawn with."""
