// SPDX-License-Identifier: MIT
// Draws the two capsules of the laboratory, and lets a pointer drag them.

import { kCss } from "./colours.js";
import { endsAt } from "./lab_truth.js";

const kReach = 1.25; // m from the middle to the nearer rim
const kArrowSeconds = 0.4;
const kHandle = 14; // pixels

export class Plane {
  /** @param changed  is called when a capsule was dragged */
  constructor(canvas, bodies, changed) {
    [this.canvas, this.bodies, this.changed] = [canvas, bodies, changed];
    this.pen = canvas.getContext("2d");
    this.held = null;
    canvas.addEventListener("pointerdown", (event) => {
      this.held = this.find(this.placeOf(event));
      if (this.held) canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => this.held && this.drag(this.placeOf(event)));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => {
      this.held = null;
    });
  }

  resize() {
    this.canvas.width = this.canvas.clientWidth;
    this.canvas.height = this.canvas.clientHeight;
    this.scale = Math.min(this.canvas.width, this.canvas.height) / 2 / kReach;
  }
  at([x, y]) {
    return [this.canvas.width / 2 + x * this.scale, this.canvas.height / 2 - y * this.scale];
  }
  placeOf(event) {
    const box = this.canvas.getBoundingClientRect();
    return [(event.clientX - box.left - this.canvas.width / 2) / this.scale, (this.canvas.height / 2 - event.clientY + box.top) / this.scale];
  }
  arrowTip(body) {
    return [body.x + body.v_x * kArrowSeconds, body.y + body.v_y * kArrowSeconds];
  }

  find(place) {
    const near = (point, more = 0) => Math.hypot(point[0] - place[0], point[1] - place[1]) * this.scale < kHandle + more;
    for (const body of this.bodies) if (near(this.arrowTip(body))) return { body, what: "arrow" };
    for (const body of this.bodies) if (endsAt(body, 0).some((end) => near(end, body.radius * this.scale))) return { body, what: "end" };
    for (const body of this.bodies) if (near([body.x, body.y], body.half_length * this.scale * 0.6)) return { body, what: "body" };
    return null;
  }

  drag([x, y]) {
    const { body, what } = this.held;
    const within = (value, most) => Math.min(most, Math.max(-most, value));
    if (what === "body") [body.x, body.y] = [within(x, 2), within(y, 1.2)];
    if (what === "arrow") [body.v_x, body.v_y] = [within((x - body.x) / kArrowSeconds, 4), within((y - body.y) / kArrowSeconds, 4)];
    // The end that is nearer to the pointer goes there; an axis has no front.
    if (what === "end") {
      const angle = Math.atan2(y - body.y, x - body.x);
      const turns = Math.round((body.angle - angle) / Math.PI);
      body.angle = Math.atan2(Math.sin(angle + turns * Math.PI), Math.cos(angle + turns * Math.PI));
    }
    this.changed();
  }

  capsule(body, t, colour, alpha) {
    const { pen } = this;
    const [a, b] = endsAt(body, t).map((end) => this.at(end));
    pen.globalAlpha = alpha;
    pen.strokeStyle = colour;
    pen.lineCap = "round";
    pen.lineWidth = Math.max(2, 2 * body.radius * this.scale);
    pen.beginPath();
    pen.moveTo(...a);
    pen.lineTo(b[0] + 0.01, b[1]);
    pen.stroke();
    pen.globalAlpha = 1;
  }

  arrow(body, colour) {
    const { pen } = this;
    const [from, to] = [this.at([body.x, body.y]), this.at(this.arrowTip(body))];
    pen.strokeStyle = pen.fillStyle = "#fff";
    pen.lineWidth = 1.5;
    pen.beginPath();
    pen.moveTo(...from);
    pen.lineTo(...to);
    pen.stroke();
    pen.fillStyle = colour;
    pen.beginPath();
    pen.arc(...to, 6, 0, 7);
    pen.fill();
    pen.stroke();
  }

  /** @param times  at which a search has looked; the last one is drawn strongest */
  draw(times) {
    this.pen.fillStyle = "#1b2230";
    this.pen.fillRect(0, 0, this.canvas.width, this.canvas.height);
    times.forEach((t, i) => this.bodies.forEach((body, side) => this.capsule(body, t, kCss[side], i === times.length - 1 ? 0.65 : 0.16)));
    this.bodies.forEach((body, side) => {
      this.capsule(body, 0, kCss[side], 1);
      this.arrow(body, kCss[side]);
    });
  }
}
