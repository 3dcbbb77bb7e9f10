// Renderer, cameras, lights, grid, views.
const canvas = document.querySelector("#stage > canvas");
const renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
const scene = new THREE.Scene();
scene.background = new THREE.Color("#fbfbfc");
scene.add(new THREE.HemisphereLight("#ffffff", "#b9c0cc", 2.2));
const lamp = new THREE.DirectionalLight("#ffffff", 1.6);
scene.add(lamp, lamp.target);

const centre = new THREE.Vector3(...run.centre), size = run.size;
const up = new THREE.Vector3(...[0, 1, 2].map((i) => (i === run.up ? 1 : 0)));
const layers = {};
for (const name of ["bodies", "joints", "springs and loads", "undeformed", "reactions", "grid"]) {
  layers[name] = new THREE.Group();
  scene.add(layers[name]);
}

const cells = 12, cell = 10 ** Math.floor(Math.log10(size)) / 2;
const grid = new THREE.GridHelper(Math.max(cells, Math.ceil(2.4 * size / cell)) * cell, Math.max(cells, Math.ceil(2.4 * size / cell)), "#c3cbe0", "#e6e8ee");
if (run.planar) grid.rotation.x = Math.PI / 2;
else if (run.up === 0) grid.rotation.z = Math.PI / 2;
else if (run.up === 2) grid.rotation.x = Math.PI / 2;
grid.position.copy(centre);
if (run.planar) grid.position.z = -0.04 * size;
else grid.position.setComponent(run.up, run.lowest - 0.02 * size);
layers.grid.add(grid);

const views = {
  "3-D": run.planar ? [-0.5, 0.35, 1] : [0, 1, 2].map((i) => (i === run.up ? 0.55 : i === (run.up + 1) % 3 ? 0.55 : -1)),
  x: [1, 0, 0], y: [0, run.up === 1 && !run.planar ? 1 : -1, 0], z: [0, 0, 1],
};
let camera, controls, flat = run.planar, facing = run.planar ? "z" : "3-D";

function look(name) {
  facing = name;
  const direction = new THREE.Vector3(...views[name]).normalize(), far = 30 * size;
  const { clientWidth: w, clientHeight: h } = canvas.parentElement, aspect = w / Math.max(h, 1);
  const half = fitted(direction, aspect);
  camera = flat
    ? new THREE.OrthographicCamera(-half * aspect, half * aspect, half, -half, -far, far)
    : new THREE.PerspectiveCamera(30, aspect, size / 500, far);
  const away = flat ? 5 * size : half / Math.tan(Math.PI / 12) + 0.3 * size;
  const upright = Math.abs(direction.dot(up)) > 0.99 ? new THREE.Vector3(...[0, 1, 2].map((i) => (i === (run.up + 1) % 3 ? 1 : 0))) : up;
  camera.up.copy(upright);
  camera.position.copy(centre).addScaledVector(direction, away);
  if (controls) controls.dispose();
  controls = new THREE.OrbitControls(camera, canvas);
  controls.target.copy(centre);
  controls.addEventListener("change", draw);
  controls.update();
  for (const button of document.querySelectorAll("#look button[data-view]")) button.classList.toggle("on", button.dataset.view === name);
  draw();
}

// Half the height that shows the box around the whole motion, looked at along `direction`.
function fitted(direction, aspect) {
  const side = new THREE.Vector3().crossVectors(Math.abs(direction.dot(up)) > 0.99 ? new THREE.Vector3(...[0, 1, 2].map((i) => (i === (run.up + 1) % 3 ? 1 : 0))) : up, direction).normalize();
  const over = new THREE.Vector3().crossVectors(direction, side);
  let wide = 0, high = 0;
  for (let corner = 0; corner < 8; corner++) {
    const p = new THREE.Vector3(...[0, 1, 2].map((i) => run.box[(corner >> i) & 1][i])).sub(centre);
    wide = Math.max(wide, Math.abs(p.dot(side)));
    high = Math.max(high, Math.abs(p.dot(over)));
  }
  return 1.25 * Math.max(high, wide / aspect, 0.05 * size);
}

function resize() {
  const { clientWidth: w, clientHeight: h } = canvas.parentElement;
  renderer.setSize(w, h, false);
  if (!camera) return;
  const aspect = w / Math.max(h, 1);
  if (camera.isPerspectiveCamera) camera.aspect = aspect;
  else {
    camera.top = fitted(new THREE.Vector3(...views[facing]).normalize(), aspect);
    camera.bottom = -camera.top;
    camera.right = camera.top * aspect;
    camera.left = -camera.right;
  }
  camera.updateProjectionMatrix();
  draw();
}

let waiting = false;
function draw() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => { waiting = false; drawNow(); });
}

function drawNow() {
  lamp.position.copy(camera.position).addScaledVector(up, 0.6 * camera.position.distanceTo(centre));
  lamp.target.position.copy(centre);
  renderer.render(scene, camera);
  drawNames();
}
