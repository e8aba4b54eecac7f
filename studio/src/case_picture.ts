// SPDX-License-Identifier: Apache-2.0
import { svg } from "./dom";
import { Geometry } from "./geometry";

/// A case seen from the side and above: skin, slider, way, taxels.
export function case_picture(shape: Geometry): SVGElement {
  const [width, height] = [240, 130];
  const scale = 200 / shape.length;
  const left = 20, skin = 78;
  const parts: SVGElement[] = [];
  const thickness = [7, 20, 7];
  let y = skin + 34;
  shape.layers.slice(0, 3).forEach((layer, i) => {
    y -= thickness[i];
    parts.push(svg("rect", { x: left, y, width: 200, height: thickness[i], class: layer.role === "core" ? "p-core" : "p-metal" }));
  });
  shape.taxels.forEach((taxel, i) => {
    const [from, to] = [left + taxel.lower[0] * scale, left + taxel.upper[0] * scale];
    parts.push(svg("rect", { x: from + 1, y: y, width: Math.max(1, to - from - 2), height: 7, class: i % 2 ? "p-taxel" : "p-taxel2" }));
  });
  if (shape.slides) {
    const x = left + shape.start[0] * scale;
    if (shape.shape === "sphere" || shape.shape === "cylinder") {
      const radius = Math.min(30, shape.radius * scale);
      parts.push(svg("circle", { cx: x, cy: y - 8 - radius, r: radius, class: "p-slider" }));
    } else {
      const w = Math.max(12, shape.size[0] * scale);
      parts.push(svg("rect", { x: x - w / 2, y: y - 34, width: w, height: 26, class: "p-slider", rx: 2 }));
    }
    if (shape.stroke > 0) {
      const end = x + shape.stroke * scale * (shape.direction[0] || 1);
      parts.push(svg("path", { d: `M${x} ${y - 20}H${end - 3}m-5 -4l6 4l-6 4`, class: "p-way" }));
    }
  } else {
    for (let i = 0; i < 6; ++i) parts.push(svg("path", { d: `M${left + 18 + i * 32} ${y + 9}h12m-4 -3l5 3l-5 3M${left + 30 + i * 32} ${y + 21}h-12m4 -3l-5 3l5 3`, class: "p-shear" }));
  }
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, class: "picture", "aria-hidden": "true" }, ...parts);
}
