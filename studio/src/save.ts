// SPDX-License-Identifier: Apache-2.0
import { button, el, say } from "./dom";
import { Series } from "./series";

export function save(name: string, content: Blob): void {
  const link = el("a", { href: URL.createObjectURL(content), download: name });
  document.body.append(link);
  link.click();
  link.remove();
  window.setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

export async function copy(text: string, what: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    say(`${what} copied: ${text.split("\n")[0]}`);
  } catch {
    say(text); // a browser that keeps its clipboard for itself
  }
}

/// "Copy as command" and "Copy as Python".
export function copy_buttons(command: () => string | Promise<string>, python: () => string | Promise<string>): HTMLElement {
  return el("span", { class: "row" },
    button("Copy as command", async () => copy(await command(), "Command"), "small"),
    button("Copy as Python", async () => copy(await python(), "Python"), "small"));
}

export function save_canvas(name: string, canvas: HTMLCanvasElement): void {
  canvas.toBlob((blob) => blob && save(name, blob), "image/png");
}

/// Rows of every series one below the other, with units in the header.
export function csv_of(series: Series[]): Blob {
  const cell = (text: string) => (/[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text);
  const rows = ["series,time [s],value,unit"];
  for (const one of series) {
    one.time.forEach((time, i) => rows.push([cell(one.label), time, one.values[i], one.unit].join(",")));
  }
  return new Blob([rows.join("\n") + "\n"], { type: "text/csv" });
}

const escaped = (text: string) => text.replace(/[&<>"']/g, (c) => `&#${c.charCodeAt(0)};`);

/// The curves as a figure of their own, for a paper.
export function svg_of(series: Series[], title: string, colours: string[], unit: string, factor: number): Blob {
  const [width, height, left, bottom, top] = [800, 420, 70, 50, 30 + 18 * Math.ceil(series.length / 2)];
  const all = series.flatMap((one) => Array.from(one.values).filter(Number.isFinite));
  const [low, high] = [Math.min(0, ...bounds(all)), Math.max(0, ...bounds(all))];
  const end = Math.max(...series.map((one) => one.time[one.time.length - 1]));
  const x = (time: number) => left + (time / end) * (width - left - 20);
  const y = (value: number) => height - bottom - ((value - low) / (high - low || 1)) * (height - bottom - top);
  const parts = [`<text x="${left}" y="18" font-size="14">${escaped(title)}</text>`];
  for (let i = 0; i <= 5; ++i) {
    const [time, value] = [(end * i) / 5, low + ((high - low) * i) / 5];
    parts.push(`<path d="M${x(time)} ${top}V${height - bottom}M${left} ${y(value)}H${width - 20}" stroke="#ddd"/>`,
      `<text x="${x(time)}" y="${height - bottom + 18}" text-anchor="middle">${Number(time.toPrecision(3))}</text>`,
      `<text x="${left - 6}" y="${y(value) + 4}" text-anchor="end">${Number((value * factor).toPrecision(3))}</text>`);
  }
  parts.push(`<text x="${width / 2}" y="${height - 10}" text-anchor="middle">time [s]</text>`,
    `<text x="16" y="${height / 2}" transform="rotate(-90 16 ${height / 2})" text-anchor="middle">${escaped(unit || "1")}</text>`);
  series.forEach((one, i) => {
    const at = (k: number, row: number) => (Number.isFinite(one.values[row] ?? NaN) ? `${x(one.time[k]).toFixed(2)},${y(one.values[row]).toFixed(2)}` : "");
    const beside = one.step === "held" ? -1 : 1; // whose value a corner of a step has
    const path = Array.from(one.time, (_, k) => (one.step === "held" ? [at(k, k + beside), at(k, k)] : one.step ? [at(k, k), at(k, k + beside)] : [at(k, k)])).flat();
    const colour = colours[i % colours.length];
    parts.push(`<polyline fill="none" stroke="${colour}" stroke-width="1.4" points="${path.filter(Boolean).join(" ")}"/>`,
      `<text x="${left + (i % 2) * 360}" y="${38 + 18 * Math.floor(i / 2)}" fill="${colour}">${escaped(one.label)}</text>`);
  });
  return new Blob([`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" font-family="sans-serif" font-size="12">` +
    `<rect width="100%" height="100%" fill="#fff"/>${parts.join("")}</svg>`], { type: "image/svg+xml" });
}

function bounds(values: number[]): [number, number] {
  return values.reduce<[number, number]>(([a, b], v) => [Math.min(a, v), Math.max(b, v)], [0, 0]);
}
