// SPDX-License-Identifier: Apache-2.0
// The figures of a run: each is rows of cells, a cell one pair of axes. chart_data.py says what FIGURES holds.
(() => {
  const HEIGHT = 150, TALLEST = 420, NARROW = 560, NARROWEST = 160, LINE = 15, MARK = 6, PLAIN = 0.1, LEFT = 68, UNNAMED = 58, BAR = 74, EDGE = 12;
  const DASHES = { dashed: "6 3", dotted: "1.5 3", "": "none", none: "none" };
  const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  let clips = 0;

  function signedLog(peak) { // linear about zero up to 5 decades below the peak
    const top = Math.ceil(Math.log10(peak) - 1e-9), threshold = 10 ** (top - 5);
    const at = (value) => Math.sign(value) * (Math.abs(value) <= threshold ? 0.6 * Math.abs(value) / threshold
                                                                           : 0.6 + Math.log10(Math.abs(value) / threshold));
    const powers = [0, 2, 4].map((n) => 10 ** (top - n));
    return { at, ends: [-1.3 * 10 ** top, 1.3 * 10 ** top], ticks: [...powers.map((power) => -power), 0, ...powers] };
  }

  // Logarithmic axis of positive values; its ticks are a factor of ten apart, or less where it is short.
  function logAxis(axis, values) {
    let low = Infinity, high = 0;
    for (const value of values) if (value > 0) { low = Math.min(low, value); high = Math.max(high, value); }
    if (!high) [low, high] = [1, 10];
    const room = Math.max(0.05 * Math.log10(high / low), 0.05), ends = [axis.low ?? low / 10 ** room, axis.high ?? high * 10 ** room];
    const decades = Math.log10(ends[1] / ends[0]), found = [];
    const apart = Math.ceil(decades / 6), factors = decades < 2 ? [1, 2, 5] : [1];
    for (let power = Math.floor(Math.log10(ends[0])); power <= Math.log10(ends[1]); ++power) for (const factor of factors) {
      const value = Number((factor * 10 ** power).toPrecision(3));
      if (value >= ends[0] && value <= ends[1] && power % apart === 0) found.push(value);
    }
    return { at: (value) => value > 0 ? Math.log10(value) : NaN, ends, ticks: found.length ? found : [low, high] };
  }

  // Divisor and words of a linear axis.
  function scaled({ name, unit }, peak) {
    const [divisor, prefix] = scale(peak);
    if (unit !== "1") return [divisor, `${name} [${prefix}${unit}]`.trim()];
    if (peak >= PLAIN && peak < 1e5) return [1, name];
    const power = [...String(Math.round(Math.log10(divisor)))].map((sign) => sign === "-" ? "⁻" : SUPERSCRIPTS[sign]).join("");
    return [divisor, divisor === 1 ? name : `${name} [10${power}]`.trim()];
  }

  function extent(axis, values) {
    let low = Infinity, high = -Infinity;
    for (const value of values) if (value !== null) { low = Math.min(low, value); high = Math.max(high, value); }
    if (low > high) [low, high] = [0, 1];
    const room = 0.06 * (high - low) || 0.06 * Math.abs(high) || 1;
    return [axis.low ?? low - room, axis.high ?? high + room];
  }

  // Words along an axis, in smaller letters where they are longer than it.
  function within(svg, attributes, words, room) {
    const text = make(svg, "text", attributes, words), length = text.getComputedTextLength();
    if (length > room + 16) text.style.fontSize = `${Math.max(8, 11 * (room + 16) / length)}px`;
  }

  // Series of a curve that lie between two places, with one beyond each.
  function shownRows(x, [low, high]) {
    let first = x.findIndex((value) => value >= low), last = x.findLastIndex((value) => value <= high);
    if (first < 0) first = x.length - 1;
    return [Math.max(0, first - 1), Math.min(x.length - 1, Math.max(last, first - 1) + 1)];
  }

  function* valuesWithin(cell, span) {
    for (const curve of cell.curves) {
      const x = FIGURES.arrays[curve.x], [first, last] = shownRows(x, span);
      for (const series of [curve.y, ...curve.band || []]) {
        for (let i = first; i <= last; ++i) if (x[i] >= span[0] && x[i] <= span[1]) yield FIGURES.arrays[series][i];
      }
    }
    for (const { low, high } of cell.spans.filter((each) => each.along === "y")) { yield low; yield high; }
  }

  // Title and legend above a cell, in as many lines as they need; returns where the axes begin.
  function header(svg, cell, width) {
    let y = 12, x = cell.bare ? 0 : Math.min(LEFT, 8);
    if (cell.title) {
      let line = make(svg, "text", { class: "name", x, y });
      for (const word of cell.title.split(" ")) {
        const before = line.textContent;
        line.textContent = before ? `${before} ${word}` : word;
        if (before && line.getComputedTextLength() > width - x) {
          line.textContent = before;
          y += LINE;
          line = make(svg, "text", { class: "name", x, y }, word);
        }
      }
      x += line.getComputedTextLength() + 14;
    }
    const entries = cell.legend ? [...cell.spans, ...cell.curves, ...cell.marks, ...cell.shapes].filter((each) => each.label) : [];
    if (cell.bare) entries.reverse(); // the upper parts of a drawing come last
    const group = make(svg, "g");
    const made = entries.map((each) => {
      const part = make(group, "g"), line = each.edge !== undefined && !each.fill, wide = each.fill || each.along && each.colour;
      make(part, wide ? "rect" : "line", wide
        ? { x: 0, y: -9, width: 16, height: 10, style: `fill: ${each.fill || each.colour}; stroke: ${each.fill ? "var(--ink)" : "none"}; stroke-width: .5` }
        : { x1: 0, x2: 18, y1: -4, y2: -4, style: `stroke: ${(line ? each.edge : each.colour) || "var(--quiet)"}; stroke-width: ${each.look === "none" ? 5 : Math.min(4, 1.4 * (each.width || 0.8))}; stroke-dasharray: ${DASHES[each.look || ""]}` });
      const text = make(part, "text", { x: 23, y: 0 }, each.label);
      return [part, 23 + text.getComputedTextLength() + 14];
    });
    const all = made.reduce((sum, [, room]) => sum + room, 0);
    if (made.length && all <= width - x + 14) x = width - all + 14; // beside the title, at the right
    else if (made.length) { x = 8; if (cell.title) y += LINE + 1; }
    for (const [part, room] of made) {
      if (x > 8 && x + room > width + 14) { x = 8; y += LINE + 1; }
      part.setAttribute("transform", `translate(${x} ${y})`);
      x += room;
    }
    return cell.title || made.length ? y + 9 : 8;
  }

  function drawCurve(svg, curve, frame, clip) {
    const x = FIGURES.arrays[curve.x], [first, last] = shownRows(x, frame.x);
    const path = (series, rows) => {
      let text = "", pen = false;
      for (const i of rows) {
        const value = FIGURES.arrays[series][i];
        if (value === null || !Number.isFinite(frame.py(value))) { pen = false; continue; }
        const px = frame.px(x[i]).toFixed(1), py = frame.py(value).toFixed(1);
        text += !pen ? `M${px} ${py}` : curve.step === "over" ? `V${py}H${px}` : curve.step ? `H${px}V${py}` : `L${px} ${py}`;
        pen = true;
      }
      return text;
    };
    const rows = Array.from({ length: last - first + 1 }, (_, i) => first + i);
    const bars = curve.look === "none";
    if (curve.band && bars) for (const i of rows) {
      const [from, to] = curve.band.map((series) => frame.py(FIGURES.arrays[series][i] ?? NaN)), px = frame.px(x[i]);
      if (Number.isFinite(from + to)) make(svg, "path", { d: `M${px - 3} ${from}h6m-3 0V${to}m-3 0h6`, "clip-path": clip, style: `stroke: ${curve.colour}; fill: none` });
    }
    if (curve.band && !bars) {
      const corner = (series) => rows.flatMap((i, k) => { // a band of steps is drawn by its corners
        const value = FIGURES.arrays[series][i], px = frame.px(x[i]).toFixed(1);
        if (value === null || !Number.isFinite(frame.py(value))) return [];
        const py = frame.py(value).toFixed(1), other = curve.step === "over" ? k - 1 : k + 1;
        if (!curve.step || other < 0 || other >= rows.length) return [`${px} ${py}`];
        const beside = `${frame.px(x[rows[other]]).toFixed(1)} ${py}`;
        return curve.step === "over" ? [beside, `${px} ${py}`] : [`${px} ${py}`, beside];
      });
      const outline = [...corner(curve.band[0]), ...corner(curve.band[1]).reverse()];
      if (outline.length) make(svg, "path", { d: `M${outline.join("L")}Z`, "clip-path": clip, style: `fill: ${curve.colour}; opacity: .25` });
    }
    if (!bars) make(svg, "path", { class: "curve", d: path(curve.y, rows), "clip-path": clip,
                        style: `stroke: ${curve.colour}; stroke-width: ${1.2 * curve.width}; stroke-dasharray: ${DASHES[curve.look]}` });
    if (curve.marks && (bars || rows.length * MARK < frame.right - frame.left)) for (const i of rows) {
      const value = FIGURES.arrays[curve.y][i];
      if (value !== null && Number.isFinite(frame.py(value))) make(svg, "circle", { cx: frame.px(x[i]), cy: frame.py(value), r: bars ? 2 * curve.width : 2, "clip-path": clip, style: `fill: ${curve.colour}` });
    }
  }

  function drawMap(svg, map, frame, clip, wide) {
    if (map.image) {
      const [x0, x1, y0, y1] = map.ends;
      make(svg, "image", { href: map.image, x: frame.px(x0), y: frame.py(y1), width: frame.px(x1) - frame.px(x0), "clip-path": clip,
                           height: frame.py(y0) - frame.py(y1), preserveAspectRatio: "none",
                           style: `image-rendering: ${map.smooth ? "auto" : "pixelated"}` });
    }
    for (const line of map.lines) {
      let path = "";
      for (let i = 0; i < line.length; i += 2) path += `${i ? "L" : "M"}${frame.px(line[i]).toFixed(1)} ${frame.py(line[i + 1]).toFixed(1)}`;
      make(svg, "path", { d: path, style: "fill: none; stroke: #fff; stroke-width: 1.1" });
    }
    const classes = Object.entries(map.classes), left = frame.right + 8;
    classes.forEach(([name, colour], i) => {
      make(svg, "rect", { x: left, y: frame.top + 18 * i, width: 10, height: 10, style: `fill: ${colour}` });
      make(svg, "text", { x: left + 14, y: frame.top + 18 * i + 9 }, name);
    });
    if (classes.length) return;
    const tall = frame.bottom - frame.top, id = `bar-${++clips}`;
    const gradient = make(make(svg, "defs"), "linearGradient", { id, x1: 0, x2: 0, y1: 0, y2: 1 });
    map.bar.forEach((colour, i) => make(gradient, "stop", { offset: i / (map.bar.length - 1), "stop-color": colour }));
    make(svg, "rect", { x: left, y: frame.top, width: 9, height: tall, style: `fill: url(#${id})` });
    if (map.beyond) make(svg, "path", { d: `M${left} ${frame.top}h9l-4.5 -8Z`, style: `fill: ${map.bar[0]}` });
    const [divisor, words] = scaled(map, Math.max(Math.abs(map.low), Math.abs(map.high)));
    for (const [place, name] of map.ticks) {
      make(svg, "text", { x: left + 13, y: frame.bottom - (place - map.low) / (map.high - map.low) * tall + 4 }, name);
    }
    const round = map.ticks.length ? [] : ticks(map.low / divisor, map.high / divisor, Math.max(2, Math.min(5, tall / 26)), STEPS);
    for (const value of round.length > 2 || map.ticks.length ? round : map.low < 0 ? [map.low / divisor, 0, map.high / divisor] : [0, map.high / divisor]) {
      const y = frame.bottom - (value * divisor - map.low) / (map.high - map.low) * tall;
      make(svg, "text", { x: left + 13, y: y + 4 }, Number(value.toPrecision(3)).toString());
    }
    if (words) within(svg, { transform: `translate(${wide - 3} ${(frame.top + frame.bottom) / 2}) rotate(-90)`, "text-anchor": "middle" }, words.trim(), tall);
  }

  /** The lines of a note, from the last one on, that the room it is given has place for. */
  function fitting(note, frame) {
    const lines = note.words.split("\n"), [width, height] = note.room;
    if (!width && !height) return lines;
    const wide = frame.px(width) - frame.px(0), count = Math.floor((frame.py(0) - frame.py(height)) / 9.5);
    const narrow = lines.map((line) => 0.6 * 1.4 * note.size * line.length <= wide);
    return lines.filter((line, i) => i >= lines.length - count && narrow[i]);
  }

  function drawShapes(svg, cell, frame) {
    for (const shape of cell.shapes) {
      let path = "";
      for (const outline of shape.outlines) {
        for (let i = 0; i < outline.length; i += 2) path += `${i ? "L" : "M"}${frame.px(outline[i]).toFixed(1)} ${frame.py(outline[i + 1]).toFixed(1)}`;
        if (shape.fill) path += "Z";
      }
      make(svg, "path", { d: path, style: `fill: ${shape.fill || "none"}; stroke: ${shape.edge || "none"}; stroke-width: ${1.4 * shape.width}; stroke-dasharray: ${DASHES[shape.look]}; stroke-linejoin: round` });
    }
    for (const note of cell.notes) {
      const relative = !cell.shapes.length;
      const x = relative ? frame.left + note.x * (frame.right - frame.left) : frame.px(note.x);
      const y = relative ? frame.top + note.y * (frame.bottom - frame.top) : frame.py(note.y);
      const group = make(svg, "g"), lines = fitting(note, frame);
      lines.forEach((line, i) => make(group, "text", { x, y: y + 4 + 12 * (i - (lines.length - 1) / 2), "text-anchor": note.anchor,
                                                       style: `fill: ${note.colour}; font-size: ${1.4 * note.size}px` }, line));
      if (note.boxed) {
        const box = group.getBBox(), back = make(group, "rect", { x: box.x - 2, y: box.y, width: box.width + 4, height: box.height, class: "behind" });
        group.prepend(back);
      }
    }
  }

  function drawAxes(svg, cell, frame, wide, named) {
    const reach = Math.max(...frame.x.map((end) => Math.abs(end - cell.x.origin))), height = Math.max(...frame.y.map(Math.abs));
    const both = cell.equal ? Math.max(reach, height) : 0; // one unit where both have one scale
    const [xDivisor, xWords] = scaled(cell.x.name || !named ? cell.x : { ...cell.x, name: named }, both || reach);
    for (const value of ticks(...frame.x.map((end) => (end - cell.x.origin) / xDivisor), Math.max(Math.min(3, (frame.right - frame.left) / 45), Math.round((frame.right - frame.left) / 80)), STEPS)) {
      const x = frame.px(value * xDivisor + cell.x.origin);
      if (!cell.map) make(svg, "line", { class: "gridline", x1: x, x2: x, y1: frame.top, y2: frame.bottom });
      const tick = make(svg, "text", { x, y: frame.bottom + 14, "text-anchor": "middle" }, Number(value.toPrecision(6)).toString());
      tick.setAttribute("x", Math.min(x, wide - 1 - tick.getComputedTextLength() / 2));
    }
    const log = frame.scale, [yDivisor, yWords] = log ? [1, cell.y.name] : scaled(cell.y, both || height);
    const values = log ? log.ticks : ticks(...frame.y.map((end) => end / yDivisor), Math.max(3, Math.round((frame.bottom - frame.top) / 30)), STEPS);
    const empty = !cell.curves.length && !cell.map && !cell.shapes.length;
    const numbers = (empty ? [] : values).map((value) => {
      const y = frame.py(value * yDivisor);
      if (!cell.map) make(svg, "line", { class: "gridline", x1: frame.left, x2: frame.right, y1: y, y2: y });
      return make(svg, "text", { x: frame.left - 6, y: y + 4, "text-anchor": "end" }, log ? withUnit(value, cell.y.unit, 3) : Number(value.toPrecision(6)).toString());
    });
    // Numbers of many digits are smaller, so that the name of the axis has its place.
    const longest = Math.max(0, ...numbers.map((one) => one.getComputedTextLength())), room = frame.left - (cell.y.name ? 24 : 8);
    if (longest > room) for (const one of numbers) one.style.fontSize = `${Math.max(7, 11 * room / longest)}px`;
    make(svg, "path", { class: "axis", d: `M${frame.left} ${frame.top}V${frame.bottom}H${frame.right}` });
    if (xWords && (cell.x.name || named)) {
      const text = make(svg, "text", { class: "along", y: frame.bottom + 30, "text-anchor": "middle" }, xWords), half = text.getComputedTextLength() / 2;
      text.setAttribute("x", Math.max(half + 1, Math.min(wide - half - 1, (frame.left + frame.right) / 2)));
    }
    if (cell.y.name && !empty) within(svg, { transform: `translate(11 ${(frame.top + frame.bottom) / 2}) rotate(-90)`, "text-anchor": "middle" }, yWords, frame.bottom - frame.top);
  }

  // named: what the horizontal axis is, where the cell that says so is far away on a narrow screen.
  function drawCell(holder, cell, named, neighbours, redraw, readout) {
    holder.textContent = "";
    const wide = Math.max(NARROWEST, holder.clientWidth), svg = make(holder, "svg", { role: "img", "aria-label": cell.title || named });
    svg.setAttribute("viewBox", `0 0 ${wide} 100`);
    const above = (each, width = wide) => header(svg, each, width) + (each.phases.length ? 12 : 0) + (each.map && each.map.beyond ? 4 : 0);
    const needed = neighbours.map(([each, width]) => { // axes side by side begin at one height
      const room = above(each, width);
      svg.textContent = "";
      return room;
    });
    const top = Math.max(above(cell), ...needed);
    const zoomed = cell.zoom || null, x = zoomed || extent(cell.x, cell.curves.flatMap((curve) => FIGURES.arrays[curve.x]));
    const special = cell.y.signed ? signedLog(cell.y.signed) : cell.y.log ? logAxis(cell.y, [...valuesWithin(cell, x)]) : null;
    const y = special ? special.ends : extent(zoomed ? { low: null, high: null } : cell.y, valuesWithin(cell, x));
    const left = cell.bare ? 0 : cell.y.name ? LEFT : UNNAMED;
    let right = wide - (cell.map ? BAR : cell.bare ? 0 : EDGE), tall = HEIGHT * cell.height;
    if (cell.equal) {
      tall = (right - left) * (y[1] - y[0]) / (x[1] - x[0]);
      if (tall > TALLEST) { right = left + (right - left) * TALLEST / tall; tall = TALLEST; }
    }
    const bottom = top + tall, at = special ? special.at : (value) => value;
    const frame = { left, right, top, bottom, x, y, scale: special,
                    px: (value) => left + (value - x[0]) / (x[1] - x[0]) * (right - left),
                    py: (value) => bottom - (at(value) - at(y[0])) / (at(y[1]) - at(y[0])) * tall };
    const height = bottom + (cell.bare ? 4 : cell.x.name || named ? 36 : 22);
    svg.setAttribute("viewBox", `0 0 ${wide} ${height}`);
    const id = `cell-${++clips}`, clip = `url(#${id})`;
    make(make(svg, "clipPath", { id }), "rect", { x: left, y: top, width: right - left, height: tall });
    for (const span of cell.spans.filter((each) => each.along === "x")) {
      make(svg, "rect", { x: frame.px(span.low), y: top, width: Math.max(0, frame.px(span.high) - frame.px(span.low)), height: tall, "clip-path": clip, style: `fill: ${span.colour}` });
    }
    if (!cell.bare) drawAxes(svg, cell, frame, wide, named);
    for (const span of cell.spans.filter((each) => each.along === "y")) {
      make(svg, "rect", { x: left, y: frame.py(span.high), width: right - left, height: Math.max(0, frame.py(span.low) - frame.py(span.high)), "clip-path": clip, style: `fill: ${span.colour}; opacity: .5` });
    }
    for (const mark of cell.marks) {
      const along = mark.along === "x" ? { x1: frame.px(mark.at), x2: frame.px(mark.at), y1: top, y2: bottom } : { x1: left, x2: right, y1: frame.py(mark.at), y2: frame.py(mark.at) };
      make(svg, "line", { ...along, "clip-path": clip, style: `stroke: var(--quiet); stroke-width: 1; stroke-dasharray: ${DASHES[mark.look]}` });
      if (mark.words && mark.at >= x[0] && mark.at <= x[1]) make(svg, "text", { class: "quiet", x: frame.px(mark.at) + 4, y: top + 11 }, mark.words);
    }
    for (const phase of cell.phases) if (!zoomed) {
      const text = make(svg, "text", { class: "quiet", y: top - 4, "text-anchor": "middle" }, phase.words), half = text.getComputedTextLength() / 2;
      text.setAttribute("x", Math.max(left + half, Math.min(frame.px(phase.x), right - half))); // not over the numbers beside the axis
    }
    for (const curve of cell.curves) drawCurve(svg, curve, frame, clip);
    if (cell.map) drawMap(svg, cell.map, frame, clip, wide);
    drawShapes(svg, cell, frame);
    if (cell.bare) fit(svg);
    if (!cell.curves.length) { svg.style.cursor = "default"; return; }
    const place = (pixel) => x[0] + (pixel - left) / (right - left) * (x[1] - x[0]);
    interact(svg, { width: wide, left, right, top, bottom }, {
      tell: (pixel) => { readout.textContent = reading_at(cell, place(pixel), named); },
      zoom: (low, high) => redraw(place(low), place(high)),
      whole: () => redraw(),
    });
  }

  // Words beyond the drawing's edges are part of the picture.
  function fit(svg) {
    const box = svg.getBBox();
    svg.setAttribute("viewBox", `${box.x - 2} ${box.y - 2} ${box.width + 4} ${box.height + 4}`);
  }

  function reading_at(cell, at, named) {
    const values = cell.curves.map((curve) => {
      const x = FIGURES.arrays[curve.x];
      const row = Math.max(0, curve.step === "held" ? x.findLastIndex((value) => value <= at) : x.findIndex((value) => value >= at));
      return `${curve.label || cell.y.name || "value"} ${withUnit(FIGURES.arrays[curve.y][row], cell.y.unit)}`;
    });
    return `${cell.x.name || named || "at"} ${withUnit(at - cell.x.origin, cell.x.unit, 5)}: ${values.join(", ")}`;
  }

  function drawChart(chart, holder) {
    const narrow = holder.clientWidth < NARROW, columns = narrow ? Math.min(chart.narrow, chart.widths.length) : chart.widths.length;
    const readout = holder.parentElement.querySelector(".readout");
    holder.style.gridTemplateColumns = (narrow ? Array(columns).fill(1) : chart.widths).map((part) => `minmax(0, ${part}fr)`).join(" ");
    holder.textContent = "";
    const places = chart.rows.flatMap((row, r) => row.map((cell, c) => {
      const div = document.createElement("div");
      div.className = "chart";
      if (row.length === 1) div.style.gridColumn = "1 / -1";
      holder.append(div);
      // The axis is named by the last cell of its column; where columns lie below one another every cell names it.
      const last = [...chart.rows].reverse().find((each) => each[c] && each[c].x.name && each.length === row.length);
      // Below one another, cells without a title are of the column whose first one has it.
      const first = chart.rows.find((each) => each.length === row.length)[c];
      const shown = cell.title || columns === chart.widths.length ? cell : { ...cell, title: first.title };
      return { cell: shown, div, row: r, column: `${c} of ${row.length}`, named: narrow && columns < chart.widths.length && last ? last[c].x.name : "" };
    }));
    const beside = (each) => narrow ? [] : places.filter((other) => other !== each && other.row === each.row)
      .map((other) => [other.cell, other.div.clientWidth]);
    const draw = (each) => drawCell(each.div, each.cell, each.named, beside(each), (low, high) => {
      // Cells of one column over the same span show the same part of it.
      for (const other of places) if (other.column === each.column && other.cell.curves.length
          && other.cell.x.low === each.cell.x.low && other.cell.x.high === each.cell.x.high) {
        other.cell.zoom = low === undefined ? null : [low, high];
        draw(other);
      }
    }, readout);
    places.forEach(draw);
  }

  for (const [name, chart] of Object.entries(FIGURES.charts)) {
    const holder = document.getElementById(`chart-${name}`);
    onWidth(holder, () => drawChart(chart, holder));
    drawChart(chart, holder);
  }
})();
