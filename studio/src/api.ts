// SPDX-License-Identifier: Apache-2.0
// The server's calls and what they answer.

export interface Key {
  key: string; type: string; dimensions: string[]; si_unit: string; range: string; range_reason: string;
  need: string; default: string; choices: string[]; help: string; source: string;
}
export interface CaseValue {
  key: string; written: string; si: string; numbers: number[]; unit: string; text: string; origin: string;
  line: number | null;
}
export interface CaseError {
  message: string; remedy: string; line: number | null; column: number | null; length: number | null; keys: string[];
}
export interface Cost { memory_bytes: number; seconds: number; threads: number; }
export interface Verdict {
  valid: boolean; errors?: CaseError[]; values?: CaseValue[]; applicable?: string[]; explanation?: string; warning?: string; cost?: Cost | null;
}
export interface Metric { value: number; unit: string; }
export interface Outline {
  path: string; kind: "run" | "sweep" | "fit"; title: string; state: string; started: string; command: string;
  warnings: string[]; metrics: Record<string, Metric>;
}
export interface Summary {
  metrics?: Record<string, Metric>; error_estimate?: Record<string, number>; timing?: Record<string, number>;
  parameters?: Record<string, { value: number; unit: string; lower_95: number | null; upper_95: number | null }>;
  column?: string;
}
export interface Result extends Outline {
  summary: Summary; case: string; tables: string[]; fields: boolean; report: boolean; points?: string[];
}
export interface Job {
  id: string; kind: string; folder: string; command: string; python: string; state: string; expected_s: number;
  message: string; created: number; started: number; ended: number;
  progress: { activity: string; fraction: number; left_s: number | null; elapsed_s: number } | null;
}
export interface Column { name: string; unit: string; texts: string[] | null; values: Float64Array; }
export interface Table { rows: number; columns: Column[]; }
export interface Frame { name: string; time: number; fields: string[]; }
export interface Fields {
  ions: { x: number[]; y: number[]; z: number[]; frames: Frame[] } | null;
  strain: {
    x: number[]; y: number[]; z: number[]; time: number[]; frame: string; slider_x: number[] | null;
    slider_y: number[] | null;
  } | null;
  contact: { x: number[]; y: number[]; frames: Frame[] } | null;
}
export interface Field { shape: number[]; unit: string; least: number | null; greatest: number | null; values: Float32Array; }

async function answer(path: string, options?: RequestInit): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(path, options);
  } catch {
    throw new Error("the Studio's server does not answer: start ionskin studio again and open its new link");
  }
  if (!response.ok) {
    const body = await response.json().catch(() => ({}));
    throw new Error(body.error ?? `the server answers ${response.status}`);
  }
  return response;
}

function query(values: Record<string, string>): string {
  return "?" + new URLSearchParams(values).toString();
}

export async function get<T>(path: string, values: Record<string, string> = {}): Promise<T> {
  return (await answer(path + query(values))).json() as Promise<T>;
}

export async function post<T>(path: string, body: unknown): Promise<T> {
  const options = { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) };
  return (await answer(path, options)).json() as Promise<T>;
}

export async function upload(name: string, text: string): Promise<{ path: string }> {
  const options = { method: "POST", headers: { "Content-Type": "text/csv" }, body: text };
  return (await answer("/api/upload" + query({ name }), options)).json() as Promise<{ path: string }>;
}

/// The heading and where the numbers begin; the layout stands in packed.hpp.
function unpack(buffer: ArrayBuffer): [any, number] {
  const length = new DataView(buffer).getUint32(0, true);
  return [JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length))), 4 + length];
}

export async function table(path: string, name: string): Promise<Table> {
  const buffer = await (await answer("/api/table" + query({ path, name }))).arrayBuffer();
  const [heading, begin] = unpack(buffer);
  let offset = begin;
  for (const column of heading.columns) {
    column.values = column.texts ? new Float64Array(0) : new Float64Array(buffer, offset, heading.rows);
    offset += column.values.byteLength;
  }
  return heading as Table;
}

export async function field(path: string, group: string, frame: string, name: string): Promise<Field> {
  const buffer = await (await answer("/api/field" + query({ path, group, frame, name }))).arrayBuffer();
  const [heading, begin] = unpack(buffer);
  return { ...heading, values: new Float32Array(buffer, begin) } as Field;
}

export const fields = (path: string) => get<Fields>("/api/fields", { path });
export const check = (text: string) => post<Verdict>("/api/case/check", { text });
