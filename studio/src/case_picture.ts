// SPDX-License-Identifier: Apache-2.0
import { svg } from "./dom";
import { Geometry } from "./geometry";

/// A case seen from the side and above: skin, slider, way, taxels.
export function case_picture(shape: Geometry): SVGElement {
  const [width, height] = [240, 130];
  const scale = 200 / shape.length;
  const left = 20, skin = 78;
  const parts: SVGElement[] = [];
  if (shape.curvature) return framed(width, height, bent(shape.curvature > 0));
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
    if (shape.path.length > 1) {
      parts.push(...path_seen(shape.path.map(([at, across]) => [left + at * scale, y - 14 - (across - Math.min(...shape.path.map((one) => one[1]))) * scale])));
    } else if (shape.stroke > 0) {
      const end = x + shape.stroke * scale * (shape.direction[0] || 1);
      parts.push(svg("path", { d: `M${x} ${y - 20}H${end - 3}m-5 -4l6 4l-6 4`, class: "p-way" }));
      if (shape.back_and_forth) parts.push(svg("path", { d: `M${x + 3} ${y - 20}m5 -4l-6 4l6 4`, class: "p-way" }));
      if (shape.cycles > 1) parts.push(words(end + 6, y - 15, `${shape.cycles} ×`));
    }
  } else if (shape.pressed) {
    for (let i = 0; i < 6; ++i) parts.push(svg("path", { d: `M${left + 20 + i * 32} ${y - 24}v18m-4 -6l4 6l4 -6`, class: "p-way" }));
  } else {
    for (let i = 0; i < 6; ++i) parts.push(svg("path", { d: `M${left + 18 + i * 32} ${y + 9}h12m-4 -3l5 3l-5 3M${left + 30 + i * 32} ${y + 21}h-12m4 -3l-5 3l5 3`, class: "p-shear" }));
  }
  // Drops of the water that moves in the core.
  if (shape.wet) for (let i = 0; i < 7; ++i) parts.push(svg("circle", { cx: left + 16 + i * 28, cy: y + 13 + (i % 2) * 8, r: 2.5, class: "p-drop" }));
  return framed(width, height, parts);
}

/// A path as seen from above, with its waypoints and an arrow at its end.
function path_seen(path: [number, number][]): SVGElement[] {
  const way = path.filter((at, i) => !i || at.some((value, axis) => value !== path[i - 1][axis]));
  if (way.length < 2) return [];
  const [end, before] = [way[way.length - 1], way[way.length - 2]];
  const angle = (Math.atan2(end[1] - before[1], end[0] - before[0]) * 180) / Math.PI;
  return [svg("path", { d: `M${way.map((at) => at.join(" ")).join("L")}`, class: "p-way" }),
    ...way.slice(0, -1).map(([x, y]) => svg("circle", { cx: x, cy: y, r: 2.5, class: "p-stop" })),
    svg("path", { d: "M-6 -4l6 4l-6 4", transform: `translate(${end.join(" ")}) rotate(${angle})`, class: "p-way" })];
}

function words(x: number, y: number, text: string): SVGElement {
  const element = svg("text", { x, y, class: "p-words" });
  element.textContent = text;
  return element;
}

function framed(width: number, height: number, parts: SVGElement[]): SVGElement {
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, class: "picture", "aria-hidden": "true" }, ...parts);
}

/// A strip between its electrodes, bent with its top face stretched or pressed.
function bent(top_stretched: boolean): SVGElement[] {
  const arc = (offset: number) => (top_stretched ? `M20 ${90 + offset}Q120 ${20 + offset} 220 ${90 + offset}` : `M20 ${50 + offset}Q120 ${120 + offset} 220 ${50 + offset}`);
  return ([[0, 7, "p-metal"], [13, 20, "p-core"], [26, 7, "p-metal"]] as [number, number, string][]).map(([offset, thick, kind]) =>
    svg("path", { d: arc(offset), class: `${kind} p-bent`, "stroke-width": thick }));
}
