#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The units that hand memory between threads (task pool, worker team, cache, interrupt), compiled and run under the thread
# sanitizer: scripts/check_threads.sh [JOBS]. Where the sanitizer cannot run at all, says so and passes.
set -eu
cd "$(dirname "$0")/.."

probe=$(mktemp -d)
trap 'rm -rf "$probe"' EXIT
printf '#include <thread>\nint main() { std::thread([] {}).join(); }\n' >"$probe/probe.cpp"
if ! reason=$("${CXX:-c++}" -fsanitize=thread -o "$probe/probe" "$probe/probe.cpp" -pthread 2>&1 && "$probe/probe" 2>&1); then
  echo "skipped: the thread sanitizer cannot run on this machine: $(echo "$reason" | head -n 1)"
  exit 0
fi
cmake --preset threads
cmake --build --preset threads --parallel "${1:-2}"
ctest --preset threads
