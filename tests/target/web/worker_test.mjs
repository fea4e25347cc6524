// SPDX-License-Identifier: MIT
// Files that are dropped on the page, of both kinds; and in the browser's own worker a flipped bit of input changes the hash, which
// is otherwise that of node.

import { readFileSync } from "node:fs";
import { basename, join } from "node:path";
import { Bridge, instantiate } from "../../../port/platforms/web/page/bridge.js";
import { Engine } from "../../../port/platforms/web/page/engine.js";
import { check, open, root, says, serve, site, until, visit } from "./browser.mjs";

const kSamples = 250, kStepsPerSample = 8;
const kFlipAt = 100;

/** Of a hand that moves in a circle; one may have another last bit. */
function samples(flipAt) {
  const x = Float32Array.from({ length: kSamples }, (_, i) => 0.5 * Math.sin(i * 0.088));
  if (flipAt >= 0) new Uint32Array(x.buffer)[flipAt] ^= 1;
  return Array.from(x);
}

async function hashInNode(xs) {
  const bridge = new Bridge(await instantiate(readFileSync(join(site, "bridge.wasm"))));
  const engine = new Engine(bridge);
  engine.choose(0, "hand");
  engine.choose(1, "script:guard");
  engine.start(1);
  for (const x of xs) {
    engine.hand(0, x, -0.3, 0.2, 0);
    for (let i = 0; i < kStepsPerSample; i += 1) engine.step(); // Bound: kStepsPerSample
  }
  engine.recording();
  return [bridge.hash(), engine.state[0]];
}

/** The same by the worker of the page, with no page that takes part. */
const hashInWorker = (page, xs) => page.evaluate(([moves, steps]) => new Promise((resolve, reject) => {
  const worker = new Worker("worker.js", { type: "module" });
  const send = (task, more) => worker.postMessage({ task, ...more });
  worker.onerror = (event) => reject(new Error(event.message));
  worker.onmessage = ({ data }) => {
    if (data.kind === "problem") reject(new Error(data.text));
    if (data.kind === "saved") {
      worker.terminate();
      resolve([data.hash, data.steps]);
    }
    if (data.kind !== "ready") return;
    ["hand", "script:guard"].forEach((source, side) => send("choose", { side, source }));
    send("start", { paused: true, touches: 1 });
    for (const x of moves) {
      send("hand", { side: 0, x, y: -0.3, feet: 0.2, buttons: 0 });
      for (let i = 0; i < steps; i += 1) send("one"); // Bound: steps
    }
    send("save");
  };
  send("load", { url: new URL("bridge.wasm", location.href).href });
}), [xs, kStepsPerSample]);

async function flippedBit(page) {
  const [plain, flipped] = [samples(-1), samples(kFlipAt)];
  check(plain.filter((x, i) => x !== flipped[i]).length === 1, "one sample is another one");
  const here = `${await hashInWorker(page, plain)}`;
  check(here === `${await hashInWorker(page, plain)}`, "the same samples give the same hash");
  check(here === `${await hashInNode(plain)}`, `the hash in the browser is that in node: ${here}`);
  check(here.endsWith(`,${kSamples * kStepsPerSample}`), `all steps were made: ${here}`);
  const other = `${await hashInWorker(page, flipped)}`;
  check(other !== here, "one bit of one sample changes the hash");
  check(other === `${await hashInNode(flipped)}`, `and so it does in node: ${other}`);
  console.log(`in the browser's worker: ${here}; with one bit flipped: ${other}`);
}

/** @returns whether the page took what was dragged over it and dropped, instead of leaving it to the browser, which would go there */
const drop = (page, name, bytes) => page.evaluate(([file, text]) => {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], file));
  const events = ["dragover", "drop"].map((kind) => new DragEvent(kind, { dataTransfer, bubbles: true, cancelable: true }));
  const at = document.getElementById("salle");
  return events.every((event) => !at.dispatchEvent(event));
}, [name, bytes.toString("base64")]);

async function drops(page) {
  const events = join(root, "port/programs/recordings/default.events");
  check(await drop(page, basename(events), readFileSync(events)), "the page takes a device's recording");
  await says(page, /default.events moves the left stick/);
  check((await page.inputValue("#left")) === "recording", "the list says so");
  await until(page, "fencing");
  // Without its description the ranges are the counts that it told.
  const bare = readFileSync(events, "utf8").split("\n").filter((line) => line.startsWith("E:")).join("\n");
  check(await drop(page, "bare.events", Buffer.from(bare)), "the page takes one without a description");
  await says(page, /bare.events moves the left stick.*ranges are not known/);
  const engine = new Engine(new Bridge(await instantiate(readFileSync(join(site, "bridge.wasm")))));
  engine.choose(0, "script:attack");
  engine.choose(1, "script:guard");
  engine.start(1);
  while (engine.step()); // Bound: the bout
  check(await drop(page, "bout.batuta", Buffer.from(engine.recording())), "the page takes a bout");
  await says(page, /bout.batuta: \d+ steps, \d+ hashes agreed. The same bits here as there/);
  check((await page.textContent("#hash")).split(engine.bridge.hash()).length === 3, "both hashes are shown");
}

const server = await serve();
const browser = await open();
try {
  const { page, errors } = await visit(browser, server.url);
  await until(page, "fencing");
  await flippedBit(page);
  await drops(page);
  check(errors.length === 0, `the console says ${errors}`);
} finally {
  await browser.close();
  server.stop();
}
