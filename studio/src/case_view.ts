// SPDX-License-Identifier: Apache-2.0
// The case: form and text of the same words, checked by the program as one types.
import { CaseValue, Verdict, check, post } from "./api";
import { CaseActions } from "./case_actions";
import { CaseForm } from "./case_form";
import { case_picture } from "./case_picture";
import { CaseTextEditor } from "./case_text";
import { attempt, button, el } from "./dom";
import { first_waypoints, missing_keys, with_path, without_idle_keys } from "./fitting_keys";
import { duration, memory } from "./format";
import { geometry_of } from "./geometry";
import { key_in_text, of_first_slider, slider_count } from "./slider_list";
import { store } from "./store";
import { WaypointEditor, without_waypoints } from "./waypoint_editor";

export function case_view(): HTMLElement {
  if (!store.case_text) {
    return el("div", { class: "page" }, el("h1", {}, "No case is open"), el("p", {}, "Choose one on the start page."), button("Start", () => { location.hash = "#start"; }, "primary"));
  }
  const verdict_line = el("p", { class: "verdict", role: "status" });
  const problems = el("ul", { class: "problems" });
  const explanation = el("pre", { class: "explanation", tabIndex: 0 });
  const actions = new CaseActions();
  const editor = new CaseTextEditor((text) => { store.case_text = text; later(); });
  // One edit after the other: each goes into the text that the one before made.
  let edits = Promise.resolve();
  const sketch = el("div", { class: "sketch" });
  let valid: CaseValue[] = [], written: CaseValue[] = [];
  const sliders = el("p", { class: "hint" });
  const taken = new Map<string, string>();
  const take = (text: string) => {
    store.case_text = editor.text = text;
    attempt(judge);
  };
  const set = (key: string, value: string) => {
    edits = edits.then(() => attempt(async () => {
      const edited = await post<{ text: string }>("/api/case/set", { text: store.case_text, key: key_in_text(key, written), value });
      take(await fitted(key, edited.text));
    }));
  };
  const rewrite = (change: (text: string) => string) => { edits = edits.then(() => attempt(async () => take(change(store.case_text)))); };
  const form = new CaseForm(store.keys, set, rewrite);
  const path = new WaypointEditor(set, rewrite);
  let lacking: string[] = []; // of the last choice: the check may tell what it lacks before what does not go with it
  /// The text fitted to another choice: keys that do not go with it are taken away, and what it lacks gets a field.
  async function fitted(key: string, text: string): Promise<string> {
    if (!store.keys.find((one) => one.key === key)?.choices.length && !lacking.includes(key)) return text;
    lacking = [];
    if (key === "motion.kind" && !/^kind\s*=\s*"waypoints"/m.test(text)) text = without_waypoints(text);
    const verdict = await check(text);
    if (verdict.valid) return settled(text);
    const kept = without_idle_keys(text, verdict.errors!, taken);
    const is_path = key === "motion.kind" && /^kind\s*=\s*"waypoints"/m.test(kept) && !/^\[\[motion\.waypoints\]\]/m.test(kept);
    if (is_path) return with_path(kept, first_waypoints(valid));
    let filled = kept;
    for (const lacked of missing_keys((await check(kept)).errors ?? []).filter((one) => taken.has(one))) {
      filled = (await post<{ text: string }>("/api/case/set", { text: filled, key: lacked, value: taken.get(lacked) })).text;
    }
    const last = await check(filled);
    if (last.valid) return settled(filled);
    lacking = missing_keys(last.errors!);
    return filled;
  }
  /// The text with the keys that an earlier choice took away and this one takes.
  async function settled(text: string): Promise<string> {
    for (const one of (await check(text)).values ?? []) if (one.origin === "file") taken.delete(one.key);
    for (const [key, value] of taken) {
      const again = (await post<{ text: string }>("/api/case/set", { text, key, value })).text;
      if (!(await check(again)).valid) continue;
      taken.delete(key);
      text = again;
    }
    return text;
  }
  let timer = 0, asked = 0;
  const later = () => {
    window.clearTimeout(timer);
    timer = window.setTimeout(() => attempt(judge), 200);
  };
  async function judge(): Promise<void> {
    const mine = ++asked;
    const verdict = await check(store.case_text);
    if (mine !== asked) return; // a newer text is being judged
    tell(verdict);
  }
  function tell(verdict: Verdict): void {
    const errors = verdict.errors ?? [];
    editor.mark(errors);
    if (verdict.valid) {
      written = verdict.values!;
      valid = of_first_slider(written);
      const count = slider_count(written);
      sliders.textContent = count > 1 ? `This case has ${count} sliders: the form and the picture show the first, the text has all.` : "";
      const shape = geometry_of(valid);
      form.show(valid, verdict.applicable!);
      path.show(valid, shape);
      sketch.replaceChildren(case_picture(shape));
    } else form.offer(missing_keys(errors));
    form.show_rows(store.case_text);
    form.mark(errors);
    actions.allow(verdict.valid ? verdict.values : undefined);
    verdict_line.className = verdict.valid ? "verdict good" : "verdict bad";
    const cost = verdict.cost;
    verdict_line.textContent = verdict.valid
      ? "✓ Valid" + (cost ? `: about ${duration(cost.seconds)} and ${memory(cost.memory_bytes)} with ${cost.threads} threads` : "")
      : `✕ ${errors.length === 1 ? "One mistake" : `${errors.length} mistakes`}`;
    problems.replaceChildren(...errors.map((error) => el("li", {},
      button(error.line ? `Line ${error.line}` : "Case", () => editor.go_to(error), "link"), ` ${error.message}: `, el("em", {}, error.remedy))),
      ...(verdict.warning ? [el("li", { class: "warning" }, verdict.warning)] : []));
    explanation.textContent = verdict.explanation ?? "";
    window.dispatchEvent(new CustomEvent("judged"));
  }
  editor.text = store.case_text;
  attempt(judge);
  return el("div", { class: "page wide" },
    el("h1", {}, "Case"), verdict_line, problems, actions.element,
    el("div", { class: "two case" },
      el("section", {}, el("h2", {}, "Form"), sliders, sketch, path.element, form.element),
      el("section", {}, el("h2", {}, "Text"), editor.element,
        el("details", {}, el("summary", {}, "What it means (check --explain)"), explanation))));
}
