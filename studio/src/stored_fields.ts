// SPDX-License-Identifier: Apache-2.0
// The fields of a run: which there are, and the one that is shown at an instant, fetched when it is looked at.
import { Field, Fields, Frame, field } from "./api";
import { Volume } from "./volume";

export interface Shown { volume: Volume; time: number; }
export interface Pressed {
  /// Cell edges from the slider's centre [mm]; values per cell, x fastest.
  x: number[]; y: number[]; pressure: Field; slip: Field; time: number;
}

const mm = (list: number[], shift = 0) => list.map((value) => (value + shift) * 1e3);
const nearest = (times: number[], time: number) => times.reduce((best, at, i) => (Math.abs(at - time) < Math.abs(times[best] - time) ? i : best), 0);

export class StoredFields {
  private kept = new Map<string, Promise<Field>>();

  constructor(private path: string, readonly list: Fields, private width: number, private period: number) {}

  /// Identity and name of every field through the thickness.
  channels(): [string, string][] {
    const names = new Set((this.list.ions?.frames ?? []).flatMap((frame) => frame.fields));
    const words: Record<string, string> = { concentration: "Concentration", potential: "Potential", shear: "Core shear (ion grid)" };
    const all: [string, string][] = this.list.strain ? [["strain/gamma", "Core shear"]] : [];
    return [...all, ...[...names].map((name): [string, string] => [`ions/${name}`, words[name] ?? name])];
  }

  async volume(channel: string, time: number): Promise<Shown | undefined> {
    const [group, name] = channel.split("/");
    if (group === "strain" && this.list.strain) {
      const grid = this.list.strain;
      const i = nearest(grid.time, time);
      const moves = grid.frame === "slider";
      const [x, y] = moves ? [grid.slider_x?.[i] ?? 0, grid.slider_y?.[i] ?? this.width / 2e3] : [0, 0];
      const values = await this.fetch("strain", String(i), "gamma");
      return { volume: { x: mm(grid.x, x), y: mm(grid.y, y), z: mm(grid.z), field: values }, time: grid.time[i] };
    }
    const grid = this.list.ions;
    if (!grid || grid.frames.length === 0) return undefined;
    const frame = grid.frames[nearest(grid.frames.map((one) => one.time), time)];
    return { volume: { x: mm(grid.x), y: mm(grid.y), z: mm(grid.z), field: await this.fetch("ions", frame.name, name) }, time: frame.time };
  }

  /// The contact at an instant: the last state that was passed. Cycles repeat.
  async contact(time: number): Promise<Pressed | undefined> {
    const grid = this.list.contact;
    if (!grid || grid.frames.length === 0) return undefined;
    const within = this.period > 0 ? time % this.period : time;
    const frame = grid.frames.reduce<Frame | undefined>((last, one) => (one.time <= within + 1e-9 ? one : last), undefined);
    if (!frame) return undefined;
    const [pressure, slip] = await Promise.all([this.fetch("contact", frame.name, "pressure"), this.fetch("contact", frame.name, "slip")]);
    return { x: mm(grid.x), y: mm(grid.y), pressure, slip, time: frame.time };
  }

  private fetch(group: string, frame: string, name: string): Promise<Field> {
    const id = `${group}/${frame}/${name}`;
    if (!this.kept.has(id)) {
      if (this.kept.size > 60) this.kept.delete(this.kept.keys().next().value!);
      this.kept.set(id, field(this.path, group, frame, name));
    }
    return this.kept.get(id)!;
  }
}
