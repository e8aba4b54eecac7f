// SPDX-License-Identifier: Apache-2.0
// Actions on a case: run it, sweep a key, fit keys to a measurement.
import { CaseValue, get, post, upload } from "./api";
import { attempt, button, el, labelled, say, select } from "./dom";
import { key_words } from "./format";
import { copy_buttons } from "./save";
import { store } from "./store";

interface Started { folder: string; command: string; python: string; }

export class CaseActions {
  readonly element: HTMLElement;
  private name = el("input", { type: "text", value: store.name, maxLength: 60, pattern: "[A-Za-z0-9][A-Za-z0-9._\\-]*", required: true, oninput: () => this.judge_name() });
  private name_problem = el("span", { class: "field-problem", role: "alert" });
  private key = el("select", { onchange: () => this.propose() });
  private from = el("input", { type: "text" });
  private step = el("input", { type: "text" });
  private to = el("input", { type: "text" });
  private preview = el("span", { class: "hint" });
  private data = el("select", { onchange: () => attempt(() => this.list_columns()) });
  private file = el("input", { type: "file", accept: ".csv,text/csv", onchange: () => attempt(() => this.take_file()) });
  private column = el("select");
  private free = el("select", { multiple: true, size: 5 });
  private buttons: HTMLButtonElement[] = [];
  private values: CaseValue[] = [];
  private valid = false;

  constructor() {
    const run = button("Run", () => this.start(this.run()), "primary");
    const sweep = button("Run the sweep", () => this.start(this.sweep()), "primary");
    const fit = button("Run the fit", () => this.start(this.fit()), "primary");
    run.id = "run-button";
    this.buttons = [run, sweep, fit];
    for (const input of [this.from, this.step, this.to]) input.addEventListener("input", () => this.tell_values());
    this.element = el("div", { class: "actions" },
      el("div", { class: "row" }, labelled("Name of the results", this.name), this.name_problem, run, this.copies(() => this.run())),
      el("details", {}, el("summary", {}, "Sweep a key"),
        el("div", { class: "row" }, labelled("Key", this.key), labelled("From", this.from), labelled("Step", this.step), labelled("To", this.to)),
        this.preview, el("div", { class: "row" }, sweep, this.copies(() => this.sweep()))),
      el("details", { ontoggle: () => attempt(() => this.list_data()) }, el("summary", {}, "Fit to a measurement"),
        el("div", { class: "row" }, labelled("Measured CSV of this folder", this.data), labelled("or add a file", this.file), labelled("Column", this.column)),
        el("div", { class: "row" }, labelled("Keys to fit", this.free, "Ctrl for several"), fit, this.copies(() => this.fit()))));
  }

  /// @param values of a valid case, or nothing for one with mistakes
  allow(values: CaseValue[] | undefined): void {
    this.valid = Boolean(values);
    this.judge_name();
    if (!values) return;
    this.values = values;
    const numeric = values.filter((one) => one.numbers.length === 1 && !one.key.startsWith("numerics."));
    const fill = (control: HTMLSelectElement, wanted: string) => {
      const kept = [...control.selectedOptions].map((option) => option.value);
      control.replaceChildren(...numeric.map((one) => el("option", { value: one.key, title: one.key }, key_words(one.key))));
      for (const option of control.options) option.selected = kept.length ? kept.includes(option.value) : option.value === wanted;
    };
    fill(this.key, "contact.friction");
    fill(this.free, "coupling.coefficient");
    if (!this.from.value) this.propose();
  }

  private judge_name(): void {
    store.name = this.name.value;
    const good = this.name.checkValidity();
    this.name.setAttribute("aria-invalid", String(!good));
    this.name_problem.textContent = good ? "" : this.name.value ? "letters, digits, dots, - and _; a letter or digit first" : "the results need a name";
    for (const one of this.buttons) one.disabled = !this.valid || !good;
  }

  private copies(request: () => object): HTMLElement {
    const ask = async () => post<Started>("/api/jobs", { ...request(), dry: true });
    return copy_buttons(async () => this.tried(ask, (one) => one.command), async () => this.tried(ask, (one) => one.python));
  }

  private async tried(ask: () => Promise<Started>, part: (one: Started) => string): Promise<string> {
    try {
      return part(await ask());
    } catch (problem) {
      say((problem as Error).message, true);
      throw problem;
    }
  }

  private start(request: object): void {
    attempt(async () => {
      const started = await post<Started>("/api/jobs", request);
      store.awaited.add(started.folder);
      say(`Started: ${started.command}`);
    });
  }

  private base(kind: string) {
    return { kind, case: store.case_text, source: store.source, name: this.name.value };
  }
  private run() { return this.base("run"); }
  private sweep() {
    return { ...this.base("sweep"), name: `${this.name.value}-sweep`, over: [{ key: this.key.value, values: this.swept() }] };
  }
  private fit() {
    return { ...this.base("fit"), name: `${this.name.value}-fit`, data: this.data.value, column: this.column.value, free: [...this.free.selectedOptions].map((one) => one.value) };
  }

  /// The number and unit of a value as the case writes it.
  private parts(): [number, string] {
    const written = this.values.find((one) => one.key === this.key.value)?.written.replace(/"/g, "") ?? "";
    const match = /^\s*([-+\d.eE]+)\s*(.*)$/.exec(written);
    return match ? [Number(match[1]), match[2]] : [0, ""];
  }

  private propose(): void {
    const [value, unit] = this.parts();
    const tail = unit ? ` ${unit}` : "";
    const rounded = (x: number) => String(Number(x.toPrecision(3)));
    const size = Math.abs(value) || 1;
    [this.from.value, this.step.value, this.to.value] = [rounded(value - size / 2) + tail, rounded(size / 4) + tail, rounded(value + size / 2) + tail];
    this.tell_values();
  }

  private swept(): string[] {
    const read = (input: HTMLInputElement) => /^\s*([-+\d.eE]+)\s*(.*?)\s*$/.exec(input.value);
    const [from, step, to] = [read(this.from), read(this.step), read(this.to)];
    if (!from || !step || !to || new Set([from[2], step[2], to[2]]).size > 1) return [];
    const [first, width, last] = [Number(from[1]), Number(step[1]), Number(to[1])];
    const count = Math.floor((last - first) / width + 1e-9);
    if (!(count >= 0) || count > 199) return [];
    return Array.from({ length: count + 1 }, (_, i) => `${Number((first + i * width).toPrecision(12))}${from[2] ? ` ${from[2]}` : ""}`);
  }

  private tell_values(): void {
    const values = this.swept();
    this.preview.textContent = values.length ? `${values.length} runs: ${values.slice(0, 6).join(", ")}${values.length > 6 ? ", …" : ""}` : "From, step and to are numbers with the same unit; at most 200 runs.";
    this.buttons[1].disabled = values.length === 0;
  }

  private async list_data(chosen = this.data.value): Promise<void> {
    const files = await get<{ data: string[] }>("/api/files");
    this.data.replaceChildren(...files.data.map((name) => el("option", { value: name }, name)));
    if (files.data.includes(chosen)) this.data.value = chosen;
    await this.list_columns();
  }

  private async list_columns(): Promise<void> {
    if (!this.data.value) return;
    const { text } = await get<{ text: string }>("/api/text", { path: this.data.value });
    const names = text.split("\n", 1)[0].split(",").map((title) => title.replace(/["\r]/g, "").trim().split(" [")[0]).filter((name) => name !== "time");
    this.column.replaceWith(this.column = select(names.map((name) => [name, name]), names.includes("current_difference") ? "current_difference" : names[0], () => {}));
    this.column.id = "fit-column";
    document.querySelector(`label[for="${this.column.id}"]`) ?? this.column.setAttribute("aria-label", "Column");
  }

  private async take_file(): Promise<void> {
    const file = this.file.files?.[0];
    if (!file) return;
    const stored = await upload(file.name.replace(/[^\w.-]/g, "-").replace(/^[^A-Za-z0-9]+/, ""), await file.text());
    await this.list_data(stored.path);
    say(`${stored.path} is in the folder`);
  }
}
