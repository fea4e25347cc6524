// SPDX-License-Identifier: MIT
// A board at a serial line, in a paced session of port/shared/link/link.md: it makes the steps of a bout that was fenced here, and
// what it tells of each is compared with what was computed here.

import { FrameReader, frame, hello, kForce, kHello, kRefused, kReport, kSample, kStep, kWelcome, sampleAt, step } from "./link.js";

const kPatienceMs = 250, kTries = 12;
// For so long a line may take nothing, and a port may take to close: what has not ended by then never does.
const kLongestMs = kTries * kPatienceMs;
// How far apart a board's fencers are on guard, m: Salle::distance (fencing/fencer.hpp). No Hello tells it.
export const kBoardApart = 2.25;
// Bytes of a payload that are read here, at least; a message with fewer is none.
const kLeastBytes = new Map([[kWelcome, 4], [kForce, 13], [kReport, 52]]), kLeastOfOthers = 5;
const kWhyRefused = ["no session", "wrong mode", "wrong step", "the bout is over", "not ready"];

export const kRow = 8; // numbers of a step that are compared

export class BoardError extends Error {}

/** Why a board cannot make a bout, or nothing. @param apart  how far apart its fencers began, m */
export function whyNotOnBoard(apart) {
  if (apart === kBoardApart) return "";
  return `The fencers of this bout began ${apart} m apart, as those who see do; a board has its own ${kBoardApart} m: it cannot be compared.`;
}

/** Waits for the end of something, but no longer than the longest. What it fails with is thrown. @returns whether it has ended */
async function endsInTime(promise) {
  let timer = null;
  const late = new Promise((resolve) => {
    timer = setTimeout(resolve, kLongestMs, false);
  });
  try {
    return await Promise.race([promise.then(() => true), late]);
  } finally {
    clearTimeout(timer);
  }
}

function whyRefused(view) {
  const why = view.byteLength > 0 ? kWhyRefused[view.getUint8(0)] : undefined;
  return why ?? "it tells no reason that this page knows";
}

const isWhole = ({ type, view }) => view.byteLength >= (kLeastBytes.get(type) ?? kLeastOfOthers);

/** The samples of every step of a recording (src/record/recorder.md). */
export function stepsOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const kSnapshotHead = 20, kSum = 4, kHead = 3;
  const steps = [];
  let at = kSnapshotHead + view.getUint32(16, true) + kSum;
  while (at + kHead <= bytes.length) { // Bound: the recording
    const size = view.getUint16(at + 1, true);
    if (String.fromCharCode(bytes[at]) === "S") steps.push(samplesAt(view, at + kHead));
    at += kHead + size + kSum;
  }
  return steps;
}

function samplesAt(view, body) {
  let at = body + 4 + 2;
  return [0, 1].map((side) => {
    if (view.getUint8(body + 4 + side) === 0) return null;
    const sample = sampleAt(view, at);
    at += kSample;
    return sample;
  });
}

export class Board {
  /** @param line  {write(bytes), onBytes}: onBytes is set here, and called with what comes. @param touches  of its bout */
  constructor(line, touches) {
    this.line = line;
    this.touches = touches;
    this.reader = new FrameReader();
    this.number = 0;
    this.wake = () => {};
    this.inbox = [];
    line.onBytes = (bytes) => {
      this.inbox.push(...this.reader.take(bytes));
      this.wake();
    };
  }

  async send(type, payload) {
    const isTaken = await endsInTime(this.line.write(frame(type, this.number, payload)));
    if (!isTaken) throw new BoardError("its line takes nothing any more");
    this.number += 1;
  }

  /** The next message until `end`, or null. What comes may be a part of one; and a board that is alone never ceases to tell. */
  async next(end) {
    if (performance.now() >= end) return null;
    while (this.inbox.length === 0 && performance.now() < end) { // Bound: the patience
      await new Promise((resolve) => {
        const timer = setTimeout(resolve, end - performance.now());
        this.wake = () => {
          clearTimeout(timer);
          resolve();
        };
      });
    }
    this.wake = () => {};
    return this.inbox.shift() ?? null;
  }

  async open() {
    this.session = (1 + Math.floor(Math.random() * 0xfffe) + 0x10000 * Math.floor(Math.random() * 0xffff)) >>> 0;
    for (let i = 0; i < kTries; i += 1) { // Bound: kTries
      await this.send(kHello, hello(this.session, this.touches));
      const end = performance.now() + kPatienceMs;
      for (let message = await this.next(end); message; message = await this.next(end)) { // Bound: the patience
        if (message.type === kWelcome && isWhole(message) && message.view.getUint32(0, true) === this.session) return;
      }
    }
    const other = this.reader.otherVersion > 0 ? "; it speaks another version of the link" : "";
    throw new BoardError(`no board answers at this line${other}`);
  }

  /** @returns {forces: [[x, y], [x, y]], bout, touches, score} of that step, as the board tells it */
  async step(number, samples) {
    for (let i = 0; i < kTries; i += 1) { // Bound: kTries
      await this.send(kStep, step(number, samples));
      const answer = await this.answer(number);
      if (answer) return answer;
    }
    throw new BoardError(`the board does not answer step ${number}`);
  }

  async answer(number) {
    const forces = [null, null];
    const frames = new Set(); // of the step, whichever time they were told: by type and side, or place in a list
    const end = performance.now() + kPatienceMs;
    for (let message = await this.next(end); message; message = await this.next(end)) { // Bound: the patience
      const { type, view } = message;
      if (type === kRefused) throw new BoardError(`the board refuses step ${number}: ${whyRefused(view)}`);
      if (type === kWelcome || !isWhole(message) || view.getUint32(0, true) !== number) continue;
      frames.add(type === kReport ? type : type * 256 + view.getUint8(4));
      if (type === kForce) forces[view.getUint8(4)] = [view.getFloat32(5, true), view.getFloat32(9, true)];
      if (type !== kReport) continue;
      if (view.getUint16(50, true) !== (this.session & 0xffff)) throw new BoardError("the board was reset: its session is another one");
      const whole = frames.size === view.getUint8(4) && forces[0] && forces[1];
      return whole ? { forces, bout: view.getUint8(5), touches: view.getUint8(6), score: [view.getUint8(8), view.getUint8(9)] } : null;
    }
    return null;
  }
}

/** Has the board make all steps. @param expected  kRow floats a step: forces, bout, touches, score. @param tell  how far it is
 * @returns the number of the first step that differs, or 0 */
export async function compare(board, steps, expected, tell) {
  await board.open();
  for (let i = 0; i < steps.length; i += 1) { // Bound: the steps
    const told = await board.step(i + 1, steps[i]);
    const row = [...told.forces[0], ...told.forces[1], told.bout, told.touches, ...told.score];
    if (row.some((value, j) => !Object.is(value, expected[kRow * i + j]))) return i + 1;
    if (i % 100 === 0) tell(i);
  }
  return 0;
}

/** A line of the browser's own. @returns a line of Board, with a close() that gives the port back, so that it may be opened anew */
export async function openSerial(baud = 3000000) {
  const port = await navigator.serial.requestPort();
  await port.open({ baudRate: baud, bufferSize: 4096 });
  const writer = port.writable.getWriter();
  const reader = port.readable.getReader();
  const line = { write: (bytes) => writer.write(bytes), onBytes: () => {} };
  const listening = (async () => {
    for (let got = await reader.read(); !got.done; got = await reader.read()) line.onBytes(got.value);
  })().catch(() => {}); // a line that is gone is silent, and silence is told
  const ended = (promise) => endsInTime(promise.catch(() => {}));
  line.close = async () => {
    await ended(writer.abort()); // also of a write that a board has ceased to take
    await ended(reader.cancel());
    await ended(listening);
    // A port closes only where nobody holds its streams; one that was pulled out is closed already.
    reader.releaseLock();
    writer.releaseLock();
    await ended(port.close());
  };
  return line;
}
