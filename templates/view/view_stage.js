// The picture: camera, light, and when it is drawn. It is drawn when something has changed, not all the time; while things change,
// with fewer pixels where the machine is slow.
import * as THREE from "./three.js";
import { OrbitControls } from "./OrbitControls.js";
import { RoomEnvironment } from "./RoomEnvironment.js";
import { bodies, dispose, Pictures } from "./bodies.js";

const GROUND = 0x15171a;
const SLOW_MS = 45;  // a drawing that takes longer gets fewer pixels while the view moves; by eye
const REST_MS = 250;
const LONGEST_MS = 600;  // of a drawing when all is at rest: so long nothing answers

// Of the pixels of a side, so that a drawing takes so long.
const share = (wanted_ms, cost_ms) => Math.min(1, Math.max(0.35, Math.sqrt(wanted_ms / cost_ms)));

// Without a graphics card smooth edges cost more than all else.
function is_software() {
  const gl = document.createElement("canvas").getContext("webgl2");
  const info = gl?.getExtension("WEBGL_debug_renderer_info");
  return info ? /swiftshader|llvmpipe|softpipe|software/i.test(gl.getParameter(info.UNMASKED_RENDERER_WEBGL)) : false;
}

export class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !is_software(), powerPreference: "high-performance" });
    this.renderer.toneMapping = THREE.ACESFilmicToneMapping;
    this.renderer.toneMappingExposure = 0.95;
    this.scene = new THREE.Scene();
    this.scene.background = backdrop();
    const filter = new THREE.PMREMGenerator(this.renderer);
    this.scene.environment = filter.fromScene(new RoomEnvironment(this.renderer), 0.03).texture;
    filter.dispose();
    this.sun = new THREE.DirectionalLight(0xfff4e4, 1.6);
    this.scene.add(this.sun, this.sun.target);
    this.camera = new THREE.PerspectiveCamera(36, 1, 0.01, 1000);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.pictures = new Pictures(() => this.draw());
    this.group = null;
    this.gone = [];
    this.cost = { rest: 0, quick: 4 * SLOW_MS };  // of a drawing with all pixels, ms
    this.ratio = 1;
    this.asked = false;
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0) return;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.width = width;
    this.height = height;
    this.draw();
  }

  // Shows the bodies in place of those before; the camera stays, but for the first. Resolves when they have been drawn.
  show(buffer) {
    const begin = performance.now();
    const next = bodies(buffer, this.pictures);
    this.canvas.dataset.read = (performance.now() - begin).toFixed(1);
    const is_first = this.group === null;
    if (this.group) this.scene.remove(this.group);
    this.gone.push(...(this.group ? [this.group] : []));
    this.group = next;
    this.scene.add(next);
    this.box = new THREE.Box3().setFromObject(next);
    if (is_first) this.frame();
    return new Promise((resolve) => {
      this.drawn = resolve;
      this.draw();
    });
  }

  // All of it in the picture: what stands upright from the front, what lies from above.
  frame() {
    if (!this.box || this.box.isEmpty()) return;
    const size = this.box.getSize(new THREE.Vector3());
    const centre = this.box.getCenter(new THREE.Vector3());
    const lies = size.y < 0.25 * Math.max(size.x, size.z);
    const from = lies ? new THREE.Vector3(0.35, 0.85, 0.75) : new THREE.Vector3(0.32, 0.14, 1);
    const radius = 0.5 * size.length();
    const half = 0.5 * THREE.MathUtils.degToRad(this.camera.fov);
    const narrow = Math.min(half, Math.atan(Math.tan(half) * this.camera.aspect));
    const far = 0.92 * radius / Math.sin(narrow);
    this.camera.near = far / 200;
    this.camera.far = far * 50;
    this.camera.updateProjectionMatrix();
    this.camera.position.copy(centre).addScaledVector(from.normalize(), far);
    this.controls.target.copy(centre);
    this.sun.target.position.copy(centre);
    this.sun.position.copy(centre).add(new THREE.Vector3(-0.9, 0.75, 0.55).multiplyScalar(3 * radius));
    this.controls.update();
    this.draw();
  }

  // By the keyboard: angles in radians, a factor of the distance.
  turn(across, up) {
    const from = this.camera.position.clone().sub(this.controls.target);
    const at = new THREE.Spherical().setFromVector3(from);
    at.theta += across;
    at.phi = THREE.MathUtils.clamp(at.phi + up, 0.02, Math.PI - 0.02);
    this.camera.position.copy(this.controls.target).add(from.setFromSpherical(at));
    this.controls.update();
    this.draw();
  }
  move(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
    this.draw();
  }

  draw() {
    clearTimeout(this.rest);
    const is_slow = this.cost.rest > SLOW_MS;
    if (is_slow) this.rest = setTimeout(() => this.come_to_rest(), REST_MS);
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      if (is_slow) this.render(share(SLOW_MS, this.cost.quick), false);
      else this.render(1, true);
    });
  }

  // With as many pixels as come in a moment; more where it turns out to be quicker than was thought.
  come_to_rest() {
    const part = share(LONGEST_MS, this.cost.rest);
    this.render(part, true);
    if (share(LONGEST_MS, this.cost.rest) > 1.3 * part) this.rest = setTimeout(() => this.come_to_rest(), REST_MS);
  }

  // What glass bends takes a second drawing of all that is behind it: while the picture changes on a slow machine it does not bend.
  see_through(is_bent) {
    this.group?.traverse(({ material }) => {
      if (!material?.userData.is_clear || material.userData.is_bent === is_bent) return;
      material.userData.is_bent = is_bent;
      material.transmission = is_bent ? 1 : 0;
      material.transparent = !is_bent;
      material.opacity = is_bent ? 1 : 0.16;
      material.depthWrite = is_bent;
      material.needsUpdate = true;
    });
  }

  render(part, is_final) {
    const ratio = part * Math.min(window.devicePixelRatio, 2);
    if (this.ratio !== ratio || this.size !== `${this.width}x${this.height}`) {
      this.ratio = ratio;
      this.size = `${this.width}x${this.height}`;
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(this.width, this.height, false);
    }
    this.see_through(is_final);
    const begin = performance.now();
    this.renderer.render(this.scene, this.camera);
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));  // until it has been drawn
    const took = performance.now() - begin;
    this.canvas.dataset.draw = `${took.toFixed(1)} ${part.toFixed(2)}`;
    this.cost[is_final ? "rest" : "quick"] = took / (part * part);
    this.canvas.dataset.camera = this.camera.position.toArray().map((x) => x.toFixed(5)).join(" ");
    for (const group of this.gone) dispose(group);
    this.gone = [];
    this.drawn?.();
    this.drawn = null;
  }
}

// Lighter in the middle, so that edges of glass have something to stand against.
function backdrop() {
  const picture = document.createElement("canvas");
  picture.width = picture.height = 256;
  const pen = picture.getContext("2d");
  const light = pen.createRadialGradient(128, 112, 10, 128, 128, 190);
  light.addColorStop(0, "#474e55");
  light.addColorStop(0.55, "#2a2e33");
  light.addColorStop(1, `#${GROUND.toString(16)}`);
  pen.fillStyle = light;
  pen.fillRect(0, 0, 256, 256);
  const texture = new THREE.CanvasTexture(picture);
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}
