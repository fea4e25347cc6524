// SPDX-License-Identifier: MIT
// A serial line of the browser is given back, whatever became of the bout on it: the next press of the button opens it anew. The
// port is a mock that, as the browser's own, refuses to be opened twice and to be closed while somebody holds its streams.

import { check, open, serve, until, visit } from "./browser.mjs";

const kPort = () => {
  const port = { isOpen: false, times: 0, ends: false };
  port.open = async () => {
    if (port.isOpen) throw new DOMException("The port is already open.", "InvalidStateError");
    port.readable = new ReadableStream({ start: (line) => port.ends && line.error(new DOMException("The device has been lost.", "NetworkError")) });
    port.writable = new WritableStream();
    port.isOpen = true;
    port.times += 1;
  };
  port.close = async () => {
    if (port.readable.locked || port.writable.locked) throw new TypeError("Cannot cancel a locked stream");
    port.isOpen = false;
  };
  globalThis.port = port;
  globalThis.choose = async () => port;
  Object.defineProperty(navigator, "serial", { value: { requestPort: () => globalThis.choose() } });
};

/** One press of the button, until the page has said what became of it. */
async function pressed(page, expected) {
  await page.evaluate(() => { document.getElementById("word").textContent = ""; });
  await page.click("#board");
  await page.waitForFunction(() => /^The board: .*\.$/.test(document.getElementById("word").textContent), null, { timeout: 60000, polling: 50 });
  const word = await page.textContent("#word");
  check(expected.test(word), `the page should say ${expected}, and says: ${word}`);
  await page.waitForFunction(() => !document.getElementById("board").disabled, null, { timeout: 10000, polling: 50 });
}

const server = await serve();
const browser = await open();
try {
  const { page, errors } = await visit(browser, server.url, {}, kPort);
  await until(page, "fencing");
  await page.selectOption("#right", "script:guard");
  await page.selectOption("#touches", "1");
  await page.keyboard.press("Escape");
  for (const key of ["a", "w"]) await page.keyboard.down(key);
  await until(page, "over");
  const times = () => page.evaluate(() => [globalThis.port.times, globalThis.port.isOpen]);
  for (const press of [1, 2]) {
    await pressed(page, /no board answers/);
    check(`${await times()}` === `${press},false`, `after ${press} presses it was opened and is open: ${await times()}`);
  }
  await page.evaluate(() => { globalThis.port.ends = true; });
  await pressed(page, /no board answers/);
  check(`${await times()}` === "3,false", `a line that broke is given back as well: ${await times()}`);
  await page.evaluate(() => { globalThis.choose = async () => { throw new DOMException("No port selected by the user.", "NotFoundError"); }; });
  await pressed(page, /No port selected/);
  check(errors.length === 0, `the console says ${errors}`);
  console.log("a line is given back, and opened anew");
} finally {
  await browser.close();
  server.stop();
}
