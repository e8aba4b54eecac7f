# SPDX-License-Identifier: Apache-2.0
"""A headless Chromium that a test can click through, spoken to over pipes (Chrome DevTools Protocol)."""

import contextlib
import itertools
import json
import os
import pathlib
import shutil
import subprocess
import tempfile


def chromium():
    """Path of the browser, or None."""
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


class Page:
    """One open page. What its script throws and what appears as an error on the console is in `errors`; addresses that
    it asks for beyond its own file are in `requests`, and get no answer."""

    def __init__(self, to_browser, from_browser):
        self._to, self._from, self._numbers = to_browser, from_browser, itertools.count(1)
        self._session, self.errors, self.requests = None, [], []

    def open(self, path):
        """Opens a file and waits until it is loaded."""
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self._session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=1100, height=2400, deviceScaleFactor=1, mobile=False)
        self.call("Page.navigate", url=pathlib.Path(path).resolve().as_uri())
        while self._receive().get("method") != "Page.loadEventFired":
            pass

    def call(self, method, **parameters):
        """One command of the protocol and its result."""
        number = next(self._numbers)
        message = {"id": number, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        self._to.write(json.dumps(message).encode() + b"\0")
        self._to.flush()
        while True:
            answer = self._receive()
            if answer.get("id") == number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def _receive(self):
        text = bytearray()
        while (letter := self._from.read(1)) != b"\0":
            if not letter:
                raise RuntimeError("the browser has ended")
            text += letter
        answer = json.loads(text)
        if answer.get("method") == "Runtime.exceptionThrown":
            self.errors.append(answer["params"]["exceptionDetails"])
        if answer.get("method") == "Log.entryAdded" and answer["params"]["entry"]["level"] == "error":
            self.errors.append(answer["params"]["entry"]["text"])
        if answer.get("method") == "Runtime.consoleAPICalled" and answer["params"]["type"] in ("error", "assert"):
            self.errors.append(answer["params"]["args"])
        if answer.get("method") == "Network.requestWillBeSent":
            address = answer["params"]["request"]["url"]
            self.requests += [address] if not address.startswith(("file:", "data:")) else []
        return answer

    def evaluate(self, expression):
        """The value of a JavaScript expression."""
        return self.call("Runtime.evaluate", expression=expression, returnByValue=True)["result"].get("value")

    def settle(self):
        """Waits until two frames have been drawn: elements have learned of a new width."""
        self.call("Runtime.evaluate", awaitPromise=True,
                  expression="new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 0))))")

    def box(self, selector):
        """Place of the first element of a selector: left, top, width, height."""
        find = f"const e = document.querySelector({json.dumps(selector)}); e.scrollIntoView({{behavior: 'instant'}});"
        return self.evaluate(f"(() => {{ {find} const b = e.getBoundingClientRect(); "
                             "return [b.left, b.top, b.width, b.height]; })()")

    def overlapping_labels(self, selector):
        """Pairs of texts of one SVG that lie over each other."""
        return self.evaluate("""(() => {
          const found = [];
          for (const svg of document.querySelectorAll(%s)) {
            const texts = [...svg.querySelectorAll("text")].filter((text) => text.textContent);
            const boxes = texts.map((text) => text.getBoundingClientRect());
            boxes.forEach((a, i) => boxes.slice(0, i).forEach((b, j) => {
              const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left);
              const high = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
              if (wide > 1 && high > 2) found.push([texts[j].textContent, texts[i].textContent]);
            }));
          }
          return found;
        })()""" % json.dumps(selector))

    def mouse(self, kind, x, y, clicks=1):
        """One event of the mouse."""
        pressed = {} if kind == "mouseMoved" else {"button": "left", "clickCount": clicks}
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **pressed)

    def click(self, x, y, clicks=1):
        """Presses and releases the button."""
        for count in range(1, clicks + 1):
            self.mouse("mousePressed", x, y, count)
            self.mouse("mouseReleased", x, y, count)


@contextlib.contextmanager
def browser_page(path):
    """A Page with a file open; the browser ends with the block."""
    to_read, to_write = os.pipe()
    from_read, from_write = os.pipe()
    with tempfile.TemporaryDirectory(prefix="ionskin-browser-", ignore_cleanup_errors=True) as profile:
        command = (f'exec "{chromium()}" --headless --no-sandbox --disable-gpu --no-first-run --disable-dev-shm-usage '
                   '--host-resolver-rules="MAP * ~NOTFOUND" --disable-background-networking '
                   f'--user-data-dir="{profile}" --remote-debugging-pipe 3<&{to_read} 4>&{from_write}')
        with subprocess.Popen(["bash", "-c", command], pass_fds=(to_read, from_write), stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) as process:
            os.close(to_read)
            os.close(from_write)
            with os.fdopen(to_write, "wb") as to_browser, os.fdopen(from_read, "rb") as from_browser:
                page = Page(to_browser, from_browser)
                page.open(path)
                yield page
                process.terminate()
