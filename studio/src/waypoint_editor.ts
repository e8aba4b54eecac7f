// SPDX-License-Identifier: Apache-2.0
// A path through waypoints: a plan of the skin with points to drag, a table, and a CSV file in their place.
import { CaseValue, upload } from "./api";
import { attempt, button, el, say, svg } from "./dom";
import { number } from "./format";
import { Geometry } from "./geometry";
import { blocks, with_block, without_block, without_blocks } from "./table_text";

const columns = ["time", "position", "height", "force"];
const width = 420, margin = 14;

export class WaypointEditor {
  readonly element = el("div", { class: "waypoints" });
  private count = 0;

  /// @param edit sets a key; @param rewrite makes a new text of the case from the one before
  constructor(private edit: (key: string, value: string) => void, private rewrite: (change: (text: string) => string) => void) {}

  show(values: CaseValue[], shape: Geometry): void {
    const given = new Map(values.map((one) => [one.key, one]));
    this.count = 0;
    while (given.has(`motion.waypoints[${this.count}].time`)) ++this.count;
    const followed = values.some((one) => one.key === "motion.kind" && one.text === "waypoints");
    this.element.hidden = !followed;
    if (!followed || this.element.contains(document.activeElement?.closest("input") ?? null)) return;
    const file = el("input", { type: "file", accept: ".csv,text/csv", "aria-label": "CSV file of waypoints", onchange: () => attempt(() => this.take(file)) });
    const rows = Array.from({ length: this.count }, (_, i) => el("tr", {}, el("th", { scope: "row" }, String(i + 1)), ...columns.map((column) => {
      const key = `motion.waypoints[${i}].${column}`;
      const written = (given.get(key)?.written ?? "").replace(/"/g, "");
      return el("td", {}, el("input", { type: "text", size: column === "position" ? 16 : 8, value: written, "data-key": key, "aria-label": `${column} of waypoint ${i + 1}`,
        onchange: (event: Event) => this.edit(key, (event.target as HTMLInputElement).value) }));
    }), el("td", {}, this.count > 2 ? remover(i, () => this.rewrite((text) => without_block(text, list, i))) : null)));
    this.element.replaceChildren(
      el("h3", {}, "Path"), ...(shape.path.length ? [this.plan(shape), el("p", { class: "hint" }, "Seen from above; drag a point to move it.")] : []),
      ...(this.count ? [el("div", { class: "scroll" }, el("table", {}, el("thead", {}, el("tr", {}, ...["", "Time", "Place x, y", "Height", "or force", ""].map((title) => el("th", { scope: "col" }, title)))), el("tbody", {}, ...rows))),
        button("Add a waypoint", () => this.rewrite(with_waypoint_after_last), "small")] : [el("p", { class: "hint" }, "The path is read from a file.")]),
      el("div", { class: "row" }, el("span", { class: "hint" }, "Read the path from a CSV file instead:"), file));
  }

  private plan(shape: Geometry): SVGElement {
    const scale = (width - 2 * margin) / shape.length;
    const across = Math.max(scale, 80 / shape.width); // narrow skins are drawn wider
    const height = across * shape.width + 2 * margin;
    const at = ([x, y]: [number, number]) => [margin + x * scale, height - margin - y * across];
    const line = svg("polyline", { class: "p-way", points: shape.path.map((one) => at(one).join()).join(" ") });
    const [x0, y0] = at(shape.path[0]);
    const plan = svg("svg", { viewBox: `0 0 ${width} ${height}`, class: "plan", role: "img", "aria-label": "Plan of the skin with the path" },
      svg("rect", { x: margin, y: margin, width: width - 2 * margin, height: height - 2 * margin, class: "p-core" }),
      svg("rect", { x: x0 - shape.size[0] * scale / 2, y: y0 - shape.size[1] * across / 2, width: shape.size[0] * scale, height: shape.size[1] * across, class: "p-slider", opacity: 0.5 }), line);
    if (this.count !== shape.path.length) return plan;
    const points = shape.path.map((one) => [...one] as [number, number]);
    const dots: SVGElement[] = [];
    points.forEach((first) => {
      const place: [number, number] = [...first];
      // Waypoints at one place, as those of touchdown, move together.
      const together = points.flatMap((one, k) => (one[0] === first[0] && one[1] === first[1] ? [k] : []));
      const [cx, cy] = at(place);
      const dot = svg("circle", { cx, cy, r: 7, class: "p-point" }, svg("title", {}));
      dots.push(dot);
      dot.firstChild!.textContent = `Waypoint ${together.map((k) => k + 1).join(" and ")}`;
      dot.addEventListener("pointerdown", (event) => dot.setPointerCapture((event as PointerEvent).pointerId));
      dot.addEventListener("pointermove", (event) => {
        const pointer = event as PointerEvent;
        if (!dot.hasPointerCapture(pointer.pointerId)) return;
        const box = plan.getBoundingClientRect(), unit = width / box.width;
        const clamp = (value: number, half: number, most: number) => {
          const edge = Math.min(half + most / 100, most / 2); // the slider stays inside the skin
          return Math.max(edge, Math.min(most - edge, value));
        };
        place[0] = clamp(((pointer.clientX - box.left) * unit - margin) / scale, shape.size[0] / 2, shape.length);
        place[1] = clamp((height - margin - (pointer.clientY - box.top) * unit) / across, shape.size[1] / 2, shape.width);
        const [x, y] = at(place);
        for (const k of together) {
          points[k] = [...place];
          dots[k].setAttribute("cx", String(x));
          dots[k].setAttribute("cy", String(y));
        }
        line.setAttribute("points", points.map((one) => at(one).join()).join(" "));
      });
      dot.addEventListener("pointerup", () => {
        for (const k of together) this.edit(`motion.waypoints[${k}].position`, `["${number(place[0], 4)} mm", "${number(place[1], 4)} mm"]`);
      });
      plan.append(dot);
    });
    return plan;
  }

  private async take(input: HTMLInputElement): Promise<void> {
    const file = input.files?.[0];
    if (!file) return;
    const stored = await upload(file.name.replace(/[^\w.-]/g, "-").replace(/^[^A-Za-z0-9]+/, ""), await file.text());
    this.rewrite((text) => in_section(without_waypoints(text), "motion", `file = ${JSON.stringify(stored.path)}`));
    say(`The path is read from ${stored.path}`);
  }
}

function remover(index: number, click: () => void): HTMLElement {
  const cross = button("×", click, "small");
  cross.setAttribute("aria-label", `Remove waypoint ${index + 1}`);
  return cross;
}

const list = "motion.waypoints";

export function without_waypoints(text: string): string {
  const rest = without_blocks(text, list);
  return rest.replace(/^file\s*=.*\n/m, (line, at: number) => (section_at(rest, at) === "motion" ? "" : line));
}

/// The last one again, a second later.
function with_waypoint_after_last(text: string): string {
  const last = blocks(text, list).pop();
  if (!last) return text;
  return with_block(text, list, last.replace(/^(\s*time\s*=\s*")\s*([-+\d.eE]+)\s*(\w+)/m, (_, begin, value, unit) => `${begin}${Number(value) + (unit === "ms" ? 1000 : 1)} ${unit}`));
}

function section_at(text: string, at: number): string {
  return [...text.slice(0, at).matchAll(/^\[+\s*([\w.]+)/gm)].pop()?.[1] ?? "";
}

/// A line at the end of a section that is there.
export function in_section(text: string, section: string, line: string): string {
  return text.replace(new RegExp(`^\\[${section}\\][^\\n]*\\n(?:(?!\\s*\\[)[^\\n]*(?:\\n|$))*?(?=\\s*^\\[|\\s*$(?![\\s\\S]))`, "m"), (one) => `${one.replace(/\n*$/, "")}\n${line}\n`);
}
