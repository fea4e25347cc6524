// SPDX-License-Identifier: MIT
// The laboratory: two capsules, and what two searches know of their first contact after every evaluation.

import uPlot from "uplot";
import { fetchModule } from "./bridge.js";
import { kCss } from "./colours.js";
import { kOutcomes, Searches } from "./lab_search.js";
import { Plane } from "./lab_plane.js";
import { firstContact } from "./lab_truth.js";

const byId = (id) => document.getElementById(id);
const kDuration = 1; // s
const kTolerance = 1e-6;
const kTickMs = 160;
// A scale of powers is told by its whole powers alone.
const power = (tick) => (tick !== null && Math.abs(Math.log10(tick) % 1) < 1e-6 ? `1e${Math.round(Math.log10(tick))}` : null);
const kLeastError = 1e-9; // s: below it a plot on a scale of powers shows nothing

const bodies = [
  { x: -0.75, y: 0.1, angle: 0.5, v_x: 1.2, v_y: 0, turn_rate: 2, half_length: 0.45, radius: 0.02 },
  { x: 0.7, y: 0, angle: 1.9, v_x: -0.6, v_y: 0.2, turn_rate: -1.5, half_length: 0.45, radius: 0.02 },
];
/** Of a slider: least, most, step, digits told, unit. */
const kNumbers = {
  x: [-2, 2, 0.01, 2, "m"], y: [-1.2, 1.2, 0.01, 2, "m"], angle: [-3.14, 3.14, 0.01, 2, "rad"],
  v_x: [-4, 4, 0.05, 2, "m/s"], v_y: [-4, 4, 0.05, 2, "m/s"], turn_rate: [-12, 12, 0.1, 1, "rad/s"],
};
const evaluations = (count) => `${count} evaluation${count === 1 ? "" : "s"}`;

let searches = null;
let found = { advancement: [], stepping: [] };
let truth = null;
let shown = Infinity;
let timer = 0;
let plot = null;
const plane = new Plane(byId("plane"), bodies, () => changed());
const epsilon = () => 2 ** Number(byId("epsilon").value);

function sayWhat() {
  const told = (name, list) => {
    const last = list.at(Math.min(shown, list.length) - 1);
    return `${name}: ${kOutcomes[last.outcome]}${["contact", "touching"].includes(kOutcomes[last.outcome]) ? ` at ${last.free.toFixed(6)} s` : ""}, ${evaluations(last.evaluations)}`;
  };
  const meet = truth === null ? "they do not meet" : `they meet at ${truth.toFixed(6)} s`;
  byId("word").textContent = `Truth: ${meet}. ${told("Advancement", found.advancement)}. ${told("Stepping", found.stepping)}.`;
}

/** One line a method and evaluation: what is known to be free, and the bracket. */
function drawTimes() {
  const canvas = byId("times");
  [canvas.width, canvas.height] = [canvas.clientWidth, canvas.clientHeight];
  const pen = canvas.getContext("2d");
  const left = 96, right = canvas.width - 14;
  const x = (t) => left + (right - left) * Math.min(1, t / kDuration);
  pen.font = "12px sans-serif";
  [["Advancement", found.advancement, 8], ["Stepping", found.stepping, canvas.height / 2 + 4]].forEach(([name, all, top]) => {
    const list = all.slice(0, shown);
    const room = canvas.height / 2 - 16;
    const high = Math.min(7, room / all.length);
    pen.fillStyle = "#b8c6d9";
    pen.fillText(name, 4, top + 12);
    pen.fillText(`${list.at(-1).evaluations} of ${all.at(-1).evaluations}`, 4, top + 28);
    list.forEach(({ outcome, free, hit }, i) => {
      const y = top + i * high;
      pen.fillStyle = "#3f9f63";
      pen.fillRect(left, y, Math.max(1, x(free) - left), Math.max(1, high - 1));
      if (kOutcomes[outcome] === "contact") {
        pen.fillStyle = "#ff4d40";
        pen.fillRect(x(free), y, Math.max(2, x(hit) - x(free)), Math.max(1, high - 1));
      }
    });
  });
  if (truth !== null) {
    pen.fillStyle = "#fff";
    pen.fillRect(x(truth), 0, 1, canvas.height);
  }
}

function draw() {
  plane.draw(found.advancement.slice(0, shown).map((one) => one.free));
  drawTimes();
  sayWhat();
}

function drawCosts() {
  const rows = searches.costs(truth);
  const points = [...rows.advancement.map(([n, e]) => [n, e, null]), ...rows.stepping.map(([n, e]) => [n, null, e])].sort((a, b) => a[0] - b[0]);
  const known = (e) => (e === null ? null : Math.max(e, kLeastError));
  plot.setData([points.map((p) => Math.max(p[0], 1)), points.map((p) => known(p[1])), points.map((p) => known(p[2]))]);
}

function changed() {
  clearInterval(timer);
  byId("epsilon-out").textContent = `${(epsilon() * 1000).toFixed(1)} mm`;
  searches.ask(bodies, kDuration);
  truth = firstContact(bodies, kDuration);
  found = { advancement: searches.advancement(kTolerance), stepping: searches.stepping(epsilon()) };
  shown = Infinity;
  drawCosts();
  for (const input of document.querySelectorAll("#numbers input")) {
    const { side, name } = input.dataset;
    const [, , , digits, unit] = kNumbers[name];
    input.value = bodies[side][name];
    input.nextElementSibling.textContent = `${bodies[side][name].toFixed(digits)} ${unit}`;
  }
  draw();
  document.body.dataset.truth = truth ?? "none";
  document.body.dataset.advancement = found.advancement.at(-1).free;
  document.body.dataset.outcome = kOutcomes[found.advancement.at(-1).outcome];
}

function advance() {
  shown = Number.isFinite(shown) ? shown + 1 : 1;
  draw();
  if (shown >= Math.max(found.advancement.length, found.stepping.length)) clearInterval(timer);
}

function build() {
  bodies.forEach((body, side) => {
    const field = document.createElement("fieldset");
    for (const [name, [min, max, step]] of Object.entries(kNumbers)) {
      const label = document.createElement("label");
      const input = document.createElement("input");
      Object.assign(input, { type: "range", min, max, step, value: body[name] });
      Object.assign(input.dataset, { side, name });
      input.addEventListener("input", () => {
        body[name] = Number(input.value);
        changed();
      });
      label.append(`${side === 0 ? "blue" : "orange"} ${name.replace("_", " ")} `, input, document.createElement("output"));
      field.append(label);
    }
    byId("numbers").append(field);
  });
  const axis = { stroke: "#9fb0c6", grid: { stroke: "#2c3a50" }, size: 56, font: "11px sans-serif" };
  const dots = (stroke, label) => ({ label, stroke, width: 1, spanGaps: true, points: { show: true, size: 6 } });
  plot = new uPlot({
    title: "error of the time of contact, s, against distance evaluations", width: 400, height: 240,
    scales: { x: { time: false, distr: 3 }, y: { distr: 3 } }, axes: [{ ...axis, size: 30 }, { ...axis, values: (_, ticks) => ticks.map(power) }], legend: { live: false },
    cursor: { show: false }, series: [{ label: "evaluations" }, dots(kCss[0], "Advancement"), dots(kCss[1], "the paper's stepping")],
  }, [[1], [1], [1]], byId("plots"));
}

function resize() {
  plane.resize();
  plot.setSize({ width: Math.max(240, byId("plots").clientWidth - 8), height: 240 });
  draw();
}

async function begin() {
  searches = new Searches(await fetchModule("laboratory.wasm"));
  build();
  changed();
  resize();
  byId("epsilon").addEventListener("input", changed);
  byId("next").addEventListener("click", () => {
    clearInterval(timer);
    advance();
  });
  byId("play").addEventListener("click", () => {
    clearInterval(timer);
    shown = 0;
    timer = setInterval(advance, kTickMs);
  });
  byId("other").addEventListener("click", () => {
    for (const body of bodies) for (const [name, [min, max]] of Object.entries(kNumbers)) body[name] = (min + Math.random() * (max - min)) / 2;
    bodies[0].x = -Math.abs(bodies[0].x) - 0.2;
    bodies[1].x = Math.abs(bodies[1].x) + 0.2;
    changed();
  });
  addEventListener("resize", resize);
  document.body.dataset.mode = "ready";
}

begin().catch((error) => {
  byId("word").textContent = `The laboratory cannot run here: ${error.message}.`;
  byId("word").classList.add("trouble");
});
