// The run.
const run = JSON.parse(document.getElementById("run").textContent);

const times = decoded(run.t, Float64Array);
const first = times[0], last = times[times.length - 1];
for (const body of run.bodies) {
  body.pose = body.pose && decoded(body.pose, Float32Array);
  body.q = decoded(body.q, Float32Array);
  for (const set of [body.mesh, body.points]) {
    if (!set) continue;
    for (const key of ["x", "phi", "H"]) set[key] = decoded(set[key], Float32Array);
    set.count = set.x.length / 3;
    set.weights = markerWeights(body, set);
    set.shown = new Float32Array(set.x); // in the body's axes, exaggerated
    set.moved = new Float32Array(set.count); // length of the displacement that is exaggerated
  }
  if (body.mesh) body.mesh.triangles = decoded(body.mesh.triangles, Uint32Array);
  if (body.stress && body.stress.modes) body.stress.modes = decoded(body.stress.modes, Float32Array);
  if (body.stress && body.stress.vertices) body.stress.vertices = decoded(body.stress.vertices, Uint8Array);
}
for (const group of run.curves) group.values = group.values.map((text) => Array.from(decoded(text, Float32Array), (value) => (Number.isNaN(value) ? null : value)));
const curveTimes = decoded(run.curve_t, Float64Array);

// Share of each joint marker in what is left of the fit, 1 at the marker itself: inverse squares of the distance.
function markerWeights(body, set) {
  const markers = body.follow_at.length / 3, weights = new Float32Array(set.x.length / 3 * markers);
  for (let k = 0; k < set.x.length / 3 && markers; k++) {
    let sum = 0;
    for (let m = 0; m < markers; m++) {
      let square = 0;
      for (let i = 0; i < 3; i++) square += (set.x[3 * k + i] - body.follow_at[3 * m + i]) ** 2;
      sum += weights[k * markers + m] = 1 / Math.max(square, 1e-14 * run.size * run.size);
    }
    for (let m = 0; m < markers; m++) weights[k * markers + m] /= sum;
  }
  return weights;
}
