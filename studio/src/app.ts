// SPDX-License-Identifier: Apache-2.0
/*! This page contains, under the MIT licence: three.js, Copyright © 2010-2026 three.js authors; uPlot, Copyright (c) 2022 Leon Sorokin.

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE. */
import "uplot/dist/uPlot.min.css";
import "./app.css";
import { Job } from "./api";
import { case_view } from "./case_view";
import { attempt, button, el, say } from "./dom";
import { jobs_view, progress } from "./jobs_view";
import { results_view } from "./results_view";
import { start_view } from "./start_view";
import { store } from "./store";

const views: [string, string, () => HTMLElement][] = [
  ["#start", "Start", start_view], ["#case", "Case", case_view], ["#results", "Results", results_view], ["#queue", "Queue", jobs_view]];
const main = document.getElementById("main")!;
const links = new Map<string, HTMLAnchorElement>();
const running = el("div", { class: "running" });

function route(): void {
  const wanted = location.hash || "#start";
  const [hash, name, view] = views.find(([one]) => one === wanted) ?? views[0];
  for (const [one, link] of links) link.setAttribute("aria-current", one === hash ? "page" : "false");
  document.title = `${name} – ionskin Studio`;
  main.replaceChildren(view());
  window.scrollTo(0, 0);
}

function set_theme(theme: string): void {
  document.documentElement.dataset.theme = theme;
  if (!theme) delete document.documentElement.dataset.theme;
  localStorage.setItem("theme", theme);
  window.dispatchEvent(new Event("theme"));
}

function next_theme(): void {
  const order = ["", "light", "dark"];
  const next = order[(order.indexOf(document.documentElement.dataset.theme ?? "") + 1) % order.length];
  set_theme(next);
  say(next ? `${next} colours` : "colours of the system");
}

function header(): void {
  for (const [hash, name] of views) links.set(hash, el("a", { href: hash }, name));
  document.getElementById("header")!.append(el("strong", { class: "brand" }, "ionskin Studio"),
    el("nav", { "aria-label": "Views" }, ...links.values()), running, button("Colours", next_theme, "small"));
}

function take(jobs: Job[]): void {
  store.set_jobs(jobs);
  const active = jobs.find((job) => job.state === "running");
  const waiting = jobs.filter((job) => job.state === "queued").length;
  const line = active && progress(active);
  const found = jobs.filter((job) => job.state === "found").length;
  running.replaceChildren(...(active ? [el("span", {}, active.folder + (waiting ? ` (+${waiting})` : "")), ...(line ? [line] : [])] : []),
    ...(found ? [el("a", { href: "#queue" }, `${found} found in this folder, not run`)] : []));
  for (const job of jobs) {
    if (!store.awaited.has(job.folder)) continue;
    if (job.state === "finished") {
      store.awaited.delete(job.folder);
      // Runs of the same evening lie over one another until one chooses otherwise.
      store.show(job.kind === "run" ? [job.folder, ...store.chosen.filter((one) => one !== job.folder)].slice(0, 4) : [job.folder]);
      say(`${job.folder} is finished`);
    } else if (job.state === "failed") {
      store.awaited.delete(job.folder);
      say(`${job.folder} failed: ${job.message}`, true);
    }
  }
}

function follow(): void {
  const events = new EventSource("/api/events");
  events.addEventListener("jobs", (event) => take(JSON.parse((event as MessageEvent).data)));
  events.onerror = () => { if (events.readyState === EventSource.CLOSED) window.setTimeout(follow, 3000); };
}

matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => window.dispatchEvent(new Event("theme")));
set_theme(localStorage.getItem("theme") ?? "");
header();
window.addEventListener("hashchange", route);
attempt(async () => {
  await store.load_keys();
  route();
  follow();
});
