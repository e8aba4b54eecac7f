// SPDX-License-Identifier: Apache-2.0
// Elements are made here and nowhere from markup: texts of cases and files stay texts.

type Child = Node | string | null | undefined;
type Properties = Record<string, unknown>;

/// An element with properties (`class`, `onclick`, `aria-label`, ...) and children.
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K, properties: Properties = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (value === undefined || value === null || value === false) continue;
    if (name === "class") element.className = String(value);
    else if (name.startsWith("on")) element.addEventListener(name.slice(2), value as EventListener);
    else if (name in element && !name.includes("-")) (element as unknown as Properties)[name] = value;
    else element.setAttribute(name, String(value));
  }
  element.append(...children.filter((child): child is Node | string => child !== null && child !== undefined));
  return element;
}

export function svg(tag: string, attributes: Record<string, string | number>, ...children: Node[]): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

let labels = 0;

/// A control with its label.
export function labelled(text: string, control: HTMLElement, hint = ""): HTMLElement {
  control.id ||= `control-${++labels}`;
  return el("div", { class: "field" }, el("label", { htmlFor: control.id }, text), control,
    hint ? el("span", { class: "hint" }, hint) : null);
}

export function select(options: [string, string][], value: string, change: (value: string) => void): HTMLSelectElement {
  const control = el("select", { onchange: () => change(control.value) },
    ...options.map(([id, text]) => el("option", { value: id }, text)));
  control.value = value;
  return control;
}

export function button(text: string, click: () => void, kind = ""): HTMLButtonElement {
  return el("button", { type: "button", class: kind, onclick: click }, text);
}

/// Says something to everybody, also to those who listen.
export function say(text: string, problem = false): void {
  const status = document.getElementById("status")!;
  status.textContent = text;
  status.className = problem ? "problem" : "";
  window.clearTimeout(Number(status.dataset.timer));
  status.dataset.timer = String(window.setTimeout(() => { status.textContent = ""; }, problem ? 12000 : 4000));
}

/// Runs what a control asks for; a problem is said.
export async function attempt(work: () => Promise<void>): Promise<void> {
  try {
    await work();
  } catch (problem) {
    say(problem instanceof Error ? problem.message : String(problem), true);
  }
}
