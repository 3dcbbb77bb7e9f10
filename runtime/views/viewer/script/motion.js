// Where everything is at a time: x = r + A (u0 + follow + s (Phi q_f - follow) - 1/2 q_f^T H q_f e_x).
// `follow` is the part of the deformation that the joints make; it is shown as it is, so that no gap opens.
const state = { t: first, factor: run.factor, coloured: "" }; // coloured: by displacement, stress, or not

function frameAt(t) {
  let low = 0, high = times.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle; else high = middle;
  }
  const span = times[high] - times[low];
  return { low, high, share: span > 0 ? Math.min(Math.max((t - times[low]) / span, 0), 1) : 0 };
}

function mixed(values, size, frame) {
  const result = new Array(size);
  for (let k = 0; k < size; k++) {
    const a = values[frame.low * size + k], b = values[frame.high * size + k];
    result[k] = a + frame.share * (b - a);
  }
  return result;
}

function poseAt(body, frame) {
  const matrix = new THREE.Matrix4();
  if (!body.pose) return matrix;
  const a = body.pose.slice(7 * frame.low, 7 * frame.low + 7), b = body.pose.slice(7 * frame.high, 7 * frame.high + 7);
  const p = new THREE.Quaternion(a[4], a[5], a[6], a[3]), q = new THREE.Quaternion(b[4], b[5], b[6], b[3]);
  const r = [0, 1, 2].map((i) => a[i] + frame.share * (b[i] - a[i]));
  return matrix.compose(new THREE.Vector3(...r), p.slerp(q, frame.share), new THREE.Vector3(1, 1, 1));
}

function deform(body, set, q, factor) {
  const nf = body.nf, { x, phi, H, weights, shown, moved } = set, markers = body.follow_at.length / 3;
  if (!nf) return;
  const rigid = [0, 0, 0, 0, 0, 0], rest = new Array(3 * markers).fill(0);
  for (let i = 0; i < 6; i++) for (let a = 0; a < nf; a++) rigid[i] += body.follow_rigid[i * nf + a] * q[a];
  for (let i = 0; i < 3 * markers; i++) for (let a = 0; a < nf; a++) rest[i] += body.follow_rest[i * nf + a] * q[a];
  const short = new Float32Array(H.length / (nf * nf));
  for (let s = 0; s < short.length && factor; s++) {
    let value = 0;
    for (let a = 0; a < nf; a++) for (let b = 0; b < nf; b++) value += q[a] * H[(s * nf + a) * nf + b] * q[b];
    short[s] = -0.5 * value;
  }
  const perStation = short.length ? set.count / short.length : 1;
  const [ax, ay, az, bx, by, bz] = rigid;
  for (let k = 0; k < set.count; k++) {
    const X = x[3 * k], Y = x[3 * k + 1], Z = x[3 * k + 2];
    const follow = [ax + by * Z - bz * Y, ay + bz * X - bx * Z, az + bx * Y - by * X];
    let square = 0;
    for (let i = 0; i < 3; i++) {
      for (let m = 0; m < markers; m++) follow[i] += weights[k * markers + m] * rest[3 * m + i];
      let u = 0;
      for (let a = 0, place = (3 * k + i) * nf; a < nf; a++) u += phi[place + a] * q[a];
      const own = u - follow[i];
      square += own * own;
      shown[3 * k + i] = x[3 * k + i] + (factor ? follow[i] + factor * own : 0);
    }
    if (short.length && factor) shown[3 * k] += short[Math.floor(k / perStation)];
    moved[k] = Math.sqrt(square);
  }
}

// Stress of every vertex [Pa]: of a beam as it was sent, of a finite-element surface von Mises.
function stressOf(body, q, frame) {
  const n = body.mesh.count, nf = body.nf, found = new Float32Array(n);
  if (body.stress.vertices) return mixed(body.stress.vertices, n, frame).map((level) => level * run.stress / 255);
  const modes = body.stress.modes, part = new Float64Array(6);
  for (let k = 0; k < n; k++) {
    for (let i = 0, at = 6 * k * nf; i < 6; i++) { part[i] = 0; for (let a = 0; a < nf; a++) part[i] += modes[at++] * q[a]; }
    const [x, y, z, yz, xz, xy] = part;
    found[k] = Math.sqrt(((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) / 2 + 3 * (yz * yz + xz * xz + xy * xy));
  }
  return found;
}

// World position of a marker [body, place] as last deformed.
function place(marker) {
  const body = run.bodies[marker[0]], k = 3 * marker[1], p = body.points.shown;
  return new THREE.Vector3(p[k], p[k + 1], p[k + 2]).applyMatrix4(body.matrix);
}

// Axes of a joint's or load's marker a in the world; columns x, y, z.
function turned(part) {
  return new THREE.Matrix4().extractRotation(run.bodies[part.a[0]].matrix).multiply(turnedLocal(part));
}

function turnedLocal(part) {
  const a = part.axes;
  return new THREE.Matrix4().set(a[0], a[1], a[2], 0, a[3], a[4], a[5], 0, a[6], a[7], a[8], 0, 0, 0, 0, 1);
}

function moveTo(t) {
  const frame = frameAt(t);
  for (const body of run.bodies) {
    body.matrix = poseAt(body, frame);
    const q = mixed(body.q, body.nf, frame);
    for (const set of [body.points, body.mesh]) if (set) deform(body, set, q, state.factor);
    body.strained = state.coloured === "stress" && body.stress ? stressOf(body, q, frame) : null;
  }
  return frame;
}

// Path of a marker over all frames.
function path(marker) {
  const points = [], body = run.bodies[marker[0]];
  for (let k = 0; k < times.length; k++) {
    const frame = { low: k, high: k, share: 0 };
    body.matrix = poseAt(body, frame);
    deform(body, body.points, mixed(body.q, body.nf, frame), state.factor);
    points.push(place(marker));
  }
  return points;
}
