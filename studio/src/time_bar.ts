// SPDX-License-Identifier: Apache-2.0
import { button, el } from "./dom";
import { number } from "./format";

/// The instant that scene and curves show; plays at one second per second, the events slowed down by dragging.
export class TimeBar {
  readonly element: HTMLElement;
  private range = el("input", { type: "range", min: "0", max: "1", step: "any", value: "0", "aria-label": "Time" });
  private text = el("output", {}, "0 s");
  private play_button = button("Play", () => this.toggle());
  private end = 1;
  private timer = 0;

  constructor(private change: (time: number) => void) {
    this.range.addEventListener("input", () => this.set(Number(this.range.value)));
    this.range.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: -1, ArrowRight: 1, PageDown: -10, PageUp: 10 }[event.key];
      if (step === undefined) return;
      event.preventDefault();
      this.set(this.time + (step * this.end) / 400);
    });
    this.element = el("div", { class: "time-bar" }, this.play_button, this.range, this.text);
  }

  get time(): number { return Number(this.range.value); }

  set_end(end: number): void {
    this.end = end;
    this.range.max = String(end);
    this.set(Math.min(this.time, end));
  }

  set(time: number): void {
    const inside = Math.min(this.end, Math.max(0, time));
    this.range.value = String(inside);
    this.text.textContent = `${number(inside, 4)} s`;
    this.range.setAttribute("aria-valuetext", this.text.textContent);
    this.change(inside);
  }

  stop(): void {
    cancelAnimationFrame(this.timer);
    this.timer = 0;
    this.play_button.textContent = "Play";
  }

  private toggle(): void {
    if (this.timer) return this.stop();
    this.play_button.textContent = "Pause";
    let last = performance.now();
    if (this.time >= this.end) this.set(0);
    const step = (now: number) => {
      this.set(this.time + (now - last) / 1000);
      last = now;
      if (this.time >= this.end) this.stop();
      else this.timer = requestAnimationFrame(step);
    };
    this.timer = requestAnimationFrame(step);
  }
}
