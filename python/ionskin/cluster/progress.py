# SPDX-License-Identifier: Apache-2.0
"""Progress of the batches of a sweep on a cluster, as lines on standard error."""

import json
import sys
import time


class BatchProgress:
    """Progress of the batches of a sweep, printed on standard error.

    done, failed  sets of the numbers of batches that ended, which the caller fills
    """

    def __init__(self, mode, batches):
        """mode: "bar" (one line that is rewritten), "lines", "json" or "none"; batches:
        dict of number to estimated time [s]."""
        self.mode, self.seconds, self.done, self.failed = mode, batches, set(), set()
        self.start, self.shown, self.ends_open = time.monotonic(), None, False

    def time_left(self):
        """Estimated remaining time [s], by the finished share of the estimated work; None before a batch is done."""
        share = sum(self.seconds[batch] for batch in self.done) / sum(self.seconds.values())
        return (time.monotonic() - self.start) * (1 - share) / share if share else None

    def show(self, running, workers):
        """Prints the progress if it has changed; `running` and `workers` are numbers of jobs and workers."""
        state = (len(self.done), running, len(self.failed), workers)
        if self.mode == "none" or state == self.shown:
            return
        self.shown = state
        left = self.time_left()
        if self.mode == "json":
            line = json.dumps({"activity": "batches", "fraction": len(self.done) / len(self.seconds), "done": len(self.done),
                               "running": running, "failed": len(self.failed), "batches": len(self.seconds),
                               "workers": workers, "elapsed_s": time.monotonic() - self.start, "time_left_s": left})
        else:
            line = (f"batches: {len(self.done)} of {len(self.seconds)} done, {running} running, {len(self.failed)} failed; "
                    f"{workers} worker{'' if workers == 1 else 's'}" + (f"; about {left:.0f} s left" if left else ""))
        self.ends_open = self.mode == "bar"
        print(f"\r\033[K{line}" if self.ends_open else line, end="" if self.ends_open else "\n", file=sys.stderr, flush=True)

    def say(self, text):
        """Prints a message on a line of its own."""
        print("\n" * self.ends_open + text, file=sys.stderr, flush=True)
        self.ends_open, self.shown = False, None

    def close(self):
        """Ends the line of a bar."""
        if self.ends_open:
            print(file=sys.stderr, flush=True)
