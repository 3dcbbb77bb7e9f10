// Joints, springs, loads, reactions, traces, names.
const dark = "#2b303b", steel = "#8a919e", red = "#b3261e", s = 0.018 * size;
const zAxis = new THREE.Vector3(0, 0, 1), yAxis = new THREE.Vector3(0, 1, 0);

function symbol(joint) {
  const group = new THREE.Group(), add = (geometry, colour, turn) => {
    const mesh = new THREE.Mesh(geometry, matter(colour));
    if (turn) mesh.quaternion.setFromUnitVectors(yAxis, turn);
    group.add(mesh);
    return mesh;
  };
  const slide = run.planar ? new THREE.Vector3(1, 0, 0) : zAxis;
  if (joint.type === "revolute") add(new THREE.CylinderGeometry(0.8 * s, 0.8 * s, 2.8 * s, 24), dark, zAxis);
  else if (joint.type === "spherical") add(new THREE.SphereGeometry(1.1 * s, 24, 16), dark);
  else if (joint.type === "universal") {
    add(new THREE.CylinderGeometry(0.5 * s, 0.5 * s, 3.4 * s, 16), dark, zAxis);
    add(new THREE.CylinderGeometry(0.5 * s, 0.5 * s, 3.4 * s, 16), dark, new THREE.Vector3(1, 0, 0));
  } else if (["prismatic", "cylindrical", "screw", "point_on_line"].includes(joint.type)) {
    add(new THREE.BoxGeometry(2.4 * s, 2.4 * s, 2.4 * s), steel);
  } else if (joint.type === "weld") add(new THREE.BoxGeometry(1.7 * s, 1.7 * s, 1.7 * s), dark);
  else if (joint.type === "planar") add(new THREE.BoxGeometry(5 * s, 5 * s, 0.3 * s), steel);
  else if (joint.type === "prescribed_angle") add(new THREE.TorusGeometry(1.7 * s, 0.35 * s, 10, 32), red);
  else if (joint.type === "prescribed_displacement") add(new THREE.ConeGeometry(0.9 * s, 2.4 * s, 20), red, slide);
  return group;
}

// A grey block behind what the ground holds.
for (const part of [...run.joints, ...run.loads]) {
  for (const end of [part.a, part.b]) {
    if (!end || !run.bodies[end[0]].ground || part.rail || part.type.startsWith("prescribed") || part.line) continue;
    const block = new THREE.Mesh(new THREE.BoxGeometry(3.4 * s, 3.4 * s, run.planar ? 1.2 * s : 3.4 * s), matter("#b4bac5"));
    block.position.set(...run.bodies[end[0]].points.x.slice(3 * end[1], 3 * end[1] + 3));
    if (run.planar) block.position.z -= 2 * s;
    else {
      block.scale.setScalar(0.62);
      if (part.a === end) block.quaternion.setFromRotationMatrix(turnedLocal(part));
    }
    layers.joints.add(block);
  }
}

// Ends of a way: bars across a rail, marks about a hinge. Wheels in their ratio, with a spoke that turns.
const held = "#d98e04";

function bars(joint) {
  return (joint.ends || []).map((end, k) => {
    if (end === null) return null;
    const bar = new THREE.Mesh(joint.rail ? new THREE.BoxGeometry(0.6 * s, 4.4 * s, 4.4 * s) : unitRod, matter(dark));
    layers.joints.add(bar);
    return { bar, at: end, out: joint.rail ? (k ? 1.5 : -1.5) * s : 0 };
  }).filter(Boolean);
}

function wheel(radius) {
  const group = new THREE.Group(), spoke = new THREE.Mesh(unitRod, matter(steel));
  group.add(new THREE.Mesh(new THREE.TorusGeometry(radius, 0.3 * s, 10, 64), spoke.material), spoke);
  span(spoke, new THREE.Vector3(), new THREE.Vector3(radius, 0, 0), 0.25 * s);
  layers.joints.add(group);
  return group;
}

function moveBars(joint) {
  const frame = turned(joint), a = place(joint.a), x = new THREE.Vector3(1, 0, 0), along = (run.planar ? x : zAxis).clone().applyMatrix4(frame);
  for (const { bar, at, out } of joint.bars) {
    if (joint.rail) {
      bar.position.copy(a).addScaledVector(along, at + out);
      bar.quaternion.setFromUnitVectors(x, along);
    } else {
      const way = new THREE.Vector3(Math.cos(at), Math.sin(at), 0).applyMatrix4(frame);
      span(bar, a.clone().addScaledVector(way, 1.6 * s), a.clone().addScaledVector(way, 5 * s), 0.35 * s);
    }
  }
}

for (const joint of run.joints) {
  joint.bars = bars(joint);
  joint.held = joint.held && decoded(joint.held, Float32Array);
  joint.discs = (joint.wheels || []).map(wheel);
  joint.object = joint.line ? new THREE.Mesh(unitRod, matter(steel)) : symbol(joint);
  layers.joints.add(joint.object);
  if (joint.rail) {
    joint.track = new THREE.Mesh(unitRod, matter(steel));
    layers.joints.add(joint.track);
  }
  if (joint.force) {
    joint.force = decoded(joint.force, Float32Array);
    joint.arrow = arrow("#7b2d8b");
    layers.reactions.add(joint.arrow);
  }
}

function arrow(colour) {
  const group = new THREE.Group();
  group.add(new THREE.Mesh(unitRod, matter(colour)), new THREE.Mesh(new THREE.ConeGeometry(1, 1, 20), matter(colour)));
  return group;
}

// From the tip back: an arrow that ends at a point, or begins there.
function aim(object, from, vector) {
  const length = vector.length();
  object.visible = length > 1e-6 * size;
  if (!object.visible) return;
  const head = Math.min(2.6 * s, 0.5 * length), to = from.clone().add(vector), neck = to.clone().addScaledVector(vector, -head / length);
  span(object.children[0], from, neck, 0.3 * s);
  span(object.children[1], neck, to, 0.9 * s);
  object.children[1].scale.y = head;
}

// A coil of radius 1 whose length is `slender` of that, so that its wire stays round when the mesh is scaled.
class Helix extends THREE.Curve {
  constructor(slender) { super(); this.slender = slender; }
  getPoint(u, target = new THREE.Vector3()) {
    const turns = Math.max(6, Math.round(0.45 * this.slender)), inside = Math.min(Math.max((u - 0.1) / 0.8, 0), 1), radius = u < 0.06 || u > 0.94 ? 0 : 1;
    return target.set(radius * Math.cos(2 * Math.PI * turns * inside), (u - 0.5) * this.slender, radius * Math.sin(2 * Math.PI * turns * inside));
  }
}
const COIL = 1.25 * s;

function coiled(load, a, b) {
  if (!load.slender) {
    load.slender = Math.max(a.distanceTo(b) / COIL, 4);
    load.object.geometry = new THREE.TubeGeometry(new Helix(load.slender), 320, 0.13, 7);
  }
  span(load.object, a, b, COIL);
  load.object.scale.y /= load.slender;
}

for (const load of run.loads) {
  if (load.type === "spring_damper" || load.type === "bushing") {
    load.object = new THREE.Mesh(unitRod, matter("#39404d"));
    load.piston = new THREE.Mesh(unitRod, matter(steel));
    layers["springs and loads"].add(load.piston);
  } else if (load.type === "force") {
    load.object = arrow(red);
  } else {
    load.object = new THREE.Group();
    const ring = new THREE.Mesh(new THREE.TorusGeometry(2.1 * s, 0.22 * s, 10, 40, 1.6 * Math.PI), matter(load.type === "torque" ? red : "#39404d"));
    const tip = new THREE.Mesh(new THREE.ConeGeometry(0.7 * s, 1.6 * s, 16), ring.material);
    tip.position.set(2.1 * s * Math.cos(1.6 * Math.PI), 2.1 * s * Math.sin(1.6 * Math.PI), 0);
    tip.rotation.z = 1.6 * Math.PI;
    load.object.add(ring, tip);
  }
  load.vector = decoded(load.vector, Float32Array);
  layers["springs and loads"].add(load.object);
}

function moveSymbols(frame) {
  for (const joint of run.joints) {
    const a = place(joint.a), b = place(joint.b);
    if (joint.line) {
      span(joint.object, a, b, 0.5 * s);
      joint.object.visible = a.distanceTo(b) > 1e-6 * size; // wheels on one axis have none
    } else {
      joint.object.position.copy(b);
      joint.object.quaternion.setFromRotationMatrix(turned(joint));
    }
    if (joint.bars.length) moveBars(joint);
    joint.discs.forEach((disc, k) => {
      disc.position.copy(k ? b : a);
      disc.quaternion.setFromRotationMatrix(turned(k ? { a: joint.b, axes: joint.axes_b } : joint));
    });
    if (joint.held) for (const part of joint.object.children) {
      part.userData.own = part.userData.own || part.material.color.clone();
      part.material.color.set(joint.held[frame.low] ? held : part.userData.own);
    }
    if (joint.track) {
      const along = new THREE.Vector3(...(run.planar ? [1, 0, 0] : [0, 0, 1])).applyMatrix4(turned(joint));
      span(joint.track, a.clone().addScaledVector(along, joint.rail[0]), a.clone().addScaledVector(along, joint.rail[1]), 0.45 * s);
    }
    if (joint.arrow) {
      const force = new THREE.Vector3(...mixed(joint.force, 3, frame));
      aim(joint.arrow, b, force.multiplyScalar(0.3 * size / Math.max(run.largest_force, 1e-300)));
    }
  }
  for (const load of run.loads) {
    const a = place(load.a);
    if (load.piston) {
      const b = place(load.b);
      coiled(load, a, b);
      span(load.piston, a, b, 0.28 * s);
      load.piston.visible = load.object.visible = a.distanceTo(b) > 1e-6 * size;
    } else if (load.type === "force") {
      const force = new THREE.Vector3(...mixed(load.vector, 3, frame)).multiplyScalar(0.25 * size / Math.max(run.largest_load, 1e-300));
      aim(load.object, a.clone().sub(force), force);
    } else { // a ring that grows with the moment and turns with it
      const moment = new THREE.Vector3(...mixed(load.vector, 3, frame)), share = moment.length() / Math.max(run.largest_torque, 1e-300);
      load.object.visible = share > 1e-3;
      load.object.position.copy(a);
      load.object.scale.setScalar(0.6 + 0.8 * share);
      if (load.object.visible) load.object.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), moment.normalize());
    }
  }
}

const named = [...run.joints.filter((joint) => joint.shown), ...run.loads].map((part) => {
  const label = document.createElement("span");
  label.textContent = part.name;
  document.getElementById("names").append(label);
  return [label, part];
});

// Names beside their parts; one that would cover another is left out.
function drawNames() {
  const w = canvas.clientWidth, h = canvas.clientHeight, taken = [];
  for (const [label, part] of named) {
    const p = (part.piston ? place(part.a).lerp(place(part.b), 0.5) : place(part.b || part.a)).project(camera);
    const x = (p.x + 1) / 2 * w + 9, y = (1 - p.y) / 2 * h - 18, wide = 7 * part.name.length, free = taken.every(([u, v, other]) => Math.abs(y - v) > 13 || x + wide < u || u + other < x);
    label.hidden = !free || Math.abs(p.z) > 1 || x < 0 || x > w - 10 || y < 0 || y > h - 12;
    if (label.hidden) continue;
    taken.push([x, y, wide]);
    label.style.transform = `translate(${x}px, ${y}px)`;
  }
}

const traces = {};
function trace(name) {
  if (traces[name]) { scene.remove(traces[name]); delete traces[name]; return; }
  const [bodyName, marker] = [name.slice(0, name.indexOf(".")), name.slice(name.indexOf(".") + 1)];
  const b = run.bodies.findIndex((body) => body.name === bodyName), k = b < 0 ? -1 : run.bodies[b].points.names.indexOf(marker);
  if (k < 0) return;
  const points = path([b, k]), line = new THREE.BufferGeometry().setFromPoints(points);
  traces[name] = new THREE.Line(line, new THREE.LineBasicMaterial({ color: run.bodies[b].colour }));
  traces[name].frustumCulled = false;
  scene.add(traces[name]);
}

const pointer = new THREE.Raycaster();
let pressed = null;
canvas.addEventListener("pointerdown", (event) => { pressed = [event.clientX, event.clientY]; });
canvas.addEventListener("pointerup", (event) => {
  if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
  const box = canvas.getBoundingClientRect();
  pointer.setFromCamera(new THREE.Vector2(2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height), camera);
  const hit = run.joints.find((joint) => joint.object.visible && pointer.intersectObject(joint.object, true).length);
  if (!hit) return;
  const moving = run.bodies[hit.b[0]].ground ? hit.a : hit.b, body = run.bodies[moving[0]];
  trace(`${body.name}.${body.points.names[moving[1]]}`);
  show(state.t);
});
