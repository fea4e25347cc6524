// SPDX-License-Identifier: MIT
// The library's two searches, asked again and again with a little more: what each has found after every evaluation.

import { BridgeError } from "./bridge.js";

// Lab of ../laboratory.cpp, float by float.
const kBody = ["x", "y", "angle", "v_x", "v_y", "turn_rate", "half_length", "radius"];
const kDuration = 16, kTolerance = 17, kEpsilon = 18, kHalvings = 19, kFree = 20, kHit = 21, kGap = 22, kEvaluations = 23, kSize = 24;
const kBudget = 3;
export const kOutcomes = ["free", "contact", "touching", "budget", "invalid"];
const kMostEvaluations = 64, kMostSteps = 400, kMostHalvings = 24;
const kAdvancement = 0, kPaper = 1;

export class Searches {
  constructor(wasm) {
    if (wasm.lab_size() !== kSize) throw new BridgeError("page and laboratory are of different versions: load the page again");
    this.wasm = wasm;
    this.numbers = new Float32Array(wasm.memory.buffer, wasm.lab_numbers(), kSize);
  }

  ask(bodies, duration) {
    bodies.forEach((body, i) => kBody.forEach((name, j) => {
      this.numbers[i * kBody.length + j] = body[name];
    }));
    this.numbers[kDuration] = duration;
  }

  search(method, most) {
    const outcome = this.wasm.lab_search(method, most);
    const { numbers } = this;
    return { outcome, free: numbers[kFree], hit: numbers[kHit], gap: numbers[kGap], evaluations: numbers[kEvaluations] };
  }

  /** Advancement after 1, 2, 3 ... evaluations. */
  advancement(tolerance) {
    this.numbers[kTolerance] = tolerance;
    const found = [];
    for (let most = 1; most <= kMostEvaluations; most += 1) { // Bound: kMostEvaluations
      found.push(this.search(kAdvancement, most));
      if (found.at(-1).outcome !== kBudget) break;
    }
    return found;
  }

  paper(epsilon, halvings, most) {
    this.numbers[kEpsilon] = epsilon;
    this.numbers[kHalvings] = halvings;
    return this.search(kPaper, most);
  }

  /** The paper's stepping: after each step, then after each halving of the bracket. */
  stepping(epsilon) {
    const found = [];
    for (let steps = 1; steps <= kMostSteps; steps += 1) { // Bound: kMostSteps
      found.push(this.paper(epsilon, 0, steps));
      if (found.at(-1).outcome !== kBudget) break;
    }
    if (kOutcomes[found.at(-1).outcome] !== "contact") return found;
    const steps = found.length;
    for (let halvings = 1; halvings <= kMostHalvings; halvings += 1) { // Bound: kMostHalvings
      const last = found.at(-1);
      found.push(this.paper(epsilon, halvings, steps));
      if (found.at(-1).evaluations === last.evaluations) return found.slice(0, -1);
    }
    return found;
  }

  /** Error against cost: [evaluations, error in s] of each method, from coarse to fine. @param truth  s, or null: no contact */
  costs(truth) {
    const error = ({ outcome, free, hit }) => {
      const said = kOutcomes[outcome];
      if (said === "contact" || said === "touching") return truth === null ? null : Math.max(Math.abs(free - truth), Math.abs(hit - truth));
      return said === "free" && truth === null ? 0 : null;
    };
    const rows = { advancement: [], stepping: [] };
    for (let i = 2; i <= 7; i += 0.5) { // Bound: 11
      const last = this.advancement(10 ** -i).at(-1);
      rows.advancement.push([last.evaluations, error(last)]);
    }
    for (let i = 0; i <= 10; i += 1) { // Bound: 11
      const found = this.paper(0.2 * 2 ** -i, i + 4, 4096);
      rows.stepping.push([found.evaluations, error(found)]);
    }
    return rows;
  }
}
