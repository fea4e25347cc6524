// SPDX-License-Identifier: MIT
// The bout without WebGL: the salle from the side, on a flat canvas. Fewer pictures, the same fight.

import { kStripLines } from "./strip.js";
import { kCss } from "./colours.js";
import { apartOf, bladeAt, kParts, middleOf, partAt, touchesOf } from "./layout.js";

// Beside the two fencers, m.
const kBeside = 1.15;

export class Drawing {
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = canvas.getContext("2d");
    if (!this.pen) throw new Error("this browser can draw nothing");
  }

  resize(width, height) {
    [this.canvas.width, this.canvas.height] = [width, height];
  }

  draw(state, blows) {
    const { pen, canvas: { width, height } } = this;
    // Both fencers are in sight, wherever they are on the strip.
    const scale = Math.min(width / (apartOf(state) + kBeside), height / 2.3);
    const across = (place) => width / 2 + (place - middleOf(state)) * scale;
    const x = (at) => across(state[at]);
    const y = (at) => height - 0.2 * scale - state[at + 2] * scale;
    pen.fillStyle = "#1b2230";
    pen.fillRect(0, 0, width, height);
    pen.fillStyle = "#8d959e";
    pen.fillRect(0, height - 0.2 * scale, width, 0.2 * scale);
    pen.fillStyle = "#f2f2ee";
    for (const [place, broad] of kStripLines) pen.fillRect(across(place) - (broad * scale) / 2, height - 0.2 * scale, broad * scale, 0.2 * scale);
    pen.lineCap = "round";
    const capsule = (at, colour, least) => {
      pen.strokeStyle = colour;
      pen.lineWidth = Math.max(2 * state[at + 6] * scale, least);
      pen.beginPath();
      pen.moveTo(x(at), y(at));
      pen.lineTo(x(at + 3) + 0.01, y(at + 3));
      pen.stroke();
    };
    for (const side of [0, 1]) {
      for (let i = 0; i < kParts; i += 1) capsule(partAt(side, i), side === 0 ? "#b9cbe4" : "#e4cfb0", 2);
    }
    for (const side of [0, 1]) capsule(bladeAt(side), kCss[side], 3);
    const ring = (point, size, colour) => {
      pen.strokeStyle = colour;
      pen.lineWidth = 3;
      pen.beginPath();
      pen.arc(across(point[0]), height - 0.2 * scale - point[2] * scale, size, 0, 7);
      pen.stroke();
    };
    for (const blow of blows) ring(blow.point, 6, "#ffc340");
    for (const touch of touchesOf(state)) ring(touch.point, 14, "#ff3b30");
  }
}
