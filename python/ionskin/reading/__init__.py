# SPDX-License-Identifier: Apache-2.0
"""Files that take more than a table to read: of runs, and recordings from elsewhere."""
