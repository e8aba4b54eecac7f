# SPDX-License-Identifier: Apache-2.0
"""Contents of the figures of a run, as data: the page of the run draws it, `drawing` makes files of it."""
