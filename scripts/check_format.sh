#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Fails when a source is not formatted as .clang-format says.
set -euo pipefail
cd "$(dirname "$0")/.."
find src apps python tests verification benchmarks -name '*.cpp' -o -name '*.hpp' |
  xargs -n 64 -P "$(nproc)" clang-format-14 --dry-run -Werror
echo "format: all sources are formatted"
