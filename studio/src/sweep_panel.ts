// SPDX-License-Identifier: Apache-2.0
// A sweep: drag through its points, and see a figure of merit over the swept key.
import { Result, Table, get, table } from "./api";
import { attempt, el, labelled, select } from "./dom";
import { key_words, number, words } from "./format";
import { Plot } from "./plot";

export function sweep_panel(sweep: Result, show_point: (result: Result) => void): HTMLElement {
  const text = el("output", {}, "");
  const range = el("input", { type: "range", min: "0", max: "0", step: "1", value: "0", oninput: () => attempt(() => pick(Number(range.value))) });
  const plot = new Plot(() => {}, 220);
  const box = el("section", { class: "sweep" }, el("h2", {}, "Sweep"), el("div", { class: "row" }, labelled("Point of the sweep", range), text));
  const kept = new Map<number, Promise<Result>>();
  let rows: Table, finished: number[] = [], wanted = -1;

  const cell = (name: string, row: number) => {
    const column = rows.columns.find((one) => one.name === name)!;
    return column.texts ? column.texts[row] : number(column.values[row]);
  };

  async function pick(place: number): Promise<void> {
    wanted = place;
    const row = finished[place];
    const folder = sweep.points![row];
    text.textContent = keys().map((one) => `${key_words(one.name)} = ${cell(one.name, row)} ${one.unit === "1" ? "" : one.unit}`).join(", ");
    if (!kept.has(row)) kept.set(row, get<Result>("/api/result", { path: `${sweep.path}/points/${folder}` }));
    const result = await kept.get(row)!;
    if (wanted === place) show_point(result);
  }

  const keys = () => {
    const status = rows.columns.findIndex((one) => one.name === "status");
    return rows.columns.slice(2, status);
  };

  attempt(async () => {
    rows = await table(sweep.path, "sweep");
    const status = rows.columns.findIndex((one) => one.name === "status");
    finished = Array.from({ length: rows.rows }, (_, i) => i).filter((i) => rows.columns[status].texts?.[i] === "finished");
    if (!finished.length) {
      box.append(el("p", { class: "hint" }, "No point is finished."));
      return;
    }
    const key = keys()[0];
    const metrics = rows.columns.slice(status + 2).filter((one) => !one.texts);
    const draw = (name: string) => {
      const metric = metrics.find((one) => one.name === name)!;
      const order = [...finished].sort((a, b) => key.values[a] - key.values[b]);
      plot.show([{ label: words(name), unit: metric.unit, time: Float64Array.from(order, (i) => key.values[i]), values: Float64Array.from(order, (i) => metric.values[i]), marked: true }],
        { axis: `${key_words(key.name)}${key.unit && key.unit !== "1" ? ` [${key.unit}]` : ""}` });
    };
    if (!key.texts && metrics.length) {
      const first = metrics.some((one) => one.name === "peak_sampled_current_difference") ? "peak_sampled_current_difference" : metrics[0].name;
      box.append(labelled("Figure over the swept key", select(metrics.map((one) => [one.name, words(one.name)]), first, draw)), plot.element);
      draw(first);
    }
    range.max = String(finished.length - 1);
    await pick(0);
  });
  return box;
}
