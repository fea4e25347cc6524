// SPDX-License-Identifier: MIT
// Recordings of devices whose clock steps back, and whose numbers are too large, in plain node: as the host takes them, whose program
// is asked where it is built. The samples of healthy ones are held against it by engine_test.mjs.

import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { stepsOf } from "../../../port/platforms/web/page/board.js";
import { Bridge } from "../../../port/platforms/web/page/bridge.js";
import { Engine } from "../../../port/platforms/web/page/engine.js";
import { check, duel, folder, root } from "./browser.mjs";
import { pretendBridge } from "./pretend.mjs";

const kDescription = ["# EVEMU 1.3", "N: a stick", "I: 0003 0001 0002 0003", "P: 00 00 00 00 00 00 00 00", "B: 00 0b 00 00 00 00 00 00 00",
  "B: 03 03 00 00 00 00 00 00 00", "A: 00 -100 100 0 0 0", "A: 01 -100 100 0 0 0"];
const kMostOff = 1e-6;

/** @param moves  [time in us, x in counts] */
const textOf = (moves, description = kDescription) => [...description, ...moves.flatMap(([us, x]) => {
  const at = `${Math.floor(us / 1e6)}.${String(us % 1e6).padStart(6, "0")}`;
  return [`E: ${at} 0003 0000 ${x}`, `E: ${at} 0000 0000 0`];
})].join("\n");

/** What the page hands to a bout by itself: {step, time, x} */
function handed(text) {
  const bridge = pretendBridge();
  const engine = new Engine(new Bridge(bridge));
  const { seconds } = engine.loadStick(0, text);
  engine.choose(1, "script:guard");
  engine.start(5);
  for (let i = 0; i < seconds * 1000; i += 1) engine.step(); // Bound: the recording
  return bridge.samples;
}

function refusal(text) {
  try {
    new Engine(new Bridge(pretendBridge())).loadStick(0, text);
  } catch (error) {
    return error.message;
  }
  return "nothing";
}

/** @param more  for batuta-duel. @returns {words: what it says, steps: samples of each step that it makes} */
function host(text, more = []) {
  const [file, record] = ["host.events", "host.batuta"].map((name) => join(folder, name));
  writeFileSync(file, text);
  const { stderr } = spawnSync(duel, ["--left", file, "--right", "script:guard", "--record", record, ...more], { encoding: "utf8" });
  return { words: stderr.replace(`${file}:`, "line "), steps: () => stepsOf(new Uint8Array(readFileSync(record))) };
}

function sameAsHost(text, told) {
  if (!duel) return;
  const steps = host(text).steps();
  const samples = steps.flatMap(([left], step) => (left ? [{ step, ...left }] : []));
  const here = told.filter(({ step }) => step < steps.length);
  check(samples.length === here.length, `${samples.length} samples on the host, ${here.length} here`);
  samples.forEach((sample, i) => {
    const isSame = sample.step === here[i].step && sample.time === here[i].time && Math.abs(sample.x - here[i].x) < kMostOff;
    check(isSame, `sample ${i}: ${JSON.stringify(sample)} on the host, ${JSON.stringify(here[i])} here`);
  });
}

/** A clock that is set back below the first event, and goes on from there: its samples are passed at once, and the stick lives on. */
function clockStepsBack() {
  const moves = [[10000000, 10], [10010000, 20], [9510000, 30], [9520000, 40], ...Array.from({ length: 50 }, (_, i) => [10020000 + 1000 * i, i])];
  const told = handed(textOf(moves));
  const at = (step) => told.find((one) => one.step === step);
  check(Math.abs(at(0).x - 0.1) < kMostOff, `the first sample: ${JSON.stringify(at(0))}`);
  check(Math.abs(at(10).x - 0.4) < kMostOff && at(10).time === 2 ** 32 - 480000, `those of before the start, at once: ${JSON.stringify(at(10))}`);
  check(at(68) && Math.abs(at(68).x - 0.48) < kMostOff, `it goes on: ${JSON.stringify(told.at(-1))}`);
  sameAsHost(textOf(moves), told);
}

/** A stamp of an unset clock, of 1970, and one of the far future are exact. */
function farClocks() {
  for (const start of [0, 1700000000, 250000000000]) {
    const lines = [0, 1, 2, 3].flatMap((i) => [`E: ${start}.00${i}001 0003 0000 ${i}`, `E: ${start}.00${i}001 0000 0000 0`]);
    const text = [...kDescription, ...lines].join("\n");
    const told = handed(text);
    check(`${told.map(({ time }) => time)}` === "0,1000,2000", `${start}: ${told.map(({ time }) => time)}`);
    sameAsHost(text, told);
  }
}

/** Words as the host takes them, and numbers of 32 bits at most. */
function lines() {
  const kMalformed = "neither an event, nor a description, nor a comment: ";
  check(readFileSync(join(root, "port/programs/devices/recording.cpp"), "utf8").includes(`"${kMalformed}"`), "the host says the same");
  const values = [["2147483648", false], ["-2147483649", false], ["4294967296", false], ["2147483647", true], ["-2147483648", true], ["00000000000000007", true]];
  const events = [["E:\t0.000001 00003 0 7 # and so on", true], ["E:0.000001 3 0 7\r", true], [" E: 0.000001 3 0 7", false], ["E: 0.00001 3 0 7", false],
    ["E: 0.000001 10003 0 7", false], ["E: 0.000001 3 0 7 x", false], ["E: 1000000000001.000000 3 0 7", false], ["E: -1.000000 3 0 7", false],
    ...values.map(([value, isTaken]) => [`E: 0.000001 0003 0000 ${value}`, isTaken]), ["E: 0.000001 0003 0000 7 # because it is long, it is cut", true],
    ["E: 0.000001 0003 0000 77777777777777777777777777777777777777777777777\t", false]];
  for (const [line, isTaken] of events) {
    const text = [...kDescription, line, "E: 0.000002 0000 0000 0", ""].join("\n");
    const told = refusal(text);
    check(isTaken ? told === "nothing" : told.startsWith(`line 9: ${kMalformed}`), `${line}: ${told}`);
    const words = duel ? host(text, ["--seconds", "0.1"]).words : told;
    check(isTaken ? !words.includes("neither") : words.includes(told), `${line}: the page says ${told}, the host ${words}`);
  }
}

/** The host leaves these to libevemu, which takes them for some other number; the page takes them for none. */
function ranges() {
  for (const range of ["-100 4294967396 0 0", "-100 2147483648 0 0", "-2147483649 100 0 0", "-100 100 0 99999999999"]) {
    const told = refusal(textOf([[1, 5]], kDescription.map((line) => line.replace("A: 00 -100 100 0 0", `A: 00 ${range}`))));
    check(told === `line 7: the range of an axis is beyond 32 bits: "A: 00 ${range} 0"`, told);
  }
  const whole = kDescription.map((line) => line.replace("A: 00 -100 100", "A: 00 -2147483648 2147483647"));
  check(Math.abs(handed(textOf([[0, 2147483647], [2000, 0]], whole))[0].x - 1) < kMostOff, "32 bits are taken");
  // Around the only count that a stick tells whose range is not told.
  const only = handed(textOf([[0, -2147483648], [2000, -2147483648]], []));
  check(Math.abs(only[0].x + 1) < kMostOff, `the least of all counts: ${JSON.stringify(only)}`);
}

clockStepsBack();
farClocks();
lines();
ranges();
console.log(`recordings of devices are taken as on the host${duel ? "" : ", which is not built"}`);
