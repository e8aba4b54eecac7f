# SPDX-License-Identifier: Apache-2.0
"""Other codes beside ionskin: the problems, the scripts that solve them, the tables of benchmarks/peers.py."""
