// node gltf_check.js VALIDATOR FILE.glb …: what the validator of Khronos finds; status 1 where that is an error or a warning.
// node gltf_check.js --FAULT FILE.glb PLANTED.glb: writes the file with a fault, see below.
const fs = require("fs");

// The JSON of a .glb, changed, as are the floats of an accessor by `floats(json, name, change)` and its indices; its length stays
// what it was or grows by spaces.
function changed(bytes, change) {
  const length = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.subarray(20, 20 + length).toString());
  const data = Buffer.from(bytes.subarray(20 + length));
  change(json, data.subarray(8));
  let text = Buffer.from(JSON.stringify(json));
  text = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, " ")]);
  const head = Buffer.from(bytes.subarray(0, 20));
  head.writeUInt32LE(text.length, 12);
  head.writeUInt32LE(bytes.length - length + text.length, 8);
  return Buffer.concat([head, text, data]);
}

// Of the first mesh of a stone, or else of the first.
function first(json) {
  const node = json.nodes.find((n) => n.extras?.kind.startsWith("stone")) ?? json.nodes.find((n) => n.mesh !== undefined);
  return json.meshes[node.mesh].primitives[0];
}
function scaled(json, data, accessor, factor) {
  const { bufferView, count, type } = json.accessors[accessor];
  const start = json.bufferViews[bufferView].byteOffset ?? 0;
  for (let i = 0; i < count * { VEC2: 2, VEC3: 3 }[type]; ++i) {
    data.writeFloatLE(factor * data.readFloatLE(start + 4 * i), start + 4 * i);
  }
  for (const bound of ["min", "max"]) {
    if (json.accessors[accessor][bound]) json.accessors[accessor][bound] = json.accessors[accessor][bound].map((v) => Math.fround(factor * v));
  }
}

const words = process.argv.slice(2);
const plants = {
  // A bound that is wrong by a little.
  "--plant": (json) => { json.accessors.find((a) => a.max).max[0] += 0.001; },
  "--metal": (json) => { for (const m of json.materials) m.pbrMetallicRoughness.metallicFactor = 1; },
  // The triangles of a mesh turned inside out.
  "--wound": (json, data) => {
    const { bufferView, count, componentType } = json.accessors[first(json).indices];
    const start = json.bufferViews[bufferView].byteOffset ?? 0;
    const size = componentType === 5123 ? 2 : 4;
    for (let i = 0; i < count; i += 3) {
      const [a, b] = [start + size * (i + 1), start + size * (i + 2)];
      const kept = Buffer.from(data.subarray(a, a + size));
      data.copy(data, a, b, b + size);
      kept.copy(data, b);
    }
  },
  // The texture of a mesh larger by a tenth than that of the others.
  "--uv": (json, data) => { scaled(json, data, first(json).attributes.TEXCOORD_0, 1.1); },
  // Millimetres.
  "--unit": (json, data) => {
    const positions = new Set(json.meshes.flatMap((mesh) => mesh.primitives.map((p) => p.attributes.POSITION)));
    for (const accessor of positions) scaled(json, data, accessor, 1000);
    for (const node of json.nodes) if (node.translation) node.translation = node.translation.map((v) => 1000 * v);
  },
};
if (plants[words[0]]) {
  fs.writeFileSync(words[2], changed(fs.readFileSync(words[1]), plants[words[0]]));
  process.exit(0);
}
const validator = require(words[0]);
(async () => {
  let wrong = 0;
  for (const file of words.slice(1)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), { maxIssues: 50, ignoredIssues: ["UNUSED_OBJECT"] });
    const { numErrors, numWarnings, messages } = report.issues;
    console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${report.info?.totalTriangleCount} triangles`);
    if (numErrors + numWarnings === 0) continue;
    ++wrong;
    for (const message of messages) console.log(`  ${message.code} ${message.pointer}: ${message.message}`);
  }
  process.exit(wrong > 0 ? 1 : 0);
})();
