# SPDX-License-Identifier: Apache-2.0
"""Files of runs that take more than a table to read."""
