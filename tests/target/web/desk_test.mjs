// SPDX-License-Identifier: MIT
// What the buttons of the page do when they are pressed at another time than one thinks of: the page's own main.js and worker.js in
// plain node, with a bridge that makes up its bouts.

import { stepsOf } from "../../../port/platforms/web/page/board.js";
import { Pads } from "../../../port/platforms/web/page/pads.js";
import { Stick } from "../../../port/platforms/web/page/stick.js";
import { recordedHash } from "../../../port/platforms/web/page/words.js";
import { check } from "./browser.mjs";
import { kLiveHash, kPastHash, pretendPage, recordingOf } from "./pretend.mjs";

const kPollMs = 5, kWaitMs = 3000, kLineMs = 8000; // a line may take nothing for 3 s
const kLong = 5000, kShort = 60; // steps of a recording that goes on meanwhile, and of a bout that is over soon

const { byId, body, drop, saved, errors, serial, bridge } = await pretendPage();
const pause = (ms) => new Promise((resolve) => { setTimeout(resolve, ms); });
const mode = () => body.dataset.mode;

async function until(isSo, what, ms = kWaitMs) {
  const end = performance.now() + ms;
  while (!isSo() && performance.now() < end) await pause(kPollMs); // Bound: ms
  check(isSo(), `${what}; the page is ${mode()} and says: ${byId("word").textContent}`);
  check(errors.length === 0, `${what}: ${errors.map((error) => error.stack)}`);
}
const says = (expected, ms) => until(() => expected.test(byId("word").textContent), `the page should say ${expected}`, ms);
const is = (name) => until(() => mode() === name, `the page should be ${name}`);

async function choose(side, who) {
  byId(side).value = who;
  byId(side).tell("change");
  await is("fencing");
}

/** Before any bout has come to its end: what is shown is a recording, and there is none of the bout that it has ended. */
async function saveWhilePlaying() {
  await is("fencing");
  await pause(4 * kPollMs);
  await drop("other.batuta", recordingOf(kLong));
  await says(/^other.batuta plays/);
  byId("save").click();
  await says(/^There is no bout to save/);
  check(saved.length === 0 && mode() === "playing", `nothing is saved, and the recording goes on: ${saved.length} ${mode()}`);
}

/** A file that is refused while another one plays ends that one, and a single step does not stop the page. */
async function refusedWhilePlaying() {
  await drop("junk.batuta", Buffer.from("junk\0".repeat(40)));
  await says(/^junk.batuta is not a recording/);
  await is("over");
  byId("one").click();
  await pause(4 * kPollMs);
  await is("over");
  byId("save").click();
  await says(/^There is no bout to save/);
  check(saved.length === 0, "nothing is saved");
  byId("begin").click();
  await is("fencing");
}

async function saveUnfinished() {
  byId("touches").tell("change");
  await pause(4 * kPollMs);
  byId("save").click();
  await until(() => saved.length === 1, "a bout that goes on is saved");
  const bytes = saved.pop();
  const mark = recordedHash(bytes);
  check(mark?.hash === kLiveHash && mark.steps === stepsOf(bytes).length, `with its end mark: ${JSON.stringify(mark)}`);
}

function silentPort() {
  const port = { opened: 0, closed: 0 };
  serial.requestPort = async () => port;
  port.open = async () => {
    port.opened += 1;
    port.readable = new ReadableStream();
    port.writable = new WritableStream();
  };
  port.close = async () => {
    check(!port.readable.locked && !port.writable.locked, "a port closes where nobody holds its streams");
    port.closed += 1;
  };
  return port;
}

async function boutOf(right) {
  bridge.lasts = kShort;
  await choose("left", "script:guard");
  await choose("right", right);
  await is("over");
}

/** Who sees begins 4 m from the other; a board does not: it would be told to part. */
async function othersThanTheBoards() {
  const port = silentPort();
  await boutOf("script:novice");
  await byId("board").click();
  await says(/began 4 m apart.*2.25 m: it cannot be compared/);
  check(port.opened === 0, "no line is opened for it");
}

/** A worker that fails is told, and the line is given back. */
async function failingWorker() {
  const port = silentPort();
  await boutOf("script:parry");
  bridge.fails = true;
  byId("board").click();
  await says(/^The board: this page cannot make the bout again: the library stopped/);
  await until(() => !byId("board").disabled, "the button can be pressed again");
  check(port.opened === 1 && port.closed === 1, `the line is given back: ${port.opened} ${port.closed}`);
  bridge.fails = false;
}

/** After a board the page is over, whatever key comes, and the last bout can be saved. */
async function stepAfterBoard() {
  const port = silentPort();
  byId("board").click();
  await says(/^The board: no board answers/, kLineMs);
  await until(() => port.closed === 1 && !byId("board").disabled, "the line is given back");
  byId("one").click();
  await pause(4 * kPollMs);
  await is("over");
  byId("save").click();
  await until(() => saved.length === 1, "the last bout is saved");
  check(recordedHash(saved.pop())?.hash === kLiveHash, "it is the one that was fenced here");
}

/** A recording that comes to its end is told with both hashes. */
async function playsToTheEnd() {
  await drop("short.batuta", recordingOf(30));
  await says(/^short.batuta: 30 steps, 7 hashes agreed/);
  await is("over");
  check(byId("hash").textContent.split(kPastHash).length === 3, byId("hash").textContent);
}

/** A side that no hand fences any more gives its pad back: to the other side, and at rest. */
function padsOfSides() {
  const pad = { index: 0, id: "red pad", connected: true, axes: [0.9, 0, 0, -1], buttons: [] };
  navigator.getGamepads = () => [pad];
  const said = [];
  const pads = new Pads((text) => said.push(text));
  const sticks = [new Stick(), new Stick()];
  pads.poll([0], sticks);
  check(sticks[0].x > 0.8 && sticks[0].feet === 1, "the pad moves the left stick, and his feet");
  pads.poll([1], sticks);
  check(sticks[1].x > 0.8 && sticks[1].feet === 1, `the right hand takes it: ${sticks[1].x} ${said}`);
  check(sticks[0].x === 0 && sticks[0].feet === 0, `the left stick is at rest: ${sticks[0].x} ${sticks[0].feet}`);
  check(said.length === 2 && /right/.test(said[1]), `${said}`);
  pad.connected = false;
  pads.poll([1], sticks);
  pads.poll([0], sticks); // the loss was the right side's
  pad.connected = true;
  pads.poll([0], sticks);
  check(/left/.test(said.at(-1)), `${said}`);
}

await saveWhilePlaying();
await refusedWhilePlaying();
await saveUnfinished();
await othersThanTheBoards();
await failingWorker();
await stepAfterBoard();
await playsToTheEnd();
padsOfSides();
console.log("the desk does as it says");
process.exit(0); // the page would go on
