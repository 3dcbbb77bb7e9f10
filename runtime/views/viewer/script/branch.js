// A branch of motions that repeat: its picture, and the motion that the slider chooses.
const run = JSON.parse(document.getElementById("run").textContent);
const at = (id) => document.getElementById(id);
const digits = (value, count = 5) => Number(value.toPrecision(count)).toString();
const left = 70, right = 700, top = 20, bottom = 420; // of the picture
const motions = run.branches.flatMap((branch, which) => branch.motions.map((one) => ({ ...one, branch, which })));

function drawn(parent, kind, attributes, text) {
  const one = document.createElementNS("http://www.w3.org/2000/svg", kind);
  for (const key in attributes) one.setAttribute(key, attributes[key]);
  if (text !== undefined) one.textContent = text;
  parent.append(one);
  return one;
}

// Values of a row between two places, a little room at both ends.
function scale(values, from, to) {
  let low = Math.min(...values), high = Math.max(...values);
  const room = 0.04 * (high - low || Math.abs(high) || 1);
  low -= room;
  high += room;
  const place = (value) => from + ((value - low) / (high - low)) * (to - from);
  const rough = (high - low) / 6, unit = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * unit).find((k) => k >= rough), ticks = [];
  for (let k = Math.ceil(low / step); k * step <= high; k++) ticks.push(k * step);
  return { place, ticks };
}

function ticksOf(svg, x, y) {
  for (const value of x.ticks) {
    drawn(svg, "line", { x1: x.place(value), x2: x.place(value), y1: top, y2: bottom, stroke: "#eceef2" });
    drawn(svg, "text", { x: x.place(value), y: bottom + 16, "text-anchor": "middle" }, digits(value));
  }
  for (const value of y.ticks) {
    drawn(svg, "line", { x1: left, x2: right, y1: y.place(value), y2: y.place(value), stroke: "#eceef2" });
    drawn(svg, "text", { x: left - 6, y: y.place(value) + 4, "text-anchor": "end" }, digits(value));
  }
}

let marker = null, places = [];
function picture() {
  const svg = at("branch"), output = at("output").selectedIndex;
  svg.replaceChildren();
  const x = scale(motions.map((one) => one.value), left, right);
  const y = scale(motions.map((one) => one.largest[output]), bottom, top);
  ticksOf(svg, x, y);
  places = motions.map((one) => [x.place(one.value), y.place(one.largest[output])]);
  for (let k = 1; k < motions.length; k++) {
    if (motions[k].which !== motions[k - 1].which) continue;
    const unstable = motions[k - 1].stability === "unstable";
    drawn(svg, "line", {
      x1: places[k - 1][0], y1: places[k - 1][1], x2: places[k][0], y2: places[k][1], "stroke-width": 2,
      stroke: unstable ? "#9aa5b1" : "#1f4e79", ...(unstable ? { "stroke-dasharray": "5 4" } : {}),
    });
  }
  for (const special of run.specials) {
    const where = { x: x.place(special.value), y: y.place(special.largest[output]) };
    drawn(svg, "circle", { cx: where.x, cy: where.y, r: 4.5, fill: special.colour });
    drawn(svg, "text", { x: where.x + 7, y: where.y - 6 }, special.kind);
  }
  drawn(svg, "text", { x: (left + right) / 2, y: 452, "text-anchor": "middle" }, run.over);
  marker = drawn(svg, "circle", { r: 6, fill: "none", stroke: "#d55e00", "stroke-width": 2.5 });
}

const plots = run.outputs.map((output, k) => {
  const heading = document.createElement("h2"), holder = document.createElement("div");
  heading.textContent = output;
  at("curves").append(heading, holder);
  const axis = { grid: { stroke: "#eceef2" }, ticks: { size: 4 } };
  return new uPlot({
    width: 400, height: 150, cursor: { y: false }, legend: { show: false }, scales: { x: { time: false } },
    axes: [{ ...axis, size: 26 }, { ...axis, size: 62, values: (_, ticks) => ticks.map((value) => digits(value)) }],
    series: [{}, { stroke: run.colours[k % run.colours.length], width: 1.5 }],
  }, [[0, 1], [0, 0]], holder);
});

function show(k) {
  const one = motions[k];
  at("point").value = k;
  marker.setAttribute("cx", places[k][0]);
  marker.setAttribute("cy", places[k][1]);
  at("value").textContent = `${run.over} = ${digits(one.value, 7)}`;
  at("motion").textContent = `motion ${k + 1} of ${motions.length}: period ${digits(one.period, 8)} s, ${one.stability}`
    + `${one.kind ? ` (${one.kind})` : ""}${one.branch.doublings ? `, ${one.branch.doublings} doublings` : ""}`;
  plots.forEach((plot, n) => plot.setData([Array.from(decoded(one.t, Float32Array)), Array.from(decoded(one.curves[n], Float32Array))]));
  const svg = at("circle");
  svg.replaceChildren();
  drawn(svg, "circle", { r: 1, fill: "none", stroke: "#9aa5b1", "stroke-width": 0.03 });
  for (const [re, im] of one.multipliers) {
    drawn(svg, "circle", { cx: Math.max(-1.5, Math.min(1.5, re)), cy: -im, r: 0.07, fill: Math.hypot(re, im) > 1 + 1e-6 ? "#d1495b" : "#1f4e79" });
  }
  document.documentElement.dataset.motion = k;
}

document.querySelector("h1").textContent = run.title;
at("about").textContent = run.about;
for (const output of run.outputs) at("output").add(new Option(output));
at("point").max = motions.length - 1;
at("point").addEventListener("input", () => show(Number(at("point").value)));
at("output").addEventListener("change", () => { picture(); show(Number(at("point").value)); });
at("branch").addEventListener("click", (event) => {
  const svg = at("branch"), box = svg.getBoundingClientRect(), part = Math.min(box.width / 720, box.height / 460);
  const x = (event.clientX - box.left - (box.width - 720 * part) / 2) / part, y = (event.clientY - box.top - (box.height - 460 * part) / 2) / part;
  const apart = places.map((place) => Math.hypot(place[0] - x, place[1] - y));
  show(apart.indexOf(Math.min(...apart)));
});
picture();
show(0);
document.documentElement.dataset.ready = 1;
