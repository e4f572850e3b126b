// node three_check.js NODE_MODULES JOB…: three.js in a headless Chromium loads files of glTF; JOB is FILE.glb:WIDTH:HEIGHT:KIND,
// with how wide and how high in metres its things are, and one of their kinds. A job that begins with ! must be found wrong.
const fs = require("fs");
const http = require("http");
const os = require("os");
const path = require("path");
const { spawn } = require("child_process");

const modules = process.argv[2];
const jobs = process.argv.slice(3).map((text) => {
  const wrong = text.startsWith("!");
  const [file, width, height, kind] = (wrong ? text.slice(1) : text).split(":");
  return { wrong, file, width: Number(width), height: Number(height), kind };
});

const html = `<!doctype html><script type="importmap">{"imports": {"three": "/three/build/three.module.js",
"three/addons/": "/three/examples/jsm/"}}</script><script type="module" src="/page.js"></script>`;

// What is wrong with what was found of a job; nothing: "".
function fault(job, found) {
  const near = (a, b) => Math.abs(a - b) < 0.02 * b + 0.002;
  if (found.error) return found.error;
  if (found.metal !== 0) return `metalness 0 expected, got ${found.metal}`;
  if (!found.kinds[job.kind]) return `things of the kind ${job.kind} expected, got ${JSON.stringify(found.kinds)}`;
  if (!near(found.size[0], job.width)) return `${job.width} m wide expected, got ${found.size[0]}`;
  const up = found.kinds.stone ? found.size[2] : found.size[1];
  if (!near(up, job.height)) return `${job.height} m high expected, got ${up}`;
  if (found.turned > 0.02) return `triangles that look out expected, got a part of ${found.turned} that does not`;
  if (found.kinds.stone) {
    if (found.textured === 0) return "stones with textures expected, got none";
    if (found.off > 0.06) return `textures of one scale on a stone expected, got a part of ${found.off} with others`;
    if (found.scales[1] > 1.01 * found.scales[0]) return `one scale of textures expected, got ${found.scales}`;
  } else if (found.transmissive === 0) {
    return "glass that lets light through expected, got none";
  }
  if (found.lit < 100) return `a picture of it expected, got ${found.lit} pixels of 10000`;
  return "";
}

const profile = fs.mkdtempSync(path.join(os.tmpdir(), "three-"));
let browser;
function end(status) {
  clearTimeout(limit);
  browser.once("exit", () => { fs.rmSync(profile, { recursive: true, force: true, maxRetries: 20, retryDelay: 50 }); process.exit(status); });
  browser.kill("SIGKILL");
}
const limit = setTimeout(() => { console.log("three.js told nothing within five minutes"); end(1); }, 300000);

const server = http.createServer((request, response) => {
  const send = (type, body) => { response.writeHead(200, { "Content-Type": type }); response.end(body); };
  const url = new URL(request.url, "http://localhost").pathname;
  if (url === "/") return send("text/html", html);
  if (url === "/page.js") return send("text/javascript", fs.readFileSync(path.join(__dirname, "three_page.js")));
  if (url === "/jobs") return send("application/json", JSON.stringify(jobs.map((_, i) => `/job/${i}.glb`)));
  if (url.startsWith("/job/")) return send("model/gltf-binary", fs.readFileSync(jobs[parseInt(url.slice(5))].file));
  if (url.startsWith("/three/") && !url.includes("..")) {
    return send("text/javascript", fs.readFileSync(path.join(modules, url.slice(1))));
  }
  if (url !== "/results") { response.writeHead(404); return response.end(); }
  let text = "";
  request.on("data", (part) => { text += part; });
  request.on("end", () => {
    send("text/plain", "");
    let wrong = 0;
    JSON.parse(text).forEach((found, i) => {
      const what = fault(jobs[i], found);
      const well = jobs[i].wrong === (what !== "");
      console.log(`${path.basename(jobs[i].file)}: ${what || "as it should be"}${well ? "" : " (unexpected)"}`);
      if (!well) ++wrong;
    });
    end(wrong === 0 ? 0 : 1);
  });
});
server.listen(0, "127.0.0.1", () => {
  browser = spawn("chromium", ["--headless", "--no-sandbox", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", `--user-data-dir=${profile}`,
    `http://127.0.0.1:${server.address().port}/`], { stdio: "ignore" });
});
