// SPDX-License-Identifier: MIT
// Loads a module of ours and calls it. The modules are built without a loader, and import only what ends them.

import { kSize, kSynced } from "./layout.js";

export class BridgeError extends Error {}

// Whatever a module imports is called where it gives up: it tells so instead of going on.
function importsOf(module) {
  const imports = {};
  for (const { module: from, name, kind } of WebAssembly.Module.imports(module)) {
    if (kind !== "function") throw new BridgeError(`the module wants ${from}.${name}, a ${kind}`);
    imports[from] ??= {};
    imports[from][name] = () => {
      throw new BridgeError(`the library stopped (${name})`);
    };
  }
  return imports;
}

/** @param bytes  of a .wasm file. @returns its exports, started */
export async function instantiate(bytes) {
  const module = await WebAssembly.compile(bytes);
  const instance = await WebAssembly.instantiate(module, importsOf(module));
  instance.exports._initialize?.();
  return instance.exports;
}

export async function fetchModule(url) {
  const answer = await fetch(url);
  if (!answer.ok) throw new BridgeError(`${url}: ${answer.status} ${answer.statusText}`);
  return instantiate(await answer.arrayBuffer());
}

const kRoom = 1 << 16;

/** The fight: bridge.cpp. The memory does not grow, so that views of it stay. */
export class Bridge {
  constructor(exports) {
    this.wasm = exports;
    if (exports.web_state_size() !== kSize) {
      throw new BridgeError("page and bridge are of different versions: load the page again");
    }
    this.state = new Float32Array(exports.memory.buffer, exports.web_state(), kSize);
    this.synced = new Float32Array(exports.memory.buffer, exports.web_synced(), kSynced);
    this.room = new Uint8Array(exports.memory.buffer, exports.web_room(), kRoom);
    this.memory = new Uint8Array(exports.memory.buffer);
  }

  hash() {
    return BigInt.asUintN(64, this.wasm.web_hash()).toString(16).padStart(16, "0");
  }

  /** The bytes recorded since the last call. */
  takeRecorded() {
    const at = this.wasm.web_recorded();
    const bytes = this.memory.slice(at, at + this.wasm.web_recorded_size());
    this.wasm.web_forget();
    return bytes;
  }
}

/** A recording, fed to the bridge piece by piece. */
export class Playing {
  constructor(bridge, bytes) {
    this.bridge = bridge;
    this.bytes = bytes;
    this.at = 0;
    this.steps = 0;
  }

  fill() {
    const piece = this.bytes.subarray(this.at, this.at + kRoom);
    this.bridge.room.set(piece);
    this.at += piece.length;
    return [piece.length, this.at >= this.bytes.length ? 1 : 0];
  }

  /** @returns a Playback */
  begin() {
    return this.bridge.wasm.web_play(...this.fill());
  }

  /** @returns a Playback; kStep: a step was made */
  next() {
    const kWaiting = 3;
    let answer = this.bridge.wasm.web_next();
    while (answer === kWaiting) {
      this.bridge.wasm.web_feed(...this.fill());
      answer = this.bridge.wasm.web_next();
    }
    if (answer === 1) this.steps += 1;
    return answer;
  }
}
