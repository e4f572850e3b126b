// node gltf_check.js VALIDATOR FILE.glb …: what the validator of Khronos finds; status 1 where that is an error or a warning.
// With --plant or --metal before: writes FILE.glb to a second name with a wrong bound, or with metallic materials.
const fs = require("fs");

// The JSON of a .glb, changed; its length stays what it was or grows by spaces.
function changed(bytes, change) {
  const length = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.subarray(20, 20 + length).toString());
  change(json);
  let text = Buffer.from(JSON.stringify(json));
  text = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, " ")]);
  const head = Buffer.from(bytes.subarray(0, 20));
  head.writeUInt32LE(text.length, 12);
  head.writeUInt32LE(bytes.length - length + text.length, 8);
  return Buffer.concat([head, text, bytes.subarray(20 + length)]);
}

const words = process.argv.slice(2);
const plants = {
  "--plant": (json) => { json.accessors.find((a) => a.max).max[0] += 0.001; },
  "--metal": (json) => { for (const m of json.materials) m.pbrMetallicRoughness.metallicFactor = 1; },
};
if (plants[words[0]]) {
  fs.writeFileSync(words[3], changed(fs.readFileSync(words[2]), plants[words[0]]));
  process.exit(0);
}
const validator = require(words[0]);
(async () => {
  let wrong = 0;
  for (const file of words.slice(1)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), { maxIssues: 5, ignoredIssues: ["UNUSED_OBJECT"] });
    const { numErrors, numWarnings, messages } = report.issues;
    console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${report.info.totalTriangleCount} triangles`);
    if (numErrors + numWarnings === 0) continue;
    ++wrong;
    for (const message of messages) console.log(`  ${message.code} ${message.pointer}: ${message.message}`);
  }
  process.exit(wrong > 0 ? 1 : 0);
})();
