// SPDX-License-Identifier: Apache-2.0
// Controls to type a value into: a choice, a text, or an input for each number of a list.
import { Key } from "./api";
import { button, el, select } from "./dom";
import { words } from "./format";

export interface FieldControl {
  element: HTMLElement;
  inputs(): (HTMLInputElement | HTMLSelectElement)[];
  /// @param written as it stands in the text of a case; an input that one types in is left alone
  show(written: string): void;
}

/// @param label of the inputs of a list, and of those in a table
export function field_control(key: string, row: Key, label: string, edit: (value: string) => void): FieldControl {
  if (row.type.startsWith("pair of") || row.type.startsWith("list of")) return list_control(key, row, label, edit);
  const change = () => edit(row.type === "text" || row.type === "choice" ? JSON.stringify(input.value) : input.value.trim());
  const input = row.choices.length
    ? select(row.choices.map((choice) => [choice, choice]), "", change)
    : el("input", { type: "text", onchange: change, autocomplete: "off", spellcheck: false, inputMode: row.type === "number" || row.type === "integer" ? "decimal" : "text" });
  input.dataset.key = key;
  return {
    element: input, inputs: () => [input],
    show: (written) => { if (document.activeElement !== input) input.value = plain(written); },
  };
}

function list_control(key: string, row: Key, label: string, edit: (value: string) => void): FieldControl {
  const pair = row.type.startsWith("pair of");
  const element = el("div", { class: "list", role: "group", "aria-label": label });
  let inputs: HTMLInputElement[] = [];
  // A value that is not a list, "auto" for one, is written as a whole.
  const tell = () => edit(inputs.length === 1 && !pair && /^[a-z-]+$/.test(inputs[0].value) ? inputs[0].value
    : `[${inputs.map((one) => one.value.trim()).filter(Boolean).map((one) => (Number.isFinite(Number(one)) ? one : JSON.stringify(one))).join(", ")}]`);
  const input = (value: string, i: number) => {
    const name = pair ? `${label}, ${"xy"[i]}` : `${label}, ${i + 1}`;
    const made = el("input", { type: "text", size: 8, value, "aria-label": name, placeholder: pair ? "xy"[i] : row.si_unit, autocomplete: "off", spellcheck: false, onchange: tell });
    made.dataset.key = `${key}[${i}]`;
    return made;
  };
  const build = (values: string[]) => {
    inputs = values.map(input);
    const remove = (i: number) => {
      const cross = button("×", () => { inputs.splice(i, 1); tell(); build(inputs.map((one) => one.value)); }, "small");
      cross.setAttribute("aria-label", `Remove ${label}, ${i + 1}`);
      return cross;
    };
    const add = button("+", () => { build([...inputs.map((one) => one.value), ""]); inputs[inputs.length - 1].focus(); }, "small");
    add.setAttribute("aria-label", `Add to ${label}`);
    element.replaceChildren(...inputs.flatMap((one, i) => (pair ? [one] : [el("span", { class: "entry" }, one, remove(i))])), ...(pair ? [] : [add]));
  };
  return {
    element, inputs: () => inputs,
    show: (written) => {
      if (element.contains(document.activeElement)) return;
      const values = entries(written);
      while (pair && values.length < 2) values.push("");
      if (values.length !== inputs.length || !element.childElementCount) build(values);
      else values.forEach((value, i) => { inputs[i].value = value; });
    },
  };
}

/// Entries of a list as one types them; of what is not a list, itself.
export function entries(written: string): string[] {
  const inside = /^\[([^]*)\]$/.exec(written.trim())?.[1];
  if (inside === undefined) return written.trim() ? [plain(written)] : [];
  return (inside.match(/"(?:[^"\\]|\\.)*"|'[^']*'|[^,\s][^,]*/g) ?? []).map((one) => plain(one.trim()));
}

/// A text without its quotes; others stay as they are.
export function plain(written: string): string {
  try {
    if (/^'[^']*'$/.test(written)) return written.slice(1, -1);
    return /^"(?:[^"\\]|\\.)*"$/.test(written) ? JSON.parse(written) : written;
  } catch {
    return written;
  }
}

/// Label of a key: without its section, numbers of lists from 1.
export function field_label(key: string): string {
  const name = key.replace(/^[a-z]+[.]?/, "") || key;
  return words(name.replace(/\[(\d+)\]\./, (_, i) => `${Number(i) + 1}: `).replace(/\./g, " "));
}
