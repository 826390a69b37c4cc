"use strict";
// Draws the report. What went wrong, and which plots were drawn, stands in data attributes of the
// body and the canvases, for tests.
document.body.dataset.errors = "0";
window.onerror = () => { document.body.dataset.errors = String(Number(document.body.dataset.errors) + 1); };

const data = JSON.parse(document.getElementById("data").textContent);

// Okabe and Ito's palette (2008), and a shape of its own for each.
const looks = {
  "none": ["#999999", "crossRot"], "depth-map": ["#0072B2", "circle"], "object-id": ["#56B4E9", "rect"],
  "auto": ["#F0E442", "circle"], "shadow-texture": ["#009E73", "rectRot"], "planar": ["#E69F00", "triangle"],
  "stencil-volume": ["#D55E00", "star"], "ray-cast": ["#000000", "cross"], "vtk-shadow-map": ["#CC79A7", "rectRounded"],
};
const lookOf = technique => looks[technique] || ["#555555", "circle"];
const labelOf = technique => technique === "vtk-shadow-map" ? "VTK's vtkShadowMapPass"
  : technique === "none" ? "no shadows" : technique;

const charts = [];

function element(tag, parent, text, attributes) {
  const made = document.createElement(tag);
  if (text !== undefined) made.textContent = text;
  Object.assign(made, attributes || {});
  parent.appendChild(made);
  return made;
}

function number(value, digits) {
  return value === null || value === undefined ? "" : Number(value).toPrecision(digits || 3);
}

// Plain numbers at the decades and, on short axes, between them.
function tickText(value, index, ticks) {
  const lead = value / Math.pow(10, Math.floor(Math.log10(value) + 1e-9));
  const shown = ticks.length < 14 ? [1, 2, 3, 5] : ticks.length < 28 ? [1, 2, 5] : [1];
  return shown.some(each => Math.abs(lead - each) < 1e-6) ? String(Number(value.toPrecision(3))) : "";
}

function logAxis(title, low, high) {
  return { type: "logarithmic", min: low, max: high, title: { display: true, text: title, font: { size: 14 } },
    ticks: { callback: tickText, autoSkip: false, maxRotation: 0, font: { size: 12 } }, grid: { color: "#ececec" } };
}

function range(values, margin) {
  const low = Math.min(...values), high = Math.max(...values);
  return [low / margin, high * margin];
}

function draw(parent, title, datasets, x, y) {
  const box = element("div", parent, undefined, { className: "plot" });
  const canvas = element("canvas", box);
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", title);
  const chart = new Chart(canvas, {
    type: "scatter", data: { datasets },
    options: {
      animation: false, maintainAspectRatio: false, scales: { x, y },
      plugins: {
        title: { display: true, text: title, font: { size: 15 } },
        legend: { position: "bottom", labels: { usePointStyle: true, font: { size: 12 }, padding: 14 } },
        tooltip: { callbacks: { label: item => item.raw.label || item.dataset.label } },
      },
    },
  });
  charts.push(chart);
  noteInk(canvas);
}

// How many pixels of the plot are not blank.
function noteInk(canvas) {
  const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  let ink = 0;
  for (let i = 3; i < pixels.length; i += 4) ink += pixels[i] > 0 ? 1 : 0;
  canvas.dataset.ink = String(ink);
  document.body.dataset.plots = String(document.querySelectorAll("canvas[data-ink]").length);
}

// --- Error against time ---------------------------------------------------------------------------

// A row's error is that of its worst light.
function worstOf(row, measure) {
  return Math.max(...row.errors.map(error => error[measure]));
}

function frontOf(points) {
  const front = [];
  for (const point of [...points].sort((a, b) => a.x - b.x || a.y - b.y)) {
    if (!front.length || point.y < front[front.length - 1].y) front.push(point);
  }
  return front;
}

function pointsOf(rows, measure, time, floor) {
  return rows.map(row => {
    const error = worstOf(row, measure);
    return { x: row["ratio_" + time], y: Math.max(error, floor), technique: row.technique,
      label: `${row.setting}: ${number(row["ratio_" + time])} times, ${number(row["frame_ms_" + time])} ms \u00b1 ${number(row["spread_ms_" + time], 2)}, ` +
        `error ${number(error)}` };
  });
}

function drawScene(parent, rows, soft, time) {
  const measure = soft ? "mean_absolute_difference" : document.getElementById("error").value;
  const pixels = Math.max(...rows.map(row => Math.max(...row.errors.map(error => error.receiver_pixels))));
  const floor = soft ? 1e-5 : 50 / Math.max(pixels, 1);
  const points = pointsOf(rows, measure, time, floor);
  const [left, right] = range([...points.map(p => p.x), 1], 1.15);
  const [low, high] = range(points.map(p => p.y), 1.5);
  const datasets = [];
  for (const technique of Object.keys(looks)) {
    const own = points.filter(p => p.technique === technique);
    const [color, shape] = lookOf(technique);
    if (own.length) {
      datasets.push({ label: labelOf(technique), data: own, pointStyle: shape, pointRadius: 6, pointHoverRadius: 8,
        borderColor: color, backgroundColor: color + "b0", borderWidth: 2 });
    }
  }
  datasets.push({ label: "Pareto front", data: frontOf(points.filter(p => p.technique !== "none")), showLine: true,
    pointRadius: 0, borderColor: "#444", borderWidth: 1.5, pointStyle: "line", order: 10 });
  const unshadowed = rows.map(row => row.frame_ms_unshadowed).sort((a, b) => a - b)[Math.floor(rows.length / 2)];
  datasets.push({ label: "frame without shadows", data: [{ x: 1, y: low }, { x: 1, y: high }],
    showLine: true, pointRadius: 0, borderColor: "#888", borderDash: [5, 4], borderWidth: 1.5, pointStyle: "line", order: 11 });
  const what = soft ? "mean absolute difference of visibility (0 to 1)"
    : (measure === "gross_percent" ? "gross error" : "mismatch") + ", % of receiver pixels";
  draw(parent, soft ? "Soft shadows" : "Hard shadows", datasets,
    logAxis(`frame time over that without shadows (${number(unshadowed)} ms), the light ` +
      (time === "moving" ? "moving" : "still"), left, right),
    logAxis(what, low, high));
  if (points.every(p => p.y > floor)) return;
  element("p", parent, soft ? "Differences below 0.00001 are drawn at it."
    : `Settings without a wrong pixel are drawn at half a pixel, ${number(floor)} %.`, { className: "quiet" });
}

function describe(scene) {
  const lights = (scene.lights || []).map(light => light.kind).join(", ");
  const facts = (scene.facts || []).map(fact => `${fact.what}: ${number(fact.value, 4)} ${fact.unit}`.trim());
  const impostors = scene.impostors ? `, ${scene.impostors} impostors` : "";
  return `${scene.triangles.toLocaleString("en")} triangles${impostors}` + (lights ? `; lights: ${lights}` : "") +
    (facts.length ? `; ${facts.join("; ")}` : "") + ".";
}

function drawScenes() {
  const place = document.getElementById("scenes");
  place.replaceChildren();
  charts.splice(0).forEach(chart => chart.destroy());
  const time = document.getElementById("time").value;
  for (const scene of data.scenes) {
    const rows = data.rows.filter(row => row.scene === scene.name && row.axis === null && !row.failure &&
      row.errors.length);
    element("h2", place, scene.name);
    const box = element("div", place, undefined, { className: "scene" });
    const left = element("div", box);
    const image = data.pictures["scene-" + scene.name + ".png"];
    if (image) element("img", left, undefined, { src: image, alt: "the scene " + scene.name + " by ray cast" });
    element("p", left, scene.description + ". " + describe(scene));
    (scene.notes || []).forEach(note => element("p", left, "Note: " + note + ".", { className: "quiet" }));
    const right = element("div", box);
    for (const soft of [false, true]) {
      const some = rows.filter(row => row.soft === soft);
      if (some.length) drawScene(right, some, soft, time);
    }
    if (!rows.length) element("p", right, "No errors were measured here.", { className: "quiet" });
  }
}

// --- Sweeps ---------------------------------------------------------------------------------------

const axisTitles = { triangles: "triangles of the crowd", lights: "lights over the still life",
  pixels: "pixels of the window", samples: "sample lights of a soft light" };

function drawSweeps() {
  const place = document.getElementById("sweeps");
  const axes = Object.keys(axisTitles).filter(axis => data.rows.some(row => row.axis === axis && !row.failure));
  if (!axes.length) return;
  element("h2", place, "What it costs");
  element("p", place, "The cost of shadows is the frame with them, its light moving, less the frame without them. The lines are " +
    "fits cost = factor \u00d7 value to the power of an exponent, by least squares of the logarithms; 1 is linear. What costs less " +
    "than the noise is left out.");
  const half = element("div", place, undefined, { className: "half" });
  for (const axis of axes) {
    const datasets = [], xs = [], ys = [];
    for (const fit of data.fits.filter(each => each.axis === axis)) {
      const rows = data.rows.filter(row => row.axis === axis && !row.failure && row.cost_ms_moving > 0 &&
        (axis === "samples" ? row.setting.startsWith(fit.setting + "/") : row.setting === fit.setting));
      if (!rows.length) continue;
      const [color, shape] = lookOf(rows[0].technique);
      const dash = fit.setting.includes("exact") ? [6, 3] : [];
      const points = rows.map(row => ({ x: row.value, y: row.cost_ms_moving,
        label: `${row.setting}, ${row.value}: ${number(row.cost_ms_moving)} ms` }));
      points.forEach(p => { xs.push(p.x); ys.push(p.y); });
      const error = fit.exponent_error === null ? "" : ` \u00b1 ${number(fit.exponent_error, 1)}`;
      const exponent = fit.exponent === null ? "" : `: exponent ${fit.exponent.toFixed(2)}${error}`;
      datasets.push({ label: labelOf(fit.setting).replace("vtk-shadow-map", "VTK's") + exponent, data: points, pointStyle: shape,
        pointRadius: 6, borderColor: color, backgroundColor: color + "b0", borderWidth: 2 });
      if (fit.exponent !== null) {
        const ends = [Math.min(...points.map(p => p.x)), Math.max(...points.map(p => p.x))];
        datasets.push({ label: "", data: ends.map(x => ({ x, y: fit.factor_ms * Math.pow(x, fit.exponent) })), showLine: true,
          pointRadius: 0, borderColor: color, borderDash: dash, borderWidth: 1.3, order: 10 });
      }
    }
    if (!xs.length) continue;
    Chart.defaults.plugins.legend.labels.filter = item => item.text !== "";
    draw(half, "Cost against " + axis, datasets, logAxis(axisTitles[axis], ...range(xs, 1.3)),
      logAxis("milliseconds over the frame without shadows", ...range(ys, 1.5)));
  }
}

// --- The extremes ---------------------------------------------------------------------------------

// How much a technique keeps of its picture where the scene should look the same; else how much of
// what it shows is grossly wrong.
function gradeOf(figures) {
  if (!figures.drawn || figures.opengl_error) return "fails";
  if (figures.looks_plain) {
    return figures.alike_percent >= 99.99 ? "keeps" : figures.alike_percent >= 99 ? "drifts" : "fails";
  }
  const gross = figures.receivers ? 100 * figures.gross / figures.receivers : 0;
  return gross <= data.limits.gross_percent ? "keeps" : gross <= 1 ? "drifts" : "fails";
}

const gradeColors = { keeps: "", drifts: "#fbe3a6", fails: "#f3b3a0" };

function extremeCell(figures) {
  if (!figures.drawn) return "none";
  if (figures.opengl_error) return "OpenGL error";
  const alike = figures.looks_plain ? `${figures.alike_percent.toFixed(3)} / ` : "";
  return figures.receivers ? `${alike}${figures.mismatch_percent.toFixed(3)} / ${figures.gross}` : alike ? alike.slice(0, -3) : "drawn";
}

function drawExtremes() {
  const all = data.extremes || [];
  if (!all.length) return;
  const place = document.getElementById("extremes");
  element("h2", place, "The extremes");
  element("p", place, "One still life under a spotlight, and what can be done to it that tries the numbers that shadows are made " +
    "of. A cell has the share of pixels that are alike in the technique's own picture of the plain still life, where the case looks " +
    "the same, then mismatch in percent and gross pixels against the truth of the case. planar and shadow-texture leave out the " +
    "self-shadows of the still life, which is gross error in each case. Cases in grey are beyond what floats, VTK or a " +
    "technique can; where VTK's own frame without shadows is unlike by more than 0.01 %, VTK fails first.");
  const key = element("p", place);
  for (const [grade, text] of [["drifts", "alike below 99.99 %, or some gross error"],
    ["fails", "alike below 99 %, more than 1 % gross, or not drawn"]]) {
    element("span", key, undefined, { className: "key" }).style.background = gradeColors[grade];
    element("span", key, text + "\u2003");
  }
  const techniques = [...new Set(all.map(each => each.technique))];
  for (const looksPlain of [true, false]) {
    const some = all.filter(each => each.looks_plain === looksPlain);
    if (!some.length) continue;
    element("h3", place, looksPlain ? "Cases that look as the plain still life does" : "Cases that look otherwise");
    const table = element("table", element("div", place, undefined, { className: "wide" }), undefined, { className: "extremes" });
    const head = element("tr", element("thead", table));
    ["case", ...(looksPlain ? ["VTK's frame, unlike %"] : []), ...techniques].forEach(text => element("th", head, text));
    const body = element("tbody", table);
    for (const name of new Set(some.map(each => each.case))) {
      const own = some.filter(each => each.case === name);
      const line = element("tr", body, undefined, { className: own[0].beyond ? "beyond" : "" });
      element("td", line, name);
      if (looksPlain) {
        const unlike = own[0].frame_unlike_percent;
        const cell = element("td", line, unlike === null ? "" : unlike.toFixed(3));
        if (unlike > 0.01) cell.style.background = gradeColors.drifts;
      }
      for (const technique of techniques) {
        const figures = own.find(each => each.technique === technique);
        const cell = element("td", line, figures ? extremeCell(figures) : "");
        if (figures) {
          cell.style.background = gradeColors[gradeOf(figures)];
          cell.title = figures.messages.join("\n");
        }
      }
    }
  }
  place.dataset.cases = String(new Set(all.map(each => each.case)).size);
}

// --- Worst errors, and the table ------------------------------------------------------------------

function drawWorst() {
  const shown = data.worst.filter(each => data.pictures[each.error.picture]);
  if (!shown.length) return;
  const place = document.getElementById("worst");
  element("h2", place, "Each technique where it is most wrong");
  const key = element("p", place);
  for (const [color, text] of [["#e69f00", "false shadow near an edge"], ["#c80000", "gross false shadow"],
    ["#56b4e9", "missed shadow near an edge"], ["#0000dc", "gross missed shadow"], ["#e1e1e1", "right, lit"],
    ["#5f5f5f", "right, in shadow"], ["#a0a0a0", "not measured"]]) {
    element("span", key, undefined, { className: "key" }).style.background = color;
    element("span", key, text + "\u2003");
  }
  const grid = element("div", place, undefined, { className: "worst" });
  for (const each of shown) {
    const figure = element("figure", grid);
    element("img", figure, undefined, { src: data.pictures[each.error.picture], alt: "error map" });
    element("figcaption", figure, `${each.setting} on ${each.scene}, light ${each.error.light}: mismatch ` +
      `${number(each.error.mismatch_percent)} %, gross ${number(each.error.gross_percent)} %` +
      (each.soft ? `, mean absolute difference ${number(each.error.mean_absolute_difference)}` : ""));
  }
}

const columns = [["scene", r => r.scene], ["setting", r => r.setting + (r.axis ? ` (${r.axis} ${r.value})` : "")],
  ["mismatch %", r => r.errors && r.errors.length ? number(worstOf(r, "mismatch_percent")) : ""],
  ["gross %", r => r.errors && r.errors.length ? number(worstOf(r, "gross_percent")) : ""],
  ["mean abs. diff.", r => r.errors && r.errors.length ? number(worstOf(r, "mean_absolute_difference")) : ""],
  ["still, ms", r => number(r.frame_ms_static)], ["\u00b1", r => number(r.spread_ms_static, 2)],
  ["ratio", r => number(r.ratio_static)], ["moving, ms", r => number(r.frame_ms_moving)],
  ["\u00b1", r => number(r.spread_ms_moving, 2)], ["ratio", r => number(r.ratio_moving)],
  ["textures, MB", r => r.texture_bytes === null ? "" : number((r.texture_bytes || 0) / 1e6)],
  ["casters, MB", r => r.caster_bytes === null ? "" : number((r.caster_bytes || 0) / 1e6)],
  ["failure", r => r.failure || ""]];

function drawTable() {
  const table = element("table", document.getElementById("table"));
  const head = element("tr", element("thead", table));
  columns.forEach(([title]) => element("th", head, title));
  const body = element("tbody", table);
  for (const row of data.rows) {
    const line = element("tr", body);
    columns.forEach(([, text]) => element("td", line, text(row)));
  }
}

Chart.defaults.devicePixelRatio = 2;
document.getElementById("machine").textContent = `vtkshadows ${data.machine.vtkshadows}, VTK ${data.machine.vtk}, ` +
  `${data.machine.renderer}, ${data.machine.cores} cores; ${data.plan}; ${data.rows.length} runs.`;
drawScenes();
drawSweeps();
drawWorst();
drawExtremes();
drawTable();
for (const id of ["time", "error"]) document.getElementById(id).onchange = drawScenes;
document.body.dataset.done = "1";
