// SPDX-License-Identifier: MIT
// Reads a recording of a device in the evemu format, as port/programs/devices/recording.cpp does, into the samples that the
// host would make of it: the arithmetic is the bridge's SampleBuilder. A test holds the two against each other.

import { kOk } from "./layout.js";

const kSyn = 0, kKey = 1, kRel = 2, kAbs = 3;
const kDropped = 3, kReport = 0, kFingerReport = 2;
const kSlot = 0x2f, kTrackingId = 0x39; // of fingers
const kFirstButton = 0x100, kLastButton = 0x151;
// From the centre to the rim of a relative device, counts; and the time in which a stroke happens.
const kReach = 400, kStrokeUs = 1e6;
const kLongestGapUs = 30 * 60 * 1e6;
const kFingers = [kAbs, 0x35, 0x36]; // where a device tells of fingers only
const kCandidates = [[kRel, 0, 1], [kAbs, 0, 1], kFingers];
const kFeet = [[3, 4], [16, 17]]; // a second stick, a hat
// Words and blanks as event_line.cpp takes them; what the numbers may be is looked at below.
const kEvent = /^E:[ \t\r]*(\d+)\.(\d{6})[ \t\r]+([0-9a-fA-F]+)[ \t\r]+([0-9a-fA-F]+)[ \t\r]+(-?\d+)(?:[ \t\r]+#[^]*|[ \t\r]*)$/;
const kRange = /^A:\s+([0-9a-fA-F]+)\s+(-?\d+)\s+(-?\d+)\s+(-?\d+)\s+(-?\d+)/;
const kMostSeconds = 1e12, kMostCode = 0xffff;
const kLeast = -(2 ** 31), kMost = 2 ** 31 - 1; // of a value

export class EvemuError extends Error {}

const isValue = (value) => value >= kLeast && value <= kMost;

/** The line for a message, as the host quotes it: short, and with nothing but letters. */
function quoted(line) {
  const kLongest = 60;
  const bare = line.slice(0, kLongest).replace(/[\t\r]/g, " ").replace(/[^ -~]/g, "?");
  return `"${bare}${line.length > kLongest ? "..." : ""}"`;
}

/** @returns {seconds, micros, type, code, value}, or null: this is no event */
function readEvent(line) {
  const words = kEvent.exec(line);
  if (!words) return null;
  const [seconds, micros, value] = [words[1], words[2], words[5]].map(Number);
  const [type, code] = [words[3], words[4]].map((word) => parseInt(word, 16));
  const isEvent = seconds <= kMostSeconds && type <= kMostCode && code <= kMostCode && isValue(value);
  return isEvent ? { seconds, micros, type, code, value } : null;
}

/** Times are from the first event's whole second on: a clock that counts from 1970 stays exact. @returns what is wrong, or nothing */
function takeEvent({ seconds, micros, type, code, value }, lines) {
  const { events } = lines;
  lines.second ??= seconds;
  const time = (seconds - lines.second) * 1e6 + micros;
  if (events.length > 0 && Math.abs(time - lines.latest) > kLongestGapUs) return "the time stamp leaps by more than 30 minutes";
  lines.latest = events.length > 0 ? Math.max(lines.latest, time) : time;
  events.push({ time, type, code, value });
  return "";
}

/** @returns what is wrong, or nothing */
function takeRange(line, { ranges }) {
  const words = kRange.exec(line);
  if (!words) return "";
  const [min, max, fuzz, flat] = words.slice(2).map(Number);
  // No device tells such a range. libevemu reads these lines for the host, and what it takes this one for is anyone's guess.
  if (![min, max, fuzz, flat].every(isValue)) return `the range of an axis is beyond 32 bits: ${quoted(line)}`;
  ranges.set(parseInt(words[1], 16), { min, max, flat });
  return "";
}

/** What one line adds. @returns what is wrong with it, or nothing */
function takeLine(line, lines) {
  if (/^[ \t\r]*(#|$)/.test(line)) return "";
  const event = readEvent(line);
  if (event) return takeEvent(event, lines);
  if (/^[NIPBALS]:/.test(line)) return takeRange(line, lines);
  return `neither an event, nor a description, nor a comment: ${quoted(line)}`;
}

function readLines(text) {
  const lines = { events: [], ranges: new Map(), latest: 0, second: null };
  text.split("\n").forEach((line, i) => {
    const wrong = takeLine(line, lines);
    if (wrong) throw new EvemuError(`line ${i + 1}: ${wrong}`);
  });
  if (lines.events.length === 0) throw new EvemuError("it holds no events");
  return lines;
}

// Half of the widest stroke: a mouse with a fine grid would hit the rim with every twitch.
function reachOf(events, code) {
  let position = 0, low = 0, high = 0, widest = 0, start = events[0].time;
  for (const event of events) {
    if (event.time - start > kStrokeUs) {
      start = event.time;
      low = high = position;
    }
    if (event.type !== kRel || event.code !== code) continue;
    position += event.value;
    low = Math.min(low, position);
    high = Math.max(high, position);
    widest = Math.max(widest, high - low);
  }
  return Math.min(Math.max(Math.trunc(widest / 2), kReach), 0x3fffffff);
}

function observed(events, code) {
  const counts = events.filter((e) => e.type === kAbs && e.code === code).map((e) => e.value);
  const min = counts.reduce((a, b) => Math.min(a, b), Infinity);
  const max = counts.reduce((a, b) => Math.max(a, b), -Infinity);
  if (min < max) return { min, max, flat: 0 };
  const only = min === max ? min : 0;
  return { min: Math.max(only - 1, kLeast), max: Math.min(only + 1, kMost), flat: 0 };
}

const isRange = (range) => range && range.min < range.max;
const usable = (r) => [0, r.min, r.max, r.flat >= 0 && 2 * r.flat < r.max - r.min ? r.flat : 0];

function calibration({ events, ranges }, type, x, y) {
  if (type === kRel) {
    const reach = Math.max(reachOf(events, x), reachOf(events, y));
    return [[1, -reach, reach, 0], [1, -reach, reach, 0]];
  }
  const known = (code) => {
    const range = ranges.get(code);
    return isRange(range) ? range : observed(events, code);
  };
  return [usable(known(x)), usable(known(y))];
}

/** What had to be guessed, or nothing. */
function noteOf({ ranges }, type, codes) {
  if (type === kRel || codes.every((code) => isRange(ranges.get(code)))) return "";
  return "the device's axis ranges are not known; taken from the counts in the recording";
}

/** The finger that leads: the first that moves, until it is lifted. Fingers have slots, or follow each other, set apart by marks. */
class Fingers {
  constructor() {
    this.finger = 0;
    this.leading = -1;
    this.isInTurn = false;
  }
  mark(code) {
    if (code === kFingerReport) {
      this.isInTurn = true;
      if (this.finger < kMost) this.finger += 1; // a slot may have any number
    }
    if (code === kReport && this.isInTurn) this.finger = 0;
  }
  /** @returns whether the leading finger tells this */
  isLeading(code, value, codes) {
    if (code === kSlot) this.finger = value;
    if (code === kTrackingId && value < 0 && this.finger === this.leading) this.leading = -1;
    if (codes.includes(code) && this.leading < 0) this.leading = this.finger;
    return this.finger === this.leading;
  }
}

/** Beside absolute axes: the second stick or the hat that moves and whose ranges are told. @returns codes, or none */
function feetOf({ events, ranges }, axes) {
  if (axes[0] !== kAbs || axes === kFingers) return [];
  const moves = (codes) => events.some((e) => e.type === kAbs && codes.includes(e.code));
  return kFeet.find((codes) => moves(codes) && codes.every((code) => isRange(ranges.get(code)))) ?? [];
}

/** Tells the bridge which axes move. @returns {type, codes by Axis, fingers, note: what had to be guessed} */
function chooseAxes(lines, { wasm }) {
  const moves = ([type, x, y]) => lines.events.some((e) => e.type === type && (e.code === x || e.code === y));
  const axes = kCandidates.find(moves);
  if (!axes) throw new EvemuError("it holds no motion of a mouse, stick or touchpad that this page knows");
  const [type, x, y] = axes;
  const told = calibration(lines, type, x, y).map((range, which) => wasm.web_axis(which, ...range));
  if (told[1] !== kOk) throw new EvemuError("its axes have no range");
  const feet = feetOf(lines, axes);
  feet.forEach((code, i) => wasm.web_axis(2 + i, ...usable(lines.ranges.get(code))));
  return { type, codes: [x, y, ...feet], fingers: axes === kFingers ? new Fingers() : null, note: noteOf(lines, type, [x, y]) };
}

/** @returns samples (time in us from the first event), the duration in s, and what had to be guessed. @throws EvemuError */
export function readEvemu(text, bridge) {
  const lines = readLines(text);
  const { wasm, synced } = bridge;
  const { type, codes, fingers, note } = chooseAxes(lines, bridge);
  const start = lines.events[0].time;
  const samples = [];
  for (const event of lines.events) {
    if (event.type === kSyn) fingers?.mark(event.code);
    if (event.type === kSyn && event.code === kDropped) wasm.web_event(0, 0);
    if (event.type === kSyn && event.code === kReport) {
      const time = (event.time - start) >>> 0; // modulo 2^32, as on the host: a clock may step back
      if (wasm.web_sync(time) === kOk) {
        const [x, y, feetX, feetY, buttons, sequence] = synced;
        samples.push({ time, x, y, feetX, feetY, buttons, sequence });
      }
    } else if (event.type === kKey && event.code >= kFirstButton && event.code <= kLastButton) {
      wasm.web_event(event.value !== 0 ? 1 : 2, event.code & 0x0f);
    } else if (event.type === type) {
      const isTold = !fingers || fingers.isLeading(event.code, event.value, codes);
      if (isTold && codes.includes(event.code)) wasm.web_move(codes.indexOf(event.code), event.value);
    }
  }
  if (samples.length === 0) throw new EvemuError("it holds no sync mark, so no sample");
  return { samples, duration: (lines.latest - start) * 1e-6, note };
}
