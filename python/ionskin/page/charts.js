// SPDX-License-Identifier: Apache-2.0
// Drawing of the charts of all pages; pages.chart_script() puts it before a page's own scripts.
"use strict";
const SVG = "http://www.w3.org/2000/svg";
const PREFIX = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"], [1e-12, "p"], [1e-15, "f"]];
const STEPS = [1, 2, 2.5, 5, 10];

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

// Divisor and prefix that bring a largest magnitude between 1 and 1000.
function scale(peak) {
  const found = PREFIX.find(([size]) => peak >= size);
  if (found || !(peak > 0)) return found || [1, ""];
  return peak < 1e-17 ? [1, ""] : PREFIX[PREFIX.length - 1]; // rounding is not a quantity
}

function withUnit(value, unit, digits = 4) {
  if (value === null || value === undefined) return "–";
  if (unit === "1") return Number(value.toPrecision(digits)).toString();
  if (value === 0) return "0";
  const [size, prefix] = scale(Math.abs(value));
  return `${Number((value / size).toPrecision(digits))} ${prefix}${unit}`;
}

// A cursor that follows the pointer, and a drag that marks a part of the chart. frame: LEFT, RIGHT, TOP and bottom in the
// units of the drawing, whose width is `width`.
function interact(svg, { width, left, right, top, bottom }, { tell, zoom, whole }) {
  let from = null, shade = null;
  const cursor = make(svg, "line", { class: "cursor", x1: -9, x2: -9, y1: top, y2: bottom });
  const pixelOf = (event) => {
    const box = svg.getBoundingClientRect();
    return Math.min(right, Math.max(left, (event.clientX - box.left) / box.width * width));
  };
  const drop = () => {
    from = null;
    if (shade) shade.remove();
    shade = null;
  };
  svg.addEventListener("pointermove", (event) => {
    const pixel = pixelOf(event);
    cursor.setAttribute("x1", pixel);
    cursor.setAttribute("x2", pixel);
    tell(pixel);
    if (shade) {
      shade.setAttribute("x", Math.min(from, pixel));
      shade.setAttribute("width", Math.abs(pixel - from));
    }
  });
  svg.addEventListener("pointerdown", (event) => {
    from = pixelOf(event);
    shade = make(svg, "rect", { class: "window", x: from, y: top, width: 0, height: bottom - top });
  });
  const end = (event) => {
    if (from === null) return;
    const to = pixelOf(event), begin = from;
    drop();
    if (Math.abs(to - begin) > 4) zoom(Math.min(to, begin), Math.max(to, begin));
  };
  svg.addEventListener("pointerup", end);
  svg.addEventListener("pointerleave", end);
  svg.addEventListener("pointercancel", drop); // a finger that begins to scroll the page ends its drag
  svg.addEventListener("dblclick", whole);
}

// Draws again when an element has got another width; on a phone the address bar changes the height while one scrolls.
function onWidth(element, draw) {
  let last = 0;
  new ResizeObserver(() => {
    if (element.clientWidth !== last) {
      last = element.clientWidth;
      draw();
    }
  }).observe(element);
}
