# SPDX-License-Identifier: Apache-2.0
"""Readers of the files of runs, and of recordings from elsewhere."""
