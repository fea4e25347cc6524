// SPDX-License-Identifier: MIT
// What is seen: nothing out of sight on a telephone and on a large screen, the blades, the slow replay of a touch, the cameras.

import { check, colours, open, pixelsLike, serve, shareOfChange, shot, until, visit } from "./browser.mjs";

const kSteel = [[150, 150, 150], [255, 255, 255]]; // brighter than floor and wall
const kBladeOf = [[0x4a, 0xa3, 0xff], [0xff, 0x9c, 0x45]]; // page/colours.js
// The camera looks at the middle between the hands: of the picture's width and height. No chalk line, bell or body is there on guard.
const kBetweenHands = [0.4, 0.38, 0.6, 0.5];
const kViews = 4; // page/show.js
const kDetails = 5; // levels of page/salle.js, and one more
const kMuch = 0.1, kSomething = 0.02; // of the pixels
const kSettled = 100; // pictures by which traces have faded, and most often pixels are as coarse as they get
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

/** What is seen while pixels stay as coarse as they are: they get coarser a few times at most. */
async function atOneDetail(page, look) {
  const detail = () => page.evaluate(() => document.body.dataset.detail);
  for (let i = 0; i < kDetails; i += 1) {
    const before = await detail();
    const seen = await look();
    if ((await detail()) === before) return seen;
  }
  throw new Error("FAILED: in the end pixels get no coarser");
}

/** Pictures: twice as it is, from each camera, turned by keys, and with the first camera again. */
async function lookAround(page) {
  const [still, again, views] = [await newPicture(page), await newPicture(page), []];
  for (let i = 0; i < kViews; i += 1) {
    await page.keyboard.press("v");
    views.push(await newPicture(page));
  }
  await page.keyboard.press("q");
  const turned = await newPicture(page);
  await page.keyboard.press("PageUp");
  for (let i = 0; i < kViews; i += 1) await page.keyboard.press("v"); // Bound: kViews
  return { still, again, views, turned, undone: await newPicture(page) };
}

/** Each camera shows something else, and behind the last one comes the first; so do turns there and back. */
async function cameras(page) {
  await page.keyboard.press("p");
  await until(page, "paused");
  await newPicture(page, kSettled);
  const { still, again, views, turned, undone } = await atOneDetail(page, () => lookAround(page));
  check((await shareOfChange(page, still, again)) === 0, "a bout that stands still is one picture");
  for (let i = 0; i < kViews; i += 1) {
    const change = await shareOfChange(page, i === 0 ? still : views[i - 1], views[i]);
    check(change > kMuch, `camera ${i + 1} shows something else: ${change}`);
  }
  check((await shareOfChange(page, still, views.at(-1))) === 0, "behind the last camera comes the first");
  const change = await shareOfChange(page, still, turned);
  check(change > kMuch, `Q turns the camera: ${change}`);
  check((await shareOfChange(page, still, undone)) === 0, "V undoes what was turned");
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
  const steps = await stepsOf(page);
  const { end, replayed, after } = await atOneDetail(page, async () => {
    const pictures = { end: await newPicture(page, kSettled) };
    await page.keyboard.press("r");
    pictures.replayed = await newPicture(page);
    await page.waitForTimeout(kReplayMs);
    return { ...pictures, after: await newPicture(page, kSettled) };
  });
  const back = await shareOfChange(page, end, replayed);
  check(back > kSomething, `R shows what was before: ${back}`);
  const again = await shareOfChange(page, end, after);
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
