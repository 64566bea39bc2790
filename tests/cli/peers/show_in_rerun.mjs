// Opens a run in Rerun's web viewer in Chromium: show_in_rerun.mjs RUN.mcap PICTURE.png MOST_SECONDS.
// Prints what the viewer says, a line each, until it has read all; ./dev peers gets the viewer.
import { spawn } from "node:child_process";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { createReadStream, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [run, picture, seconds] = process.argv.slice(2);
const viewer = join(process.env.NODE_PATH, "@rerun-io/web-viewer");
const page = (port) => `<body style="margin:0"><div id="v"></div><script type="module">
import {WebViewer} from "./viewer/index.js";
await new WebViewer().start("http://127.0.0.1:${port}/run.mcap", document.getElementById("v"),
  {width: "1600px", height: "900px", hide_welcome_screen: true, render_backend: "webgl"});
</script></body>`;
const kinds = { js: "text/javascript", wasm: "application/wasm" };

const server = createServer((request, response) => {
  const path = request.url.split("?")[0];
  if (path === "/") return response.writeHead(200, { "content-type": "text/html" }).end(page(server.address().port));
  let file = path === "/run.mcap" ? run : join(viewer, path.replace("/viewer/", ""));
  if (!existsSync(file)) file += ".js";
  if (!existsSync(file)) return response.writeHead(404).end();
  response.writeHead(200, { "content-type": kinds[file.split(".").pop()] ?? "application/octet-stream" });
  createReadStream(file).pipe(response);
});
await new Promise((listens) => server.listen(0, "127.0.0.1", listens));

const profile = mkdtempSync(join(tmpdir(), "handmap-rerun-"));
const browser = spawn("chromium", ["--headless", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader", "--window-size=1600,900", "--remote-debugging-port=0", "--remote-allow-origins=*",
  `--user-data-dir=${profile}`, `http://127.0.0.1:${server.address().port}/`], { stdio: "ignore" });
const pause = (ms) => new Promise((done) => setTimeout(done, ms));
const portFile = join(profile, "DevToolsActivePort");
while (!existsSync(portFile)) await pause(100);
const port = readFileSync(portFile, "utf8").split("\n")[0];
let tab;
while (!(tab = (await (await fetch(`http://127.0.0.1:${port}/json`)).json()).find((t) => t.type === "page"))) await pause(100);

const WebSocket = createRequire(join(process.env.NODE_PATH, "."))("ws");
const socket = new WebSocket(tab.webSocketDebuggerUrl);
await new Promise((opens) => (socket.onopen = opens));
const answers = new Map();
let has_read = false;
socket.onmessage = ({ data }) => {
  const message = JSON.parse(data);
  if (message.method === "Runtime.consoleAPICalled") {
    const line = message.params.args.map((a) => a.value ?? a.description).join(" ").split("\n")[0];
    has_read ||= line.includes("run.mcap has finished");
    if (!/^(DEBUG|TRACE)/.test(line) || line.includes("has finished")) console.log(line);
  }
  answers.get(message.id)?.(message.result);
};
let last = 0;
const ask = (method, params = {}) =>
  new Promise((answer) => {
    answers.set(++last, answer);
    socket.send(JSON.stringify({ id: last, method, params }));
  });
await ask("Runtime.enable");
for (let s = 0; s < seconds && !has_read; ++s) await pause(1000);
await pause(5000);  // to draw it
writeFileSync(picture, Buffer.from((await ask("Page.captureScreenshot")).data, "base64"));
socket.close();
const gone = new Promise((exits) => browser.on("exit", exits));
browser.kill();
await gone;
server.close();
server.closeAllConnections();
rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
