// SPDX-License-Identifier: Apache-2.0
// What the charts of all pages are drawn with; pages.chart_script() puts it before a page's own script.
const SVG = "http://www.w3.org/2000/svg";

function make(parent, tag, attributes = {}, text = "") {
  const node = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  if (text) node.textContent = text;
  parent.append(node);
  return node;
}

// Round values between two ends, about `count` of them, a factor times a power of ten apart.
function ticks(low, high, count, factors = [1, 2, 5, 10]) {
  const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw));
  const step = factors.find((factor) => factor * power >= raw) * power, found = [];
  for (let value = Math.ceil(low / step) * step; value <= high + step * 1e-9; value += step) {
    found.push(Math.abs(value) < step * 1e-9 ? 0 : value);
  }
  return found;
}
