// In the browser: three.js loads each file of /jobs, and what it finds is told to /results. Run by three_check.js.
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

// How triangles of a mesh lie: the part of their area that looks the other way than its normals, and that whose texture is not
// as large as most of it by a hundredth.
function judged(mesh) {
  const { position, normal, uv } = mesh.geometry.attributes;
  const index = mesh.geometry.index;
  const [a, b, c, n] = [0, 0, 0, 0].map(() => new THREE.Vector3());
  const [p, q, r] = [0, 0, 0].map(() => new THREE.Vector2());
  let all = 0, turned = 0;
  const scales = [];
  for (let i = 0; i < index.count; i += 3) {
    const [x, y, z] = [index.getX(i), index.getX(i + 1), index.getX(i + 2)];
    a.fromBufferAttribute(position, x);
    b.fromBufferAttribute(position, y).sub(a);
    c.fromBufferAttribute(position, z).sub(a);
    const across = b.cross(c);
    const area = 0.5 * across.length();
    all += area;
    n.fromBufferAttribute(normal, x);
    if (across.dot(n) < 0) turned += area;
    p.fromBufferAttribute(uv, x);
    q.fromBufferAttribute(uv, y).sub(p);
    r.fromBufferAttribute(uv, z).sub(p);
    scales.push([Math.sqrt(0.5 * Math.abs(q.cross(r)) / area), area]);
  }
  scales.sort((one, other) => one[0] - other[0]);
  let below = 0, median = 0;
  for (const [scale, area] of scales) {
    below += area;
    if (below >= 0.5 * all) { median = scale; break; }
  }
  const off = scales.reduce((sum, [scale, area]) => sum + (Math.abs(scale / median - 1) > 0.01 ? area : 0), 0);
  return { turned: turned / all, off: off / all, scale: median };
}

function found(gltf) {
  const scene = gltf.scene;
  scene.updateMatrixWorld(true);
  const result = { kinds: {}, names: 0, metal: 0, transmissive: 0, textured: 0, turned: 0, off: 0, scales: [] };
  const box = new THREE.Box3();
  const known = new Map();
  scene.traverse((thing) => {
    if (!thing.isMesh) return;
    const whole = thing.userData.kind ?? thing.parent.userData.kind ?? "none";
    const kind = whole.split(" ")[0];
    result.kinds[kind] = (result.kinds[kind] ?? 0) + 1;
    if (thing.name || thing.parent.name) ++result.names;
    result.metal = Math.max(result.metal, thing.material.metalness);
    if (thing.material.transmission === 1) ++result.transmissive;
    if (thing.material.map?.image?.width > 0 && thing.material.normalMap && thing.material.roughnessMap) ++result.textured;
    if (!["joints", "water", "shard fallen"].includes(whole)) box.expandByObject(thing, true);
    if (!known.has(thing.geometry)) known.set(thing.geometry, judged(thing));
    const { turned, off, scale } = known.get(thing.geometry);
    result.turned = Math.max(result.turned, turned);
    if (kind !== "stone") return;
    result.off = Math.max(result.off, off);
    result.scales.push(scale);
  });
  result.scales = result.scales.length ? [Math.min(...result.scales), Math.max(...result.scales)] : [];
  result.size = box.getSize(new THREE.Vector3()).toArray();
  return result;
}

// How many of 10,000 pixels show something before a white ground, seen from above and in front.
function drawn(gltf) {
  const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true });
  renderer.setSize(100, 100);
  const world = new THREE.Scene();
  world.background = new THREE.Color(0xffffff);
  // The sun of the file is as bright as a sun is, which a picture of no exposure shows as white.
  gltf.scene.traverse((part) => {
    if (part.isLight) part.visible = false;
  });
  world.add(gltf.scene, new THREE.HemisphereLight(0xffffff, 0x888888, 1));
  const sphere = new THREE.Box3().setFromObject(gltf.scene).getBoundingSphere(new THREE.Sphere());
  const camera = new THREE.PerspectiveCamera(40, 1, 0.01, 1000);
  camera.position.copy(sphere.center).add(new THREE.Vector3(0, 1.5, 2).multiplyScalar(sphere.radius));
  camera.lookAt(sphere.center);
  renderer.render(world, camera);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(40000);
  gl.readPixels(0, 0, 100, 100, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  renderer.dispose();
  let lit = 0;
  for (let i = 0; i < pixels.length; i += 4) lit += pixels[i] + pixels[i + 1] + pixels[i + 2] < 760 ? 1 : 0;
  return lit;
}

const results = [];
for (const job of await (await fetch("/jobs")).json()) {
  try {
    const gltf = await new GLTFLoader().loadAsync(job);
    const result = found(gltf);
    result.lit = drawn(gltf);
    results.push(result);
  } catch (error) {
    results.push({ error: String(error) });
  }
}
await fetch("/results", { method: "POST", body: JSON.stringify(results) });
