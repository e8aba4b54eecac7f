// SPDX-License-Identifier: Apache-2.0
import { Job, post } from "./api";
import { attempt, button, el } from "./dom";
import { duration } from "./format";
import { copy_buttons } from "./save";
import { store } from "./store";

/// The queue: what runs with what is left, what waits, what ended; and what came with the folder.
export function jobs_view(): HTMLElement {
  const list = el("ul", { class: "jobs" });
  const brought = el("section");
  const fill = () => {
    if (!list.isConnected && list.childElementCount) return;
    const own = store.jobs.filter((job) => job.state !== "found"), found = store.jobs.filter((job) => job.state === "found");
    list.replaceChildren(...(own.length ? own.slice(0, 50).map(entry) : [el("li", { class: "hint" }, "Nothing was run here yet.")]));
    brought.replaceChildren(...(found.length ? [el("h2", {}, "Found in this folder, not run"),
      el("p", { class: "hint" }, "These commands are recorded in the folder itself. Whoever made the folder may have written them; run what you know."),
      el("ul", { class: "jobs" }, ...found.map(found_entry))] : []));
  };
  fill();
  store.on_jobs(fill);
  return el("div", { class: "page" }, el("h1", {}, "Queue"),
    el("p", { class: "hint" }, "One command runs at a time. They go on when this page or the server is closed."), list, brought);
}

const call = (job: Job, what: string) => attempt(async () => { await post(`/api/jobs/${job.id}/${what}`, {}); });

function found_entry(job: Job): HTMLElement {
  const controls = el("span", { class: "row" });
  if (job.command) controls.append(button("Run", () => call(job, "resume"), "small"));
  controls.append(button("Remove", () => call(job, "remove"), "small"));
  return el("li", { class: "job found" }, el("pre", {}, job.command || job.message), controls);
}

function entry(job: Job): HTMLElement {
  const open = ["queued", "running", "stopping"].includes(job.state);
  const controls = el("span", { class: "row" });
  if (open && job.state !== "stopping") controls.append(button("Cancel", () => call(job, "cancel"), "small"));
  if (job.state === "stopped" || job.state === "failed") controls.append(button("Resume", () => call(job, "resume"), "small"));
  if (job.state === "finished") controls.append(button("Open", () => store.show([job.folder]), "small primary"));
  controls.append(copy_buttons(() => job.command, () => job.python));
  if (!open) controls.append(button("Remove", () => call(job, "remove"), "small"));
  return el("li", { class: `job ${job.state}` }, el("strong", {}, job.folder), ` ${job.kind}, ${job.state} `, progress(job), controls,
    job.message ? el("details", {}, el("summary", {}, "Messages"), el("pre", {}, job.message)) : null);
}

export function progress(job: Job): HTMLElement | null {
  if (job.state !== "running" || !job.progress) return null;
  const { activity, fraction, left_s, elapsed_s } = job.progress;
  const left = left_s !== null ? `, ${duration(left_s)} left of this part` : "";
  return el("div", { class: "progress" }, el("progress", { max: 1, value: fraction, "aria-label": `${job.folder}: ${activity}` }),
    el("span", {}, `${activity || "starting"} ${Math.round(fraction * 100)} %, ${elapsed_s} s so far${left}`));
}
