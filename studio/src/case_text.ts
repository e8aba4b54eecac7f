// SPDX-License-Identifier: Apache-2.0
// The case as text with line numbers; lines with mistakes are marked.
import { CaseError } from "./api";
import { el } from "./dom";

export class CaseTextEditor {
  readonly element: HTMLElement;
  private area = el("textarea", { spellcheck: false, "aria-label": "Case as text (TOML)", wrap: "off", autocomplete: "off" });
  private gutter = el("div", { class: "gutter", "aria-hidden": "true" });
  private bad = new Map<number, string>();

  constructor(change: (text: string) => void) {
    this.area.addEventListener("input", () => {
      this.number();
      change(this.area.value);
    });
    this.area.addEventListener("scroll", () => { this.gutter.scrollTop = this.area.scrollTop; });
    this.element = el("div", { class: "editor" }, this.gutter, this.area);
  }

  get text(): string { return this.area.value; }
  set text(text: string) {
    if (text === this.area.value) return;
    this.area.value = text;
    this.number();
  }

  mark(errors: CaseError[]): void {
    this.bad = new Map(errors.filter((one) => one.line).map((one) => [one.line!, one.message]));
    this.number();
  }

  go_to(error: CaseError): void {
    if (!error.line) return;
    const lines = this.area.value.split("\n");
    const begin = lines.slice(0, error.line - 1).reduce((sum, line) => sum + line.length + 1, 0) + (error.column ?? 1) - 1;
    this.area.focus();
    this.area.setSelectionRange(begin, begin + (error.length ?? 1));
    this.area.scrollTop = Math.max(0, (error.line - 6) * Number.parseFloat(getComputedStyle(this.area).lineHeight));
  }

  private number(): void {
    const count = this.area.value.split("\n").length;
    const rows: HTMLElement[] = [];
    for (let line = 1; line <= count; ++line) {
      const message = this.bad.get(line);
      rows.push(el("div", { class: message ? "bad" : "", title: message }, message ? `✕ ${line}` : String(line)));
    }
    this.gutter.replaceChildren(...rows);
    this.gutter.scrollTop = this.area.scrollTop;
  }
}
