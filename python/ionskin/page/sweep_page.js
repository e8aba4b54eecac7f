// SPDX-License-Identifier: Apache-2.0
(() => {
  const LEFT = 74, RIGHT = 14, TOP = 24, BOTTOM = 42, NARROWEST = 280;
  let WIDTH = 900; // of the charts in pixels, so that their letters keep their size on every screen
  const PANELS = [
    { title: "Motion", height: 146, curves: ["slider_x", "slider_z", "slider_y"], colours: ["--blue", "--orange", "--purple"] },
    { title: "Mean shear γ of the core", height: 156, curves: ["mean_shear"], colours: ["--blue"] },
    { title: "Voltage between the electrodes, sampled", height: 186, curves: ["voltage"], colours: ["--green"] },
    { title: "Electrode currents, sampled", height: 186, curves: ["current_top", "current_bottom", "current_common"],
      colours: ["--blue", "--orange", "--purple"] },
    { title: "Difference current (top − bottom)/2, sampled", height: 186, curves: ["current_difference"],
      colours: ["--green"] },
  ];
  const state = { member: DATA.typical, span: null, metric: 0, key: 0 };

  // Common over all members, so that picking another run changes the curve and not the scale.
  function commonRange(names) {
    let low = 0, high = 0;
    for (const member of DATA.members) for (const name of names) for (const value of member.series[name] || []) {
      if (value !== null) { low = Math.min(low, value); high = Math.max(high, value); }
    }
    const room = 0.06 * (high - low || 1);
    return [low - (low < 0 ? room : 0), high + room];
  }

  function windowRange(member, names, span) {
    let low = 0, high = 0;
    for (const name of names) (member.series[name] || []).forEach((value, i) => {
      if (value !== null && member.time[i] >= span[0] && member.time[i] <= span[1]) {
        low = Math.min(low, value); high = Math.max(high, value);
      }
    });
    const room = 0.06 * (high - low || 1e-12);
    return [low - (low < 0 ? room : 0), high + room];
  }

  function axes(svg, frame, xTitle, unit, xUnit = "") {
    for (const value of ticks(...frame.x, Math.max(3, Math.round(WIDTH / 110)), STEPS)) {
      make(svg, "line", { class: "gridline", x1: frame.px(value), x2: frame.px(value), y1: TOP, y2: frame.bottom });
      make(svg, "text", { x: frame.px(value), y: frame.bottom + 15, "text-anchor": "middle" },
           xUnit ? withUnit(value, xUnit, 4) : Number(value.toPrecision(8)).toString());
    }
    for (const value of ticks(...frame.y, 5, STEPS)) {
      make(svg, "line", { class: "gridline", x1: LEFT, x2: WIDTH - RIGHT, y1: frame.py(value), y2: frame.py(value) });
      make(svg, "text", { x: LEFT - 6, y: frame.py(value) + 4, "text-anchor": "end" }, withUnit(value, unit, 3));
    }
    make(svg, "rect", { class: "axis", x: LEFT, y: TOP, width: WIDTH - LEFT - RIGHT, height: frame.bottom - TOP });
    make(svg, "text", { class: "along", x: (LEFT + WIDTH - RIGHT) / 2, y: frame.bottom + 32, "text-anchor": "middle" }, xTitle);
  }

  function makeFrame(x, y, height) {
    const bottom = height - BOTTOM;
    return {
      x, y, bottom,
      px: (value) => LEFT + (value - x[0]) / (x[1] - x[0]) * (WIDTH - LEFT - RIGHT),
      py: (value) => bottom - (value - y[0]) / (y[1] - y[0]) * (bottom - TOP),
      time: (pixel) => x[0] + (pixel - LEFT) / (WIDTH - LEFT - RIGHT) * (x[1] - x[0]),
    };
  }

  function legend(svg, frame, labels, colours) {
    const name = svg.querySelector(".name"), room = WIDTH - (name ? LEFT + name.getComputedTextLength() + 16 : LEFT);
    const widths = labels.map((label) => 7 * label.length + 16);
    // Where the title leaves no room, the legend goes below the chart, behind the name of the axis.
    const below = widths.reduce((sum, width) => sum + width, 0) > room, y = below ? frame.bottom + 32 : 15;
    if (below) {
      const along = svg.querySelector(".along");
      along.setAttribute("x", LEFT);
      along.setAttribute("text-anchor", "start");
    }
    let x = WIDTH - RIGHT;
    for (let i = labels.length - 1; i >= 0; --i) {
      const text = make(svg, "text", { x, y, "text-anchor": "end", style: `fill: var(${colours[i]})` }, labels[i]);
      x -= (text.getComputedTextLength ? text.getComputedTextLength() : labels[i].length * 6) + 16;
    }
  }

  function drawPanel(panel, holder) {
    const member = DATA.members[state.member], names = panel.curves.filter((name) => member.series[name]);
    holder.textContent = "";
    holder.style.display = names.length ? "" : "none";
    if (!names.length) return;
    const span = state.span || [0, member.time[member.time.length - 1]];
    const unit = DATA.curves.find((curve) => curve.name === names[0]).unit;
    const frame = makeFrame(span, state.span ? windowRange(member, names, span) : commonRange(names), panel.height);
    const svg = make(holder, "svg", { viewBox: `0 0 ${WIDTH} ${panel.height}`, role: "img", "aria-label": panel.title });
    const clip = `clip-${panel.curves[0]}`;
    make(make(svg, "clipPath", { id: clip }), "rect",
         { x: LEFT, y: TOP, width: WIDTH - LEFT - RIGHT, height: frame.bottom - TOP });
    const inside = make(svg, "g", { "clip-path": `url(#${clip})` });
    for (const [phase, start, end] of member.phases) if (phase !== "return") {
      make(inside, "rect", { class: phase === "slide" ? "slide" : "contact", x: frame.px(start), y: TOP,
                             width: frame.px(end) - frame.px(start), height: frame.bottom - TOP });
    }
    axes(svg, frame, "time [s]", unit);
    names.forEach((name, i) => {
      const step = name.startsWith("current");
      let path = "", pen = "M", last = null;
      member.series[name].forEach((value, k) => {
        if (value === null) return;
        const x = frame.px(member.time[k]).toFixed(2), y = frame.py(value).toFixed(2);
        if (step && last !== null) path += `H${x}`; // a reading is known at the end of its interval, and shown until the next
        path += `${pen}${x} ${y}`;
        pen = "L"; last = y;
      });
      make(svg, "path", { class: "curve", d: path, style: `stroke: var(${panel.colours[i]})`, "clip-path": `url(#${clip})`,
                          "data-curve": name });
    });
    title(svg, panel.title, DATA.members.length > 1 ? `${panel.title}, ${member.short}` : panel.title);
    if (names.length > 1) {
      const labels = names.map((name) => DATA.curves.find((curve) => curve.name === name).label), groups = coinciding(member, names, frame);
      legend(svg, frame, groups.map((group) => group.length > 1 ? `${group.map((i) => labels[i]).join(" = ")}` : labels[group[0]]),
             groups.map((group) => panel.colours[group[group.length - 1]]));
    }
    interact(svg, { width: WIDTH, left: LEFT, right: WIDTH - RIGHT, top: TOP, bottom: frame.bottom }, {
      tell: (pixel) => tell(frame.time(pixel)),
      zoom: (low, high) => { state.span = [frame.time(low), frame.time(high)]; drawAll(); },
      whole: () => { state.span = null; drawAll(); },
    });
  }

  // Places of curves that lie over one another, which the legend names together.
  function coinciding(member, names, frame) {
    const groups = [];
    names.forEach((name, i) => {
      const same = groups.find(([first]) => member.series[names[first]].every((value, k) => {
        const other = member.series[name][k];
        return value === null || other === null ? value === other : Math.abs(frame.py(value) - frame.py(other)) < 1;
      }));
      if (same) same.push(i); else groups.push([i]);
    });
    return groups;
  }

  // The longer name where it fits.
  function title(svg, short, long) {
    const name = make(svg, "text", { class: "name", x: LEFT, y: 15 }, long);
    if (name.getComputedTextLength() > WIDTH - LEFT) {
      name.textContent = short;
      name.setAttribute("x", 0);
    }
  }

  function tell(time) {
    const member = DATA.members[state.member];
    let row = member.time.findIndex((value) => value >= time);
    if (row < 0) row = member.time.length - 1;
    const values = DATA.curves.filter((curve) => member.series[curve.name])
      .map((curve) => `${curve.label} ${withUnit(member.series[curve.name][row], curve.unit)}`);
    document.querySelector(".readout").textContent = `${DATA.members.length > 1 || member.label ? `${member.label}, ` : ""}t = ${time.toFixed(4)} s: ${values.join(", ")}`;
  }

  function drawTrend() {
    const holder = document.getElementById("trend"), metric = DATA.metrics[state.metric], key = DATA.keys[state.key];
    holder.textContent = "";
    const chart = document.createElement("div");
    chart.className = "chart";
    holder.append(chart);
    const known = DATA.members.map((member, i) => [key.values[i], metric.values[i], i]).filter((entry) => entry[1] !== null);
    if (!known.length) return;
    // Runs that differ in the key of the axis alone are one curve; that of the run above is drawn last.
    const others = DATA.choices.filter((choice) => choice.axis !== state.key), curves = new Map();
    const curveOf = (member) => others.map((choice) => choice.of[member]).join(), own = curveOf(state.member);
    for (const entry of known) curves.set(curveOf(entry[2]), [...(curves.get(curveOf(entry[2])) || []), entry]);
    const inFront = [...known].sort((a, b) => (curveOf(a[2]) === own) - (curveOf(b[2]) === own));
    const colour = (member) => DATA.scattered || curveOf(member) === own ? "--blue" : "--pale";
    const xs = known.map((entry) => entry[0]), ys = known.map((entry) => entry[1]);
    const pad = 0.05 * (Math.max(...xs) - Math.min(...xs)) || Math.abs(xs[0]) * 0.1 || 1;
    const top = Math.max(0, ...ys), low = Math.min(0, ...ys);
    const frame = makeFrame([Math.min(...xs) - pad, Math.max(...xs) + pad], [low, top + 0.08 * (top - low || 1)], 260);
    const svg = make(chart, "svg", { viewBox: `0 0 ${WIDTH} 260`, role: "img", "aria-label": metric.name });
    axes(svg, frame, key.name, metric.unit, key.unit === "1" ? "" : key.unit);
    const words = metric.name;
    title(svg, words, words);
    if (!DATA.scattered) {
      for (const [name, curve] of [...curves].sort((a, b) => (a[0] === own) - (b[0] === own))) {
        make(svg, "path", { class: "curve", style: `stroke: var(${colour(curve[0][2])})`, "data-curve": name,
                            d: curve.sort((a, b) => a[0] - b[0]).map(([x, y], i) => `${i ? "L" : "M"}${frame.px(x)} ${frame.py(y)}`).join("") });
      }
      if (curves.size > 1) legend(svg, frame, [others.map((choice) => choice.texts[choice.of[state.member]]).join(", ")], ["--blue"]);
    }
    for (const [x, y, i] of inFront) {
      const mark = make(svg, "circle", { cx: frame.px(x), cy: frame.py(y), r: i === state.member ? 7 : 4.5,
                                         style: `fill: var(${i === state.member ? "--orange" : colour(i)}); cursor: pointer` });
      make(mark, "title", {}, `${DATA.members[i].label}: ${withUnit(y, metric.unit)}`);
      mark.addEventListener("click", () => pick(i));
    }
  }

  function button(holder, text, pressed, action) {
    const node = document.createElement("button");
    node.textContent = text;
    node.setAttribute("aria-pressed", pressed);
    node.addEventListener("click", action);
    holder.append(node);
  }

  function pick(member) {
    state.member = Math.min(DATA.members.length - 1, Math.max(0, member));
    drawAll();
  }

  // The run with a value of one key that has the most other values in common with the run that is shown.
  function nearest(chosen, place) {
    const common = (member) => DATA.choices.filter((choice) => choice.of[member] === choice.of[state.member]).length;
    const having = [...DATA.members.keys()].filter((member) => chosen.of[member] === place);
    return having.reduce((best, member) => common(member) > common(best) ? member : best);
  }

  function drawAll() {
    const metrics = document.getElementById("metrics");
    document.querySelectorAll("#explore .picker").forEach((picker, row) => {
      const choice = DATA.choices[row];
      picker.textContent = "";
      if (DATA.members.length > 1) {
        choice.texts.forEach((text, place) => button(picker, text, place === choice.of[state.member], () => pick(nearest(choice, place))));
      }
    });
    WIDTH = Math.max(NARROWEST, Math.min(900, document.getElementById("charts").clientWidth));
    const keys = document.getElementById("keys");
    if (keys) keys.textContent = "";
    if (keys && DATA.keys.length > 1) DATA.keys.forEach((key, i) => button(keys, key.name, i === state.key, () => {
      state.key = i;
      drawAll();
    }));
    if (metrics) metrics.textContent = "";
    if (metrics) DATA.metrics.forEach((metric, i) => button(metrics, metric.name, i === state.metric, () => {
      state.metric = i;
      drawAll();
    }));
    const charts = document.getElementById("charts");
    while (charts.children.length < PANELS.length) {
      const chart = document.createElement("div");
      chart.className = "chart";
      charts.append(chart);
    }
    PANELS.forEach((panel, i) => drawPanel(panel, charts.children[i]));
    if (metrics && DATA.metrics.length) drawTrend();
  }

  onWidth(document.getElementById("charts"), drawAll);
  document.addEventListener("keydown", (event) => {
    if (event.target.closest && event.target.closest("[tabindex]")) return; // arrows scroll a wide table
    if (event.key === "ArrowRight") pick(state.member + 1);
    if (event.key === "ArrowLeft") pick(state.member - 1);
  });
  drawAll();
})();
