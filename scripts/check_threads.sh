#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# What hands memory between threads, compiled and run under the thread sanitizer: scripts/check_threads.sh
# threads|threads-long [JOBS]. The first takes task pool, worker team and interrupt; the second also a sweep of the
# program, whose threads share points, skin, recovered strains and ions. Where the sanitizer cannot run at all, fails,
# unless the regular expression IONSKIN_MAY_SKIP matches "thread sanitizer".
set -eu
cd "$(dirname "$0")/.."

probe=$(mktemp -d)
trap 'rm -rf "$probe"' EXIT
printf '#include <thread>\nint main() { std::thread([] {}).join(); }\n' >"$probe/probe.cpp"
if ! reason=$("${CXX:-c++}" -fsanitize=thread -o "$probe/probe" "$probe/probe.cpp" -pthread 2>&1 && "$probe/probe" 2>&1); then
  echo "skipped: the thread sanitizer cannot run on this machine: $(echo "$reason" | head -n 1)"
  [ -n "${IONSKIN_MAY_SKIP:-}" ] && echo "thread sanitizer" | grep -Eq "$IONSKIN_MAY_SKIP" && exit 0
  echo "IONSKIN_MAY_SKIP='thread sanitizer' goes on without it" >&2
  exit 1
fi
cmake --preset threads
cmake --build --preset "$1" --parallel "${2:-2}"
/usr/bin/python3 scripts/run_tests.py "$1"
