// SPDX-License-Identifier: Apache-2.0
// A field on its grid, and the sections through it that the scene draws.
import { Field } from "./api";

export interface Volume {
  /// Lines of the cells along x and y, nodes along z [mm], z from the bottom of the core.
  x: number[]; y: number[]; z: number[];
  field: Field;
}

export interface Section {
  /// Positions [mm], three numbers a vertex; triangles; the field's value at each vertex.
  positions: Float32Array; index: Uint32Array; values: Float32Array;
}

const middle = (lines: number[], i: number) => (lines[i] + lines[i + 1]) / 2;

/// Vertices at the edges of the skin and at the middles of the cells; values are constant beyond the outermost middles.
function places(lines: number[], end: number): [number, number][] {
  const inside: [number, number][] = [];
  for (let i = 0; i + 1 < lines.length; ++i) inside.push([middle(lines, i), i]);
  const kept = inside.filter(([at]) => at > 0 && at < end);
  if (kept.length === 0) return [[0, nearest(inside, 0)], [end, nearest(inside, end)]];
  const first = Math.max(0, lines[0]), last = Math.min(end, lines[lines.length - 1]);
  return [[first, kept[0][1]], ...kept, [last, kept[kept.length - 1][1]]];
}

function nearest(list: [number, number][], at: number): number {
  return list.reduce((best, one) => (Math.abs(one[0] - at) < Math.abs(best[0] - at) ? one : best))[1];
}

function lattice(rows: number, columns: number): Uint32Array {
  const index = new Uint32Array(Math.max(0, (rows - 1) * (columns - 1) * 6));
  let at = 0;
  for (let i = 0; i + 1 < rows; ++i) {
    for (let j = 0; j + 1 < columns; ++j) {
      const a = i * columns + j;
      index.set([a, a + 1, a + columns, a + 1, a + columns + 1, a + columns], at);
      at += 6;
    }
  }
  return index;
}

/// The section at y across the width, x along the skin.
export function section_at_y(volume: Volume, y: number, length: number): Section {
  const [, ny, nx] = volume.field.shape;
  const along = places(volume.x, length);
  let row = volume.y.findIndex((line) => line > y) - 1;
  if (row < 0) row = y < volume.y[0] ? 0 : ny - 1;
  return fill(along, volume.z.map((at, i) => [at, i]), (i, k) => (k * ny + row) * nx + i, (a, z) => [a, y, z], volume);
}

/// The section across the skin at x.
export function section_at_x(volume: Volume, x: number, width: number): Section {
  const [, ny, nx] = volume.field.shape;
  let cell = volume.x.findIndex((line) => line > x) - 1;
  if (cell < 0) cell = x < volume.x[0] ? 0 : nx - 1;
  return fill(places(volume.y, width), volume.z.map((at, i) => [at, i]), (j, k) => (k * ny + j) * nx + cell, (a, z) => [x, a, z], volume);
}

/// The section at a height of the core, seen from above.
export function section_at_z(volume: Volume, part: number, length: number, width: number): Section {
  const [nz, ny, nx] = volume.field.shape;
  const height = part * volume.z[nz - 1];
  const level = volume.z.reduce((best, at, i) => (Math.abs(at - height) < Math.abs(volume.z[best] - height) ? i : best), 0);
  return fill(places(volume.x, length), places(volume.y, width), (i, j) => (level * ny + j) * nx + i, (a, b) => [a, b, volume.z[level]], volume);
}

function fill(one: [number, number][], two: [number, number][], at: (i: number, k: number) => number,
  place: (a: number, b: number) => [number, number, number], volume: Volume): Section {
  const positions = new Float32Array(one.length * two.length * 3);
  const values = new Float32Array(one.length * two.length);
  let vertex = 0;
  for (const [b, k] of two) {
    for (const [a, i] of one) {
      positions.set(place(a, b), vertex * 3);
      values[vertex++] = volume.field.values[at(i, k)];
    }
  }
  return { positions, values, index: lattice(two.length, one.length) };
}
