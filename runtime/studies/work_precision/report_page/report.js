const data = JSON.parse(document.getElementById("data").textContent), $ = (selector) => document.querySelector(selector);
const state = { tolerance: data.tolerance, price: "seconds", hidden: new Set(), sort: "cost", down: false, box: null };
for (const [k, method] of data.methods.entries()) {
  method.colour = data.colours[k % data.colours.length];
  method.good = method.trials.filter((trial) => !trial.failure && trial.error !== null && trial.seconds > 0);
  method.bad = method.trials.filter((trial) => trial.failure && trial.seconds > 0);
}

// Cost to a tolerance on the last stretch of the curve below it: a lucky point does not win.
function cost(method, tolerance, price) {
  const inside = method.good.findIndex((_, k) => method.good.slice(k).every((trial) => trial.error <= tolerance));
  if (inside < 0) return null;
  const trial = method.good[inside], above = method.good[inside - 1];
  if (!above || !(above.error > tolerance)) return { value: trial[price], trial };
  const share = Math.log(above.error / tolerance) / Math.log(above.error / Math.max(trial.error, 1e-300));
  return { value: Math.exp((1 - share) * Math.log(above[price]) + share * Math.log(trial[price])), trial };
}

const raised = (text) => String(text).replace(/[-0-9]/g, (c) => "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"["-0123456789".indexOf(c)]);
function power(value) {
  const exponent = Math.floor(Math.log10(value) + 1e-9), front = value / 10 ** exponent;
  return (Math.abs(front - 1) < 0.02 ? "" : `${front.toPrecision(2)}\u00b7`) + `10${raised(exponent)}`;
}
function worded(value, price) {
  if (value === null || value === undefined) return "\u2013";
  if (price === "evaluations") return value >= 1e4 ? `${(value / 1e3).toPrecision(3)} k` : value.toPrecision(3).replace(/\.0+$/, "");
  for (const [factor, unit] of [[1, "s"], [1e3, "ms"], [1e6, "\u00b5s"]]) if (value * factor >= 1 || unit === "\u00b5s") return `${Number((value * factor).toPrecision(3))} ${unit}`;
}
const times = (ratio) => (ratio >= 9.95 ? ratio.toFixed(0) : ratio.toFixed(1));
const element = (name, attributes, parent, text) => {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  parent.append(made);
  return made;
};

function ranking() {
  const rows = data.methods.map((method) => ({ method, cost: cost(method, state.tolerance, state.price) }));
  return rows.sort((a, b) => (a.cost ? a.cost.value : Infinity) - (b.cost ? b.cost.value : Infinity));
}

function verdict(rows) {
  const place = $("#verdict"), use = $("#use"), [first] = rows;
  place.textContent = use.textContent = "";
  if (!first || !first.cost) {
    place.textContent = `No method reached an error of ${power(state.tolerance)} in the time allowed.`;
    return;
  }
  const strong = document.createElement("b"), what = state.price === "seconds" ? "" : " evaluations";
  strong.textContent = first.method.method;
  strong.style.color = first.method.colour;
  const other = rows.find((row) => row.cost && row.method.sub_steps !== first.method.sub_steps);
  const kind = first.method.sub_steps ? "the best with one step for all" : "the best with sub-steps";
  const then = other ? `, ${times(other.cost.value / first.cost.value)} times as fast as ${other.method.method}, ${kind}` : first.method.sub_steps ? "; no method with one step for all reached it" : "";
  place.append(strong, ` is fastest to an error of ${power(state.tolerance)}: ${worded(first.cost.value, state.price)}${what} for ${Number(data.t_end.toPrecision(3))} s of motion${then}.`);
  if (first.method.command) {
    const code = document.createElement("code");
    code.textContent = `${first.method.command} --dt ${Number(first.cost.trial.dt_or_rtol.toPrecision(3))}`;
    use.append("Use it: ", code);
  }
}

const left = 74, right = 640, top_ = 12, bottom = 470;
function limits() {
  if (state.box) return state.box;
  const points = data.methods.filter((m) => !state.hidden.has(m)).flatMap((m) => m.good), all = data.methods.filter((m) => !state.hidden.has(m)).flatMap((m) => m.trials.filter((t) => t.seconds > 0));
  const errors = points.map((trial) => Math.min(Math.max(trial.error, 1e-16), 10)), costs = (all.length ? all : [{ seconds: 1e-6, evaluations: 1 }]).map((trial) => trial[state.price]);
  const [low, high] = errors.length ? [Math.min(...errors), Math.max(...errors)] : [1e-6, 1];
  return { x: [Math.log10(Math.min(...costs)) - 0.1, Math.log10(Math.max(...costs)) + 0.1], y: [Math.log10(Math.min(low, state.tolerance)) - 0.2, Math.log10(Math.max(high, state.tolerance)) + 0.2] };
}

function plot(rows) {
  const svg = $("#plot"), { x, y } = limits(), costName = state.price;
  svg.textContent = "";
  const X = (value) => left + (Math.log10(value) - x[0]) / (x[1] - x[0]) * (right - left), Y = (value) => bottom - (Math.log10(value) - y[0]) / (y[1] - y[0]) * (bottom - top_);
  const clip = element("clipPath", { id: "inside" }, svg);
  element("rect", { x: left - 7, y: top_ - 7, width: right - left + 14, height: bottom - top_ + 14 }, clip);
  for (let k = Math.ceil(x[0]); k <= x[1]; k++) {
    element("line", { class: "grid", x1: X(10 ** k), x2: X(10 ** k), y1: top_, y2: bottom }, svg);
    element("text", { x: X(10 ** k), y: bottom + 17, "text-anchor": "middle" }, svg, costName === "seconds" ? worded(10 ** k, costName) : power(10 ** k));
  }
  for (let k = Math.ceil(y[0]); k <= y[1]; k++) {
    element("line", { class: "grid", x1: left, x2: right, y1: Y(10 ** k), y2: Y(10 ** k) }, svg);
    element("text", { x: left - 8, y: Y(10 ** k) + 4, "text-anchor": "end" }, svg, `10${raised(k)}`);
  }
  element("text", { x: (left + right) / 2, y: 533, "text-anchor": "middle" }, svg, costName === "seconds" ? "CPU time of the motion, one thread (left is faster)" : "evaluations of M_hat and Q_hat, sub-steps included (left is fewer)");
  element("text", { x: 14, y: (top_ + bottom) / 2, "text-anchor": "middle", transform: `rotate(-90 14 ${(top_ + bottom) / 2})` }, svg, "error / amplitude (down is more accurate)");
  element("line", { x1: left, x2: right, y1: Y(state.tolerance), y2: Y(state.tolerance), stroke: "#374151", "stroke-dasharray": "5 4" }, svg);
  element("text", { x: left + 6, y: Y(state.tolerance) - 5 }, svg, `tolerance ${power(state.tolerance)}`);
  const curves = element("g", { "clip-path": "url(#inside)" }, svg), ends = [];
  let failed = 0;
  for (const method of data.methods) {
    if (state.hidden.has(method) || !method.trials.length) continue;
    const group = element("g", { "data-method": method.method }, curves), adaptive = method.kind === "adaptive", dash = adaptive ? "2 3" : method.kind === "one" ? "6 4" : "none";
    const at = method.good.map((trial) => [X(trial[costName]), Y(Math.min(Math.max(trial.error, 1e-16), 10)), trial]);
    element("polyline", { points: at.map(([u, v]) => `${u},${v}`).join(" "), fill: "none", stroke: method.colour, "stroke-width": rows[0].method === method ? 2.8 : 1.6, "stroke-dasharray": dash }, group);
    for (const [u, v, trial] of at) {
      const style = { fill: method.kind === "sub" ? method.colour : "#fff", stroke: method.colour, "stroke-width": 1.6 };
      const mark = adaptive ? element("path", { d: `M${u} ${v - 5}L${u + 5} ${v}L${u} ${v + 5}L${u - 5} ${v}Z`, ...style }, group) : element("circle", { cx: u, cy: v, r: 4.2, ...style }, group);
      hover(mark, method, trial);
    }
    const seen = at.filter(([u, v]) => u >= left - 5 && u <= right + 5 && v >= top_ - 5 && v <= bottom + 5);
    if (seen.length) ends.push([...seen[seen.length - 1].slice(0, 2), method]);
    for (const trial of method.bad) {
      const u = X(trial[costName]), v = bottom + 27 + 8 * (failed % 3);
      if (u < left || u > right) continue;
      const cross = element("path", { d: `M${u - 3} ${v - 3}l6 6m0 -6l-6 6`, stroke: method.colour, "stroke-width": 1.5 }, svg);
      hover(cross, method, trial);
    }
    failed += method.bad.length > 0;
  }
  // Names at the ends, moved apart so that none covers another.
  ends.sort((a, b) => b[1] - a[1]);
  ends.forEach((end, k) => {
    for (const other of ends.slice(0, k)) if (Math.abs(other[0] - end[0]) < 115 && end[1] > other[1] - 14) end[1] = other[1] - 14;
  });
  for (const [u, v, method] of ends) element("text", { class: "name", x: u + 9, y: v + 4, style: `fill:${method.colour}` }, svg, method.method);
  if (rows[0] && rows[0].cost && !state.hidden.has(rows[0].method)) element("circle", { cx: X(rows[0].cost.value), cy: Y(state.tolerance), r: 9, fill: "none", stroke: "#111827", "stroke-width": 1.8 }, svg);
  svg.scaleBack = (px, py) => [x[0] + (px - left) / (right - left) * (x[1] - x[0]), y[0] + (bottom - py) / (bottom - top_) * (y[1] - y[0])];
}

function hover(mark, method, trial) {
  mark.addEventListener("mousemove", (event) => {
    const tip = $("#tip");
    tip.hidden = false;
    tip.style.left = `${Math.min(event.clientX + 14, window.innerWidth - 250)}px`;
    tip.style.top = `${event.clientY + 12}px`;
    const name = method.kind === "adaptive" ? "relative tolerance" : "step";
    tip.textContent = [method.method, `${name} ${Number(trial.dt_or_rtol.toPrecision(4))}${method.kind === "adaptive" ? "" : " s"}, ${trial.steps} steps`, trial.failure ? `FAILED: ${trial.failure}` : `error ${power(trial.error)}, at the end ${trial.end_error > 0 ? power(trial.end_error) : "0"}`, `${worded(trial.seconds, "seconds")}, ${trial.evaluations} evaluations`].join("\n");
    for (const group of document.querySelectorAll("#plot g[data-method]")) group.style.opacity = group.dataset.method === method.method ? 1 : 0.2;
  });
  mark.addEventListener("mouseleave", () => {
    $("#tip").hidden = true;
    for (const group of document.querySelectorAll("#plot g[data-method]")) group.style.opacity = 1;
  });
}

const columns = { method: "method", cost: "to tolerance", ratio: "ratio", order: "order", finest: "finest error" };
function table(rows) {
  const head = $("#methods thead tr"), body = $("#methods tbody"), best = rows[0] && rows[0].cost ? rows[0].cost.value : null;
  head.textContent = body.textContent = "";
  for (const [key, text] of Object.entries(columns)) {
    const cell = document.createElement("th");
    cell.textContent = (key === "cost" ? `to ${power(state.tolerance)}` : text) + (state.sort === key ? (state.down ? " \u25be" : " \u25b4") : "");
    cell.addEventListener("click", () => { state.down = state.sort === key && !state.down; state.sort = key; all(); });
    head.append(cell);
  }
  const finest = (row) => Math.min(...row.method.good.map((trial) => trial.error));
  const value = { method: (row) => row.method.method, cost: (row) => (row.cost ? row.cost.value : Infinity), ratio: (row) => (row.cost ? row.cost.value : Infinity), order: (row) => -(row.method.order || 0), finest };
  const order = [...rows].sort((a, b) => { const u = value[state.sort](a), v = value[state.sort](b); return (u < v ? -1 : u > v ? 1 : 0) * (state.down ? -1 : 1); });
  const worst = Math.max(...rows.filter((row) => row.cost).map((row) => row.cost.value), 1e-300);
  for (const row of order) {
    const line = document.createElement("tr"), failed = !row.method.good.length;
    line.classList.toggle("off", state.hidden.has(row.method));
    line.classList.toggle("first", row === rows[0] && row.cost !== null);
    line.classList.toggle("failed", failed);
    const name = document.createElement("td"), dot = document.createElement("span");
    dot.textContent = { sub: "\u25cf ", one: "\u25cb ", adaptive: "\u25c7 " }[row.method.kind];
    dot.style.color = row.method.colour;
    name.append(dot, row.method.method);
    line.append(name);
    if (failed) {
      const why = document.createElement("td");
      why.colSpan = 4;
      why.textContent = `failed: ${row.method.failure || "no run came to its end"}`;
      line.append(why);
    } else {
      const bar = document.createElement("span");
      bar.className = "bar";
      bar.style.width = row.cost ? `${Math.max(2, 44 * Math.log(row.cost.value / best + 0.02) / Math.log(worst / best + 1.02))}px` : "0";
      for (const text of [row.cost ? worded(row.cost.value, state.price) : "not reached", row.cost ? `${times(row.cost.value / best)}\u00d7` : "", row.method.order ? row.method.order.toFixed(2) : "\u2013", finest(row).toExponential(2)]) {
        const cell = document.createElement("td");
        cell.textContent = text;
        line.append(cell);
      }
      if (row.cost) line.children[2].prepend(bar);
    }
    line.addEventListener("click", () => { if (!state.hidden.delete(row.method)) state.hidden.add(row.method); all(); });
    body.append(line);
  }
}

function all() {
  const rows = ranking();
  verdict(rows);
  plot(rows);
  table(rows);
  $("#wanted").textContent = power(state.tolerance);
}

$("h1").textContent = data.title || data.model;
const slider = $("#tolerance"), every = data.methods.flatMap((method) => method.good.map((trial) => trial.error));
slider.min = Math.floor(Math.log10(Math.max(Math.min(...every, data.tolerance), 1e-12)));
slider.max = -1;
slider.value = Math.log10(data.tolerance);
slider.addEventListener("input", () => { state.tolerance = 10 ** Number(slider.value); all(); });
$("#price").addEventListener("change", () => { state.price = $("#price").value; state.box = null; all(); });

let from = null;
const svg = $("#plot"), local = (event) => { const box = svg.getBoundingClientRect(); return [(event.clientX - box.left) * 800 / box.width, (event.clientY - box.top) * 545 / box.height]; };
svg.addEventListener("mousedown", (event) => { from = local(event); event.preventDefault(); });
svg.addEventListener("mouseup", (event) => {
  if (!from) return;
  const to = local(event), [a, b] = [svg.scaleBack(...from), svg.scaleBack(...to)];
  if (Math.abs(to[0] - from[0]) > 12 && Math.abs(to[1] - from[1]) > 12) { state.box = { x: [Math.min(a[0], b[0]), Math.max(a[0], b[0])], y: [Math.min(a[1], b[1]), Math.max(a[1], b[1])] }; all(); }
  from = null;
});
svg.addEventListener("dblclick", () => { state.box = null; all(); });

for (const [name, text] of Object.entries(data.measured)) {
  for (const [tag, content] of [["dt", name], ["dd", text]]) { const made = document.createElement(tag); made.textContent = content; $("dl").append(made); }
}
const trials = $("#trials");
for (const cells of [["method", "step or tolerance", "steps", "CPU time", "evaluations", "error", "error at the end", "failure"], ...data.methods.flatMap((m) => m.trials.map((t) => [m.method, t.dt_or_rtol.toPrecision(4), t.steps, worded(t.seconds, "seconds"), t.evaluations, t.error === null ? "\u2013" : t.error.toExponential(2), t.end_error === null ? "\u2013" : t.end_error.toExponential(2), t.failure]))]) {
  const line = trials.insertRow();
  for (const text of cells) line.insertCell().textContent = text;
}
all();
