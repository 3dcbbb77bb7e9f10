export {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, Float32BufferAttribute,
  Group, HemisphereLight, Line, LineBasicMaterial, LineLoop, LineSegments, Matrix4, Mesh, MeshBasicMaterial,
  MeshLambertMaterial, MeshStandardMaterial, OrthographicCamera, PerspectiveCamera, PlaneGeometry, Quaternion,
  Raycaster, Scene, SphereGeometry, CylinderGeometry, ConeGeometry, BoxGeometry, TorusGeometry, GridHelper, Vector2, Vector3,
  WebGLRenderer, TubeGeometry, Curve, EdgesGeometry, LatheGeometry,
} from "three";
export { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
