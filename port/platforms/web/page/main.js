// SPDX-License-Identifier: MIT
// The page of a bout: sticks go to the worker, states come back and are drawn when the browser draws.

import { compare, Board, openSerial, stepsOf, whyNotOnBoard } from "./board.js";
import { acceptDrops, readFile, save } from "./files.js";
import { keyboard } from "./keyboard.js";
import { Pads } from "./pads.js";
import { Plots } from "./plots.js";
import { Show } from "./show.js";
import { kBout, kExchange, kFencing, placeAt, scoreAt } from "./layout.js";
import { feetButton, followPointer, Keys, Stick } from "./stick.js";
import { recordedHash, tellExchange, tellResult, whyNot } from "./words.js";

const byId = (id) => document.getElementById(id);
const worker = new Worker("worker.js", { type: "module" });
const send = (task, more = {}, transfer = []) => worker.postMessage({ task, ...more }, transfer);

// Sticks are asked so often, beside the drawing, ms; plots are drawn anew so often.
const kPumpMs = 8, kPlotMs = 250;
const kReplayShare = 1 / 6, kReplaySeconds = 0.7;
const kPaused = "Paused. Enter goes on.";

const word = byId("word");
const say = (text, isTrouble = false) => {
  word.textContent = text;
  word.classList.toggle("trouble", isTrouble);
};
const trouble = (text) => say(text, true);

const sticks = [new Stick(), new Stick()];
const keys = new Keys(sticks);
const pads = new Pads((text) => trouble(text));
const show = new Show(byId("salle"), trouble);
const plots = new Plots(byId("plots"));
let latest = { state: null, blows: [], begun: 0, plot: null };
let waiting = false;
let spare = null;
let lastPast = null;
let lastBout = null; // {bytes, steps, touches, apart}
let asked = null; // {resolve, reject}: what the steps of a bout come to
let touches = 5; // to which the bout goes that is fenced now
let played = null; // the recording that is shown
let drawn = { at: performance.now(), count: 0 };
let plotted = 0;

const handSides = () => [0, 1].filter((side) => byId(side === 0 ? "left" : "right").value === "hand");
keys.sideOf = (hand) => (handSides().length === 2 ? hand : (handSides()[0] ?? 0));
const leading = () => sticks[handSides()[0] ?? 0];

function mode(name) {
  document.body.dataset.mode = name;
  byId("pause").textContent = ["paused", "halt"].includes(name) ? "Go on" : "Pause";
}

function chooseSides() {
  [0, 1].forEach((side) => send("choose", { side, source: byId(side === 0 ? "left" : "right").value }));
  keys.clear();
}

function begin() {
  restart();
  say(document.hidden ? kPaused : "En garde!");
}

function restart() {
  show.stopReplay();
  touches = Number(byId("touches").value);
  played = lastPast = null;
  byId("big").textContent = "";
  byId("hash").textContent = "";
  for (const stick of sticks) stick.rest();
  send("start", { paused: document.hidden, touches });
  mode(document.hidden ? "paused" : "fencing");
}

function goOn() {
  if (["paused", "halt"].includes(document.body.dataset.mode)) run();
  else begin();
}

function run() {
  show.stopReplay();
  send("run", { on: true });
  mode(played ? "playing" : "fencing");
  say(played ? `${played.name} plays.` : "Fence!");
}

function pause() {
  if (["paused", "halt"].includes(document.body.dataset.mode)) return run();
  if (!["fencing", "playing"].includes(document.body.dataset.mode)) return;
  send("run", { on: false });
  mode("paused");
  say(kPaused);
}

function replay() {
  if (!lastPast) return say("There is no touch to show yet.");
  if (["fencing", "playing"].includes(document.body.dataset.mode)) pause();
  byId("big").textContent = "slow motion";
  show.startReplay(lastPast.past, lastPast.blows, kReplayShare, kReplaySeconds);
}

async function take(file) {
  try {
    const read = await readFile(file);
    if (read.kind === "device") return send("stick", { side: 0, text: read.text, name: read.name });
    byId("hash").textContent = "";
    lastPast = null;
    played = { name: read.name, host: recordedHash(read.bytes) };
    send("play", { bytes: read.bytes.buffer, name: read.name }, [read.bytes.buffer]);
  } catch (error) {
    send("run", { on: false });
    mode("over");
    trouble(`${error.message}. Enter begins a bout.`);
  }
}

/** Asks what each step of a bout comes to here. A worker that fails says so instead. */
function askExpected({ bytes }) {
  return new Promise((resolve, reject) => {
    asked = { resolve, reject: (text) => reject(new Error(`this page cannot make the bout again: ${text}`)) };
    send("expected", { bytes });
  });
}

/** Has the board at a line make a bout, and says whether it agrees. */
async function repeatOn(line, bout) {
  const board = new Board(line, bout.touches);
  mode("over"); // whatever is fenced or plays here is given up for it
  const rows = await askExpected(bout);
  const steps = stepsOf(bout.bytes);
  const differs = await compare(board, steps, rows, (at) => say(`The board has made ${at} of ${steps.length} steps.`));
  if (differs > 0) trouble(`The board parts from this page in step ${differs}.`);
  else say(`The board has made the same ${steps.length} steps: the same forces, to the last bit.`);
}

/** The last bout, made once more by a board at a serial line: it feels what was felt, and has to agree. */
async function onBoard() {
  if (!lastBout) return say("Fence a bout first: a board repeats the last one.");
  const reason = whyNotOnBoard(lastBout.apart);
  if (reason) return trouble(reason);
  let line = null;
  byId("board").disabled = true; // a port is opened once
  try {
    line = await openSerial();
    await repeatOn(line, lastBout);
  } catch (error) {
    trouble(`The board: ${error.message}.`);
  } finally {
    await line?.close();
    byId("board").disabled = false;
  }
  return undefined;
}

function tellPlayed(verdict, hash) {
  if (!played) return; // a file that was refused has ended it meanwhile
  const { name, host } = played;
  document.body.dataset.verdict = verdict.answer;
  byId("hash").textContent = `hash here ${hash}` + (host ? `, hash of the machine that recorded it ${host.hash}` : "");
  if (verdict.answer === "end") {
    say(`${name}: ${verdict.steps} steps, ${verdict.agreed} hashes agreed. The same bits here as there.`);
  } else {
    trouble(`${whyNot(`${name} (${verdict.steps} steps, ${verdict.agreed} hashes agreed)`, verdict.answer)}`);
  }
}

const kHeard = {
  ready() {
    chooseSides();
    restart();
    if (!show.isFlat) say("En garde! Move the mouse over the picture, slide a finger, move a pad's stick, or press W A S D; T and G move the feet. H is help.");
    requestAnimationFrame(picture);
    setInterval(pump, kPumpMs);
  },
  started() {},
  state(heard) {
    waiting = false;
    const blow = heard.blows.slice(heard.begun === latest.begun ? latest.blows.length : 0);
    spare = latest.state;
    latest = heard;
    showBout(heard.state);
    if (blow.length > 0 && document.body.dataset.mode === "fencing") {
      pads.rumble(handSides(), Math.max(...blow.map((one) => one.impulse)));
    }
  },
  halt(heard) {
    if (!["fencing", "playing", "paused"].includes(document.body.dataset.mode)) return;
    lastPast = heard;
    byId("big").textContent = tellExchange(heard.bout);
    showScore(heard.bout.score);
    if (document.body.dataset.mode === "paused") return; // step by step
    if (!played) say("Halt! Enter, or Go on, goes on at once.");
    mode("halt");
    if (!show.startReplay(heard.past, heard.blows, kReplayShare, kReplaySeconds)) run();
  },
  over(heard) {
    lastPast = heard;
    document.body.dataset.hash = heard.hash;
    document.body.dataset.steps = heard.steps;
    plots.show(heard.plot);
    const isDecided = heard.bout.isOver || !played;
    byId("big").textContent = `${tellExchange(heard.bout)} ${isDecided ? tellResult(heard.bout) : ""}`;
    showScore(heard.bout.score);
    if (heard.verdict) tellPlayed(heard.verdict, heard.hash);
    else if (heard.bytes) {
      lastBout = { bytes: heard.bytes, steps: heard.steps, touches, apart: heard.apart };
      byId("hash").textContent = `hash ${heard.hash} after ${heard.steps} steps`;
      say("Enter begins anew, R shows the last touch again, X saves the bout.");
    }
    mode("over");
    show.startReplay(heard.past, heard.blows, kReplayShare, kReplaySeconds);
  },
  saved({ bytes, hash, steps }) {
    save(bytes, `bout_${steps}.batuta`);
    mode("over");
    byId("hash").textContent = `hash ${hash} after ${steps} steps`;
    document.body.dataset.hash = hash;
  },
  unsaved() {
    say("There is no bout to save: a recording is a file already.");
  },
  expected({ rows }) {
    asked?.resolve(rows);
  },
  stick({ side, name, seconds, note }) {
    const select = byId(side === 0 ? "left" : "right");
    select.querySelector('[value="recording"]').hidden = false;
    select.value = "recording";
    begin();
    say(`${name} moves the ${side === 0 ? "left" : "right"} stick for ${seconds.toFixed(1)} s${note && `; ${note}`}.`);
  },
  playing({ answer, name }) {
    if (answer === "ready") {
      mode("playing");
      byId("big").textContent = "";
      return say(`${name} plays.`);
    }
    played = null;
    document.body.dataset.verdict = answer;
    mode("over");
    trouble(`${whyNot(name, answer)} Enter begins a bout.`);
  },
  problem({ text, task }) {
    document.body.dataset.problem = text;
    if (task === "expected") return asked?.reject(text);
    return trouble(task === "stick" ? `The recording cannot be used: ${text}.` : `Something is wrong: ${text}.`);
  },
};
worker.onmessage = ({ data }) => kHeard[data.kind](data);
worker.onerror = (event) => {
  const text = event.message ?? "its worker did not start";
  trouble(`The fight cannot run here: ${text}.`);
  asked?.reject(text);
};

function showScore([left, right]) {
  byId("left-score").textContent = left;
  byId("right-score").textContent = right;
}

function showBout(state) {
  const { dataset } = document.body;
  dataset.steps = state[0];
  dataset.places = `${state[placeAt(0)]} ${state[placeAt(1)]}`;
  if (!["fencing", "playing", "paused"].includes(dataset.mode)) return;
  showScore([state[scoreAt(0)], state[scoreAt(1)]]);
  byId("exchange").textContent = `exchange ${state[kExchange]}`;
  if (state[kBout] === kFencing && !show.isReplaying) byId("big").textContent = "";
}

function pump() {
  const sides = handSides();
  pads.poll(sides, sticks);
  for (const side of sides) {
    sticks[side].advance(kPumpMs * 1e-3);
    const { x, y, feet, buttons } = sticks[side];
    send("hand", { side, x, y, feet, buttons });
  }
}

function picture(now) {
  requestAnimationFrame(picture);
  const ms = Math.min(now - drawn.at, 250);
  drawn = { at: now, count: drawn.count + 1 };
  document.body.dataset.pictures = drawn.count;
  document.body.dataset.detail = show.detail;
  if (!waiting) {
    waiting = true;
    send("look", { buffer: spare?.buffer }, spare ? [spare.buffer] : []);
    spare = null;
  }
  if (show.draw(latest.state, latest.blows, ms) && document.body.dataset.mode === "halt") run();
  const { x, y, feet } = leading();
  byId("dot").style.left = `${50 + 44 * x}%`;
  byId("dot").style.top = `${50 - 44 * y}%`;
  byId("feet").style.top = `${50 - 44 * feet}%`;
  if (latest.plot && now - plotted > kPlotMs && ["fencing", "playing"].includes(document.body.dataset.mode)) {
    plotted = now;
    plots.show(latest.plot);
  }
}

/** Where all is over, no step is left: nothing would come of it. */
function oneStep() {
  if (document.body.dataset.mode === "over") return say("There is no step left. Enter begins a bout.");
  send("one");
  mode("paused");
  return say("One step. Enter goes on.");
}

function saveBout() {
  if (!lastBout) return send("save");
  save(lastBout.bytes, `bout_${lastBout.steps}.batuta`);
  return undefined;
}

/** From its first line: its button, which has the focus, is the last. */
function openHelp() {
  byId("help").showModal();
  byId("help").scrollTop = 0;
}

function setSpeed(share) {
  byId("speed").value = share;
  send("speed", { share: Number(share) });
}

function wire() {
  // A button that a pointer has pressed lets go of the focus: the next Enter is the bout's.
  const press = (id, act) => byId(id).addEventListener("click", (event) => {
    if (event.detail > 0) event.currentTarget.blur();
    act();
  });
  press("begin", begin);
  press("pause", pause);
  press("one", oneStep);
  press("save", saveBout);
  press("open", () => byId("file").click());
  press("again", replay);
  press("board", onBoard);
  byId("board").hidden = !navigator.serial;
  press("view", () => show.nextView());
  press("help-button", openHelp);
  press("help-close", () => byId("help").close());
  for (const id of ["left", "right"]) byId(id).addEventListener("change", () => {
    chooseSides();
    begin();
  });
  byId("touches").addEventListener("change", begin);
  byId("speed").addEventListener("change", () => setSpeed(byId("speed").value));
  byId("file").addEventListener("change", (event) => {
    if (event.target.files.length > 0) take(event.target.files[0]);
    event.target.value = "";
  });
  acceptDrops(document, take);
  followPointer(show.canvas, leading, () => handSides().length > 0, (x, y) => show.turn(x, y));
  show.canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    if (event.ctrlKey || handSides().length === 0) show.near(event.deltaY > 0 ? 1.1 : 0.9);
    else if (event.deltaY !== 0) leading().notch(event.deltaY < 0 ? 1 : -1);
  }, { passive: false });
  feetButton(byId("forward"), leading, 1);
  feetButton(byId("back"), leading, -1);
  keyboard(keys, {
    Enter: goOn, KeyP: pause, Period: () => byId("one").click(), Digit1: () => setSpeed("1"), Digit2: () => setSpeed("0.25"),
    Digit3: () => setSpeed("0.05"), KeyR: replay, KeyX: saveBout, KeyO: () => byId("open").click(), KeyV: () => show.nextView(),
    KeyQ: () => show.turn(-20, 0), KeyE: () => show.turn(20, 0), PageUp: () => show.near(0.9), PageDown: () => show.near(1.1),
    KeyH: openHelp,
  });
  new ResizeObserver(() => {
    show.resize();
    plots.resize();
  }).observe(byId("stage"));
  document.addEventListener("visibilitychange", () => {
    if (!document.hidden || !["fencing", "playing"].includes(document.body.dataset.mode)) return;
    pause();
    say("Paused, for the page was in the background. Enter goes on.");
  });
  window.addEventListener("blur", () => keys.clear());
}

wire();
send("load", { url: new URL("bridge.wasm", location.href).href });
