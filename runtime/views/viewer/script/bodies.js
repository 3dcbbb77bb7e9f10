// Bodies: meshes with modes, or rods and pale faces between markers.
const unitRod = new THREE.CylinderGeometry(1, 1, 1, 14);
const paleness = { transparent: true, opacity: 0.3, depthWrite: false };
const matter = (colour, more) => new THREE.MeshLambertMaterial({ color: colour, ...more });

function shapedMesh(body, material) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(body.mesh.shown, 3));
  geometry.setAttribute("color", new THREE.BufferAttribute(new Float32Array(body.mesh.x.length).fill(1), 3));
  geometry.setIndex(new THREE.BufferAttribute(body.mesh.triangles, 1));
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

for (const body of run.bodies) {
  body.group = new THREE.Group();
  body.group.matrixAutoUpdate = false;
  layers.bodies.add(body.group);
  const thick = 0.011 * size;
  if (body.mesh) {
    body.material = matter(body.colour, { flatShading: true, side: THREE.DoubleSide, ...(body.pale && paleness) });
    body.surface = shapedMesh(body, body.material);
    body.group.add(body.surface);
    if (body.nf && !body.pale) {
      const ghost = new THREE.BufferGeometry();
      ghost.setAttribute("position", new THREE.BufferAttribute(new Float32Array(body.mesh.x), 3));
      ghost.setIndex(new THREE.BufferAttribute(body.mesh.triangles, 1));
      body.ghost = new THREE.Mesh(ghost, matter("#8b93a3", { transparent: true, opacity: 0.28, depthWrite: false, flatShading: true, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2 }));
      body.ghost.matrixAutoUpdate = false;
      layers.undeformed.add(body.ghost);
    }
  }
  body.rodMeshes = body.rods.map(() => {
    const rod = new THREE.Mesh(unitRod, matter(body.colour, body.pale && paleness));
    body.group.add(rod);
    return rod;
  });
  body.ghostRods = body.nf && !body.mesh && !body.pale ? body.rods.map(([i, j]) => {
    const at = (k) => new THREE.Vector3(...body.points.x.slice(3 * k, 3 * k + 3)), rod = new THREE.Mesh(unitRod, matter("#8b93a3", { transparent: true, opacity: 0.35, depthWrite: false }));
    span(rod, at(i), at(j), 0.5 * thick);
    const holder = new THREE.Group();
    holder.matrixAutoUpdate = false;
    holder.add(rod);
    layers.undeformed.add(holder);
    return holder;
  }) : [];
  body.knobs = body.rods.length || body.ground || body.mesh ? [] : body.points.names.slice(0, 1).map(() => {
    const knob = new THREE.Mesh(new THREE.SphereGeometry(2.2 * thick, 24, 16), matter(body.colour, body.pale && paleness));
    body.group.add(knob);
    return knob;
  });
  body.ends = body.mesh ? [] : [...new Set(body.rods.flat())].map((k) => {
    const end = new THREE.Mesh(new THREE.SphereGeometry(thick, 16, 12), matter(body.colour, body.pale && paleness));
    body.group.add(end);
    return [end, k];
  });
  body.faceMeshes = body.faces.map(() => {
    const face = new THREE.BufferGeometry();
    face.setAttribute("position", new THREE.BufferAttribute(new Float32Array(9), 3));
    const mesh = new THREE.Mesh(face, new THREE.MeshBasicMaterial({ color: body.colour, transparent: true, opacity: 0.22, side: THREE.DoubleSide, depthWrite: false }));
    mesh.frustumCulled = false;
    body.group.add(mesh);
    return mesh;
  });
}

const corner = (set, k) => new THREE.Vector3(set.shown[3 * k], set.shown[3 * k + 1], set.shown[3 * k + 2]);

function span(mesh, a, b, thick) {
  const along = b.clone().sub(a), length = Math.max(along.length(), 1e-12);
  mesh.position.copy(a).addScaledVector(along, 0.5);
  mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), along.divideScalar(length));
  mesh.scale.set(thick, length, thick);
}

// Five colours of viridis.
const scaleColours = ["#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"].map((text) => new THREE.Color(text));
function scaleColour(share) {
  const at = Math.min(Math.max(share, 0), 1) * (scaleColours.length - 1), k = Math.min(Math.floor(at), scaleColours.length - 2);
  return scaleColours[k].clone().lerp(scaleColours[k + 1], at - k);
}

function moveBodies() {
  for (const body of run.bodies) {
    body.group.matrix.copy(body.matrix);
    body.group.matrixWorldNeedsUpdate = true;
    if (body.mesh) {
      body.surface.geometry.attributes.position.needsUpdate = true;
      body.surface.geometry.computeBoundingSphere();
      const values = state.coloured === "displacement" && body.nf ? body.mesh.moved : body.strained;
      if (values) {
        const colours = body.surface.geometry.attributes.color, most = state.coloured === "stress" ? run.stress : run.deformation;
        for (let k = 0; k < body.mesh.count; k++) {
          const c = scaleColour(values[k] / most);
          colours.setXYZ(k, c.r, c.g, c.b);
        }
        colours.needsUpdate = true;
      }
      const vertexColours = !!values;
      if (body.material.vertexColors !== vertexColours) {
        body.material.vertexColors = vertexColours;
        body.material.color.set(vertexColours ? "#ffffff" : body.colour);
        body.material.needsUpdate = true;
      }
      if (body.ghost) { body.ghost.matrix.copy(body.matrix); body.ghost.matrixWorldNeedsUpdate = true; }
    }
    for (const holder of body.ghostRods) { holder.matrix.copy(body.matrix); holder.matrixWorldNeedsUpdate = true; }
    body.rods.forEach(([i, j], k) => span(body.rodMeshes[k], corner(body.points, i), corner(body.points, j), 0.011 * size));
    for (const [end, k] of body.ends) end.position.copy(corner(body.points, k));
    for (const knob of body.knobs) knob.position.copy(corner(body.points, 0));
    body.faces.forEach((face, k) => {
      const position = body.faceMeshes[k].geometry.attributes.position;
      face.forEach((point, i) => position.setXYZ(i, ...corner(body.points, point).toArray()));
      position.needsUpdate = true;
    });
  }
}
