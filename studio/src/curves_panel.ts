// SPDX-License-Identifier: Apache-2.0
// Signals of the chosen results over one another, with a measurement, error bands, exports.
import { Result, get } from "./api";
import { line_colours } from "./colours";
import { attempt, button, el, labelled, say } from "./dom";
import { Plot } from "./plot";
import { csv_of, save, save_canvas, svg_of } from "./save";
import { Quantity, Series, quantities, read_measurement, series_of } from "./series";

export class CurvesPanel {
  readonly element: HTMLElement;
  end = 1;
  private plot: Plot;
  private results: Result[] = [];
  private known: Quantity[] = [];
  private chosen = "sampled/difference";
  private measured: Series[] = [];
  private asked = 0;
  private choice = el("select", { onchange: () => { this.chosen = this.choice.value; attempt(() => this.draw()); } });
  private log = el("input", { type: "checkbox", onchange: () => attempt(() => this.draw()) });
  private bands = el("input", { type: "checkbox", checked: true, onchange: () => attempt(() => this.draw()) });
  private file = el("input", { type: "file", accept: ".csv,text/csv", onchange: () => attempt(() => this.take_file()) });
  private stored = el("select", { onchange: () => attempt(() => this.take_stored()) });

  constructor(pick: (time: number) => void) {
    this.plot = new Plot(pick);
    const options = el("div", { class: "row controls" }, el("div", { class: "curve-choice" }, labelled("Curve", this.choice)), check_box("Log scale of magnitudes", this.log), check_box("Error bands", this.bands));
    this.element = el("section", { class: "curves", "aria-label": "Curves" }, options, this.plot.element,
      el("div", { class: "row controls" },
        button("Save CSV", () => save("curves.csv", csv_of(this.plot.series)), "small"),
        button("Save SVG", () => save("curves.svg", svg_of(this.plot.series, this.choice.selectedOptions[0]?.textContent ?? "", line_colours(), this.plot.scaled.unit, this.plot.scaled.factor)), "small"),
        button("Save PNG", () => { const canvas = this.plot.canvas(); if (canvas) save_canvas("curves.png", canvas); }, "small"),
        labelled("Lay a measured CSV over it", this.file), labelled("or one of this folder", this.stored),
        button("Clear measurement", () => { this.measured = []; attempt(() => this.draw()); }, "small")));
    window.addEventListener("theme", () => attempt(() => this.draw()));
    attempt(async () => {
      const files = await get<{ data: string[] }>("/api/files");
      this.stored.replaceChildren(el("option", { value: "" }, "none"), ...files.data.map((name) => el("option", { value: name }, name)));
    });
  }

  async show(results: Result[]): Promise<void> {
    this.results = results;
    this.known = results.length ? await quantities(results[0]) : [];
    if (results !== this.results) return;
    this.choice.replaceChildren(...this.known.map((one) => el("option", { value: one.id }, one.label)));
    if (!this.known.some((one) => one.id === this.chosen)) this.chosen = this.known[0]?.id ?? "";
    this.choice.value = this.chosen;
    await this.draw();
  }

  mark(time: number): void { this.plot.mark(time); }

  private async draw(): Promise<void> {
    const mine = ++this.asked;
    const quantity = this.known.find((one) => one.id === this.chosen);
    const lists = quantity ? await Promise.all(this.results.map((result) => series_of(result, quantity, this.results.length > 1 || quantity.columns.length === 1 ? result.path : ""))) : [];
    if (mine !== this.asked) return;
    const series = lists.flat();
    const same = this.measured.filter((one) => !series.length || one.unit === series[0].unit);
    const named = same.filter((one) => quantity?.columns.some((name) => one.name === name));
    const fitting = named.length ? named : same;
    if (this.measured.length && !fitting.length) say(`the measurement has no column in ${series[0].unit}`, true);
    this.end = Math.max(0, ...series.map((one) => one.time[one.time.length - 1] ?? 0)) || 1;
    this.plot.show([...series, ...fitting], { log: this.log.checked, bands: this.bands.checked });
  }

  private async take_file(): Promise<void> {
    const file = this.file.files?.[0];
    if (!file) return;
    this.measured = read_measurement(await file.text(), file.name);
    await this.draw();
  }

  private async take_stored(): Promise<void> {
    if (!this.stored.value) return;
    const { text } = await get<{ text: string }>("/api/text", { path: this.stored.value });
    this.measured = read_measurement(text, this.stored.value);
    await this.draw();
  }
}

export function check_box(text: string, box: HTMLInputElement): HTMLElement {
  return el("label", { class: "check" }, box, ` ${text}`);
}
