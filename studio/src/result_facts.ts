// SPDX-License-Identifier: Apache-2.0
// Facts of a result in numbers and words: figures, warnings, parameters of a fit, differences between two runs.
import { Result, get, post } from "./api";
import { attempt, button, el, say } from "./dom";
import { number, quantity, shell_word, words } from "./format";
import { copy_buttons } from "./save";
import { store } from "./store";

export function result_facts(result: Result): HTMLElement {
  const { metrics = {}, error_estimate = {}, parameters } = result.summary;
  const rows = Object.entries(metrics).map(([name, metric]) => el("tr", {}, el("th", { scope: "row" }, words(name)), el("td", {}, quantity(metric.value, metric.unit)),
    el("td", {}, error_estimate[name] === undefined ? "" : `± ${number(100 * error_estimate[name], 2)} %`)));
  const head = el("thead", {}, el("tr", {}, ...["Figure", "Value", "Estimated error"].map((text) => el("th", { scope: "col" }, text))));
  const box = el("section", { class: "facts" }, el("h2", {}, result.title || result.path),
    el("p", { class: "hint" }, `${result.path}, ${result.kind}, ${result.state}, ${result.started}`),
    el("div", { class: "row" }, copy_buttons(() => result.command || `ionskin report ${shell_word(result.path)}`, () => python_of(result)),
      button("Open its case", () => store.open_case(result.case, "", result.path.replace(/[^\w.-]/g, "-").replace(/^[^A-Za-z0-9]+/, "") || "run"), "small"),
      result.kind === "fit" ? null : result.report
        ? el("a", { href: `/api/download?${new URLSearchParams({ path: `${result.path}/report.html` })}`, download: `${result.path.replace(/\//g, "-")}.html` }, "Save the report")
        : button("Make the report", () => attempt(async () => { await post("/api/jobs", { kind: "report", path: result.path }); say("The report is in the queue"); }), "small")));
  if (parameters) box.append(fit_table(parameters));
  if (rows.length) box.append(el("details", {}, el("summary", {}, `Figures: ${rows.length}`), el("div", { class: "scroll" }, el("table", {}, head, el("tbody", {}, ...rows)))));
  return box;
}

/// Above the pictures, where they are seen.
export function warnings_of(results: Result[]): HTMLElement[] {
  return results.filter((one) => one.warnings.length).map((one) => el("details", { class: "warnings" },
    el("summary", {}, `${one.warnings.length === 1 ? "One warning" : `${one.warnings.length} warnings`} of ${one.path}: ${one.warnings[0].split(/[.:] /)[0]}`),
    el("ul", {}, ...one.warnings.map((text) => el("li", {}, text)))));
}

function python_of(result: Result): string {
  const path = JSON.stringify(result.path);
  const opened = { run: `ionskin.open_results(${path})`, sweep: `ionskin.Sweep(${path})`, fit: `ionskin.Fit.from_folder(${path})` }[result.kind];
  return `import ionskin\nresult = ${opened}`;
}

function fit_table(parameters: NonNullable<Result["summary"]["parameters"]>): HTMLElement {
  const end = (value: number | null, unit: string) => (value === null ? "not fixed" : quantity(value, unit));
  return el("div", { class: "scroll" }, el("table", {}, el("caption", {}, "Fitted keys with 95 % intervals"),
    el("thead", {}, el("tr", {}, ...["Key", "Value", "From", "To"].map((text) => el("th", { scope: "col" }, text)))),
    el("tbody", {}, ...Object.entries(parameters).map(([key, one]) => el("tr", {}, el("th", { scope: "row" }, key),
      el("td", {}, quantity(one.value, one.unit)), el("td", {}, end(one.lower_95, one.unit)), el("td", {}, end(one.upper_95, one.unit)))))));
}

/// In what two runs differ, as `ionskin compare` says.
export function differences(first: Result, second: Result): HTMLElement {
  const text = el("pre", { tabIndex: 0 }, "…");
  const box = el("details", { class: "differences", ontoggle: () => attempt(fill) }, el("summary", {}, `What differs between ${first.path} and ${second.path}`), text,
    copy_buttons(() => `ionskin compare ${shell_word(first.path)} ${shell_word(second.path)}`, () => `${python_of(first)}\nother = ionskin.open_results(${JSON.stringify(second.path)})`));
  async function fill(): Promise<void> {
    if (!box.open || text.textContent !== "…") return;
    text.textContent = (await get<{ text: string }>("/api/compare", { first: first.path, second: second.path })).text;
  }
  return box;
}
