// SPDX-License-Identifier: Apache-2.0
// Geometry of a case for the scene and the small pictures, in mm.
import { CaseValue, Fields } from "./api";

export interface Layer { name: string; role: string; thickness: number; }
export interface Taxel { name: string; lower: [number, number]; upper: [number, number]; }
export interface Geometry {
  length: number; width: number; layers: Layer[]; shape: string; size: [number, number]; radius: number;
  start: [number, number]; stroke: number; direction: [number, number]; gap: number; taxels: Taxel[]; slides: boolean;
  path: [number, number][]; /// of waypoints that stand in the case
  curvature: number; /// of a prescribed bend [1/m]
  pressed: boolean;
  back_and_forth: boolean; cycles: number; wet: boolean;
}

export function geometry_of(values: CaseValue[]): Geometry {
  const find = (key: string) => values.find((one) => one.key === key);
  const mm = (key: string, i = 0, otherwise = 0) => (find(key)?.numbers[i] ?? otherwise / 1e3) * 1e3;
  const text = (key: string, otherwise = "") => find(key)?.text || otherwise;
  const layers: Layer[] = [];
  for (let i = 0; find(`skin.layers[${i}].thickness`); ++i) {
    const key = `skin.layers[${i}]`;
    layers.push({ name: text(`${key}.name`, `layer ${i + 1}`), role: text(`${key}.role`), thickness: mm(`${key}.thickness`) });
  }
  const taxels: Taxel[] = [];
  for (let i = 0; find(`readout.taxels[${i}].lower`); ++i) {
    const key = `readout.taxels[${i}]`;
    taxels.push({ name: text(`${key}.name`), lower: [mm(`${key}.lower`), mm(`${key}.lower`, 1)], upper: [mm(`${key}.upper`), mm(`${key}.upper`, 1)] });
  }
  const [length, width, radius] = [mm("skin.length", 0, 15), mm("skin.width", 0, 2), mm("slider.radius")];
  const path: [number, number][] = [];
  for (let i = 0; find(`motion.waypoints[${i}].position`); ++i) path.push([mm(`motion.waypoints[${i}].position`), mm(`motion.waypoints[${i}].position`, 1)]);
  const prescribed = text("strain.source") === "prescribed";
  const direction = find("motion.direction")?.numbers ?? [1, 0];
  const norm = Math.hypot(direction[0], direction[1]) || 1;
  return {
    length, width, layers, radius, taxels, path,
    curvature: prescribed ? find("strain.curvature")?.numbers[0] ?? 0 : 0, pressed: prescribed && (find("strain.pressure")?.numbers[0] ?? 0) !== 0,
    shape: text("slider.shape", "flat"),
    size: [mm("slider.size", 0, Math.min(2 * radius, length / 3)), mm("slider.size", 1, Math.min(2 * radius, width))],
    start: path[0] ?? [mm("slider.start", 0, length / 2), mm("slider.start", 1, width / 2)],
    stroke: mm("motion.stroke"), direction: [direction[0] / norm, direction[1] / norm], gap: mm("motion.gap"),
    back_and_forth: text("motion.kind") === "reciprocating", cycles: find("motion.cycles")?.numbers[0] ?? 1, wet: text("coupling.law") === "poroelastic",
    slides: text("strain.source", "contact") === "contact",
  };
}

/// When the case cannot be read again, its fields still tell the core.
export function geometry_of_fields(fields: Fields): Geometry | undefined {
  const grid = fields.ions ?? fields.strain;
  if (!grid) return undefined;
  const last = (list: number[]) => list[list.length - 1] * 1e3;
  return { length: last(grid.x), width: last(grid.y), layers: [{ name: "core", role: "core", thickness: last(grid.z) }], shape: "flat", size: [0, 0],
    radius: 0, start: [0, 0], stroke: 0, direction: [1, 0], gap: 0, taxels: [], slides: false, path: [], curvature: 0, pressed: false, back_and_forth: false, cycles: 1, wet: false };
}
