# SPDX-License-Identifier: Apache-2.0
"""Faults that a reader of a page would see, at the width of a desktop and of a telephone: texts over one another, texts cut
off, empty panels, sideways scrolling, errors on the console.

    python3 tests/unit/results/page_faults.py DIR/report.html ... [--pictures DIR]
"""

import argparse
import base64
import pathlib
import sys

from browser import browser_page

WIDTHS = (1300, 390)  # pixels
FAULTS = r"""(() => {
  const found = [], root = document.documentElement, wide = root.clientWidth, words = (text) => text.trim().replace(/\s+/g, " ").slice(0, 60);
  const hidden = (element) => !element.checkVisibility({ visibilityProperty: true, opacityProperty: true });
  // Every line of text with its place, and the drawing or the part of the page that may cut it off.
  const texts = [];
  for (const text of document.querySelectorAll("svg text")) {
    if (text.textContent.trim() && !hidden(text)) texts.push({ words: words(text.textContent), box: text.getBoundingClientRect(), frame: text.closest("svg") });
  }
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const parent = node.parentElement;
    if (!node.textContent.trim() || parent.closest("svg, script, style, noscript, option") || hidden(parent)) continue;
    const range = document.createRange();
    range.selectNodeContents(node);
    for (const box of range.getClientRects()) if (box.width > 1) texts.push({ words: words(node.textContent), box, frame: null, parent });
  }
  texts.sort((a, b) => a.box.top - b.box.top);
  texts.forEach((a, i) => {
    for (let j = i + 1; j < texts.length && texts[j].box.top < a.box.bottom - 2; ++j) {
      const b = texts[j];
      const across = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
      const along = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
      if (across > 1.5 && along > 2.5) found.push(`overlap: "${a.words}" and "${b.words}"`);
    }
    const scroller = a.parent && a.parent.closest(".scroll");
    const frame = a.frame ? a.frame.getBoundingClientRect() : { left: 0, right: scroller ? Infinity : wide, top: -Infinity, bottom: Infinity };
    if (a.box.left < frame.left - 1 || a.box.right > frame.right + 1 || a.box.top < frame.top - 1.5 || a.box.bottom > frame.bottom + 1.5) {
      found.push(`cut off: "${a.words}"`);
    }
  });
  for (const element of document.querySelectorAll("main *")) {
    const style = getComputedStyle(element);
    if (element.scrollWidth > element.clientWidth + 1 && element.clientWidth && style.overflowX !== "visible" && style.display !== "inline") {
      found.push(`sideways: ${element.tagName.toLowerCase()} ${words(element.textContent)}`);
    }
  }
  for (const card of document.querySelectorAll(".card")) {
    const right = card.getBoundingClientRect().right - parseFloat(getComputedStyle(card).paddingRight);
    for (const part of card.children) {
      if (part.getBoundingClientRect().left + part.scrollWidth > right + 1) found.push(`out of its card: "${words(part.textContent)}"`);
    }
  }
  if (root.scrollWidth > root.clientWidth) found.push(`sideways: the page, ${root.scrollWidth} of ${root.clientWidth} pixels`);
  for (const holder of document.querySelectorAll("figure, .chart, #charts, #trend")) {
    if (!holder.querySelector("svg, img") && !hidden(holder)) found.push(`empty: ${holder.id || holder.className || holder.getAttribute("aria-label")}`);
  }
  for (const svg of document.querySelectorAll("figure svg, .chart svg")) {
    if (hidden(svg)) continue;
    const title = words((svg.querySelector(".name") || svg).textContent), box = svg.getBoundingClientRect();
    const drawn = [...svg.querySelectorAll("path, circle, image, .note, line.mark")].filter((part) => {
      if (part.closest("defs, clipPath")) return false;
      const own = part.getBoundingClientRect();
      return own.width + own.height > 1 && own.right > box.left && own.left < box.right && own.bottom > box.top && own.top < box.bottom;
    });
    if (!drawn.length) found.push(`empty: ${title}`);
  }
  for (const image of document.images) if (!image.naturalWidth) found.push(`empty: ${image.alt}`);
  return [...new Set(found)];
})()"""


def faults(page, width):
    """Faults that a reader would see at a width in pixels, as a list of texts; `page` is open in a browser."""
    page.call("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=width < 600)
    page.settle()
    return [*page.evaluate(FAULTS), *(f"console: {str(error)[:200]}" for error in page.errors),
            *(f"asks for {address}" for address in page.requests)]


def take_pictures(page, width, stem, part=2000):
    """The whole page as PNG files, STEM-WIDTH-0.png and on."""
    page.call("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=width < 600)
    page.settle()
    height = page.evaluate("document.documentElement.scrollHeight")
    for place, top in enumerate(range(0, height, part)):
        clip = {"x": 0, "y": top, "width": width, "height": min(part, height - top), "scale": 1}
        picture = page.call("Page.captureScreenshot", clip=clip, captureBeyondViewport=True)["data"]
        stem.with_name(f"{stem.name}-{width}-{place}.png").write_bytes(base64.b64decode(picture))


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages", nargs="+", type=pathlib.Path)
    parser.add_argument("--pictures", type=pathlib.Path, help="folder for pictures of the pages")
    arguments = parser.parse_args()
    for path in arguments.pages:
        if not path.is_file():
            parser.error(f"there is no page {path}")
    bad = 0
    for path in arguments.pages:
        with browser_page(path) as page:
            for width in WIDTHS:
                seen = faults(page, width)
                bad += len(seen)
                print(f"{path} at {width}: {len(seen) or 'no'} faults", *seen, sep="\n  ")
                if arguments.pictures:
                    arguments.pictures.mkdir(parents=True, exist_ok=True)
                    take_pictures(page, width, arguments.pictures / path.resolve().parent.name)
    sys.exit(bad > 0)


if __name__ == "__main__":
    main()
