# SPDX-License-Identifier: Apache-2.0
"""Analysis of the results of a run or a sweep: figures of merit, onset of slip, sensitivities."""
