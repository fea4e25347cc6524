// SPDX-License-Identifier: MIT
// Steps the bout at 1 kHz of real time, beside the page: slow drawing never slows the fight. The page asks for the latest
// state when it draws.

import { Bridge, fetchModule } from "./bridge.js";
import { Engine } from "./engine.js";
import { kSize } from "./layout.js";

// A timer that was late by more than this has lost the time: the bout stands still for it, instead of racing after it.
const kMostBehindMs = 60;
const kTickMs = 2;

let engine = null;
let running = false;
let speed = 1;
let due = 0; // ms of bout that should be over
let last = 0;
let late = 0;
let begun = 0; // bouts and recordings so far

const say = (kind, more = {}, transfer = []) => self.postMessage({ kind, ...more }, transfer);

function tellOver() {
  const past = engine.memory.all();
  const bytes = engine.playing ? null : engine.recording();
  say("over", {
    past, bytes, blows: engine.blows, bout: engine.verdictOfBout(), hash: engine.bridge.hash(), steps: engine.state[0], apart: engine.apart,
    verdict: engine.playing ? engine.verdict : null, plot: new Float32Array(engine.plot),
  }, [past.buffer]);
}

/** A halt begins: the bout stands still until the page has shown why. */
function tellHalt() {
  running = false;
  const past = engine.memory.all();
  say("halt", { past, blows: engine.blows, bout: engine.verdictOfBout() }, [past.buffer]);
}

function tick() {
  if (!running) return;
  const now = performance.now();
  due += (now - last) * speed;
  last = now;
  if (due > kMostBehindMs) {
    late += due - kMostBehindMs;
    due = kMostBehindMs;
  }
  while (due >= 1 && !engine.over) { // Bound: kMostBehindMs
    due -= 1;
    if (engine.step() && engine.isNewHalt()) return tellHalt();
  }
  if (engine.over) {
    running = false;
    tellOver();
  } else {
    setTimeout(tick, kTickMs);
  }
}

function go(on) {
  if (running === on || (on && engine.over)) return;
  running = on;
  last = performance.now();
  if (on) tick();
}

const kTasks = {
  async load({ url }) {
    engine = new Engine(new Bridge(await fetchModule(url)));
    say("ready");
  },
  choose: ({ side, source }) => engine.choose(side, source),
  stick({ side, text, name }) {
    say("stick", { side, name, ...engine.loadStick(side, text) });
  },
  start({ paused, touches }) {
    go(false);
    engine.start(touches);
    begun += 1;
    due = late = 0;
    say("started");
    if (!paused) go(true);
  },
  hand: ({ side, x, y, feet, buttons }) => engine.hand(side, x, y, feet, buttons),
  run: ({ on }) => go(on),
  one() {
    go(false);
    if (engine.step() && engine.isNewHalt()) tellHalt();
    if (engine.over) tellOver();
  },
  speed: ({ share }) => {
    speed = share;
  },
  look({ buffer }) {
    const state = buffer ? new Float32Array(buffer) : new Float32Array(kSize);
    state.set(engine.state);
    const plot = new Float32Array(engine.plot.slice(-5000));
    say("state", { state, plot, blows: engine.blows, begun, running, late }, [state.buffer]);
  },
  save() {
    const bytes = engine.recording();
    if (!bytes) return say("unsaved"); // what plays goes on
    say("saved", { bytes, hash: engine.bridge.hash(), steps: engine.state[0] }, [bytes.buffer]);
    go(false);
    return undefined;
  },
  expected({ bytes }) {
    go(false);
    say("expected", { rows: engine.expected(bytes) });
  },
  play({ bytes, name }) {
    go(false);
    const answer = engine.play(new Uint8Array(bytes));
    begun += 1;
    due = late = 0;
    say("playing", { answer, name });
    if (answer === "ready") go(true);
  },
};

self.onmessage = async ({ data }) => {
  try {
    await kTasks[data.task](data);
  } catch (error) {
    say("problem", { text: error.message, task: data.task });
  }
};
