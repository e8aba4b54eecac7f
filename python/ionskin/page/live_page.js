// SPDX-License-Identifier: Apache-2.0
(() => {
  const LEFT = 74, RIGHT = 14, TOP = 24, BOTTOM = 24, HEIGHT = 154, MARGIN = 8;
  const PREFIX = [[1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"], [1e-12, "p"], [1e-15, "f"]];
  const COLOURS = ["blue", "orange", "green", "purple"];
  const FLAGS = [[1, "outside the trained places"], [2, "heavier or deeper than trained"], [4, "faster than trained"],
    [8, "the contact is a rough one"], [16, "a step was refused"], [32, "a negative force: detached"]];
  const TIME = DATA.time, LAST = TIME.length - 1;
  const at = (id) => document.getElementById(id);
  const state = { frame: 0, playing: false, begun: 0, from: 0 };
  let width = 0, moving = null, charts = [];

  function withUnit(value, unit, digits = 3) {
    if (value === 0) return `0 ${unit}`;
    const [scale, prefix] = PREFIX.find(([size]) => Math.abs(value) >= size) || PREFIX[PREFIX.length - 1];
    return `${Number((value / scale).toPrecision(digits))} ${prefix}${unit}`.replace("-", "−");
  }

  function canvas(parent, height, label) {
    return make(parent, "svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": label });
  }

  // The skin from above, y upwards, and what moves over it.
  function drawMap() {
    const [length, breadth] = DATA.size, box = at("map");
    const scale = Math.min((width - 2 * MARGIN) / length, 420 / breadth), left = (width - scale * length) / 2;
    const height = scale * breadth + 2 * MARGIN;
    const px = (x) => left + scale * x, py = (y) => height - MARGIN - scale * y;
    box.replaceChildren();
    const svg = canvas(box, height, "the skin from above, with the slider and the taxels");
    make(svg, "rect", { class: "skin", x: px(0), y: py(breadth), width: scale * length, height: scale * breadth });
    const taxels = DATA.regions.map(({ name, corners: [x, y, right, top] }) => {
      const rect = make(svg, "rect", { class: "taxel", x: px(x), y: py(top), width: scale * (right - x), height: scale * (top - y) });
      make(rect, "title", {}, name);
      return rect;
    });
    const sides = DATA.footprint;
    const shape = (name) => make(svg, sides ? "rect" : "circle", { class: name });
    moving = { taxels, px, py, scale, sides, stuck: shape("stuck"), slider: shape("slider") };
  }

  function drawChart(parent, { title, unit, curves }) {
    const holder = document.createElement("div");
    holder.className = "chart";
    parent.append(holder);
    const svg = canvas(holder, HEIGHT, title), bottom = HEIGHT - BOTTOM, right = width - RIGHT;
    let low = 0, high = 0;
    for (const { values } of curves) for (const value of values) { low = Math.min(low, value); high = Math.max(high, value); }
    const room = 0.06 * (high - low || 1), span = TIME[LAST] - TIME[0] || 1;
    [low, high] = [low - (low < 0 ? room : 0), high + room];
    const px = (time) => LEFT + (right - LEFT) * (time - TIME[0]) / span;
    const py = (value) => bottom - (bottom - TOP) * (value - low) / (high - low);
    for (const value of ticks(TIME[0], TIME[0] + span, Math.max(3, Math.round(width / 110)))) {
      make(svg, "line", { class: "gridline", x1: px(value), x2: px(value), y1: TOP, y2: bottom });
      make(svg, "text", { x: px(value), y: bottom + 17, "text-anchor": "middle" }, `${Number(value.toPrecision(6))} s`);
    }
    for (const value of ticks(low, high, 4)) {
      make(svg, "line", { class: "gridline", x1: LEFT, x2: right, y1: py(value), y2: py(value) });
      make(svg, "text", { x: LEFT - 6, y: py(value) + 4, "text-anchor": "end" }, withUnit(value, unit));
    }
    make(svg, "rect", { class: "axis", x: LEFT, y: TOP, width: right - LEFT, height: bottom - TOP });
    make(svg, "text", { class: "name", x: LEFT, y: 14 }, title);
    let edge = right;
    const named = curves.length <= COLOURS.length && curves.length > 1 ? [...curves].reverse() : [];
    for (const { label, colour } of named) {
      const text = make(svg, "text", { x: edge, y: 14, "text-anchor": "end", style: `fill: var(--${colour || COLOURS[curves.findIndex((one) => one.label === label)]})` }, label);
      edge -= text.getComputedTextLength() + 12;
    }
    const identifier = `clip${charts.length}`;
    const clip = make(make(svg, "clipPath", { id: identifier }), "rect", { x: LEFT, y: 0, width: 0, height: HEIGHT });
    const seen = { "clip-path": `url(#${identifier})` };
    for (const part of [{ class: "ahead" }, seen]) {
      const group = make(svg, "g", part);
      curves.forEach(({ colour, values }, i) => {
        const path = values.map((value, k) => `${k ? "L" : "M"}${px(TIME[k]).toFixed(1)} ${py(value).toFixed(1)}`).join("");
        make(group, "path", { class: "curve", d: path, style: `stroke: var(--${colour || COLOURS[i % COLOURS.length]})` });
      });
    }
    const cursor = make(svg, "line", { class: "cursor", y1: TOP, y2: bottom });
    svg.addEventListener("pointerdown", (event) => {
      const box = svg.getBoundingClientRect(), x = (event.clientX - box.left) * width / box.width;
      show(frameAt(TIME[0] + span * (x - LEFT) / (right - LEFT)));
    });
    charts.push((frame) => {
      clip.setAttribute("width", px(TIME[frame]) - LEFT);
      cursor.setAttribute("x1", px(TIME[frame]));
      cursor.setAttribute("x2", px(TIME[frame]));
    });
  }

  function draw() {
    width = Math.max(280, at("map").clientWidth);
    drawMap();
    charts = [];
    at("charts").replaceChildren();
    for (const chart of DATA.charts) drawChart(at("charts"), chart);
    paint();
  }

  function place(node, centreX, centreY, [length, breadth], opacity) {
    const { px, py, scale, sides } = moving;
    const set = (values) => Object.entries(values).forEach(([name, value]) => node.setAttribute(name, value));
    if (sides) {
      set({ x: px(centreX - length / 2), y: py(centreY + breadth / 2), width: scale * length, height: scale * breadth });
    } else {
      set({ cx: px(centreX), cy: py(centreY), r: scale * length / 2 });
    }
    node.style.opacity = opacity;
  }

  function paint() {
    const frame = state.frame, touches = DATA.normal_force[frame] > 0;
    moving.taxels.forEach((taxel, i) => {
      const current = DATA.currents[i].values[frame];
      taxel.style.fill = `var(--${current < 0 ? "blue" : "orange"})`;
      taxel.style.fillOpacity = DATA.full > 0 ? 0.85 * Math.min(1, Math.abs(current) / DATA.full) : 0;
    });
    const disc = 2 * Math.sqrt(DATA.contact_area[frame] / Math.PI);
    const sides = moving.sides || (touches ? [disc, disc] : [2e-2 * DATA.size[0], 0]);
    const share = touches ? DATA.stick_share[frame] : 0;
    place(moving.slider, DATA.slider_x[frame], DATA.slider_y[frame], sides, touches ? 1 : 0.35);
    place(moving.stuck, DATA.slider_x[frame], DATA.slider_y[frame], sides.map((side) => side * Math.sqrt(share)), 0.35);
    charts.forEach((move) => move(frame));
    const flags = FLAGS.filter(([bit]) => DATA.flags[frame] & bit).map(([, text]) => text);
    at("now").textContent = [`${TIME[frame].toFixed(3)} s`, touches ? `${withUnit(DATA.normal_force[frame], "N")}, ` +
      `${Math.round(100 * share)} % sticks` : `in the air`, `height ${withUnit(DATA.slider_z[frame], "m")}`, ...flags].join(" · ");
    at("time").value = frame;
    at("time").setAttribute("aria-valuetext", `${TIME[frame].toFixed(3)} s`);
  }

  function frameAt(time) {
    let low = 0, high = LAST;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (TIME[middle] <= time) low = middle; else high = middle - 1;
    }
    return low;
  }

  function show(frame) {
    state.frame = Math.min(LAST, Math.max(0, frame));
    state.from = TIME[state.frame];
    state.begun = performance.now();
    paint();
  }

  function play(playing) {
    if (playing && state.frame === LAST) show(0);
    state.playing = playing;
    state.from = TIME[state.frame];
    state.begun = performance.now();
    at("toggle").textContent = playing ? "Pause" : "Play";
    if (playing) requestAnimationFrame(advance);
  }

  function advance(now) {
    if (!state.playing) return;
    state.frame = frameAt(state.from + Math.max(0, now - state.begun) / 1000 * Number(at("speed").value));
    paint();
    if (state.frame === LAST) play(false); else requestAnimationFrame(advance);
  }

  function faster(steps) {
    const speed = at("speed");
    speed.selectedIndex = Math.min(speed.length - 1, Math.max(0, speed.selectedIndex + steps));
    show(state.frame);
  }

  const step = Math.max(1, Math.round(LAST / 100));
  const KEYS = { " ": () => play(!state.playing), ArrowLeft: () => show(state.frame - step), ArrowRight: () => show(state.frame + step),
    Home: () => show(0), End: () => show(LAST), "+": () => faster(1), "-": () => faster(-1) };
  document.addEventListener("keydown", (event) => {
    const own = event.target.closest("select") || (event.key === " " && event.target.closest("button"));
    if (own || event.ctrlKey || event.metaKey || event.altKey || !KEYS[event.key]) return;
    event.preventDefault();
    KEYS[event.key]();
  });
  at("toggle").addEventListener("click", () => play(!state.playing));
  at("time").addEventListener("input", () => show(Number(at("time").value)));
  at("speed").addEventListener("change", () => show(state.frame));
  at("scale").textContent = `Taxels: orange for a positive and blue for a negative current, full at ${withUnit(DATA.full, "A")} and beyond.`;
  addEventListener("resize", () => { if (at("map").clientWidth !== width) draw(); });
  draw();
})();
