// Tables whose headings sort their rows, by numbers where they begin with one.
document.querySelectorAll("table.sortable th").forEach((heading) => {
  heading.addEventListener("click", () => {
    const sense = heading.dataset.sense === "1" ? -1 : 1;
    const rows = [...heading.closest("table").rows].filter((row) => row.cells[0].tagName === "TD");
    const text = (row) => row.cells[heading.cellIndex].textContent;
    const number = (row) => text(row) === "infinite" ? Infinity : parseFloat(text(row));
    const compare = (a, b) => number(a) - number(b) || text(a).localeCompare(text(b));
    rows.sort((a, b) => sense * compare(a, b)).forEach((row) => row.parentNode.append(row));
    heading.dataset.sense = sense;
  });
});

// Moves the drawing of the building and makes histories that zoom together. Without this script, or without the data
// of a run, the page keeps its static charts and the drawing at rest.
(function () {
  "use strict";
  const source = document.getElementById("run-data");
  if (!source) return;
  const run = JSON.parse(source.textContent);
  const listeners = [];  // called with the time, s
  const graphs = [];     // of the histories
  let time = run.start;
  const end = run.start + run.interval * (run.rows - 1);

  function showTime(t) {
    time = Math.min(Math.max(t, run.start), end);
    for (const each of listeners) each(time);
  }

  // ---------------------------------------------------------------------------------------- drawing

  // Every shape: points at rest, the way that each goes per unit of exaggeration, and the motions that displace it,
  // [index of the motion, x, y] for each.
  function readShapes(svg) {
    const pairs = (text) => text.trim().split(/\s+/).map((pair) => pair.split(",").map(Number));
    return [...svg.querySelectorAll("polygon, polyline")].map((element) => {
      const rest = pairs(element.getAttribute("points"));
      const still = rest.map(() => [0, 0]);
      const spread = element.dataset.spread ? pairs(element.dataset.spread) : still;
      const move = element.dataset.move
        ? element.dataset.move.split(" ").map((point) => point === "-" ? [] : point.split("+").map((term) => term.split(/[:,]/).map(Number)))
        : rest.map(() => []);
      return { element, rest, spread, move, name: element.dataset.name, isOrbit: element.classList.contains("orbit"), isGap: element.classList.contains("gap") };
    });
  }

  function valueAt(motion, row) {
    const values = run.motions[motion];
    if (!values) return 0;
    const before = Math.min(Math.floor(row), values.length - 1), after = Math.min(before + 1, values.length - 1);
    return values[before] + (row - before) * (values[after] - values[before]);
  }

  // The place of point i of a shape at a row of the histories, with displacements `factor` times larger.
  function place(shape, i, row, factor) {
    let x = shape.rest[i][0] + (factor - 1) * shape.spread[i][0], y = shape.rest[i][1] + (factor - 1) * shape.spread[i][1];
    for (const [motion, alongX, alongY] of shape.move[i]) {
      const value = factor * valueAt(motion, row);
      x += alongX * value;
      y += alongY * value;
    }
    return [x, y];
  }

  const text = (points) => points.map(([x, y]) => x.toFixed(4) + "," + y.toFixed(4)).join(" ");

  function fitView(svg, shapes, factor) {
    const largest = run.motions.map((values) => values ? values.reduce((most, value) => Math.max(most, Math.abs(value)), 0) : 0);
    let low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    for (const shape of shapes) {
      shape.rest.forEach((rest, i) => {
        for (const axis of [0, 1]) {
          const centre = rest[axis] + (factor - 1) * shape.spread[i][axis];
          const reach = shape.move[i].reduce((sum, term) => sum + Math.abs(term[1 + axis]) * factor * largest[term[0]], 0);
          low[axis] = Math.min(low[axis], centre - reach);
          high[axis] = Math.max(high[axis], centre + reach);
        }
      });
    }
    const border = 0.03 * Math.max(high[0] - low[0], high[1] - low[1]);
    svg.setAttribute("viewBox", [low[0] - border, low[1] - border, high[0] - low[0] + 2 * border, high[1] - low[1] + 2 * border].join(" "));
  }

  function startDrawing(figure) {
    const svg = figure.querySelector("svg"), shapes = readShapes(svg);
    const controls = figure.querySelector(".controls"), caption = figure.querySelector("figcaption");
    const control = (name) => controls.querySelector("[name=" + name + "]");
    const scrub = control("time"), clock = controls.querySelector("output");
    let factor = Number(control("exaggeration").value), playing = false, stoppedAt = null;

    function drawOrbits() {
      const stride = Math.max(1, Math.floor(run.rows / 3000));
      for (const shape of shapes) {
        if (!shape.isOrbit) continue;
        const points = [];
        for (let row = 0; row < run.rows; row += stride) points.push(place(shape, 0, row, factor));
        shape.element.setAttribute("points", text(points));
      }
      if (shapes.some((shape) => shape.isOrbit)) drawImpacts();
    }
    // A dot with its time on the orbit where each impact began.
    function drawImpacts() {
      svg.querySelectorAll("circle, text").forEach((each) => each.remove());
      const box = svg.viewBox.baseVal, size = 0.026 * box.width;
      for (const impact of run.impacts) {
        const gap = shapes.find((shape) => shape.isGap && shape.name === impact.where);
        if (!gap) continue;
        const [x, y] = place(gap, 0, (impact.start - run.start) / run.interval, factor);
        const add = (name, attributes) => {
          const element = document.createElementNS(svg.namespaceURI, name);
          for (const each in attributes) element.setAttribute(each, attributes[each]);
          return svg.appendChild(element);
        };
        const inwards = x > box.x + 0.5 * box.width ? -0.3 * size : 0.3 * size;
        add("circle", { cx: x, cy: y, r: 0.2 * size });
        add("text", { x: x + inwards, y: y - 0.3 * size, "font-size": size, "text-anchor": inwards < 0 ? "end" : "start" })
          .textContent = impact.start.toFixed(2) + " s";
      }
    }
    function setFactor(value) {
      factor = value;
      fitView(svg, shapes, factor);
      drawOrbits();
      caption.textContent = factor === 1 ? caption.dataset.trueScale : caption.dataset.exaggerated.replace("{}", factor);
      draw(time);
    }
    function draw(t) {
      const row = (t - run.start) / run.interval;
      const hit = new Set(run.impacts.filter((each) => each.start <= t && t <= each.end).map((each) => each.where));
      for (const shape of shapes) {
        shape.element.classList.toggle("hit", shape.isGap && hit.has(shape.name));
        if (!shape.isOrbit && (shape.element.dataset.move || shape.element.dataset.spread))
          shape.element.setAttribute("points", text(shape.rest.map((_, i) => place(shape, i, row, factor))));
      }
      scrub.value = t;
      clock.value = t.toFixed(3) + " s";
    }
    function play(on) {
      playing = on;
      control("play").textContent = on ? "Pause" : "Play";
      if (!on) return;
      if (time >= end) showTime(run.start);
      let last = null;
      requestAnimationFrame(function frame(now) {
        if (!playing) return;
        const passed = last === null ? 0 : Math.min((now - last) / 1000, 0.1) * Number(control("speed").value);
        last = now;
        const next = run.impacts.find((each) => each.start > time && each.start <= time + passed && each.start !== stoppedAt);
        if (next && control("stop").checked) {
          stoppedAt = next.start;
          showTime(next.start);
          play(false);
          return;
        }
        showTime(time + passed);
        if (time >= end) play(false); else requestAnimationFrame(frame);
      });
    }
    control("play").addEventListener("click", () => play(!playing));
    scrub.min = run.start;
    scrub.max = end;
    scrub.step = run.interval;
    scrub.addEventListener("input", () => { play(false); stoppedAt = null; showTime(Number(scrub.value)); });
    control("exaggeration").addEventListener("change", (event) => setFactor(Number(event.target.value)));
    control("next").disabled = run.impacts.length === 0;
    control("next").addEventListener("click", () => {
      play(false);
      const next = run.impacts.find((each) => each.start > time) || run.impacts[0];
      stoppedAt = next.start;
      showTime(next.start);
    });
    controls.hidden = false;
    listeners.push(draw);
    setFactor(factor);
  }

  // -------------------------------------------------------------------------------------- histories

  function startHistories() {
    if (typeof Dygraph === "undefined") return;
    const style = getComputedStyle(document.documentElement);
    const colour = (name) => style.getPropertyValue(name).trim();
    // Dygraphs reads titles of axes as HTML.
    const html = (text) => text.replace(/[&<>"']/g, (letter) => "&#" + letter.charCodeAt(0) + ";");

    let synchronising = false;
    function zoomAll(range) {
      if (synchronising) return;
      synchronising = true;
      for (const graph of graphs) graph.updateOptions({ dateWindow: range });
      synchronising = false;
    }
    document.querySelectorAll("figure[data-history]").forEach((figure) => {
      const chart = run.charts[Number(figure.dataset.history)];
      const box = document.createElement("div"), plot = document.createElement("div"), legend = document.createElement("div");
      box.className = "history";
      plot.className = "plot";
      plot.setAttribute("role", "img");
      plot.setAttribute("aria-label", chart.title + ": " + chart.label + " over time of " + chart.series.map((series) => series.name).join(", "));
      legend.className = "legend";
      const heading = document.createElement("h3");
      heading.textContent = chart.title;
      box.append(heading, legend, plot);
      figure.replaceWith(box);
      const rows = Array.from({ length: run.rows }, (_, row) =>
        [run.start + row * run.interval, ...chart.series.map((series) => series.values[row])]);
      const inTwoUnits = (value) =>
        Number(value.toPrecision(4)) + " (" + Number((chart.second.factor * value).toPrecision(3)) + " " + chart.second.symbol + ")";
      graphs.push(new Dygraph(plot, rows, {
        labels: ["time [s]", ...chart.series.map((series) => series.name)],
        colors: chart.series.map((series) => series.colour === "#000000" ? colour("--ink") : series.colour),
        labelsDiv: legend, legend: "always", ylabel: html(chart.label), xlabel: "time [s]",
        gridLineColor: colour("--line"), axisLineColor: colour("--soft-ink"), strokeWidth: 1.3, axisLabelWidth: 62,
        digitsAfterDecimal: 4, animatedZooms: false, axes: chart.second ? { y: { valueFormatter: inTwoUnits } } : {},
        zoomCallback: (from, to) => zoomAll([from, to]),
      }));
    });
    // Long quiet parts of a record would squeeze the motion: the page begins with the part where a curve exceeds 5 % of
    // its largest value.
    const times = (row) => run.start + row * run.interval;
    let first = run.rows, last = 0;
    for (const chart of run.charts)
      for (const series of chart.series) {
        const threshold = 0.05 * Math.max(...series.values.map(Math.abs));
        const moves = (value) => Math.abs(value) > threshold;
        const begin = series.values.findIndex(moves);
        if (begin < 0) continue;
        first = Math.min(first, begin);
        last = Math.max(last, series.values.length - 1 - [...series.values].reverse().findIndex(moves));
      }
    const margin = Math.ceil(0.1 * (last - first));
    if (last - first + 2 * margin < 0.6 * run.rows)
      zoomAll([times(Math.max(first - margin, 0)), times(Math.min(last + margin, run.rows - 1))]);
    // The values at the time of the drawing.
    listeners.push((t) => {
      const row = Math.round((t - run.start) / run.interval);
      for (const graph of graphs) graph.setSelection(row);
    });
    const reset = document.getElementById("whole-histories");
    if (reset) {
      reset.hidden = false;
      reset.addEventListener("click", () => zoomAll(null));
    }
  }

  const figure = document.querySelector("figure.drawing");
  if (figure) startDrawing(figure);
  startHistories();
  document.querySelectorAll("button.jump").forEach((button) => {
    button.hidden = !figure;
    button.addEventListener("click", () => {
      showTime(Number(button.dataset.time));
      figure.scrollIntoView({ behavior: "smooth", block: "center" });
    });
  });
  window.moatReport = { showTime, time: () => time, graphs };
})();
