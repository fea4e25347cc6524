// SPDX-License-Identifier: MIT
// Force on the hands, distance of the blades and impulse of the blows over time, with uPlot.

import uPlot from "uplot";
import { kCss } from "./colours.js";

const kFields = 5;
const kMostPoints = 1000;
const kAxis = { stroke: "#9fb0c6", grid: { stroke: "#2c3a50" }, ticks: { stroke: "#2c3a50" }, size: 44, font: "11px sans-serif" };

// An axis of a value that has not moved yet is as high as the least that matters.
const atLeast = (most) => (_, low, high) => [Math.min(low, 0), Math.max(high, most)];

const options = ([title, series, most], width, height) => ({
  title, width, height, legend: { show: false }, cursor: { show: false },
  scales: { x: { time: false }, y: { range: atLeast(most) } },
  axes: [{ ...kAxis, size: 26 }, kAxis],
  series: [{}, ...series],
});

export class Plots {
  constructor(box) {
    this.box = box;
    const line = (label, stroke) => ({ label, stroke, width: 1.5, points: { show: false } });
    const kinds = [
      ["force on the hands, share of the range", [line("left", kCss[0]), line("right", kCss[1])], 0.1],
      ["distance of the blades, m", [line("gap", "#7ddc8a")], 0.1],
      ["impulse of the blows, N s", [line("impulse", "#ffc340")], 0.1],
    ];
    this.plots = kinds.map((kind) => new uPlot(options(kind, 300, 120), [[], ...kind[1].map(() => [])], box));
  }

  resize() {
    const width = Math.max(200, this.box.clientWidth - 8);
    for (const plot of this.plots) plot.setSize({ width, height: 120 });
  }

  /** @param rows  time, force left, force right, gap, impulse; again and again */
  show(rows) {
    const count = rows.length / kFields;
    const every = Math.max(1, Math.ceil(count / kMostPoints));
    const columns = Array.from({ length: kFields }, () => []);
    for (let i = 0; i < count; i += every) {
      columns.forEach((column, field) => {
        // A blow lasts one step: of those between two points the largest is shown.
        let value = rows[i * kFields + field];
        if (field === 4 || field === 1 || field === 2) {
          for (let j = i; j < Math.min(i + every, count); j += 1) value = Math.max(value, rows[j * kFields + field]);
        }
        column.push(value);
      });
    }
    const [time, left, right, gap, impulse] = columns;
    this.plots[0].setData([time, left, right]);
    this.plots[1].setData([time, gap]);
    this.plots[2].setData([time, impulse]);
  }
}
