// SPDX-License-Identifier: Apache-2.0
import { Outline, Verdict, check, get, post } from "./api";
import { case_picture } from "./case_picture";
import { attempt, button, el } from "./dom";
import { duration } from "./format";
import { geometry_of } from "./geometry";
import { store } from "./store";

interface Starter { id: string; name: string; summary: string; text: string; }

export function start_view(): HTMLElement {
  const cards = el("div", { class: "cards" });
  const cases = el("ul", { class: "plain" }), results = el("ul", { class: "plain" });
  attempt(async () => {
    const starters = await get<Starter[]>("/api/gallery");
    cards.replaceChildren(...starters.map(card));
  });
  attempt(async () => {
    const files = await get<{ cases: string[] }>("/api/files");
    fill(cases, files.cases.map((name) => button(name, () => attempt(() => open_file(name)), "link")), "No case files yet.");
  });
  attempt(async () => {
    const found = await get<Outline[]>("/api/runs");
    fill(results, found.slice(0, 12).map((one) => button(`${one.path} (${one.kind}, ${one.state})`, () => store.show([one.path]), "link")), "No results yet.");
  });
  return el("div", { class: "page" },
    el("h1", {}, "Touch a skin"),
    el("p", {}, "Choose a case, press Run, and see what the electrodes give. Everything is a plain file in this folder, and every click can be copied as a command."),
    cards,
    el("div", { class: "two" },
      el("section", {}, el("h2", {}, "Cases in this folder"), cases),
      el("section", {}, el("h2", {}, "Newest results"), results)));
}

function fill(list: HTMLElement, entries: HTMLElement[], otherwise: string): void {
  list.replaceChildren(...(entries.length ? entries.map((entry) => el("li", {}, entry)) : [el("li", { class: "hint" }, otherwise)]));
}

async function open_file(name: string): Promise<void> {
  const { text } = await get<{ text: string }>("/api/text", { path: name });
  store.open_case(text, name, name.replace(/\.toml$/, "").replace(/[^\w.-]/g, "-"));
}

async function open_starter(starter: Starter): Promise<void> {
  await post("/api/gallery/open", { id: starter.id });
  store.open_case(starter.text, "", starter.id.replace("_", "-"));
}

function card(starter: Starter): HTMLElement {
  const picture = el("div", { class: "card-picture" });
  const time = el("span", { class: "hint" }, "…");
  attempt(async () => {
    const verdict: Verdict = await check(starter.text);
    if (verdict.values) picture.append(case_picture(geometry_of(verdict.values)));
    time.textContent = verdict.cost ? `about ${duration(verdict.cost.seconds)} to run` : "seconds to run";
    // The strain file of this starter is written when it is opened.
    if (starter.id === "strain_file" && !verdict.values) picture.append(case_picture(given_strain()));
  });
  return el("article", { class: "card" }, picture, el("h2", {}, starter.name), el("p", {}, starter.summary), time,
    button("Open", () => attempt(() => open_starter(starter)), "primary"));
}

function given_strain() {
  const layer = (role: string, thickness: number) => ({ name: role, role, thickness });
  return { length: 15, width: 2, layers: [layer("electrode", 0.01), layer("core", 0.18), layer("electrode", 0.01)], shape: "flat",
    size: [0, 0] as [number, number], radius: 0, start: [0, 0] as [number, number], stroke: 0, direction: [1, 0] as [number, number], gap: 0, taxels: [], slides: false, path: [], curvature: 0, pressed: false, back_and_forth: false, cycles: 1, wet: false };
}
