// SPDX-License-Identifier: MIT
// The page's end of the serial link: its frames are those of link.md, and the fencing firmware in the emulator makes the same
// steps as the page. Exit status 77: there is no firmware (cmake --workflow --preset cortex-m4f) or no emulator.

import { spawn } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:net";
import { join } from "node:path";
import { Board, compare, kRow, stepsOf } from "../../../port/platforms/web/page/board.js";
import { Bridge, instantiate } from "../../../port/platforms/web/page/bridge.js";
import { Engine } from "../../../port/platforms/web/page/engine.js";
import { FrameReader, frame, kStep, step } from "../../../port/platforms/web/page/link.js";
import { check, folder, root, site } from "./browser.mjs";

const kSkipped = 77;
const kSteps = 300, kTouches = 3;
const firmware = process.env.BATUTA_FIRMWARE ?? join(root, "build/target/cortex-m4f/batuta-fencing.elf");
const kMachine = "mps2-an386";

/** The example of link.md, there and back, and what becomes of damage. */
function frames() {
  const page = readFileSync(join(root, "port/shared/link/link.md"), "utf8");
  const [before, wire] = [...page.matchAll(/^ {4}((?:[0-9a-f]{2} ?)+)$/gm)].map((match) => match[1].trim());
  const sample = { time: 2000, x: 0.5, y: -0.25, feetX: 0, feetY: 0, buttons: 1, sequence: 2 };
  const made = frame(kStep, 7, step(3, [sample, null]));
  const hex = (bytes) => Buffer.from(bytes).toString("hex").replace(/(..)(?!$)/g, "$1 ");
  check(hex(made) === wire, `the frame of link.md: ${hex(made)}`);
  const reader = new FrameReader();
  const [message] = reader.take(made);
  check(message.type === kStep && message.number === 7 && before.includes(hex(new Uint8Array(message.view.buffer, 4, message.view.byteLength))), "and back");
  const bent = made.slice();
  bent[4] ^= 4;
  check(reader.take(bent).length === 0 && reader.damaged === 1, "a bent frame is damaged");
  check(reader.take(made).length === 1, "the next one is whole");
  check(reader.take(Uint8Array.from([0, ...new Array(500).fill(9), 0])).length === 0, "what is too long is dropped");
}

async function emulated() {
  const path = join(folder, "uart");
  const line = { onBytes: () => {}, write: async () => {} };
  const server = createServer((socket) => {
    socket.on("data", (bytes) => line.onBytes(bytes));
    socket.on("error", () => {});
    line.write = async (bytes) => socket.write(bytes);
  });
  await new Promise((ready) => server.listen(path, ready));
  const emulator = spawn("sh", [join(root, "toolchains/emulate.sh"), kMachine, firmware], { env: { ...process.env, BATUTA_QEMU_OPTIONS: `-serial unix:${path}` }, stdio: "inherit" });
  return { line, stop: () => { emulator.kill(); server.close(); } };
}

function bout() {
  const engine = new Engine(new Bridge(readModule));
  engine.choose(0, "hand");
  engine.choose(1, "script:parry");
  engine.start(kTouches);
  for (let i = 0; i < kSteps; i += 1) { // Bound: kSteps
    engine.hand(0, Math.sin(i / 40), 0.3, 0.7, 0);
    engine.step();
  }
  const bytes = engine.recording();
  return { steps: stepsOf(bytes), expected: engine.expected(bytes) };
}

frames();
const readModule = await instantiate(readFileSync(join(site, "bridge.wasm")));
const { steps, expected } = bout();
check(steps.length === kSteps && expected.length === kRow * kSteps && steps.every(([left, right]) => left && right), "each step has both samples");
if (!existsSync(firmware) || !existsSync("/usr/bin/qemu-system-arm")) {
  console.log(`the frames are those of link.md; (Skipped) no firmware at ${firmware}, or no emulator`);
  process.exit(kSkipped);
}
const { line, stop } = await emulated();
try {
  const differs = await compare(new Board(line, kTouches), steps, expected, () => {});
  check(differs === 0, `the board parts in step ${differs}`);
  const bent = expected.slice();
  bent[kRow * 200] += 1e-7;
  check((await compare(new Board(line, kTouches), steps, bent, () => {})) === 201, "a force with another last bit is found");
  console.log(`the firmware makes the same ${kSteps} steps`);
} finally {
  stop();
}
