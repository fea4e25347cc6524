// SPDX-License-Identifier: MIT
// What a bout and a recording come to, in words.

const kSides = ["left", "right"];
const kWhyNot = {
  foreign: "is not a recording of batuta",
  "other version": "is a recording of another version of the format: it cannot be played here",
  "other scalar": "is a recording of another scene than this page's duel",
  "other scene": "is a recording of another version or another scene than this page's duel",
  "too large": "is a recording of another scene than this page's duel",
  gap: "has a gap here: the recorder could not write as fast as the bout went",
  cut: "ends here without an end mark",
  waiting: "ends here without an end mark",
  parted: "parts from this replay here: another machine, or a recording that was changed",
  damaged: "is damaged here",
  "goes on": "goes on behind its end mark",
};

export const whyNot = (name, answer) => `${name} ${kWhyNot[answer] ?? "is damaged here"}.`;

/** What an exchange brought. @param bout  Engine.verdictOfBout() */
export function tellExchange({ touches, annulled, isCorpsACorps }) {
  if (isCorpsACorps) return "Corps à corps: nobody touched.";
  if (touches.length === 0) return "Nobody touched.";
  const told = touches.map((touch) => `${kSides[touch.by]} touches the ${touch.part} at ${touch.time.toFixed(3)} s`);
  return `${touches.length > 1 ? "Double! " : ""}${told.join("; ")}.${annulled ? " Annulled: it would decide for both." : ""}`;
}

/** Who won. */
export function tellResult({ score: [left, right] }) {
  return left === right ? `A draw, ${left} : ${right}.` : `${left > right ? "Left" : "Right"} wins ${left} : ${right}.`;
}

/** The hash that the end mark of a recording tells (recorder.md): that of the machine that made it. @returns null: none */
export function recordedHash(bytes) {
  const kBody = 16, kSum = 4, kHead = 3;
  const at = bytes.length - kBody - kSum - kHead;
  if (at < 0 || bytes[at] !== 0x45 || bytes[at + 1] !== kBody || bytes[at + 2] !== 0) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset + at + kHead, kBody);
  return { steps: view.getUint32(0, true), hash: view.getBigUint64(4, true).toString(16).padStart(16, "0") };
}
