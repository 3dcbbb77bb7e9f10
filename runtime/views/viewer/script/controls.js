// Play, slider, speed, exaggeration, views, what is shown, pictures, and the state in the address.
const $ = (selector) => document.querySelector(selector);
$("h1").textContent = run.title;
$("#about").textContent = run.about;
$("#about").classList.toggle("failed", !run.ok);
const shown = { bodies: true, joints: true, "springs and loads": true, undeformed: true, names: true, grid: true, reactions: false, "colour: displacement": false, "colour: stress": false };
const tints = ["colour: displacement", "colour: stress"];
const slider = $("#time"), clock = $("#clock"), decimals = Math.min(Math.max(3 - Math.floor(Math.log10(Math.max(last - first, 1e-9))), 0), 9);
slider.min = first;
slider.max = last;

function show(t) {
  state.t = Math.min(Math.max(t, first), last);
  slider.value = state.t;
  clock.textContent = `t = ${state.t.toFixed(decimals)} s`;
  const frame = moveTo(state.t);
  moveBodies();
  moveSymbols(frame);
  moveCurves();
  draw();
}

slider.addEventListener("input", () => show(Number(slider.value)));
slider.addEventListener("change", remember);

const speeds = [0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100];
for (const value of speeds) $("#speed").add(new Option(value < 1 ? `1/${Math.round(1 / value)}` : `${value}\u00d7`, value));
$("#speed").value = speeds.reduce((best, value) => Math.abs(Math.log(value * 8 / (last - first || 1))) < Math.abs(Math.log(best * 8 / (last - first || 1))) ? value : best);

let playing = false, before = 0;
function play(on) {
  playing = on;
  $("#play").textContent = on ? "\u275a\u275a pause" : "\u25b6 play";
  if (on) {
    if (state.t >= last) show(first);
    before = performance.now();
    requestAnimationFrame(step);
  } else remember();
}
function step(now) {
  if (!playing) return;
  const next = state.t + (now - before) / 1000 * Number($("#speed").value);
  before = now;
  show(next > last ? first : next);
  requestAnimationFrame(step);
}
$("#play").addEventListener("click", () => play(!playing));

const stretch = $("#stretch input");
$("#stretch").hidden = !run.bodies.some((body) => body.nf);
function setFactor(factor) {
  state.factor = factor;
  stretch.value = factor / run.factor;
  $("#stretch output").textContent = factor >= 100 ? factor.toFixed(0) : String(Number(factor.toPrecision(2)));
  for (const name of Object.keys(traces)) { trace(name); trace(name); }
  show(state.t);
}
stretch.addEventListener("input", () => setFactor(Number(stretch.value) * run.factor));
stretch.addEventListener("change", remember);
stretch.addEventListener("dblclick", () => setFactor(1));

function setShown(name, on) {
  shown[name] = on;
  if (layers[name]) layers[name].visible = on;
  if (name === "names") $("#names").hidden = !on;
  if (!tints.includes(name)) return;
  for (const other of tints) if (on && other !== name) shown[other] = false;
  for (const box of document.querySelectorAll("#show input")) box.checked = shown[box.dataset.name];
  state.coloured = (tints.find((tint) => shown[tint]) || "").slice(8);
  $("#scale").hidden = !state.coloured;
  if (state.coloured) $("#scale span").textContent = `0 ... ${state.coloured === "stress" ? prefixed(run.stress, "Pa") : prefixed(run.deformation, "m")}`;
}
function prefixed(value, unit) {
  const [factor, prefix] = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "\u00b5"]].find(([size]) => value >= size) || [1e-9, "n"];
  return `${Number((value / factor).toPrecision(3))} ${prefix}${unit}`;
}
for (const name of Object.keys(shown)) {
  if (name === "reactions" && !run.joints.some((joint) => joint.arrow)) continue;
  const possible = { undeformed: run.bodies.some((body) => body.nf), "colour: displacement": run.bodies.some((body) => body.nf && body.mesh), "colour: stress": run.bodies.some((body) => body.stress) && run.stress > 0 };
  if (possible[name] === false) { setShown(name, false); delete shown[name]; continue; }
  const label = document.createElement("label"), box = document.createElement("input");
  box.type = "checkbox";
  box.dataset.name = name;
  box.addEventListener("change", () => { setShown(name, box.checked); show(state.t); remember(); });
  label.append(box, ` ${name}`);
  $("#show").append(label);
}
{
  const paint = $("#scale canvas").getContext("2d");
  for (let x = 0; x < 120; x++) { paint.fillStyle = `#${scaleColour(x / 119).getHexString()}`; paint.fillRect(x, 0, 1, 10); }
}

function button(text, action, view) {
  const made = document.createElement("button");
  made.textContent = text;
  if (view) made.dataset.view = view;
  made.addEventListener("click", action);
  $("#look").append(made);
  return made;
}
for (const name of Object.keys(views)) button(name, () => { look(name); remember(); }, name);
const parallel = button("parallel", () => { flat = !flat; parallel.classList.toggle("on", flat); look(facing); remember(); });
parallel.classList.toggle("on", flat);
button("save picture", () => { drawNow(); download(canvas.toDataURL("image/png"), "png"); });
if (window.MediaRecorder && canvas.captureStream) button("save film", film);

function download(address, ending) {
  const link = document.createElement("a");
  link.href = address;
  link.download = `${run.name}.${ending}`;
  link.click();
}
function film() {
  const kind = ["video/mp4", "video/webm"].find((type) => MediaRecorder.isTypeSupported(type)), parts = [];
  const recorder = new MediaRecorder(canvas.captureStream(30), { mimeType: kind, videoBitsPerSecond: 8e6 });
  recorder.ondataavailable = (event) => parts.push(event.data);
  recorder.onstop = () => download(URL.createObjectURL(new Blob(parts, { type: kind })), kind.slice(6));
  show(first);
  recorder.start();
  play(true);
  setTimeout(() => { play(false); recorder.stop(); }, 1000 * (last - first) / Number($("#speed").value));
}

document.addEventListener("keydown", (event) => {
  if (["SELECT", "INPUT"].includes(event.target.tagName) && event.target.type !== "checkbox") return;
  if (event.key === " ") { event.preventDefault(); play(!playing); }
  const frame = frameAt(state.t), at = frame.share > 0.5 ? frame.high : frame.low;
  if (event.key === "ArrowRight") show(times[Math.min(at + 1, times.length - 1)]);
  if (event.key === "ArrowLeft") show(times[Math.max(at - 1, 0)]);
});

// #t=0.06&x=10&view=z&trace=rod.end&hide=names,grid&with=reactions
function remember() {
  const away = Object.keys(shown).filter((name) => !shown[name] && !["reactions", ...tints].includes(name)), extra = ["reactions", ...tints].filter((name) => shown[name]);
  const words = { t: state.t.toPrecision(6), x: Number(state.factor.toPrecision(3)), view: facing, trace: Object.keys(traces).join(), hide: away.join(), with: extra.join() };
  const text = Object.entries(words).filter(([, value]) => value !== "").map(([key, value]) => `${key}=${encodeURIComponent(value)}`).join("&");
  try { history.replaceState(null, "", `#${text}`); } catch { /* inside a frame without an address */ }
}
const usualHint = $("#hint").textContent;
function recall() {
  const words = new URLSearchParams(location.hash.slice(1));
  const list = (key) => (words.get(key) || "").split(",").filter(Boolean);
  if (words.get("view") in views) facing = words.get("view");
  if (words.has("parallel")) { flat = words.get("parallel") === "1"; parallel.classList.toggle("on", flat); }
  const missing = [];
  for (const [key, on] of [["hide", false], ["with", true]]) for (const name of list(key)) {
    const own = [name, `colour: ${name}`].find((one) => one in shown);
    if (own) setShown(own, on); else missing.push(`${key}=${name}`);
  }
  $("#hint").textContent = missing.length ? `${missing.join(", ")}: not in this page, which has ${Object.keys(shown).join(", ")}` : usualHint;
  for (const name of Object.keys(shown)) setShown(name, shown[name]);
  for (const box of document.querySelectorAll("#show input")) box.checked = shown[box.dataset.name];
  resize();
  look(facing);
  setFactor(words.has("x") && Number.isFinite(Number(words.get("x"))) ? Number(words.get("x")) : run.factor);
  show(words.has("t") && Number.isFinite(Number(words.get("t"))) ? Number(words.get("t")) : first);
  for (const name of list("trace")) trace(name);
  show(state.t);
}
window.addEventListener("hashchange", recall);
new ResizeObserver(resize).observe($("#stage"));
recall();
setTimeout(moveCurves, 100); // the charts fill their legends once they are laid out
window.symgenView = { run, state, show, place, setFactor, digits };
document.documentElement.dataset.ready = "1";
