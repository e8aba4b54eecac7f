# SPDX-License-Identifier: Apache-2.0
"""Sweeps on the machines of a cluster."""
