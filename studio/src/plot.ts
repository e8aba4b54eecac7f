// SPDX-License-Identifier: Apache-2.0
// Curves over time with uPlot; a line marks the instant of the time bar.
import uPlot from "uplot";
import { is_dark, line_colours } from "./colours";
import { scale_for, number } from "./format";
import { Series } from "./series";

/// Marks of a log scale: the powers of ten.
function decades(_chart: uPlot, _axis: number, least: number, greatest: number): number[] {
  const first = Math.ceil(Math.log10(least) - 1e-9), last = Math.floor(Math.log10(greatest) + 1e-9);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => Number(`1e${first + i}`));
}

export class Plot {
  readonly element = document.createElement("div");
  scaled = { factor: 1, unit: "" };
  series: Series[] = [];
  private chart?: uPlot;
  private time = 0;
  private log = false;
  private bands = true;
  private axis = "time [s]";
  private line = Object.assign(document.createElement("div"), { className: "instant" });
  private watcher = new ResizeObserver(() => this.fit());

  /// @param pick called with the instant that a reader clicks on
  constructor(private pick: (time: number) => void, private height = 300) {
    this.element.className = "plot";
    this.element.setAttribute("role", "img");
    this.watcher.observe(this.element);
  }

  show(series: Series[], options: { log?: boolean; bands?: boolean; axis?: string } = {}): void {
    this.series = series;
    this.log = options.log ?? this.log;
    this.bands = options.bands ?? this.bands;
    this.axis = options.axis ?? this.axis;
    this.draw();
  }

  /// The mark is an element of its own: curves need not be drawn again while it moves.
  mark(time: number): void {
    this.time = time;
    this.place_mark();
  }

  canvas(): HTMLCanvasElement | undefined { return this.chart?.ctx.canvas; }

  private fit(): void {
    const width = this.element.clientWidth;
    if (this.chart && width > 0 && Math.abs(width - this.chart.width) > 1) this.chart.setSize({ width, height: this.height });
  }

  private draw(): void {
    this.chart?.destroy();
    this.chart = undefined;
    this.element.replaceChildren();
    const width = this.element.clientWidth || 600;
    const largest = this.series.reduce((most, one) => one.values.reduce((m, v) => (Math.abs(v) > m ? Math.abs(v) : m), most), 0);
    this.scaled = scale_for(largest, this.series[0]?.unit ?? "");
    const label = this.series.map((one) => one.label).join(", ");
    this.element.setAttribute("aria-label", this.series.length ? `${label} over ${this.axis}; largest magnitude ${number(largest * this.scaled.factor)} ${this.scaled.unit}` : "no curve");
    if (this.series.length === 0) return;
    // A log scale over more decades than these shows rounding, no signal.
    const smallest = this.log ? largest * 1e-6 : 0;
    const value = (v: number) => (!Number.isFinite(v) || (this.log && Math.abs(v) <= smallest) ? null : (this.log ? Math.abs(v) : v) * this.scaled.factor);
    const tables: uPlot.AlignedData[] = [];
    const described: uPlot.Series[] = [{ label: this.axis }];
    const bands: uPlot.Band[] = [];
    const colours = line_colours();
    this.series.forEach((one, i) => {
      const colour = colours[i % colours.length];
      const line: uPlot.Series = { label: `${one.label}${this.scaled.unit ? ` [${this.scaled.unit}]` : ""}`, stroke: colour, width: 1.5,
        dash: i >= colours.length ? [6, 4] : undefined, spanGaps: true, points: { show: Boolean(one.points || one.marked), size: one.marked ? 8 : 4 },
        value: (_, v) => (v === null ? "–" : number(v)) };
      const paths = one.step && uPlot.paths.stepped!({ align: one.step === "held" ? 1 : -1 });
      if (paths) line.paths = paths;
      if (one.points) line.width = 0;
      const columns: (number | null)[][] = [Array.from(one.values, value)];
      described.push(line);
      if (one.band && this.bands && !this.log) {
        const at = described.length;
        const edge = { label: "", stroke: undefined, width: 0, points: { show: false }, spanGaps: true, ...(paths ? { paths } : {}) };
        described.push({ ...edge }, { ...edge });
        columns.push(Array.from(one.values, (v, k) => value(v + one.band![k])), Array.from(one.values, (v, k) => value(v - one.band![k])));
        bands.push({ series: [at, at + 1], fill: colour + "44" });
      }
      tables.push([Array.from(one.time), ...columns] as uPlot.AlignedData);
    });
    const ink = is_dark() ? "#d5dae1" : "#333";
    const grid = { stroke: is_dark() ? "#39424e" : "#e3e6ea", width: 1 };
    const axis = { stroke: ink, grid, ticks: grid };
    this.chart = new uPlot({
      width, height: this.height, series: described, bands,
      scales: { x: { time: false }, y: { distr: this.log ? 3 : 1 } },
      axes: [{ ...axis, label: this.axis, labelSize: 22 }, { ...axis, label: this.scaled.unit || "1", labelSize: 20, size: 62,
        ...(this.log ? { splits: decades } : {}), values: (_, marks) => marks.map((mark) => (mark === null ? "" : number(mark, 3))) }],
      cursor: { drag: { x: true, y: false } },
      legend: { live: true },
      hooks: { draw: [() => this.place_mark()], ready: [(chart) => {
        chart.over.addEventListener("click", () => { if (chart.cursor.left! >= 0) this.pick(chart.posToVal(chart.cursor.left!, "x")); });
        // The edges of bands need no line in the legend.
        chart.root.querySelectorAll(".u-series").forEach((row, i) => { if (i > 0 && !described[i]?.label) (row as HTMLElement).hidden = true; });
      }] },
    }, uPlot.join(tables, tables.map((one) => one.map(() => 1))), this.element);
  }

  private place_mark(): void {
    const chart = this.chart;
    if (!chart) return;
    if (this.line.parentElement !== chart.over) chart.over.append(this.line);
    const x = chart.valToPos(this.time, "x");
    this.line.hidden = this.axis !== "time [s]" || !(x >= 0 && x <= chart.over.clientWidth);
    this.line.style.transform = `translateX(${x}px)`;
  }
}
