// SPDX-License-Identifier: Apache-2.0
// The case as a form, made from the schema table: one field per key, with unit, range, default and help.
import { CaseError, CaseValue, Key } from "./api";
import { el, labelled, select } from "./dom";
import { words } from "./format";

export type Edit = (key: string, value: string) => void;

const headings: Record<string, string> = { title: "Case", skin: "Skin", materials: "Materials", slider: "Slider", motion: "Motion", contact: "Contact",
  electrochemistry: "Ions", coupling: "Coupling", strain: "Strain", readout: "Readout", numerics: "Accuracy", output: "Output" };

export class CaseForm {
  readonly element = el("div", { class: "form" });
  private fields = new Map<string, { control: HTMLInputElement | HTMLSelectElement; problem: HTMLElement; box: HTMLElement }>();
  private shape = "";
  private last: { values: CaseValue[]; applicable: string[] } = { values: [], applicable: [] };

  constructor(private keys: Key[], private edit: Edit) {}

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
      const written = value?.written ?? this.row(key)?.default ?? "";
      if (document.activeElement !== control) control.value = plain(written);
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
      control.setAttribute("aria-invalid", String(own.length > 0));
      problem.textContent = own.map((error) => `${error.message}: ${error.remedy}`).join("\n");
      if (own.length) box.closest("details")?.setAttribute("open", "");
    }
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
    const change = () => this.edit(key, typed(control.value, row));
    const control = row.choices.length
      ? select(row.choices.map((choice) => [choice, choice]), "", change)
      : el("input", { type: "text", onchange: change, autocomplete: "off", spellcheck: false, inputMode: row.type === "number" || row.type === "integer" ? "decimal" : "text" });
    control.dataset.key = key;
    const facts = [row.si_unit ? `SI unit ${row.si_unit}` : "", row.range, row.default ? `default ${plain(row.default)}` : row.need].filter(Boolean).join("; ");
    const problem = el("span", { class: "field-problem", role: "alert" });
    const name = key.replace(/^[a-z]+[.]?/, "") || key;
    const box = labelled(words(name.replace(/\[(\d+)\]\./, (_, i) => `${Number(i) + 1}: `).replace(/\./g, " ")), control);
    control.setAttribute("aria-describedby", `${control.id}-help`);
    box.title = `${key}: ${row.help}`;
    box.append(problem, el("details", { class: "help" }, el("summary", {}, "?"),
      el("div", { id: `${control.id}-help` }, `${row.help} ${row.range_reason}`, el("br"), el("code", {}, key), ` ${facts}`, row.source ? el("div", { class: "hint" }, `Source: ${row.source}`) : null)));
    this.fields.set(key, { control, problem, box });
    return box;
  }
}

/// A text without its quotes; lists stay as they are.
function plain(written: string): string {
  try {
    return /^"(?:[^"\\]|\\.)*"$/.test(written) ? JSON.parse(written) : written;
  } catch {
    return written;
  }
}

function typed(value: string, row: Key): string {
  return row.type === "text" || row.type === "choice" ? JSON.stringify(value) : value.trim();
}
