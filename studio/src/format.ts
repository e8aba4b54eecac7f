// SPDX-License-Identifier: Apache-2.0

const prefixes: [number, string][] = [
  [1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"], [1e-12, "p"], [1e-15, "f"]];
const prefixed = new Set(["A", "C", "V", "Pa", "N", "s", "m"]);

/// The factor and the unit in which numbers up to `largest` are read most easily.
export function scale_for(largest: number, unit: string): { factor: number; unit: string } {
  if (unit === "1" || unit === "") return { factor: 1, unit: "" };
  if (!prefixed.has(unit) || !(largest > 0)) return { factor: 1, unit };
  const [size, prefix] = prefixes.find(([limit]) => largest >= limit * 0.9999) ?? prefixes[prefixes.length - 1];
  return { factor: 1 / size, unit: prefix + unit };
}

export function number(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e5)) return value.toExponential(digits - 2).replace("e", " e");
  return String(Number(value.toPrecision(digits)));
}

export function quantity(value: number, unit: string, digits = 4): string {
  const scaled = scale_for(Math.abs(value), unit);
  return `${number(value * scaled.factor, digits)} ${scaled.unit}`.trim();
}

/// A word as one types it in a shell, whatever it holds.
export function shell_word(text: string): string {
  return /^[\w./=,:+-]+$/.test(text) ? text : `'${text.replace(/'/g, "'\\''")}'`;
}

export function duration(seconds: number): string {
  if (seconds < 90) return `${Math.max(1, Math.round(seconds))} s`;
  if (seconds < 5400) return `${Math.round(seconds / 60)} min`;
  return `${number(seconds / 3600, 2)} h`;
}

export function memory(bytes: number): string {
  return bytes < 1e9 ? `${Math.round(bytes / 1e6)} MB` : `${number(bytes / 1e9, 2)} GB`;
}

/// "peak_sampled_current_top" as words.
export function words(name: string): string {
  const text = name.replace(/_/g, " ").replace(/\b(young|poisson)s\b/g, (surname) => `${surname[0].toUpperCase()}${surname.slice(1, -1)}'s`);
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/// A key of a case as words: "contact.friction" is "Contact: friction", "skin.layers[1].thickness" "Skin: layer 2 thickness".
export function key_words(key: string): string {
  const [section, ...rest] = key.split(".");
  const name = rest.join(" ").replace(/(\w+?)s?\[(\d+)\]/g, (_, list, i) => `${list} ${Number(i) + 1}`);
  return rest.length ? `${words(section)}: ${words(name).replace(/^[A-Z](?=[a-z])/, (letter) => (/^(Young|Poisson)/.test(words(name)) ? letter : letter.toLowerCase()))}` : words(section);
}
