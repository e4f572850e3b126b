// A binary glTF as this program writes it, read into few large meshes: bodies that share a mesh become instances, all others of a
// material one mesh. A pavement of thousands of stones is then drawn with a handful of calls.
import * as THREE from "./three.js";

const ARRAYS = { 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };
const WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

function chunks(buffer) {
  const words = new DataView(buffer);
  if (words.getUint32(0, true) !== 0x46546c67) throw new Error("the bodies are no glTF");
  const length = words.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 20, length)));
  return { json, at: 20 + length + 8 };
}

class Reader {
  constructor(buffer, pictures) {
    this.buffer = buffer;
    this.pictures = pictures;
    const { json, at } = chunks(buffer);
    this.json = json;
    this.at = at;
  }

  values(index) {
    const accessor = this.json.accessors[index];
    const view = this.json.bufferViews[accessor.bufferView];
    const offset = this.at + (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    return new ARRAYS[accessor.componentType](this.buffer, offset, accessor.count * WIDTHS[accessor.type]);
  }

  texture(info, space) {
    if (!info) return null;
    const image = this.json.images[this.json.textures[info.index].source];
    const view = this.json.bufferViews[image.bufferView];
    const bytes = new Uint8Array(this.buffer, this.at + (view.byteOffset ?? 0), view.byteLength);
    return this.pictures.texture(bytes, image.mimeType, space);
  }

  material(index) {
    return this.pictures.material(JSON.stringify([this.json.materials[index], this.textures_of(index)]), () => this.made(index));
  }

  // What tells two materials of one description apart.
  textures_of(index) {
    const pbr = this.json.materials[index].pbrMetallicRoughness ?? {};
    return [this.texture(pbr.baseColorTexture, THREE.SRGBColorSpace), this.texture(this.json.materials[index].normalTexture, THREE.NoColorSpace),
      this.texture(pbr.metallicRoughnessTexture, THREE.NoColorSpace)].map((texture) => texture?.uuid);
  }

  made(index) {
    const given = this.json.materials[index];
    const pbr = given.pbrMetallicRoughness ?? {};
    const colour = new THREE.Color().fromArray(pbr.baseColorFactor ?? [1, 1, 1]);
    const roughness = pbr.roughnessFactor ?? 1;
    const extensions = given.extensions ?? {};
    if (extensions.KHR_materials_transmission) return glass(given.name, roughness, extensions);
    return new THREE.MeshStandardMaterial({
      name: given.name, color: colour, roughness, metalness: 0,
      map: this.texture(pbr.baseColorTexture, THREE.SRGBColorSpace),
      normalMap: this.texture(given.normalTexture, THREE.NoColorSpace),
      roughnessMap: this.texture(pbr.metallicRoughnessTexture, THREE.NoColorSpace),
    });
  }
}

// Faces let light through. Walls of cracks do so too, but a rasteriser shows one layer of such things alone: so cracks are what they
// look like from afar, pale lines that catch the light.
function glass(name, roughness, extensions) {
  const volume = extensions.KHR_materials_volume ?? {};
  if (/broken|crushed/.test(name)) {
    return new THREE.MeshPhysicalMaterial({
      name, color: /crushed/.test(name) ? 0xf2f5f4 : 0xd3e2de, roughness: Math.max(roughness, 0.25), metalness: 0,
      clearcoat: 0.6, clearcoatRoughness: 0.2, envMapIntensity: 1.35, side: THREE.DoubleSide,
    });
  }
  return new THREE.MeshPhysicalMaterial({
    name, color: 0xffffff, roughness, metalness: 0, transmission: 1, ior: extensions.KHR_materials_ior?.ior ?? 1.5,
    thickness: volume.thicknessFactor ?? 0, attenuationDistance: volume.attenuationDistance ?? Infinity,
    attenuationColor: new THREE.Color().fromArray(volume.attenuationColor ?? [1, 1, 1]), specularIntensity: 1,
    envMapIntensity: 1.1, userData: { is_clear: true, is_bent: true },
  });
}

// Textures by what they show, and materials by what is said of them, so that those of the versions before serve again: to make what
// a graphics card runs for a material takes longer than all else.
const VERSIONS_KEPT = 4;
export class Pictures {
  constructor(ready) {
    this.known = new Map();
    this.ready = ready;
    this.version = 0;
    this.materials = new Map();
  }
  material(key, make) {
    if (!this.materials.has(key)) this.materials.set(key, { thing: make(), version: 0 });
    const entry = this.materials.get(key);
    entry.version = this.version;
    return entry.thing;
  }
  texture(bytes, type, space) {
    let sum = bytes.length;
    for (let i = 0; i < bytes.length; i += 97) sum = (Math.imul(sum, 31) + bytes[i]) | 0;
    const key = `${bytes.length}:${sum}:${space}`;
    if (this.known.has(key)) {
      this.known.get(key).version = this.version;
      return this.known.get(key).thing;
    }
    const texture = new THREE.Texture();
    texture.colorSpace = space;
    texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
    texture.flipY = false;
    texture.anisotropy = 4;
    this.known.set(key, { thing: texture, version: this.version });
    createImageBitmap(new Blob([bytes], { type }), { colorSpaceConversion: "none" }).then((image) => {
      texture.image = image;
      texture.needsUpdate = true;
      this.ready();
    });
    return texture;
  }
  // The next version begins.
  step() {
    ++this.version;
    for (const things of [this.known, this.materials]) {
      for (const [key, { thing, version }] of things) {
        if (version > this.version - VERSIONS_KEPT) continue;
        thing.dispose();
        things.delete(key);
      }
    }
  }
}

function matrix(node) {
  const made = new THREE.Matrix4();
  return made.compose(new THREE.Vector3().fromArray(node.translation ?? [0, 0, 0]),
    new THREE.Quaternion().fromArray(node.rotation ?? [0, 0, 0, 1]), new THREE.Vector3(1, 1, 1));
}

// Every mesh with the places where it stands.
function placed(json) {
  const places = new Map();
  const visit = (index, outer) => {
    const node = json.nodes[index];
    const own = outer.clone().multiply(matrix(node));
    if (node.mesh !== undefined) {
      if (!places.has(node.mesh)) places.set(node.mesh, []);
      places.get(node.mesh).push(own);
    }
    for (const child of node.children ?? []) visit(child, own);
  };
  for (const index of json.scenes[json.scene ?? 0].nodes) visit(index, new THREE.Matrix4());
  return places;
}

// All parts of one material, moved to where they stand.
function merged(reader, parts) {
  let points = 0, corners = 0;
  for (const { primitive } of parts) {
    points += reader.json.accessors[primitive.attributes.POSITION].count;
    corners += reader.json.accessors[primitive.indices].count;
  }
  const position = new Float32Array(3 * points), normal = new Float32Array(3 * points), uv = new Float32Array(2 * points);
  const index = new Uint32Array(corners);
  let point = 0, corner = 0;
  for (const { primitive, place } of parts) {
    const e = place.elements;
    const from = reader.values(primitive.attributes.POSITION), turned = reader.values(primitive.attributes.NORMAL);
    const count = from.length / 3;
    for (let i = 0, o = 3 * point; i < from.length; i += 3, o += 3) {
      const x = from[i], y = from[i + 1], z = from[i + 2], u = turned[i], v = turned[i + 1], w = turned[i + 2];
      position[o] = e[0] * x + e[4] * y + e[8] * z + e[12];
      position[o + 1] = e[1] * x + e[5] * y + e[9] * z + e[13];
      position[o + 2] = e[2] * x + e[6] * y + e[10] * z + e[14];
      normal[o] = e[0] * u + e[4] * v + e[8] * w;
      normal[o + 1] = e[1] * u + e[5] * v + e[9] * w;
      normal[o + 2] = e[2] * u + e[6] * v + e[10] * w;
    }
    if (primitive.attributes.TEXCOORD_0 !== undefined) uv.set(reader.values(primitive.attributes.TEXCOORD_0), 2 * point);
    const corners_ = reader.values(primitive.indices);
    for (let i = 0; i < corners_.length; ++i) index[corner + i] = corners_[i] + point;
    point += count;
    corner += corners_.length;
  }
  return geometry(position, normal, uv, index);
}

function geometry(position, normal, uv, index) {
  const made = new THREE.BufferGeometry();
  made.setAttribute("position", new THREE.BufferAttribute(position, 3));
  made.setAttribute("normal", new THREE.BufferAttribute(normal, 3));
  if (uv) made.setAttribute("uv", new THREE.BufferAttribute(uv, 2));
  made.setIndex(new THREE.BufferAttribute(index, 1));
  return made;
}

// The bodies of a file, as a group.
export function bodies(buffer, pictures) {
  pictures.step();
  const reader = new Reader(buffer, pictures);
  const group = new THREE.Group();
  const materials = new Map();
  const material = (index) => {
    if (!materials.has(index)) materials.set(index, reader.material(index));
    return materials.get(index);
  };
  const apart = new Map();
  for (const [mesh, places] of placed(reader.json)) {
    for (const primitive of reader.json.meshes[mesh].primitives) {
      if (places.length < 8) {
        if (!apart.has(primitive.material)) apart.set(primitive.material, []);
        for (const place of places) apart.get(primitive.material).push({ primitive, place });
        continue;
      }
      const attribute = (name) => primitive.attributes[name] === undefined ? null : reader.values(primitive.attributes[name]);
      const made = geometry(attribute("POSITION"), attribute("NORMAL"), attribute("TEXCOORD_0"), reader.values(primitive.indices));
      const many = new THREE.InstancedMesh(made, material(primitive.material), places.length);
      places.forEach((place, i) => many.setMatrixAt(i, place));
      group.add(many);
    }
  }
  for (const [index, parts] of apart) group.add(new THREE.Mesh(merged(reader, parts), material(index)));
  return group;
}

// Materials stay (Pictures).
export function dispose(group) {
  group.traverse((part) => {
    if (!part.isMesh) return;
    part.geometry.dispose();
    if (part.isInstancedMesh) part.dispose();
  });
}
