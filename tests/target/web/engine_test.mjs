// SPDX-License-Identifier: MIT
// The bridge in node, without a browser: the same bytes as batuta-duel from the same sources; a flipped bit of input changes the
// hash, one of a recording is found; and files that are none are refused by name.

import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Bridge, instantiate } from "../../../port/platforms/web/page/bridge.js";
import { Engine } from "../../../port/platforms/web/page/engine.js";
import { EvemuError } from "../../../port/platforms/web/page/evemu.js";
import { kExchange, middleOf, placeAt } from "../../../port/platforms/web/page/layout.js";
import { recordedHash } from "../../../port/platforms/web/page/words.js";
import { check, checkReplay, duel, folder, root, site, sizesOfSite } from "./browser.mjs";

const bridge = new Bridge(await instantiate(readFileSync(join(site, "bridge.wasm"))));
const device = join(root, "port/programs/recordings/default.events");
// fencing::Strip: half of 14 m but 0.4 m; 1.5 m from the one on the right at 1.125 m.
const kMostBack = 6.6, kMostForth = -0.375, kNear = 0.01;
// A pad with two sticks: the second one walks.
const pad = join(folder, "pad.events");
writeFileSync(pad, padEvents());
// Its clock is set back behind the first event for a while, and forward again.
const back = join(folder, "back.events");
writeFileSync(back, padEvents((i) => (i >= 100 && i < 150 ? i - 150 : i)));
const touchpads = [[false, true], [true, true], [false, false]].map((how, i) => {
  const file = join(folder, `touchpad_${i}.events`);
  writeFileSync(file, fingersPad(...how));
  return file;
});
const kMostDuelKb = 90, kMostSiteKb = 400;
const kSpeaks = 2000; // steps of a bout that need not come to its end

/** @param clock  what it tells, in hundredths of a second, at each of them */
function padEvents(clock = (i) => i) {
  const lines = ["# EVEMU 1.3", "N: a pad", "I: 0003 0001 0002 0003", "P: 00 00 00 00 00 00 00 00", "B: 00 0b 00 00 00 00 00 00 00",
    "B: 03 1b 00 03 00 00 00 00 00", "A: 00 -100 100 0 0 0", "A: 01 -100 100 0 0 0", "A: 03 -10 10 0 0 0", "A: 04 -10 10 0 0 0"];
  for (let i = 1; i < 400; i += 1) { // 4 s
    const at = (60 + clock(i) / 100).toFixed(6);
    const event = (type, code, value) => lines.push(`E: ${at} ${type} ${code} ${Math.round(value)}`);
    event("0003", "0000", 100 * Math.sin(i / 20));
    event("0003", "0001", 100 * Math.sin(i / 33));
    event("0003", "0003", 10 * Math.cos(i / 30));
    event("0003", "0004", 10 * Math.sin(i / 50));
    event("0000", "0000", 0);
  }
  return `${lines.join("\n")}\n`;
}

/** A touchpad that tells of fingers only: a second one comes down, the first is lifted, and comes back. The fingers have slots, or
 * follow each other. */
function fingersPad(isInTurn, isTold) {
  const lines = ["# EVEMU 1.3"];
  if (isTold) {
    lines.push("N: a touchpad", "I: 0003 0001 0002 0003", "P: 00 00 00 00 00 00 00 00", "B: 00 0b 00 00 00 00 00 00 00",
      "B: 03 00 00 00 00 00 80 60 02", "A: 2f 0 4 0 0 0", "A: 35 0 1200 0 0 0", "A: 36 0 800 0 0 0", "A: 39 0 65535 0 0 0");
  }
  for (let i = 1; i < 400; i += 1) { // 4 s
    const event = (type, code, value) => lines.push(`E: ${(i / 100).toFixed(6)} ${type} ${code} ${Math.round(value)}`);
    const finger = (slot, phase) => {
      if (!isInTurn) event("0003", "002f", slot);
      if (i % 100 === 60 * slot + 10) event("0003", "0039", i);
      event("0003", "0035", 600 + 500 * Math.sin(i / 20 + phase));
      event("0003", "0036", 400 + 350 * Math.sin(i / 33 + phase));
      if (isInTurn) event("0000", "0002", 0);
    };
    const isDown = i % 100 < 80;
    if (isDown) finger(0, 0);
    if (!isInTurn && i % 100 === 80) {
      event("0003", "002f", 0);
      event("0003", "0039", -1);
    }
    if (i % 100 >= 40) finger(1, 2);
    event("0000", "0000", 0);
  }
  return `${lines.join("\n")}\n`;
}

function fence(engine, touches, steps = Infinity) {
  engine.start(touches);
  for (let i = 0; i < steps && engine.step(); i += 1); // Bound: the bout
  return engine.recording();
}

function sameAsTheHost() {
  check(duel, "batuta-duel is built");
  const pairs = [["script:attack", "script:parry", 5], ["script:guard", "script:attack", 1], [device, "script:parry", 5], ["script:guard", device, 1],
    ["script:master", "script:novice", 5], ["script:club", "script:attack", 2], [pad, "script:guard", 5], [back, "script:guard", 5],
    ...touchpads.map((file) => [file, "script:guard", 5])];
  for (const [left, right, touches] of pairs) {
    const engine = new Engine(bridge);
    [left, right].forEach((source, side) => {
      if ([device, pad, back, ...touchpads].includes(source)) engine.loadStick(side, readFileSync(source, "utf8"));
      else engine.choose(side, source);
    });
    const bytes = Buffer.from(fence(engine, touches));
    const file = join(folder, "host.batuta");
    execFileSync(duel, ["--left", left, "--right", right, "--touches", `${touches}`, "--record", file]);
    const native = readFileSync(file);
    check(bytes.equals(native), `${left} ${right}: ${bytes.length} bytes here, ${native.length} natively, the same ones`);
    check(recordedHash(bytes).hash === bridge.hash(), "the hash of the end mark is that of the duel");
    const { score } = engine.verdictOfBout();
    console.log(`${left} ${right}: ${score}, ${engine.state[0]} steps, ${bytes.length} bytes: those of batuta-duel`);
  }
}

/** A hand that lunges whenever it may: the score counts up by one for each halt, and the bout ends at its touches. */
function bouts() {
  for (const touches of [1, 3]) {
    const engine = new Engine(bridge);
    engine.choose(0, "hand");
    engine.choose(1, "script:guard");
    engine.start(touches);
    let halts = 0;
    for (let i = 0; !engine.over; i += 1) { // Bound: the bout
      engine.hand(0, -1, 1, 0, 0);
      engine.step();
      if (!engine.isNewHalt()) continue;
      halts += 1;
      check(`${engine.verdictOfBout().score}` === `${halts},0`, `after ${halts} halts: ${engine.verdictOfBout().score}`);
      check(engine.state[kExchange] === halts, "the exchange is that of the touch until the halt is over");
    }
    const { score, isOver } = engine.verdictOfBout();
    check(halts === touches - 1 && isOver && `${score}` === `${touches},0`, `to ${touches}: ${halts} halts, ${score}`);
  }
}

/** Feet: forward up to the other, back up to the end of the strip, and the other stays. */
function walk() {
  const engine = new Engine(bridge);
  [0, 1].forEach((side) => engine.choose(side, "hand"));
  const after = (feet) => {
    engine.start(1);
    for (let i = 0; i < 6000 && !engine.over; i += 1) { // Bound: 6 s
      engine.hand(0, -1, -1, feet, 0);
      engine.step();
    }
    check(Math.abs(middleOf(engine.state) - (engine.state[placeAt(0)] + 1.125) / 2) < 1e-6, "the right fencer stays at 1.125 m");
    return engine.state[placeAt(0)];
  };
  const [stays, back, forth] = [after(0), after(-1), after(1)];
  check(Math.abs(stays + 1.125) < 1e-6, `without an order the left fencer stays: ${stays}`);
  check(Math.abs(back + kMostBack) < kNear, `back to the end of the strip of 14 m: ${back}`);
  // The other's point may stop him before his feet have to stand.
  check(forth > stays + 0.5 && forth < kMostForth + kNear, `forward, and not past the other: ${forth}`);
}

/** A bout by a hand that moves in a circle; one coordinate of one sample may have another last bit. */
function byHand(flipAt) {
  const engine = new Engine(bridge);
  engine.choose(0, "hand");
  engine.choose(1, "script:guard");
  engine.start(1);
  const bits = new DataView(new ArrayBuffer(4));
  for (let i = 0; i < kSpeaks; i += 1) {
    bits.setFloat32(0, Math.fround(0.5 * Math.sin(i * 0.011)));
    if (i === flipAt) bits.setUint32(0, bits.getUint32(0) ^ 1);
    if (i % 8 === 0) engine.hand(0, bits.getFloat32(0), -0.3, 0.2, 0);
    engine.step();
  }
  return engine.recording();
}

function flippedBits() {
  const plain = byHand(-1);
  const hash = recordedHash(plain).hash;
  check(recordedHash(byHand(-1)).hash === hash, "the same samples give the same hash");
  check(recordedHash(byHand(800)).hash !== hash, "one bit of one sample changes the hash");
  const engine = new Engine(bridge);
  const played = (bytes) => {
    const begun = engine.play(bytes);
    if (begun !== "ready") return { answer: begun };
    while (engine.step()); // Bound: the recording
    return engine.verdict;
  };
  const good = played(plain);
  check(good.answer === "end" && good.steps === kSpeaks, JSON.stringify(good));
  for (const at of [40, 3000, Math.floor(plain.length / 2), plain.length - 8]) {
    const bytes = plain.slice();
    bytes[at] ^= 1;
    const { answer } = played(bytes);
    check(answer !== "end" && answer !== "ready", `bit flipped in byte ${at}: ${answer}`);
  }
  check(played(plain.slice(0, plain.length - 30)).answer === "cut", "a cut recording is cut");
  check(played(new Uint8Array([...plain, 0])).answer === "goes on", "a byte behind the end mark is seen");
  check(played(new TextEncoder().encode("no recording at all, but long enough to be looked at".repeat(9))).answer === "foreign", "a text is foreign");
  const fixtures = join(root, "tests/fixtures/default.batuta");
  const old = played(new Uint8Array(readFileSync(fixtures)));
  console.log(`tests/fixtures/default.batuta: ${old.answer}`);
  const file = join(folder, "hand.batuta");
  writeFileSync(file, plain);
  checkReplay(file, "batuta-duel replays it");
}

/** Where the ranges of a device's axes are not told, the page says so, in the host's words. */
function guessedRanges() {
  const words = readFileSync(join(root, "port/programs/devices/motion_axes.cpp"), "utf8");
  const notes = [pad, ...touchpads].map((file) => new Engine(bridge).loadStick(0, readFileSync(file, "utf8")).note);
  check(`${notes.slice(0, 3)}` === ",,", `nothing is guessed: ${notes}`);
  check(notes[3] !== "" && words.includes(`"${notes[3]}"`), `the ranges are guessed: ${notes[3]}`);
}

function badDevices() {
  const engine = new Engine(bridge);
  const cases = { "": /no events/, "N: pad\n": /no events/, "hello\n": /line 1/, "E: 0.000001 0000 0000 0\n": /no motion/,
    "E: 1.0 0003 0000 5\n": /line 1/, "E: 0.000001 0003 0000 0005\n": /no sync mark/,
    "E: 0.000001 0003 0000 0005\nE: 9999.000000 0000 0000 0000\n": /leaps/ };
  for (const [text, expected] of Object.entries(cases)) {
    let told = "nothing";
    try {
      engine.loadStick(0, text);
    } catch (error) {
      check(error instanceof EvemuError, `${error}`);
      told = error.message;
    }
    check(expected.test(told), `${JSON.stringify(text)}: ${told}`);
  }
}

/** The bounds of docs/browser.md. */
function sizes() {
  const all = sizesOfSite();
  const duelSize = new Map(all).get("bridge.wasm");
  const whole = all.reduce((sum, [, size]) => sum + size, 0);
  check(duelSize <= kMostDuelKb, `the duel has ${duelSize.toFixed(1)} KB of at most ${kMostDuelKb}`);
  check(whole <= kMostSiteKb, `the site has ${whole.toFixed(1)} KB of at most ${kMostSiteKb}`);
  console.log(`wasm of the duel ${duelSize.toFixed(1)} KB, whole site ${whole.toFixed(1)} KB`);
}

sizes();
sameAsTheHost();
bouts();
walk();
flippedBits();
guessedRanges();
badDevices();
console.log("the engine does as the host");
