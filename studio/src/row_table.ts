// SPDX-License-Identifier: Apache-2.0
// The tables of a list, layers or taxels, as rows: read from the text, so that they stand while a case has mistakes.
import { CaseError, CaseValue, Key } from "./api";
import { button, el } from "./dom";
import { FieldControl, field_control } from "./field_control";
import { words } from "./format";
import { blocks, with_block, with_block_before, without_block, written_in } from "./table_text";

export interface RowList {
  list: string; title: string; one: string; ordered: boolean;
  /// Text of one more table, to add. @param count how many there are
  another(rows: string[], count: number, valid: CaseValue[]): string;
}

function renamed(block: string, name: string): string {
  return block.replace(/^(\s*name\s*=\s*).*$/m, (_, begin) => `${begin}${JSON.stringify(name)}`);
}

function free_name(rows: string[], one: string): string {
  const taken = new Set(rows.map((row) => written_in(row, "name").replace(/^["']|["']$/g, "")));
  for (let i = rows.length + 1; ; ++i) if (!taken.has(`${one}${i}`)) return `${one}${i}`;
}

export const row_lists: RowList[] = [
  { list: "skin.layers", title: "Layers, from the bottom up", one: "layer", ordered: true,
    another: (rows) => renamed(rows[rows.length - 1] ?? '[[skin.layers]]\nname = ""\nrole = "electrode"\nmaterial = "platinum"\nthickness = "10 um"\n', free_name(rows, "layer ")) },
  { list: "readout.taxels", title: "Taxels of the top electrode", one: "taxel", ordered: false,
    another: (rows, count, valid) => {
      const size = (key: string) => (valid.find((one) => one.key === key)?.numbers[0] ?? 1e-3) * 1e3;
      const mm = (value: number) => `"${Number(value.toPrecision(6))} mm"`;
      // Beside the last one, where the skin has room; the check says where it has none.
      const last = valid.find((one) => one.key === `readout.taxels[${count - 1}].upper`)?.numbers;
      const from = last ? last[0] * 1e3 : 0, length = size("skin.length"), to = from < length ? from + (length - from) / 2 : from;
      return `[[readout.taxels]]\nname = ${JSON.stringify(free_name(rows, "t"))}\nlower = [${mm(from)}, "0 mm"]\nupper = [${mm(to)}, ${mm(size("skin.width"))}]\n`;
    } },
];

export class RowTable {
  readonly element = el("div", { class: "rows" });
  private cells = new Map<string, { control: FieldControl; problem: HTMLElement }>();
  private count = -1;
  private columns: [string, Key][];

  constructor(readonly own: RowList, keys: Key[], private edit: (key: string, value: string) => void, private rewrite: (change: (text: string) => string) => void) {
    const begin = `${own.list}[].`;
    this.columns = keys.filter((one) => one.key.startsWith(begin)).map((one) => [one.key.slice(begin.length), one]);
  }

  /// True if there are any in the text; then the other ways to write the list have no fields.
  get stands(): boolean { return this.count > 0; }

  /// @param valid of the case when it was last valid
  show(text: string, valid: CaseValue[]): void {
    const rows = blocks(text, this.own.list);
    // Lists that are written in one line, and grids of taxels, have fields of their own.
    this.element.hidden = !rows.length && valid.some((one) => one.key.startsWith(`${this.own.list}[`) || (one.key.startsWith(`${this.own.list}.`) && one.origin !== "default"));
    if (rows.length !== this.count) this.build(rows, valid);
    for (const [key, { control }] of this.cells) {
      const [, index, column] = /\[(\d+)\]\.(\w+)$/.exec(key)!;
      control.show(written_in(rows[Number(index)], column));
    }
  }

  mark(errors: CaseError[]): void {
    for (const [key, { control, problem }] of this.cells) {
      const own = errors.filter((error) => error.keys.includes(key));
      for (const input of control.inputs()) input.setAttribute("aria-invalid", String(own.length > 0));
      problem.textContent = own.map((error) => `${error.message}: ${error.remedy}`).join("\n");
    }
  }

  private build(rows: string[], valid: CaseValue[]): void {
    this.count = rows.length;
    this.cells.clear();
    const { list, title, one, ordered } = this.own;
    const lines = rows.map((_, i) => el("tr", {}, el("th", { scope: "row" }, String(i + 1)), ...this.columns.map(([column, row]) => this.cell(`${list}[${i}].${column}`, row, `${words(column)} of ${one} ${i + 1}`)),
      el("td", {}, el("span", { class: "entry" }, ordered && i > 0 ? this.tool("↑", `Move ${one} ${i + 1} down by one`, (text) => with_block_before(text, list, i)) : null,
        this.tool("×", `Remove ${one} ${i + 1}`, (text) => without_block(text, list, i))))));
    this.element.replaceChildren(el("h3", {}, title),
      ...(rows.length ? [el("div", { class: "scroll" }, el("table", {}, el("thead", {}, el("tr", {}, ...["", ...this.columns.map(([column]) => words(column)), ""].map((head) => el("th", { scope: "col" }, head)))), el("tbody", {}, ...lines)))] : []),
      button(`Add a ${one}`, () => this.rewrite((text) => with_block(text, list, this.own.another(blocks(text, list), this.count, valid))), "small"));
  }

  private cell(key: string, row: Key, label: string): HTMLElement {
    const control = field_control(key, row, label, (value) => this.edit(key, value));
    for (const input of control.inputs()) input.setAttribute("aria-label", label);
    const problem = el("span", { class: "field-problem", role: "alert" });
    this.cells.set(key, { control, problem });
    return el("td", { title: row.help }, control.element, problem);
  }

  private tool(sign: string, label: string, change: (text: string) => string): HTMLElement {
    const made = button(sign, () => { this.count = -1; this.rewrite(change); }, "small");
    made.setAttribute("aria-label", label);
    return made;
  }
}
