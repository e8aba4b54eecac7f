// SPDX-License-Identifier: Apache-2.0
// State that the views share: keys, jobs, the case that is worked on, the results that are looked at.
import { Job, Key, get } from "./api";

type Listener = () => void;

class Store {
  keys: Key[] = [];
  jobs: Job[] = [];
  case_text = "";
  /// The case file or "" for a new case; the name of what is run next.
  source = "";
  name = "run";
  /// Paths of the results on show; the first is the one in the scene.
  chosen: string[] = [];
  /// Folders that open when their job ends.
  awaited = new Set<string>();
  private listeners: Listener[] = [];

  on_jobs(listener: Listener): void { this.listeners.push(listener); }

  set_jobs(jobs: Job[]): void {
    this.jobs = jobs;
    this.listeners.forEach((listener) => listener());
  }

  async load_keys(): Promise<void> {
    if (this.keys.length === 0) this.keys = await get<Key[]>("/api/keys");
  }

  open_case(text: string, source: string, name: string): void {
    [this.case_text, this.source, this.name] = [text, source, name];
    location.hash = "#case";
  }

  show(paths: string[]): void {
    this.chosen = paths;
    location.hash = "#results";
    window.dispatchEvent(new Event("chosen"));
  }
}

export const store = new Store();
