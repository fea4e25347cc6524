// SPDX-License-Identifier: MIT
// The figures of docs/browser.md: cmake --build --preset web-figures. Sizes are those of gzip -9, as a server sends them.

import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { performance } from "node:perf_hooks";
import { Bridge, instantiate } from "../../../port/platforms/web/page/bridge.js";
import { open, root, serve, site, sizesOfSite, until, visit } from "./browser.mjs";

const kRuns = 7, kSteps = 40000, kVisits = 5, kPictureMs = 6000;
const kParry = 1, kAttack = 2, kTouches = 1;

function sizes() {
  const all = sizesOfSite();
  for (const [name, size] of all) console.log(`${name.padEnd(18)} ${size.toFixed(1)} KB`);
  console.log(`whole site         ${all.reduce((sum, [, size]) => sum + size, 0).toFixed(1)} KB`);
}

async function step() {
  const { wasm } = new Bridge(await instantiate(readFileSync(join(site, "bridge.wasm"))));
  wasm.web_choose(0, kAttack);
  wasm.web_choose(1, kParry);
  let least = Infinity;
  for (let run = 0; run < kRuns; run += 1) {
    wasm.web_start(kTouches, 0);
    const before = performance.now();
    for (let i = 0; i < kSteps; i += 1) if (wasm.web_step() !== 0) wasm.web_start(kTouches, 0);
    least = Math.min(least, ((performance.now() - before) * 1000) / kSteps);
  }
  const [native, hash] = execFileSync(join(root, "build/host/batuta_web_bench"), [`${kSteps}`], { encoding: "utf8" }).trim().split(" ");
  const here = BigInt.asUintN(64, wasm.web_hash()).toString(16).padStart(16, "0");
  console.log(`step: wasm ${least.toFixed(2)} us, native ${native} us: ${(least / native).toFixed(2)} x; the hashes are ${here === hash ? "the same" : "OTHERS"}`);
}

async function inTheBrowser() {
  const server = await serve();
  const times = [];
  const browser = await open();
  for (let i = 0; i < kVisits; i += 1) {
    const before = performance.now();
    const { page } = await visit(browser, server.url, { viewport: { width: 480, height: 700 } });
    await page.waitForFunction(() => Number(document.body.dataset.steps) > 0, null, { polling: 10 });
    times.push(performance.now() - before);
    await page.context().close();
  }
  console.log(`until the blade can be moved: ${times.map((ms) => (ms / 1000).toFixed(2)).join(" ")} s`);
  const { page } = await visit(browser, server.url, { viewport: { width: 504, height: 700 } });
  await until(page, "fencing");
  await page.addStyleTag({ content: "#stage { height: 300px !important; width: 480px; min-height: 0 } " });
  await page.waitForTimeout(3000);
  const count = () => page.evaluate(() => Number(document.body.dataset.pictures));
  const [first, start] = [await count(), performance.now()];
  await page.waitForTimeout(kPictureMs);
  const rate = ((await count()) - first) / ((performance.now() - start) / 1000);
  const box = await page.locator("#salle").boundingBox();
  console.log(`pictures a second at ${box.width} x ${box.height}, software GL: ${rate.toFixed(1)}`);
  await browser.close();
  server.stop();
}

sizes();
await step();
await inTheBrowser();
