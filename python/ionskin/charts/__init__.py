# SPDX-License-Identifier: Apache-2.0
"""What the figures of a run show, as data: the page of the run draws it, `drawing` makes files of it."""
