// SPDX-License-Identifier: Apache-2.0
// Results: the list, the scene and the curves of those that are chosen.
import { Outline, Result, get } from "./api";
import { CurvesPanel, check_box } from "./curves_panel";
import { attempt, button, el } from "./dom";
import { quantity } from "./format";
import { differences, result_facts, warnings_of } from "./result_facts";
import { ScenePanel } from "./scene_panel";
import { column, table_of } from "./series";
import { store } from "./store";
import { sweep_panel } from "./sweep_panel";
import { TimeBar } from "./time_bar";

/// Instant at which there is something to see: the middle of the first slide, or the beginning.
async function middle_of_slide(result: Result): Promise<number> {
  if (!result.tables.includes("signals")) return 0;
  const data = await table_of(result, "signals");
  const phases = column(data, "phase")?.texts ?? [];
  const first = phases.indexOf("slide");
  if (first < 0) return 0;
  const after = phases.findIndex((phase, i) => i > first && phase !== "slide");
  const time = column(data, "time")!.values;
  return (time[first] + time[after < 0 ? time.length - 1 : after]) / 2;
}

export function results_view(): HTMLElement {
  const list = el("ul", { class: "plain results" });
  const scene = new ScenePanel();
  const bar = new TimeBar((time) => { scene.set_time(time); curves.mark(time); });
  const curves = new CurvesPanel((time) => bar.set(time));
  const below = el("div", { class: "below" });
  const above = el("div");
  const stage = el("div", { class: "stage" }, above, scene.element, bar.element, curves.element, below);
  const empty = el("p", { class: "hint" }, "Choose results in the list, or run a case first.");
  let known: Outline[] = [];

  async function show_results(results: Result[]): Promise<void> {
    const [first] = results;
    stage.hidden = !first;
    empty.hidden = Boolean(first);
    if (!first) return;
    scene.element.hidden = first.kind === "fit";
    await curves.show(results);
    bar.set_end(curves.end);
    if (bar.time === 0) bar.set(await middle_of_slide(first));
    if (first.kind !== "fit") await scene.show(first);
    window.dispatchEvent(new Event("shown"));
  }

  async function choose(): Promise<void> {
    bar.stop();
    const results = await Promise.all(store.chosen.map((path) => get<Result>("/api/result", { path })));
    const [first, second] = results;
    above.replaceChildren();
    below.replaceChildren();
    above.append(...warnings_of(results));
    if (first?.kind === "sweep") {
      above.append(sweep_panel(first, (point) => attempt(async () => show_results([point]))));
      below.append(result_facts(first));
      stage.hidden = false;
      empty.hidden = true;
      return;
    }
    if (second?.kind === "run") below.append(differences(first, second));
    below.append(...results.map(result_facts));
    await show_results(results.filter((one) => one.kind !== "sweep"));
  }

  function fill(): void {
    list.replaceChildren(...known.map((one) => {
      const box = el("input", { type: "checkbox", checked: store.chosen.includes(one.path), onchange: () => {
        store.chosen = box.checked ? [...store.chosen, one.path] : store.chosen.filter((path) => path !== one.path);
        attempt(choose);
      } });
      const peak = one.metrics.peak_sampled_current_difference;
      return el("li", {}, check_box("", box), button(one.path, () => { store.chosen = [one.path]; fill(); attempt(choose); }, "link"),
        el("span", { class: "hint" }, ` ${one.kind}${one.state === "finished" || one.kind === "fit" ? "" : `, ${one.state}`}${peak ? `, ${quantity(peak.value, peak.unit, 3)} peak` : ""}`));
    }), ...(known.length ? [] : [el("li", { class: "hint" }, "No results yet.")]));
    for (const box of list.querySelectorAll("input")) box.setAttribute("aria-label", `Overlay ${box.closest("li")!.querySelector("button")!.textContent}`);
  }

  async function load(): Promise<void> {
    known = await get<Outline[]>("/api/runs");
    store.chosen = store.chosen.filter((path) => known.some((one) => one.path === path));
    if (!store.chosen.length && known.length) store.chosen = [known[0].path];
    fill();
    await choose();
  }
  const reload = () => { if (list.isConnected) attempt(load); else window.removeEventListener("chosen", reload); };
  window.addEventListener("chosen", reload);
  stage.hidden = true;
  attempt(load);
  return el("div", { class: "page wide results-view" }, el("h1", {}, "Results"),
    el("div", { class: "split" }, el("aside", { "aria-label": "List of results" }, el("p", { class: "hint" }, "Tick several to lay them over one another."), list), el("div", {}, empty, stage)));
}
