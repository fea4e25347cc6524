// SPDX-License-Identifier: MIT
// A bout on a board whose line or answers are not as they should be, in plain node: it takes nothing any more, refuses without a
// reason, tells half a message. And one that is as it should be.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { Board, BoardError, compare, kBoardApart, kRow, openSerial, whyNotOnBoard } from "../../../port/platforms/web/page/board.js";
import { FrameReader, frame, kForce, kHello, kRefused, kReport, kStep, kWelcome } from "../../../port/platforms/web/page/link.js";
import { check, root } from "./browser.mjs";

const kLongestMs = 10000; // the page's patience with a line is 3 s
const kSteps = 20, kForceBytes = 13, kReportBytes = 54, kWelcomeBytes = 26, kRefusedBytes = 10;

/** What becomes of it: what it says, or that it never ends. */
function ending(promise, ms = kLongestMs) {
  const late = new Promise((resolve) => { setTimeout(resolve, ms, `nothing within ${ms} ms`); });
  const told = (error) => (error instanceof BoardError ? error.message : `${error}`);
  return Promise.race([promise.then(() => "it ends well", told), late]);
}

function payload(bytes, fill) {
  const view = new DataView(new ArrayBuffer(bytes));
  fill(view);
  return new Uint8Array(view.buffer);
}

/** A board that answers, by the fields of link.md. @param step  what it tells of one: frames */
function answering(step) {
  const reader = new FrameReader();
  const line = { onBytes: () => {}, session: 0, number: 0 };
  const tell = (type, bytes) => {
    const wire = frame(type, line.number, bytes);
    line.number += 1;
    setImmediate(() => line.onBytes(wire));
  };
  line.write = async (bytes) => {
    for (const { type, view } of reader.take(bytes)) {
      if (type === kHello) {
        line.session = view.getUint32(0, true);
        tell(kWelcome, payload(kWelcomeBytes, (told) => told.setUint32(0, line.session, true)));
      }
      if (type === kStep) step(view.getUint32(0, true), tell, line.session);
    }
  };
  return line;
}

const force = (number, side) => payload(kForceBytes, (view) => {
  view.setUint32(0, number, true);
  view.setUint8(4, side);
  view.setFloat32(5, number + side, true);
});

function madeStep(number, tell, session) {
  for (const side of [0, 1]) tell(kForce, force(number, side));
  tell(kReport, payload(kReportBytes, (view) => {
    view.setUint32(0, number, true);
    view.setUint8(4, 3);
    view.setUint16(50, session & 0xffff, true);
  }));
}

async function agrees() {
  const rows = Float32Array.from({ length: kRow * kSteps }, (_, i) => ({ 0: 1, 2: 2 })[i % kRow] ?? 0);
  for (let i = 0; i < kSteps; i += 1) for (const at of [0, 2]) rows[kRow * i + at] += i;
  const steps = Array.from({ length: kSteps }, () => [null, null]);
  check((await compare(new Board(answering(madeStep), 1), steps, rows, () => {})) === 0, "a board that does the same agrees");
  rows[kRow * 7] += 1;
  check((await compare(new Board(answering(madeStep), 1), steps, rows, () => {})) === 8, "one that parts is told");
  const short = (number, tell, session) => { // torn messages, and then whole ones
    for (const type of [kForce, kReport, kWelcome]) tell(type, force(number, 0).subarray(0, 4));
    tell(kWelcome, new Uint8Array(0));
    madeStep(number, tell, session);
  };
  check((await compare(new Board(answering(short), 1), steps.slice(0, 2), rows, () => {})) === 0, "half a message is none");
}

async function refusals() {
  const cases = [[new Uint8Array(0), "it tells no reason that this page knows"], [new Uint8Array(kRefusedBytes).fill(9), "it tells no reason that this page knows"],
    [new Uint8Array(kRefusedBytes).fill(2), "wrong step"]];
  for (const [bytes, why] of cases) {
    const told = await ending(compare(new Board(answering((_, tell) => tell(kRefused, bytes)), 1), [[null, null]], [], () => {}));
    check(told === `the board refuses step 1: ${why}`, `Refused of ${bytes.length} bytes: ${told}`);
  }
}

/** A port as Web Serial has it: an abort reaches a write that its board does not take. @param isDeaf  nor does that help */
function stuckPort(isDeaf) {
  const port = { isOpen: false, closed: 0 };
  port.open = async () => {
    port.isOpen = true;
    port.readable = new ReadableStream();
    let signal = null;
    port.writable = new WritableStream({
      start(controller) { signal = controller.signal; },
      write: () => new Promise((_, reject) => { if (!isDeaf) signal.addEventListener("abort", () => reject(new Error("aborted"))); }),
    });
  };
  port.close = async () => {
    if (port.readable.locked || port.writable.locked) throw new TypeError("Cannot cancel a locked stream");
    port.isOpen = false;
  };
  return port;
}

async function takesNothing() {
  for (const isDeaf of [false, true]) {
    const port = stuckPort(isDeaf);
    Object.defineProperty(globalThis, "navigator", { value: { serial: { requestPort: async () => port } }, configurable: true });
    const line = await openSerial();
    const told = await ending(new Board(line, 1).open());
    check(told === "its line takes nothing any more", told);
    check((await ending(line.close())) === "it ends well" && !port.isOpen, `the line is given back, deaf ${isDeaf}`);
  }
}

function distances() {
  const fencer = readFileSync(join(root, "include/batuta/fencing/fencer.hpp"), "utf8");
  check(Number(/Scalar distance = Scalar\(([\d.]+)\)/.exec(fencer)?.[1]) === kBoardApart, "a board's fencers are as far apart as the library's");
  check(whyNotOnBoard(kBoardApart) === "" && /cannot be compared/.test(whyNotOnBoard(4)), whyNotOnBoard(4));
}

distances();
await agrees();
await refusals();
await takesNothing();
console.log("a board that does not answer as it should is told");
process.exit(0);
