// SPDX-License-Identifier: MIT
// For tests in plain node, without a build: a bridge that makes up its bouts, and around the page's own main.js and worker.js as
// much of a browser as they ask for. It knows neither steel nor pictures.

import { register } from "node:module";
import { kBout, kSize, placeAt } from "../../../port/platforms/web/page/layout.js";

const page = new URL("../../../port/platforms/web/page/", import.meta.url);
const kHead = 24, kStep = 13, kEnd = 23; // bytes of a recording's start and pieces (src/record/recorder.md)
const kSeers = 3; // by the numbers of web_choose(): from here on they see
const kReady = 0, kMade = 1, kOver = 2, kForeign = 8; // of a Playback
export const kLiveHash = "0000000000001111", kPastHash = "0000000000002222";

const headOf = () => Uint8Array.from({ length: kHead }, (_, i) => (i === 0 ? 0x62 : 0));
const stepOf = () => Uint8Array.from({ length: kStep }, (_, i) => ({ 0: 0x53, 1: kStep - 7 })[i] ?? 0);

function endOf(steps, hash) {
  const bytes = Uint8Array.from({ length: kEnd }, (_, i) => ({ 0: 0x45, 1: kEnd - 7 })[i] ?? 0);
  const view = new DataView(bytes.buffer);
  view.setUint32(3, steps, true);
  view.setBigUint64(7, BigInt(`0x${hash}`), true);
  return bytes;
}

/** A recording of so many steps, without a sample. */
export function recordingOf(steps) {
  return Buffer.concat([headOf(), ...Array.from({ length: steps }, stepOf), endOf(steps, kPastHash)]);
}

/** What bridge.cpp exports. `lasts`: steps after which a bout is over; `fails`: the next step of a recording ends the library. */
export function pretendBridge() {
  const kTaken = 1 << 12, kRoom = 1 << 17, kSynced = 1 << 11;
  const buffer = new ArrayBuffer(1 << 19);
  const state = new Float32Array(buffer, 0, kSize);
  const room = new Uint8Array(buffer, kRoom);
  const sees = [false, false];
  let taken = 0, isPast = false, left = -1; // steps that a recording still has; -1: a player that was not begun
  const put = (bytes) => {
    new Uint8Array(buffer, kTaken + taken).set(bytes);
    taken += bytes.length;
  };
  const show = (over, past) => {
    isPast = past;
    state[0] = over;
    state[kBout] = !past && over >= bridge.lasts ? 2 : 0;
  };
  const bridge = {
    memory: { buffer }, lasts: Infinity, fails: false, samples: [],
    web_state: () => 0, web_state_size: () => kSize, web_synced: () => kSynced, web_room: () => kRoom,
    web_recorded: () => kTaken, web_recorded_size: () => taken, web_unread: () => 0, web_agreed: () => 7,
    web_forget() { taken = 0; },
    web_hash: () => BigInt(`0x${isPast ? kPastHash : kLiveHash}`),
    web_choose(side, who) { sees[side] = who >= kSeers; },
    web_feet() {},
    web_sample(side, time, x) { bridge.samples.push({ side, step: state[0], time: time >>> 0, x }); },
    web_start() {
      taken = 0;
      state.fill(0);
      const apart = sees.includes(true) ? 4 : 2.25;
      [state[placeAt(0)], state[placeAt(1)]] = [-apart / 2, apart / 2];
      show(0, false);
      put(headOf());
      return 0;
    },
    web_step() {
      show((isPast ? 0 : state[0]) + 1, false);
      put(stepOf());
      return 0;
    },
    web_end() {
      put(endOf(state[0], kLiveHash));
      return 0;
    },
    web_play(count) {
      left = room[0] === 0x62 ? Math.floor((count - kHead) / kStep) - 1 : -1; // an end mark is longer than a step
      if (left < 0) return kForeign;
      show(0, true);
      return kReady;
    },
    web_next() {
      if (bridge.fails) throw new Error("the library stopped (abort)");
      if (left < 0) return kForeign;
      if (left === 0) return kOver;
      left -= 1;
      show(state[0] + 1, true);
      return kMade;
    },
    ...pretendBuilder(new Float32Array(buffer, kSynced, 6)),
  };
  return bridge;
}

/** What recorded_device.cpp exports, of absolute axes alone. */
function pretendBuilder(synced) {
  const axes = [], at = [0, 0, 0, 0];
  let sequence = 0;
  const deflection = (which) => {
    const { min, max } = axes[which];
    return (2 * Math.min(Math.max(at[which], min), max) - min - max) / (max - min) * (which % 2 === 0 ? 1 : -1);
  };
  return {
    web_axis(which, isRelative, min, max) {
      axes[which] = { min: min | 0, max: max | 0 };
      at[which] = Math.trunc((axes[which].min + axes[which].max) / 2);
      return axes[which].min < axes[which].max ? 0 : 1;
    },
    web_move(which, counts) { at[which] = counts | 0; },
    web_event() {},
    web_sync() {
      synced.set([deflection(0), deflection(1), 0, 0, 0, sequence]);
      sequence += 1;
      return 0;
    },
  };
}

class Element {
  constructor(id) {
    Object.assign(this, { id, value: "", textContent: "", hidden: false, disabled: false, dataset: {}, style: {}, heard: {} });
    this.classList = { toggle() {} };
  }
  addEventListener(kind, act) { this.heard[kind] = act; }
  tell(kind, event = {}) { return this.heard[kind]({ detail: 0, currentTarget: this, preventDefault() {}, ...event }); }
  click() { return this.tell("click"); }
  querySelector() { return new Element(""); }
}

/** What draws is left out: three and uPlot come from npm. */
const kStubs = {
  "./show.js": `export class Show {
    canvas = { addEventListener() {} }; isFlat = true; isReplaying = false; detail = 0;
    startReplay() { return true; } stopReplay() {} draw() { return false; } resize() {}
  }`,
  "./plots.js": "export class Plots { show() {} resize() {} }",
};

function leaveOutDrawing() {
  const urls = Object.entries(kStubs).map(([name, text]) => [name, `data:text/javascript,${encodeURIComponent(text)}`]);
  const hook = `const urls = new Map(${JSON.stringify(urls)});
    export const resolve = (name, context, next) => urls.has(name) ? { url: urls.get(name), shortCircuit: true } : next(name, context);`;
  register(`data:text/javascript,${encodeURIComponent(hook)}`);
}

/** The worker is of the same node: what the two tell each other comes later, and is no copy. */
function pretendWorker(errors) {
  const later = (who, data) => setImmediate(() => {
    try {
      Promise.resolve(who()({ data })).catch((error) => errors.push(error));
    } catch (error) {
      errors.push(error);
    }
  });
  const worker = {};
  globalThis.self = { postMessage: (data) => later(() => worker.onmessage, data) };
  const loaded = import(new URL("worker.js", page));
  globalThis.Worker = class {
    constructor() { return worker; }
  };
  worker.postMessage = (data) => loaded.then(() => later(() => globalThis.self.onmessage, data));
}

/** The page of a bout, loaded. @returns {byId, body, drop(name, bytes), saved: bytes of each file, errors, serial, bridge} */
export async function pretendPage() {
  const elements = new Map(), errors = [], saved = [], serial = {};
  const byId = (id) => elements.get(id) ?? elements.set(id, new Element(id)).get(id);
  const bridge = pretendBridge();
  Object.assign(byId("left"), { value: "hand" });
  Object.assign(byId("right"), { value: "script:parry" });
  Object.assign(byId("touches"), { value: "5" });
  const document = Object.assign(new Element("document"), { body: new Element("body"), getElementById: byId, createElement: () => ({ click() {} }) });
  document.body.dataset.mode = "loading";
  URL.createObjectURL = (blob) => blob.arrayBuffer().then((bytes) => saved.push(new Uint8Array(bytes)));
  const globals = { document, window: new Element("window"), location: { href: "http://pretend/" }, navigator: { serial, getGamepads: () => [] },
    requestAnimationFrame() {}, ResizeObserver: class { observe() {} }, fetch: async () => ({ ok: true, arrayBuffer: async () => new ArrayBuffer(0) }) };
  for (const [name, value] of Object.entries(globals)) Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  Object.assign(WebAssembly, { compile: async () => ({}), instantiate: async () => ({ exports: bridge }) });
  WebAssembly.Module.imports = () => [];
  pretendWorker(errors);
  leaveOutDrawing();
  await import(new URL("main.js", page));
  const drop = (name, bytes) => document.tell("drop", { dataTransfer: { files: [new File([bytes], name)] } });
  return { byId, body: document.body, drop, saved, errors, serial, bridge };
}
