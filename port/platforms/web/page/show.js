// SPDX-License-Identifier: MIT
// What draws: the salle where there is WebGL, else a flat drawing; the camera by hand; and the replay in slow motion.

import { Drawing } from "./drawing.js";
import { kSize } from "./layout.js";
import { Salle } from "./salle.js";

const kViews = [
  { turn: 0.35, lift: 0.12, far: 4.2 },   // from the side
  { turn: 1.35, lift: 0.22, far: 3.0 },   // over the left fencer's shoulder
  { turn: 0, lift: 1.35, far: 4.5 },      // from above
  { turn: -0.5, lift: 0.05, far: 2.6 },   // near the blades
];
const kStepsPerState = 2;
// Slower than this over so many pictures, ms, and the picture gets fewer pixels.
const kSlowMs = 38, kPatience = 20;

export class Show {
  /** @param trouble  is told why there is no WebGL */
  constructor(canvas, trouble) {
    this.view = { ...kViews[0] };
    this.place = 0;
    this.past = null;
    try {
      this.artist = new Salle(canvas);
      this.isFlat = false;
    } catch (error) {
      // A canvas that was asked for WebGL gives no other pen: a new one takes its place.
      const fresh = canvas.cloneNode();
      canvas.replaceWith(fresh);
      this.artist = new Drawing(fresh);
      this.isFlat = true;
      trouble(`This browser has no WebGL (${error.message.split("\n")[0].slice(0, 80)}). The bout is drawn flat, from the side; all else works.`);
    }
    this.slow = { sum: 0, count: 0 };
    this.canvas = this.isFlat ? this.artist.canvas : canvas;
    this.resize();
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    this.artist.resize(clientWidth, clientHeight);
  }

  turn(x, y) {
    this.view.turn -= x * 0.008;
    this.view.lift = Math.min(1.5, Math.max(-0.15, this.view.lift + y * 0.006));
  }
  near(share) {
    this.view.far = Math.min(9, Math.max(1.3, this.view.far * share));
  }
  nextView() {
    this.place = (this.place + 1) % kViews.length;
    this.view = { ...kViews[this.place] };
  }

  /** Slow motion. @param past  states one after the other; @param share  of the speed */
  startReplay(past, blows, share, seconds) {
    const count = past.length / kSize;
    if (count < 2) return false;
    const wanted = Math.min(count, Math.ceil((seconds * 1000) / kStepsPerState));
    this.past = { states: past, blows, count, at: count - wanted, share };
    return true;
  }
  get isReplaying() {
    return this.past !== null;
  }
  stopReplay() {
    this.past = null;
  }

  /** Share of the pixels that a picture could have along a side. */
  get detail() {
    return this.artist.detail ?? 1;
  }

  watchPace(ms) {
    const { slow } = this;
    slow.sum += ms;
    slow.count += 1;
    if (slow.count < kPatience) return;
    if (!this.isFlat && slow.sum / slow.count > kSlowMs && this.artist.coarser()) this.resize();
    this.slow = { sum: 0, count: 0 };
  }

  /** @returns whether a replay has come to its end in this picture */
  draw(state, blows, ms) {
    let ended = false;
    this.watchPace(ms);
    if (this.past) {
      const { past } = this;
      past.at += (ms * past.share) / kStepsPerState;
      ended = past.at >= past.count - 1;
      const i = Math.min(Math.floor(past.at), past.count - 1);
      const then = past.states.subarray(i * kSize, (i + 1) * kSize);
      const until = then[0] / 1000;
      this.artist.draw(then, past.blows.filter((blow) => blow.time <= until), this.view);
      if (ended) this.past = null;
    } else if (state) {
      this.artist.draw(state, blows, this.view);
    }
    return ended;
  }
}
