// SPDX-License-Identifier: MIT
// What the worker does, without the worker: bouts with their sticks, step by step, and recordings. A test in node drives it
// as well.

import { Playing } from "./bridge.js";
import { readEvemu } from "./evemu.js";
import { kRow } from "./board.js";
import { apartOf, forceAt, isOver, kAnnulled, kBout, kHalt, kTouches, kGap, kHasBlow, kImpulse, kBlow, kOk, kPlayback, kSize, kSteps, scoreAt, scoreOf, touchesOf } from "./layout.js";

const kScripts = ["guard", "parry", "attack", "novice", "club", "master"].map((name) => `script:${name}`);
// The past of a bout that a slow replay shows: every second step of the last 1.6 s.
const kKept = 800, kKeepEvery = 2;
// A bout of the preliminary rounds, as batuta-duel ends one in which nobody is touched.
export const kBoutSteps = 180000;

/** The last part of a bout, for the replay in slow motion. */
class Memory {
  constructor() {
    this.states = Array.from({ length: kKept }, () => new Float32Array(kSize));
    this.count = 0;
  }
  add(state) {
    if (state[kSteps] % kKeepEvery === 0) this.states[this.count++ % kKept].set(state);
  }
  /** @returns the states in the order of time, one after the other in one array */
  all() {
    const length = Math.min(this.count, kKept);
    const copy = new Float32Array(length * kSize);
    for (let i = 0; i < length; i += 1) copy.set(this.states[(this.count - length + i) % kKept], i * kSize);
    return copy;
  }
}

// Of times modulo 2^32 us, as batuta::is_later() (port/clock.hpp).
const isLater = (a, b) => ((a - b) | 0) > 0;

/** A stick whose samples come from an evemu recording: at any time the last one up to then, as the host plays it (ReplayDevice). A
 * sample of a clock that has stepped back is not later than now: it is passed like any other. */
class RecordedStick {
  constructor({ samples, duration }) {
    this.samples = samples;
    this.duration = duration;
    this.next = 0;
  }
  rewind() {
    this.next = 0;
  }
  at(now) {
    const first = this.next;
    while (this.next < this.samples.length && !isLater(this.samples[this.next].time, now)) this.next += 1; // Bound: the samples
    return this.next > first ? this.samples[this.next - 1] : null;
  }
}

export class Engine {
  constructor(bridge) {
    this.bridge = bridge;
    this.state = bridge.state;
    this.recorded = [null, null];
    this.hands = [null, null];
    this.numbers = [0, 0];
    this.playing = null;
    this.memory = new Memory();
    this.pieces = []; // of the recording of the bout that is fenced here; none: there is no such bout
    this.blows = [];
    this.plot = [];
    this.over = true;
  }

  /** @param source  hand, script:NAME, or what loadStick() left. */
  choose(side, source) {
    if (source !== "recording") this.recorded[side] = null;
    this.bridge.wasm.web_choose(side, kScripts.indexOf(source));
  }

  /** @param text  of an evemu recording, which then moves this side's stick. @returns {seconds, note: what had to be guessed} */
  loadStick(side, text) {
    const read = readEvemu(text, this.bridge);
    this.recorded[side] = new RecordedStick(read);
    this.choose(side, "recording");
    return { seconds: read.duration, note: read.note };
  }

  /** @param touches  to which the bout goes */
  start(touches) {
    this.playing = null;
    this.forget();
    this.pieces = [];
    this.hands = [null, null];
    this.numbers = [0, 0];
    for (const stick of this.recorded) stick?.rewind();
    if (this.bridge.wasm.web_start(touches, 1) !== kOk) throw new Error("the bout could not begin");
    this.over = false;
    this.ended = false;
    this.apart = apartOf(this.state);
    const longest = Math.max(0, ...this.recorded.map((stick) => stick?.duration ?? 0));
    this.limit = longest > 0 ? longest : kBoutSteps * 1e-3;
    this.pieces.push(this.bridge.takeRecorded());
  }

  forget() {
    this.memory = new Memory();
    this.blows = [];
    this.plot = [];
    this.halted = false;
  }

  /** Where a hand holds its stick, and what it orders its feet; the next step takes it. */
  hand(side, x, y, feet, buttons) {
    this.hands[side] = { x, y, feet, buttons };
  }

  feed(side) {
    const now = this.state[kSteps] * 1000;
    if (this.recorded[side]) {
      const sample = this.recorded[side].at(now);
      if (sample) this.tell(side, sample);
    } else if (this.hands[side]) {
      const { x, y, feet, buttons } = this.hands[side];
      this.tell(side, { time: now, x, y, feetX: 0, feetY: feet, buttons, sequence: this.numbers[side] });
      this.numbers[side] += 1;
      this.hands[side] = null;
    }
  }

  tell(side, { time, x, y, feetX, feetY, buttons, sequence }) {
    this.bridge.wasm.web_feet(side, feetX, feetY);
    this.bridge.wasm.web_sample(side, time, x, y, buttons, sequence);
  }

  /** @returns whether a step was made */
  step() {
    if (this.over) return false;
    if (this.playing) return this.stepPlaying();
    this.feed(0);
    this.feed(1);
    if (this.bridge.wasm.web_step() !== kOk) throw new Error("the bout refused a step");
    this.pieces.push(this.bridge.takeRecorded());
    this.note();
    if (isOver(this.state) || !(this.state[kSteps] * 1e-6 * 1000 < this.limit)) this.finish();
    return true;
  }

  note() {
    const { state } = this;
    this.memory.add(state);
    this.plot.push(state[kSteps] / 1000, Math.hypot(state[forceAt(0)], state[forceAt(0) + 1]),
      Math.hypot(state[forceAt(1)], state[forceAt(1) + 1]), state[kGap], state[kImpulse]);
    if (state[kHasBlow] === 1 && state[kImpulse] > 0) {
      this.blows.push({ time: state[kSteps] / 1000, impulse: state[kImpulse], point: Array.from(state.slice(kBlow, kBlow + 3)) });
    }
  }

  /** The end mark: the recording can be saved. */
  finish() {
    if (this.ended || this.playing || this.pieces.length === 0) return;
    this.bridge.wasm.web_end();
    this.pieces.push(this.bridge.takeRecorded());
    this.ended = true;
    this.over = true;
  }

  /** The recording of the bout so far; a bout that goes on ends here. @returns null: no bout is there that was fenced here */
  recording() {
    if (this.pieces.length === 0) return null;
    this.finish();
    const bytes = new Uint8Array(this.pieces.reduce((sum, piece) => sum + piece.length, 0));
    let at = 0;
    for (const piece of this.pieces) {
      bytes.set(piece, at);
      at += piece.length;
    }
    return bytes;
  }

  /** The bout that was fenced here is given up for a recording. What is wrong with a file leaves that bout, but ends the recording that
   * was shown: its player has begun anew. @param bytes  of a *.batuta file. @returns "ready", or what is wrong with it */
  play(bytes) {
    const playing = new Playing(this.bridge, bytes);
    const answer = playing.begin();
    if (answer !== 0) {
      this.leave();
      return kPlayback[answer];
    }
    this.playing = playing;
    this.pieces = [];
    this.verdict = null;
    this.forget();
    this.over = false;
    return "ready";
  }

  /** Nothing is played any more. */
  leave() {
    if (!this.playing) return;
    this.playing = null;
    this.over = true;
  }

  stepPlaying() {
    const answer = this.playing.next();
    if (answer === 1) {
      this.note();
      return true;
    }
    this.over = true;
    const behind = answer === 2 && (this.playing.at < this.playing.bytes.length || this.bridge.wasm.web_unread() > 0);
    this.verdict = { answer: behind ? "goes on" : kPlayback[answer], steps: this.playing.steps, agreed: this.bridge.wasm.web_agreed() };
    return false;
  }

  /** What each step of a recording comes to, as a board tells it: forces of both sides, bout, touches, score.
   * @returns kRow floats a step. @throws where it does not come to its end here: nothing could be held against it */
  expected(bytes) {
    const begun = this.play(bytes);
    if (begun !== "ready") throw new Error(`its recording is not played: ${begun}`);
    const rows = [];
    while (this.stepPlaying()) { // Bound: the recording
      const { state } = this;
      rows.push(state[forceAt(0)], state[forceAt(0) + 1], state[forceAt(1)], state[forceAt(1) + 1], state[kBout], state[kTouches],
        state[scoreAt(0)], state[scoreAt(1)]);
    }
    const { answer } = this.verdict;
    this.leave();
    if (answer !== "end") throw new Error(`its recording is played for ${rows.length / kRow} steps: ${answer}`);
    return new Float32Array(rows);
  }

  /** Whether the step that was just made is the first of a halt. */
  isNewHalt() {
    const before = this.halted;
    this.halted = this.state[kBout] === kHalt;
    return this.halted && !before;
  }

  /** What the bout comes to so far. */
  verdictOfBout() {
    const { state } = this;
    const touches = touchesOf(state);
    const isCorpsACorps = state[kBout] === kHalt && touches.length === 0;
    return { touches, isCorpsACorps, annulled: state[kAnnulled] === 1, score: scoreOf(state), isOver: isOver(state) };
  }
}
