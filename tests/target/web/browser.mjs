// SPDX-License-Identifier: MIT
// What the tests of the page share: a server of static files, a browser without a window, and the host's program.

import { execFileSync } from "node:child_process";
import { createServer } from "node:http";
import { existsSync, mkdtempSync, readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, extname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const here = dirname(fileURLToPath(import.meta.url));
export const root = resolve(here, "../../..");
export const site = join(root, "build/web/site");
export const folder = mkdtempSync(join(tmpdir(), "batuta_web_"));
const kTypes = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".txt": "text/plain" };
const kChromium = ["/usr/bin/chromium", "/usr/bin/chromium-browser"].find(existsSync);

export function check(condition, what) {
  if (!condition) throw new Error(`FAILED: ${what}`);
}

/** @returns [name, KB] of each file of the site, as a server sends it */
export function sizesOfSite() {
  return readdirSync(site).map((name) => [name, gzipSync(readFileSync(join(site, name)), { level: 9 }).length / 1024]);
}

/** @returns the address of a server of the site, and what stops it */
export async function serve() {
  const server = createServer((request, answer) => {
    const path = join(site, new URL(request.url, "http://x").pathname.replace(/\/$/, "/index.html"));
    if (!path.startsWith(site) || !existsSync(path)) {
      answer.writeHead(404).end();
      return;
    }
    answer.writeHead(200, { "content-type": kTypes[extname(path)] ?? "application/octet-stream" }).end(readFileSync(path));
  });
  await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  return { url: `http://127.0.0.1:${server.address().port}/`, stop: () => server.close() };
}

/** A browser that draws in software. @param more  arguments of Chromium */
export async function open(more = []) {
  const modules = join(root, "build/node/package.json");
  const { chromium } = createRequire(modules)("playwright-core");
  const gl = more.includes("--disable-gpu") ? [] : ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
  return chromium.launch({ executablePath: kChromium, args: ["--no-sandbox", ...gl, ...more] });
}

const kWithinPage = ["data:", "blob:"];

/** A page of the site. What its console says of errors is collected, and what it asks of anyone but its own server. */
export async function visit(browser, url, options = {}, before = null) {
  const context = await browser.newContext({ acceptDownloads: true, viewport: { width: 900, height: 900 }, ...options });
  const page = await context.newPage();
  const errors = [];
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("request", (request) => {
    const { protocol, origin } = new URL(request.url());
    if (!kWithinPage.includes(protocol) && origin !== new URL(url).origin) errors.push(`it loads ${request.url()}`);
  });
  if (before) await page.addInitScript(before);
  await page.goto(url, { timeout: 120000 });
  return { page, errors };
}

export const mode = (page) => page.evaluate(() => document.body.dataset.mode);

export async function until(page, names, ms = 60000) {
  await page.waitForFunction((wanted) => wanted.includes(document.body.dataset.mode), [names].flat(), { timeout: ms });
}

/** What the page says in a line of its own. */
export const word = (page) => page.textContent("#word");

export async function says(page, expected) {
  await page.waitForFunction((text) => new RegExp(text).test(document.getElementById("word").textContent), expected.source, { timeout: 60000, polling: 100 })
    .catch(async () => check(false, `the page should say ${expected}, and says: ${await word(page)}`));
}

/** A picture of a part of the page, without what lies over its canvas; as text. */
export async function shot(page, selector) {
  const bytes = await page.locator(selector).screenshot({ style: "#stage > :not(canvas) { visibility: hidden !important; }" });
  return bytes.toString("base64");
}

/** Pixels of pictures, by a function of the page: of RGBA, width and height of each, and `more`. */
function ofPixels(page, shots, more, look) {
  return page.evaluate(async ([texts, rest, source]) => {
    const pixels = await Promise.all(texts.map(async (text) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${text}`)).blob());
      const pen = new OffscreenCanvas(image.width, image.height).getContext("2d");
      pen.drawImage(image, 0, 0);
      return pen.getImageData(0, 0, image.width, image.height);
    }));
    return new Function(`return ${source}`)()(pixels, rest);
  }, [shots, more, String(look)]);
}

/** How many colours a part of the page has: a picture that was not drawn has one. */
export async function colours(page, selector) {
  return ofPixels(page, [await shot(page, selector)], null, ([{ data }]) => new Set(new Uint32Array(data.buffer)).size);
}

/** How many pixels have a colour from `least` to `most`, in a part of the picture: left, top, right, bottom as shares of it. */
export function pixelsLike(page, picture, [least, most], part = [0, 0, 1, 1]) {
  return ofPixels(page, [picture], { least, most, part }, ([{ data, width, height }], more) => {
    const [left, top, right, bottom] = more.part.map((share, i) => Math.floor(share * [width, height][i % 2]));
    const isLike = (at) => more.least.every((value, i) => data[at + i] >= value && data[at + i] <= more.most[i]);
    let count = 0;
    for (let y = top; y < bottom; y += 1) for (let x = left; x < right; x += 1) count += isLike(4 * (y * width + x)) ? 1 : 0; // Bound: the picture
    return count;
  });
}

/** The share of the pixels in which two pictures of one size differ. */
export function shareOfChange(page, one, other) {
  return ofPixels(page, [one, other], null, ([a, b]) => {
    const [before, after] = [a, b].map(({ data }) => new Uint32Array(data.buffer));
    return before.filter((pixel, i) => pixel !== after[i]).length / before.length;
  });
}

/** Saves the last bout. @returns where */
export async function savedBout(page, name) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#save")]);
  const path = join(folder, name);
  await download.saveAs(path);
  return path;
}

export const duel = [join(root, "build/host/batuta-duel"), join(root, "build/duel/batuta-duel")].find(existsSync);

/** What the host's program says of a recording; throws where it does not replay it to the end. */
function replayed(path) {
  check(duel, "there is no batuta-duel in build/host or build/duel: cmake --workflow --preset duel");
  return execFileSync(duel, ["--replay", path], { encoding: "utf8" });
}

/** The host's program replays a recording to its end mark, and comes to its hash. @returns what it says */
export function checkReplay(path, name) {
  const words = replayed(path).trim();
  check(words.endsWith(`hashes agreed, search advancement, hash ${lastHash(path)}`), `${name}: ${words}`);
  return words;
}

/** The hash in the end mark of a recording. */
export function lastHash(path) {
  const bytes = readFileSync(path);
  return bytes.readBigUInt64LE(bytes.length - 4 - 16 + 4).toString(16).padStart(16, "0");
}
