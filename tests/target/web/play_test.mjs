// SPDX-License-Identifier: MIT
// Bouts by mouse, by touch, by gamepad and by keys alone: each is saved, replayed by the host's program, and has its hash.

import { check, checkReplay, lastHash, mode, open, savedBout, serve, until, visit } from "./browser.mjs";

// A lunge, high inside, against who only waits; the other way round the bout would have no end.
async function guardOnTheRight(page) {
  await page.selectOption("#right", "script:guard");
  await page.selectOption("#touches", "1");
  await until(page, "fencing");
}

async function lungeByMouse(page) {
  const box = await page.locator("#salle").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.move(x - box.height * 0.4, y - box.height * 0.4, { steps: 12 });
}

async function lungeByTouch(page) {
  const box = await page.locator("#salle").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height * 0.8];
  const session = await page.context().newCDPSession(page);
  const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  await touch("touchStart", [{ x, y }]);
  for (let i = 1; i <= 10; i += 1) {
    const share = i / 10;
    await touch("touchMove", [{ x: x - share * box.width * 0.42, y: y - share * box.height * 0.42 }]);
  }
  await until(page, "over");
  await touch("touchEnd", []);
}

const kPad = () => {
  globalThis.pad = { index: 0, id: "mock pad", connected: true, axes: [0, 0], buttons: [], mapping: "standard", rumbles: [] };
  globalThis.pad.vibrationActuator = { playEffect: (kind, how) => Promise.resolve(globalThis.pad.rumbles.push({ kind, ...how })) };
  navigator.getGamepads = () => [globalThis.pad.connected ? globalThis.pad : null];
};

async function lungeByPad(page) {
  // Beats the other blade aside first, so that there is something to feel.
  await page.evaluate(() => {
    globalThis.pad.rumbles = [];
    globalThis.pad.axes = [0, -0.5];
  });
  await page.waitForFunction(() => globalThis.pad.rumbles.length > 0, null, { timeout: 60000, polling: 50 }).catch(() => check(false, "a beat is felt"));
  await page.evaluate(() => { globalThis.pad.axes = [0, 0]; });
  await page.waitForTimeout(400);
  await page.evaluate(() => { globalThis.pad.axes = [-1, -1]; });
}

async function lungeByKeys(page) {
  for (const key of ["KeyA", "KeyW"]) await page.keyboard.down(key);
  await until(page, "over");
  for (const key of ["KeyA", "KeyW"]) await page.keyboard.up(key);
}

async function tabTo(page, id) {
  for (let i = 0; i < 20 && (await page.evaluate(() => document.activeElement.id)) !== id; i += 1) await page.keyboard.press("Tab");
}

async function guardByKeys(page) {
  // Keys alone: to the lists with Tab, and through them with the arrows.
  await tabTo(page, "right");
  // Letters are the fencer's meanwhile, also those that an entry begins with.
  const at = (x) => page.waitForFunction((left) => document.getElementById("dot").style.left === left, x, { timeout: 60000, polling: 50 })
    .catch(() => check(false, `the stick goes to ${x} while a list has the focus`));
  const chosen = await page.inputValue("#right");
  for (const key of ["s", "d"]) await page.keyboard.down(key);
  await at("94%");
  for (const key of ["s", "d"]) await page.keyboard.up(key);
  await at("50%");
  check((await page.inputValue("#right")) === chosen, `the list still says ${chosen}`);
  for (let i = 0; i < 6; i += 1) await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowDown");
  check((await page.inputValue("#right")) === "script:guard", "the arrows choose script: guard");
  await page.keyboard.press("Tab");
  await page.keyboard.press("ArrowUp");
  check((await page.inputValue("#touches")) === "1", "the arrows choose one touch");
  await until(page, "fencing");
}

/** Enter, which a list keeps, begins the next bout once Escape has left the list. */
async function enterAfterEscape(page) {
  await tabTo(page, "touches");
  await page.keyboard.press("Enter");
  check((await mode(page)) === "over", "Enter is the list's");
  for (let i = 0; i < 2; i += 1) await page.keyboard.press("Escape"); // Enter opens a list: first it is closed, then left
  check((await page.evaluate(() => document.activeElement === document.body)), "Escape leaves the list");
  await page.keyboard.press("Enter");
  await until(page, "fencing");
}

const kBouts = {
  mouse: { lunge: lungeByMouse },
  touch: { lunge: lungeByTouch, options: { hasTouch: true, viewport: { width: 390, height: 844 } } },
  pad: { lunge: lungeByPad, before: kPad },
  keys: { lunge: lungeByKeys, begin: guardByKeys, after: enterAfterEscape },
};

const server = await serve();
const browser = await open();
try {
  for (const [name, { lunge, options, before, begin = guardOnTheRight, after }] of Object.entries(kBouts)) {
    const { page, errors } = await visit(browser, server.url, options, before);
    await until(page, "fencing");
    await begin(page);
    await lunge(page);
    await until(page, "over");
    const hash = await page.evaluate(() => document.body.dataset.hash);
    check(/touches/.test(await page.textContent("#big")), `${name}: somebody touches: ${await page.textContent("#big")}`);
    const path = await savedBout(page, `${name}.batuta`);
    check(lastHash(path) === hash, `${name}: the page shows ${hash}, the file ends with ${lastHash(path)}`);
    const words = checkReplay(path, name);
    if (name === "pad") {
      const rumbles = await page.evaluate(() => globalThis.pad.rumbles);
      check(rumbles.length > 0 && rumbles.every((one) => one.kind === "dual-rumble" && one.strongMagnitude > 0), `rumbles: ${JSON.stringify(rumbles)}`);
      console.log(`${rumbles.length} rumbles`);
    }
    check(errors.length === 0, `${name}: the console says ${errors}`);
    console.log(`${name}: ${await page.textContent("#big")} ${hash}, replayed natively: ${words.split(": ").pop()} (${await mode(page)})`);
    if (after) await after(page);
    check(errors.length === 0, `${name}: the console says ${errors}`);
    await page.context().close();
  }
} finally {
  await browser.close();
  server.stop();
}
