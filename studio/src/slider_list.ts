// SPDX-License-Identifier: Apache-2.0
// Cases of several sliders: the form shows the first of the list as if it were the only one.
import { CaseValue } from "./api";

const first = /^slider\[0\]\.(motion\.|contact\.)?/;

/// Name that a value of the first slider has in a case of one slider: "slider.radius" of "slider[0].radius".
function alone(key: string): string {
  return key.replace(first, (_, section?: string) => section ?? "slider.");
}

/// Values of a case with those of the first slider in the place of what all share, without those of the other sliders.
export function of_first_slider(values: CaseValue[]): CaseValue[] {
  const own = new Map(values.filter((one) => first.test(one.key)).map((one) => [alone(one.key), one]));
  const shared = values.filter((one) => !one.key.startsWith("slider[") && !own.has(one.key));
  return [...shared, ...[...own].map(([key, one]) => ({ ...one, key }))];
}

/// Key in the text of a key of the form.
export function key_in_text(key: string, values: CaseValue[]): string {
  const listed = values.some((one) => one.key.startsWith("slider[0]."));
  if (listed && key.startsWith("slider.")) return key.replace(/^slider\./, "slider[0].");
  const own = `slider[0].${key}`;
  return values.some((one) => one.key === own) ? own : key;
}

/// Number of the sliders of a case.
export function slider_count(values: CaseValue[]): number {
  return Math.max(1, new Set(values.map((one) => /^slider\[(\d+)\]/.exec(one.key)?.[1]).filter(Boolean)).size);
}
