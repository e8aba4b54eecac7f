// SPDX-License-Identifier: Apache-2.0
// The case as a form, made from the schema table: one field per key, with unit, range, default and help.
import { CaseError, CaseValue, Key } from "./api";
import { el, labelled } from "./dom";
import { FieldControl, field_control, field_label, plain } from "./field_control";
import { words } from "./format";
import { RowTable, row_lists } from "./row_table";

export type Edit = (key: string, value: string) => void;

const headings: Record<string, string> = { title: "Case", skin: "Skin", materials: "Materials", slider: "Slider", motion: "Motion", contact: "Contact",
  electrochemistry: "Ions", coupling: "Coupling", strain: "Strain", readout: "Readout", numerics: "Accuracy", output: "Output" };

export class CaseForm {
  readonly element = el("div", { class: "form" });
  private fields = new Map<string, { control: FieldControl; problem: HTMLElement; box: HTMLElement }>();
  private shape = "";
  private last: { values: CaseValue[]; applicable: string[] } = { values: [], applicable: [] };

  private tables: RowTable[];

  constructor(private keys: Key[], private edit: Edit, rewrite: (change: (text: string) => string) => void) {
    this.tables = row_lists.map((list) => new RowTable(list, keys, edit, rewrite));
  }

  /// Rows of layers and taxels, as they stand in the text.
  show_rows(text: string): void {
    for (const table of this.tables) {
      table.show(text, this.last.values);
      for (const [key, { box }] of this.fields) if (key.startsWith(`${table.own.list}.`)) box.hidden = table.stands;
    }
  }

  /// Fields are made once for the same set of keys, so that what one types in stays in place.
  /// @param applicable keys of the table that have a meaning in this case; others have no field
  show(values: CaseValue[], applicable: string[]): void {
    this.last = { values, applicable };
    const given = new Map(values.map((one) => [one.key, one]));
    const shape = [...given.keys(), ...applicable].join();
    if (shape !== this.shape) {
      this.shape = shape;
      this.build(given, new Set(applicable));
    }
    for (const [key, { control, box }] of this.fields) {
      const value = given.get(key);
      control.show(value?.written ?? this.row(key)?.default ?? "");
      box.classList.toggle("default", !value || value.origin === "default" || value.origin === "preset");
    }
    this.mark([]);
  }

  /// Fields for keys that a case with mistakes lacks, beside those that it had when it was valid.
  offer(keys: string[]): void {
    const { values, applicable } = this.last;
    if (!values.length || keys.every((key) => this.fields.has(key))) return;
    this.show(values, [...applicable, ...keys]);
    this.last = { values, applicable };
  }

  mark(errors: CaseError[]): void {
    for (const [key, { control, problem, box }] of this.fields) {
      const own = errors.filter((error) => error.keys.includes(key));
      for (const input of control.inputs()) input.setAttribute("aria-invalid", String(own.length > 0));
      problem.textContent = own.map((error) => `${error.message}: ${error.remedy}`).join("\n");
      if (own.length) box.closest("details")?.setAttribute("open", "");
    }
    for (const table of this.tables) table.mark(errors);
  }

  private row(key: string): Key | undefined {
    const pattern = key.replace(/\[\d+\]/g, "[]").replace(/^materials\.[^.]+\./, "materials.NAME.");
    return this.keys.find((one) => one.key === pattern);
  }

  private build(given: Map<string, CaseValue>, applicable: Set<string>): void {
    this.fields.clear();
    const sections = new Map<string, HTMLElement[]>();
    const listed = new Set<string>();
    const add = (key: string, row: Key) => {
      if (listed.has(key)) return;
      listed.add(key);
      const section = key.split(/[.[]/)[0];
      if (!sections.has(section)) sections.set(section, []);
      sections.get(section)!.push(this.field(key, row));
    };
    for (const row of this.keys) {
      if (row.key.startsWith("motion.waypoints[]")) continue; // in the editor of the path
      const table = this.tables.find((one) => row.key.startsWith(`${one.own.list}[]`));
      if (table) {
        const section = row.key.split(".")[0];
        if (!sections.has(section)) sections.set(section, []);
        if (!sections.get(section)!.includes(table.element)) sections.get(section)!.push(table.element);
        if (!table.element.hidden) continue;
      }
      if (/\[\]|NAME/.test(row.key)) {
        for (const key of given.keys()) if (this.row(key) === row) add(key, row);
      } else if (applicable.has(row.key) || given.has(row.key)) add(row.key, row);
    }
    const open = new Map([...this.element.querySelectorAll<HTMLDetailsElement>(":scope > details")].map((one) => [one.dataset.section, one.open]));
    this.element.replaceChildren(...[...sections].map(([name, fields]) =>
      el("details", { "data-section": name, open: open.get(name) ?? ["title", "slider", "motion", "contact", "coupling", "numerics"].includes(name) },
        el("summary", {}, headings[name] ?? words(name)), ...fields)));
  }

  private field(key: string, row: Key): HTMLElement {
    const label = field_label(key);
    const control = field_control(key, row, label, (value) => this.edit(key, value));
    const facts = [row.si_unit ? `SI unit ${row.si_unit}` : "", row.range, row.default ? `default ${plain(row.default)}` : row.need].filter(Boolean).join("; ");
    const problem = el("span", { class: "field-problem", role: "alert" });
    const box = labelled(label, control.element);
    control.element.setAttribute("aria-describedby", `${control.element.id}-help`);
    box.title = `${key}: ${row.help}`;
    box.append(problem, el("details", { class: "help" }, el("summary", {}, "?"),
      el("div", { id: `${control.element.id}-help` }, `${row.help} ${row.range_reason}`, el("br"), el("code", {}, key), ` ${facts}`, row.source ? el("div", { class: "hint" }, `Source: ${row.source}`) : null)));
    this.fields.set(key, { control, problem, box });
    return box;
  }
}
