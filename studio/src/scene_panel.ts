// SPDX-License-Identifier: Apache-2.0
// The scene with its controls: what is drawn, where it is cut, how far the thickness is stretched.
import { Result, check, fields } from "./api";
import { ColourScale, css, colour, slip, stick } from "./colours";
import { attempt, button, el, labelled, select } from "./dom";
import { quantity } from "./format";
import { Geometry, geometry_of, geometry_of_fields } from "./geometry";
import { check_box } from "./curves_panel";
import { save_canvas } from "./save";
import { Scene } from "./scene";
import { column, table_of } from "./series";
import { Pressed, Shown, StoredFields } from "./stored_fields";
import { Section, section_at_x, section_at_y, section_at_z } from "./volume";

interface Way { time: Float64Array; x: Float64Array; y?: Float64Array; z: Float64Array; force?: Float64Array; }

export class ScenePanel {
  readonly element = el("section", { class: "scene-panel", "aria-label": "Skin in three dimensions" });
  private scene?: Scene;
  private stored?: StoredFields;
  private geometry?: Geometry;
  private way?: Way;
  private channel = "";
  private cut = "y";
  private contact = "pressure";
  private place = 0.5;
  private time = 0;
  private busy = false;
  private again = false;
  private walls = el("input", { type: "checkbox", checked: true, onchange: () => this.refresh() });
  private channels = el("select", { onchange: () => { this.channel = this.channels.value; this.refresh(); } });
  private legend = el("div", { class: "legend" });
  private note = el("p", { class: "hint" });
  private result?: Result;
  private drawn: unknown[] = [];

  constructor() {
    try {
      this.scene = new Scene();
    } catch {
      this.element.append(el("p", { class: "hint" }, "This browser shows no WebGL: the curves remain."));
      return;
    }
    const place = el("input", { type: "range", min: "0", max: "1", step: "0.01", value: "0.5", oninput: () => { this.place = Number(place.value); this.refresh(); } });
    const stretch = el("input", { type: "range", min: "1", max: "40", step: "1", value: "10", oninput: () => { this.scene!.set_stretch(Number(stretch.value)); this.refresh(); } });
    const contacts = select([["pressure", "Contact pressure"], ["slip", "Stick and slip"], ["", "No contact"]], this.contact, (value) => { this.contact = value; this.refresh(); });
    this.element.append(this.scene.element, this.legend, this.note, el("div", { class: "row controls" },
      labelled("Field", this.channels),
      labelled("Cut", select([["y", "Along the slide"], ["x", "Across"], ["z", "Level"], ["volume", "Slices of the volume"], ["", "None"]], this.cut, (value) => { this.cut = value; this.refresh(); })),
      labelled("Place of the cut", place), labelled("Face", contacts), labelled("Thickness stretched", stretch),
      check_box("Wall layers magnified", this.walls),
      button("Save PNG", () => { this.scene!.draw(); save_canvas("skin.png", this.scene!.canvas); }, "small")));
    window.addEventListener("theme", () => this.scene!.render());
  }

  get frames(): number { return this.scene?.frames ?? 0; }

  async show(result: Result): Promise<void> {
    if (!this.scene) return;
    this.result = result;
    this.drawn = [];
    [this.stored, this.way, this.geometry] = [undefined, undefined, undefined];
    const [list, verdict] = await Promise.all([
      result.fields ? fields(result.path) : Promise.resolve({ ions: null, strain: null, contact: null }), check(result.case)]);
    const data = result.tables.includes("signals") ? await table_of(result, "signals") : undefined;
    if (this.result !== result) return;
    this.geometry = verdict.values ? geometry_of(verdict.values) : geometry_of_fields(list);
    if (!this.geometry) return;
    const [time, x, z] = ["time", "slider_x", "slider_z"].map((name) => data && column(data, name)?.values);
    const cycles = data ? Math.max(1, ...(column(data, "cycle")?.values ?? [1])) : 1;
    const end = time ? time[time.length - 1] : 0;
    if (time && x && z && Number.isFinite(x[0])) {
      this.way = { time, x, z, y: column(data!, "slider_y")?.values, force: column(data!, "normal_force")?.values };
    } else this.geometry.slides = false;
    this.stored = new StoredFields(result.path, list, this.geometry.width, end / cycles);
    const channels = this.stored.channels();
    this.channels.replaceChildren(...channels.map(([id, name]) => el("option", { value: id }, name)));
    if (!channels.some(([id]) => id === this.channel)) this.channel = channels[0]?.[0] ?? "";
    this.channels.value = this.channel;
    this.scene.show(this.geometry);
    this.refresh();
  }

  set_time(time: number): void {
    this.time = time;
    this.refresh();
  }

  /// Only the newest wish is fetched while an earlier one is under way.
  private refresh(): void {
    if (this.busy) {
      this.again = true;
      return;
    }
    this.busy = true;
    attempt(() => this.update()).then(() => {
      this.busy = false;
      if (this.again) {
        this.again = false;
        this.refresh();
      }
    });
  }

  private async update(): Promise<void> {
    const [scene, stored, shape, time] = [this.scene, this.stored, this.geometry, this.time];
    if (!scene || !stored || !shape) return;
    const [x, y, z, force] = this.at(time);
    scene.move_slider(x, y, z);
    const touches = force > 0;
    const [shown, pressed] = await Promise.all([
      this.cut && this.channel ? stored.volume(this.channel, time) : undefined,
      this.contact && touches ? stored.contact(time) : undefined]);
    if (stored !== this.stored) return;
    this.note.textContent = shown && Math.abs(shown.time - time) > 0.02 ? `This field is stored at ${quantity(shown.time, "s")}, the nearest instant; output.fields stores more.` : "";
    // The slider alone moves between two stored instants: nothing else is made anew for a frame.
    const drawn = [shown?.volume.field, shown?.time, this.cut, this.place, this.walls.checked, pressed?.pressure, this.contact];
    if (drawn.every((one, i) => one === this.drawn[i]) && this.drawn.length) return;
    this.drawn = drawn;
    const scale = shown && this.scale(shown);
    scene.show_sections(shown ? this.sections(shown, shape) : [], scale ?? { least: 0, greatest: 1, diverging: false });
    const pressures: ColourScale = { least: 0, greatest: pressed ? usual(pressed.pressure.values) : 1, diverging: false };
    scene.show_contact(pressed, this.contact, pressures);
    this.tell(shown, scale, pressed, pressures);
  }

  private at(time: number): [number, number, number, number] {
    const shape = this.geometry!;
    if (!this.way) return [shape.start[0], shape.start[1], shape.gap, 0];
    const way = this.way;
    let low = 0, high = way.time.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (way.time[middle] <= time) low = middle;
      else high = middle;
    }
    const span = way.time[high] - way.time[low];
    const share = span > 0 ? Math.min(1, Math.max(0, (time - way.time[low]) / span)) : 0;
    const mix = (list: Float64Array) => list[low] + (list[high] - list[low]) * share;
    const x = mix(way.x) * 1e3;
    const y = way.y ? mix(way.y) * 1e3 : shape.start[1] + (shape.direction[0] ? ((x - shape.start[0]) * shape.direction[1]) / shape.direction[0] : 0);
    return [x, y, mix(way.z) * 1e3, way.force ? mix(way.force) : 0];
  }

  private sections(shown: Shown, shape: Geometry): Section[] {
    const volume = this.walls.checked ? { ...shown.volume, z: shown.volume.z.map((_, i, all) => (all[all.length - 1] * i) / Math.max(1, all.length - 1)) } : shown.volume;
    if (this.cut === "y") return [section_at_y(volume, this.place * shape.width * 0.999, shape.length)];
    if (this.cut === "x") return [section_at_x(volume, this.place * shape.length * 0.999, shape.width)];
    if (this.cut === "z") return [section_at_z(volume, this.place, shape.length, shape.width)];
    return [0.1, 0.3, 0.5, 0.7, 0.9].map((part) => section_at_x(volume, part * shape.length, shape.width))
      .concat([section_at_y(volume, this.place * shape.width * 0.999, shape.length)]);
  }

  private scale(shown: Shown): ColourScale {
    const { least, greatest } = shown.volume.field;
    if (this.channel.endsWith("concentration") && least !== null && greatest !== null) {
      const middle = shown.volume.field.values[0];
      const reach = Math.max(greatest - middle, middle - least);
      return { least: middle - reach, greatest: middle + reach, diverging: true };
    }
    // Smoothing leaves a shear that cannot be negative a little below 0.
    const both = (least ?? 0) < -0.1 * (greatest ?? 0) && (greatest ?? 0) > 0;
    const reach = Math.max(Math.abs(least ?? 0), Math.abs(greatest ?? 0));
    return both ? { least: -reach, greatest: reach, diverging: true } : { least: 0, greatest: greatest ?? 1, diverging: false };
  }

  private tell(shown: Shown | undefined, scale: ColourScale | undefined, pressed: Pressed | undefined, pressures: ColourScale): void {
    const name = [...this.channels.options].find((one) => one.value === this.channel)?.textContent ?? "";
    const bars: HTMLElement[] = [];
    if (shown && scale) bars.push(bar(name, scale, shown.volume.field.unit));
    if (pressed && this.contact === "pressure") bars.push(bar("Contact pressure up to its 90th percentile", pressures, "Pa"));
    if (pressed && this.contact === "slip") bars.push(el("span", { class: "key" }, swatch(stick), " sticks ", swatch(slip), " slips"));
    this.legend.replaceChildren(...bars);
  }
}

/// The pressure that nine cells of ten stay below: peaks under sharp edges follow the mesh.
function usual(pressures: Float32Array): number {
  const sorted = Float32Array.from(pressures).filter((one) => one > 0).sort();
  return sorted[Math.floor(sorted.length * 0.9)] || 1;
}

function swatch(rgb: [number, number, number]): HTMLElement {
  const box = el("span", { class: "swatch" });
  box.style.background = css(rgb);
  return box;
}

function bar(name: string, scale: ColourScale, unit: string): HTMLElement {
  const canvas = el("canvas", { width: 160, height: 12, "aria-hidden": "true" });
  const pen = canvas.getContext("2d")!;
  for (let i = 0; i < 160; ++i) {
    pen.fillStyle = css(colour(scale, scale.least + ((scale.greatest - scale.least) * i) / 159));
    pen.fillRect(i, 0, 1, 12);
  }
  return el("span", { class: "key" }, `${name}: `, el("span", {}, quantity(scale.least, unit, 3)), canvas, el("span", {}, quantity(scale.greatest, unit, 3)));
}
