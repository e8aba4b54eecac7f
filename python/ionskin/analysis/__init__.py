# SPDX-License-Identifier: Apache-2.0
"""What the results of a run or a sweep say: figures of merit, regimes, sensitivities, and statements about them."""
