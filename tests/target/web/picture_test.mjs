// SPDX-License-Identifier: MIT
// What is seen: nothing out of sight on a telephone and on a large screen, the blades, the slow replay of a touch, the cameras.

import { check, colours, open, pixelsLike, serve, shareOfChange, shot, until, visit } from "./browser.mjs";

const kSteel = [[150, 150, 150], [255, 255, 255]]; // brighter than floor and wall
const kBladeOf = [[0x4a, 0xa3, 0xff], [0xff, 0x9c, 0x45]]; // page/colours.js
// The camera looks at the middle between the hands: of the picture's width and height. No chalk line, bell or body is there on guard.
const kBetweenHands = [0.4, 0.38, 0.6, 0.5];
const kViews = 4; // page/show.js
const kMuch = 0.1, kSomething = 0.02; // of the pixels
const kSettled = 100; // pictures by which traces have faded and pixels are as coarse as they get
const kReplaySteps = 700, kReplayMs = 4500; // kReplaySeconds of page/main.js; by kReplayShare, and a little

async function nothingOutOfSight(page, path, width, height) {
  check((await page.evaluate(() => document.documentElement.scrollWidth)) <= width, `${path} at ${width}: nothing stands out to the right`);
  for (const button of await page.locator("main button").all()) {
    const box = await button.boundingBox();
    check(box && box.x >= 0 && box.x + box.width <= width && box.height >= 30, `${path} at ${width}: ${await button.textContent()}`);
  }
  const stage = await page.locator("#stage").boundingBox();
  check(stage.y + stage.height <= height && stage.width >= 0.4 * width, `${path} at ${width}: the picture is in sight`);
}

async function sizes(browser, url) {
  for (const [width, height] of [[390, 844], [1920, 1080]]) {
    for (const path of ["", "laboratory.html"]) {
      const { page, errors } = await visit(browser, url + path, { viewport: { width, height } });
      await until(page, ["fencing", "ready"]);
      if (!path) await page.selectOption("#right", "script:guard");
      await page.waitForTimeout(700);
      await nothingOutOfSight(page, path, width, height);
      const seen = await colours(page, "#stage");
      check(seen > (path ? 30 : 500), `${path} at ${width}: ${seen} colours`);
      if (!path) {
        const steel = await pixelsLike(page, await shot(page, "#salle"), kSteel, kBetweenHands);
        check(steel > 0.05 * width, `at ${width}: the blades are between the hands: ${steel} pixels`);
        console.log(`at ${width} x ${height}: ${steel} pixels of steel`);
      }
      check(errors.length === 0, `${errors}`);
      await page.context().close();
    }
  }
}

/** Where there is no WebGL, each blade has its fencer's colour. */
async function flatBlades(url) {
  const browser = await open(["--disable-gpu", "--disable-3d-apis"]);
  try {
    const { page } = await visit(browser, url);
    await until(page, "fencing");
    await page.waitForTimeout(700);
    const picture = await shot(page, "#salle");
    for (const colour of kBladeOf) {
      const seen = await pixelsLike(page, picture, [colour, colour]);
      check(seen > 100, `drawn flat, ${colour}: ${seen} pixels`);
    }
  } finally {
    await browser.close();
  }
}

const pictures = (page) => page.evaluate(() => Number(document.body.dataset.pictures));
const stepsOf = (page) => page.evaluate(() => document.body.dataset.steps);

async function newPicture(page, more = 2) {
  const before = await pictures(page);
  await page.waitForFunction((least) => Number(document.body.dataset.pictures) > least, before + more, { timeout: 120000, polling: 50 });
  return shot(page, "#salle");
}

/** Each camera shows something else, and behind the last one comes the first; so do turns there and back. */
async function cameras(page) {
  await page.keyboard.press("p");
  await until(page, "paused");
  const still = await newPicture(page, kSettled);
  check((await shareOfChange(page, still, await newPicture(page))) === 0, "a bout that stands still is one picture");
  let last = still;
  for (let i = 1; i <= kViews; i += 1) {
    await page.keyboard.press("v");
    const next = await newPicture(page);
    const change = await shareOfChange(page, last, next);
    check(change > kMuch, `camera ${i} shows something else: ${change}`);
    last = next;
  }
  check((await shareOfChange(page, still, last)) === 0, "behind the last camera comes the first");
  await page.keyboard.press("q");
  const turned = await shareOfChange(page, still, await newPicture(page));
  check(turned > kMuch, `Q turns the camera: ${turned}`);
  await page.keyboard.press("PageUp");
  await page.keyboard.press("v"); // the second camera, as it was
  for (let i = 1; i < kViews; i += 1) await page.keyboard.press("v"); // Bound: kViews
  check((await shareOfChange(page, still, await newPicture(page))) === 0, "V undoes what was turned");
  await page.keyboard.press("p");
  await until(page, "fencing");
}

/** A touch is shown once more: the picture goes back and comes again to where it was, and the bout does not. */
async function slowReplay(page) {
  await page.selectOption("#touches", "1");
  await until(page, "fencing");
  await page.waitForFunction((least) => Number(document.body.dataset.steps) > least, kReplaySteps, { timeout: 60000, polling: 50 });
  for (const key of ["a", "w"]) await page.keyboard.down(key);
  await until(page, "over");
  for (const key of ["a", "w"]) await page.keyboard.up(key);
  await page.waitForTimeout(kReplayMs);
  const [end, steps] = [await newPicture(page, kSettled), await stepsOf(page)];
  await page.keyboard.press("r");
  const back = await shareOfChange(page, end, await newPicture(page));
  check(back > kSomething, `R shows what was before: ${back}`);
  await page.waitForTimeout(kReplayMs);
  const again = await shareOfChange(page, end, await newPicture(page, kSettled));
  check(again === 0, `it comes to the same end: ${again}`);
  check((await stepsOf(page)) === steps, "no step is made for it");
  console.log(`slow replay: ${(100 * back).toFixed(1)} % of the pixels are others`);
}

const server = await serve();
const browser = await open();
try {
  await sizes(browser, server.url);
  const { page, errors } = await visit(browser, server.url, { viewport: { width: 360, height: 420 } });
  await until(page, "fencing");
  await page.selectOption("#right", "script:guard");
  await page.keyboard.press("Escape");
  await until(page, "fencing");
  await cameras(page);
  await slowReplay(page);
  check(errors.length === 0, `the console says ${errors}`);
  await flatBlades(server.url);
} finally {
  await browser.close();
  server.stop();
}
