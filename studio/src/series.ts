// SPDX-License-Identifier: Apache-2.0
// Curves over time, of runs and of measurements.
import { Column, Result, Table, table } from "./api";
import { words } from "./format";

export interface Series {
  label: string; name?: string; unit: string; time: Float64Array; values: Float64Array;
  /// Half width of the error band at each row, when an estimate exists.
  band?: Float64Array;
  /// Drawn as points: a measurement.
  points?: boolean;
  /// "held": read at its instant and shown until the next, as a sampled current; "over": the mean over the step that ends there.
  step?: "held" | "over";
  /// A curve with its points marked: those of a sweep.
  marked?: boolean;
}

/// Columns that can be drawn together: a name to choose, the table and its columns.
export interface Quantity { id: string; label: string; table: string; columns: string[]; unit: string; }

const tables = new Map<string, Promise<Table>>();

/// A table of a finished run is fetched once.
export function table_of(result: { path: string; state: string }, name: string): Promise<Table> {
  const id = `${result.path}\n${name}\n${result.state}`;
  if (!tables.has(id)) {
    if (tables.size > 400) tables.clear();
    tables.set(id, table(result.path, name));
    tables.get(id)!.catch(() => tables.delete(id));
  }
  return tables.get(id)!;
}

export const column = (data: Table, name: string): Column | undefined => data.columns.find((one) => one.name === name);

const groups: [string, string, RegExp][] = [
  ["difference", "Current difference", /^current_difference$/],
  ["electrodes", "Currents of both electrodes", /^current_(top|bottom)$/],
  ["common", "Common current", /^current_common$/],
];

/// Everything of a run that can be drawn over time.
export async function quantities(result: Result): Promise<Quantity[]> {
  const list: Quantity[] = [];
  for (const name of result.tables.filter((one) => one !== "sweep" && !one.endsWith("_error"))) {
    const data = await table_of(result, name);
    const kind = name === "signals" ? "" : `, ${name.replace("_", " ")}`;
    const numeric = data.columns.filter((one) => !one.texts && one.name !== "time" && one.name !== "cycle" && !one.name.endsWith("_error"));
    const taken = new Set<string>();
    const add = (id: string, label: string, columns: Column[]) => {
      if (columns.length === 0) return;
      columns.forEach((one) => taken.add(one.name));
      list.push({ id: `${name}/${id}`, label: label + kind, table: name, columns: columns.map((one) => one.name), unit: columns[0].unit });
    };
    if (/taxels$/.test(name)) {
      const through = /^(current|charge)_circuit_/; // of taxels with circuits of their own
      const names: Record<string, string> = { A: "Currents of taxels", C: "Charges of taxels", V: "Voltages of taxels" };
      for (const unit of new Set(numeric.map((one) => one.unit))) {
        const label = (names[unit] ?? `All of taxels [${unit}]`) + (name === "taxels" ? "" : ", sampled");
        const [own, all] = [true, false].map((of_circuit) => numeric.filter((one) => one.unit === unit && through.test(one.name) === of_circuit));
        add(`all-${unit}`, label, all);
        add(`circuit-${unit}`, `${label}, through their circuits`, own);
      }
      continue;
    }
    if (name === "fit") {
      add("fit", "Measured and fitted", numeric.filter((one) => /_(measured|fitted)$/.test(one.name)));
    }
    for (const [id, label, pattern] of groups) add(id, label, numeric.filter((one) => pattern.test(one.name)));
    for (const one of numeric) if (!taken.has(one.name)) add(one.name, words(one.name), [one]);
  }
  return list;
}

/// The relative error that the run estimates for a column, from its root mean square or its peak.
function relative_error(result: Result, name: string): number | undefined {
  const estimates = result.summary.error_estimate ?? {};
  return estimates[name] ?? estimates[`rms_${name}`] ?? estimates[`peak_${name}`] ?? estimates[`peak_sampled_${name}`];
}

/// A current is a mean over a step or an interval, of which nothing must be drawn before the step begins or the reading is known.
function step_of(table: string, name: string): "held" | "over" | undefined {
  return !name.startsWith("current") ? undefined : table.startsWith("sampled") ? "held" : "over";
}

export async function series_of(result: Result, quantity: Quantity, label: string): Promise<Series[]> {
  if (!result.tables.includes(quantity.table)) return [];
  const data = await table_of(result, quantity.table);
  const time = column(data, "time")?.values ?? new Float64Array(0);
  const errors = result.tables.includes(`${quantity.table}_error`) ? await table_of(result, `${quantity.table}_error`) : undefined;
  return quantity.columns.flatMap((name) => {
    const found = column(data, name);
    if (!found) return [];
    const stated = errors && column(errors, name)?.values;
    const own = column(data, `${name}_error`)?.values ?? (stated?.length === found.values.length ? stated : undefined);
    const relative = relative_error(result, name);
    const band = own ?? (relative === undefined ? undefined : found.values.map((value) => Math.abs(value) * relative));
    return [{ label: quantity.columns.length > 1 || !label ? `${label} ${words(name)}`.trim() : label, unit: found.unit, time, values: found.values, band,
      points: name.endsWith("_measured"), step: step_of(quantity.table, name) }];
  });
}

const factors: Record<string, number> = { "": 1, f: 1e-15, p: 1e-12, n: 1e-9, u: 1e-6, "µ": 1e-6, m: 1e-3, k: 1e3, M: 1e6 };

/// A measured CSV file: its columns in SI units, as the header says: `time [s],current_difference [uA]`.
/// Throws Error when it is not such a file.
export function read_measurement(text: string, name: string): Series[] {
  const [header, ...rows] = text.trim().split(/\r?\n/);
  const titles = header.split(",").map((title) => /^\s*"?\s*(.*?)\s*\[\s*(.*?)\s*\]/.exec(title));
  if (titles.length < 2 || titles.some((title) => !title)) {
    throw new Error(`${name} has no header with units, such as: time [s],current_difference [uA]`);
  }
  const columns = titles.map((title, i) => {
    const [, prefix, unit] = /^([fpnuµmkM]?)(s|A|C|V|N)$/.exec(title![2]) ?? [title![2], "", title![2]];
    return { name: title![1], unit, values: Float64Array.from(rows, (row) => Number.parseFloat(row.split(",")[i]) * factors[prefix]) };
  });
  const time = columns.find((one) => one.name === "time") ?? columns[0];
  return columns.filter((one) => one !== time).map((one) => ({ label: `${name}: ${words(one.name)}`, name: one.name, unit: one.unit, time: time.values, values: one.values, points: true }));
}
