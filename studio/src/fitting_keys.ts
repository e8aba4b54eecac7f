// SPDX-License-Identifier: Apache-2.0
// Keys that go with a choice, as the check says: those without effect leave the text, a path of waypoints begins as the
// motion that it replaces.
import { CaseError, CaseValue } from "./api";

/// Keys that the check asks for.
export function missing_keys(errors: CaseError[]): string[] {
  return errors.flatMap((error) => /^missing key ([\w.[\]]+)/.exec(error.message)?.[1] ?? []);
}

/// The text without the lines of keys that have no effect; a value of several lines is left to its author.
/// @param taken what those keys held is kept here, for a choice that asks for them again
export function without_idle_keys(text: string, errors: CaseError[], taken: Map<string, string>): string {
  const lines = text.split("\n");
  for (const error of errors) {
    const key = /^([\w.[\]]+) (?:has no effect|does not belong|is given, but)/.exec(error.message)?.[1];
    const line = key && error.line ? lines[error.line - 1] : undefined;
    if (line === undefined || !new RegExp(`^\\s*${key!.split(".").pop()}\\s*=`).test(line)) continue;
    const balance = (line.match(/\[/g) ?? []).length - (line.match(/\]/g) ?? []).length;
    if (balance !== 0) continue;
    taken.set(key!, line.slice(line.indexOf("=") + 1).replace(/^((?:"(?:[^"\\]|\\.)*"|[^#"])*)#.*$/, "$1").trim());
    lines[error.line! - 1] = "\0";
  }
  return lines.filter((line) => line !== "\0").join("\n");
}

/// Touchdown, slide and lift-off of the motion before as waypoints.
export function first_waypoints(before: CaseValue[]): string {
  const find = (key: string, i = 0, otherwise = 0) => before.find((one) => one.key === key)?.numbers[i] ?? otherwise;
  const mm = (value: number) => `${Number((value * 1e3).toPrecision(6))} mm`;
  const length = find("skin.length", 0, 15e-3), across = find("skin.width", 0, 2e-3);
  const from = [find("slider.start", 0, length / 2), find("slider.start", 1, across / 2)];
  const norm = Math.hypot(find("motion.direction", 0, 1), find("motion.direction", 1)) || 1;
  const to = from.map((value, i) => value + find("motion.stroke") * find("motion.direction", i, i ? 0 : 1) / norm);
  const load = before.find((one) => one.key === "motion.preload");
  const pressed = load?.unit === "N" ? `force = "${load.numbers[0]} N"` : `height = "${mm(-(load?.numbers[0] ?? 1e-6))}"`;
  const free = `height = "${mm(find("motion.gap", 0, 1e-3))}"`;
  let time = 0;
  const rows: [number, number[], string][] = [[0, from, free], [find("motion.touchdown", 0, 0.5), from, pressed],
    [find("motion.slide", 0, 1), to, pressed], [find("motion.lift", 0, 0.5), to, free]];
  return rows.map(([after, place, level]) => `\n[[motion.waypoints]]\ntime = "${Number((time += after).toPrecision(6))} s"\nposition = ["${mm(place[0])}", "${mm(place[1])}"]\n${level}\n`).join("");
}

/// The text with a path behind its section of the motion.
export function with_path(text: string, path: string): string {
  const begin = text.search(/^\[motion\]/m);
  if (begin < 0) return text;
  const next = text.slice(begin + 1).search(/^\[/m);
  const end = next < 0 ? text.length : begin + 1 + next;
  return `${text.slice(0, end).trimEnd()}\n${path}\n${text.slice(end)}`;
}
