// SPDX-License-Identifier: MIT
// The sticks of two hands, and what is ordered to their feet. Whatever moved last leads the stick: pointer, keys or pad. Stick
// coordinates: right and up are +1; of the feet, forward.

const clamp = (value) => Math.min(1, Math.max(-1, value));

// A key has no way of its own: the stick goes to where it points in about the time of a hand.
const kKeySpeed = 9; // 1/s
export const kKeysOf = [
  { KeyW: [0, 1], KeyS: [0, -1], KeyA: [-1, 0], KeyD: [1, 0] },
  { ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] },
];
export const kFeetKeysOf = [{ KeyT: 1, KeyG: -1 }, { KeyI: 1, KeyK: -1 }];
// A notch of a wheel is a step of so long, s; notches add up to no more than the second.
const kNotchSeconds = 0.2, kMostWheelSeconds = 0.6;

export class Stick {
  constructor() {
    this.x = 0;
    this.y = 0;
    this.buttons = 0;
    this.leader = "none";
    this.goal = [0, 0];
    this.feetBy = { pad: 0, keys: 0, button: 0, wheel: 0 };
    this.wheelSeconds = 0;
  }
  /** The order to the feet: whoever gives one. */
  get feet() {
    return clamp(Object.values(this.feetBy).reduce((sum, order) => sum + order, 0));
  }
  /** A notch of a wheel. @param way  1 forward, -1 back: against the way of before it ends that */
  notch(way) {
    const goesOn = this.feetBy.wheel === way;
    this.wheelSeconds = Math.min(kMostWheelSeconds, (goesOn ? this.wheelSeconds : 0) + kNotchSeconds);
    this.feetBy.wheel = way;
  }
  /** At the centre, with no step of the wheel left. */
  rest() {
    this.put("none", 0, 0);
    this.wheelSeconds = this.feetBy.wheel = 0;
  }
  /** A position that a pointer or pad tells. */
  put(leader, x, y, buttons = 0) {
    this.leader = leader;
    [this.x, this.y, this.buttons] = [clamp(x), clamp(y), buttons];
  }
  /** Where the pressed keys point. */
  aim(x, y) {
    this.leader = "keys";
    this.goal = [clamp(x), clamp(y)];
  }
  advance(seconds) {
    this.wheelSeconds -= seconds;
    if (this.wheelSeconds <= 0) this.feetBy.wheel = 0;
    if (this.leader !== "keys") return;
    const way = kKeySpeed * seconds;
    const toward = (from, to) => from + Math.min(way, Math.max(-way, to - from));
    this.x = toward(this.x, this.goal[0]);
    this.y = toward(this.y, this.goal[1]);
  }
}

/** Keys of both hands. With one player both hands' keys are his. */
export class Keys {
  constructor(sticks) {
    this.sticks = sticks;
    this.down = new Set();
    this.sideOf = (hand) => hand;
  }
  isStick(code) {
    return [...kKeysOf, ...kFeetKeysOf].some((keys) => code in keys);
  }
  set(code, pressed) {
    if (pressed) this.down.add(code);
    else this.down.delete(code);
    if (kFeetKeysOf.some((keys) => code in keys)) return this.setFeet();
    const sums = new Map();
    kKeysOf.forEach((keys, hand) => {
      const side = this.sideOf(hand);
      if (!(code in keys) && !(sums.has(side))) {
        if (!Object.keys(keys).some((key) => this.down.has(key)) && this.sideOf(0) !== this.sideOf(1)) return;
      }
      const sum = sums.get(side) ?? [0, 0];
      for (const [key, [x, y]] of Object.entries(keys)) {
        if (this.down.has(key)) {
          sum[0] += x;
          sum[1] += y;
        }
      }
      sums.set(side, sum);
    });
    for (const [side, sum] of sums) this.sticks[side].aim(...sum);
    return undefined;
  }
  setFeet() {
    for (const stick of this.sticks) stick.feetBy.keys = 0;
    kFeetKeysOf.forEach((keys, hand) => {
      const { feetBy } = this.sticks[this.sideOf(hand)];
      for (const [key, way] of Object.entries(keys)) if (this.down.has(key)) feetBy.keys += way;
    });
  }
  clear() {
    for (const code of [...this.down]) this.set(code, false);
  }
}

/** Mouse and touch: the stick is where the pointer is, seen from the middle of the stage. A finger begins at the centre. */
export function followPointer(element, stick, isOn, camera) {
  const fingers = new Map();
  let anchor = null;
  const reach = () => Math.min(element.clientWidth, element.clientHeight) * 0.36;
  const put = (event, leader, x0, y0) =>
    stick().put(leader, (event.clientX - x0) / reach(), (y0 - event.clientY) / reach(), event.buttons & 1);
  const middle = () => {
    const box = element.getBoundingClientRect();
    return [box.left + box.width / 2, box.top + box.height / 2];
  };
  element.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "mouse") {
      if (event.button === 0 && isOn()) put(event, "mouse", ...middle());
      return;
    }
    fingers.set(event.pointerId, event);
    if (fingers.size === 1) anchor = [event.clientX, event.clientY];
  });
  element.addEventListener("pointermove", (event) => {
    if (event.pointerType === "mouse") {
      if (event.buttons & 6) camera(event.movementX, event.movementY);
      else if (isOn()) put(event, "mouse", ...middle());
      return;
    }
    if (!fingers.has(event.pointerId)) return;
    const before = fingers.get(event.pointerId);
    fingers.set(event.pointerId, event);
    if (fingers.size > 1) camera((event.clientX - before.clientX) / 2, (event.clientY - before.clientY) / 2);
    else if (isOn()) put(event, "touch", ...anchor);
  });
  const gone = (event) => {
    fingers.delete(event.pointerId);
    // A finger that lets go is a stick that springs back; a mouse has no such end.
    if (event.pointerType !== "mouse" && fingers.size === 0 && isOn()) stick().put("touch", 0, 0);
  };
  element.addEventListener("pointerup", gone);
  element.addEventListener("pointercancel", gone);
  element.addEventListener("contextmenu", (event) => event.preventDefault());
}

/** A button that orders the feet as long as it is held. @param way  1 forward, -1 back */
export function feetButton(element, stick, way) {
  let held = null;
  element.addEventListener("pointerdown", (event) => {
    held = stick();
    held.feetBy.button = way;
  });
  const release = () => {
    if (held) held.feetBy.button = 0;
    held = null;
  };
  for (const name of ["pointerup", "pointercancel", "pointerleave"]) element.addEventListener(name, release);
  element.addEventListener("mousedown", (event) => event.preventDefault()); // the focus stays where it is
  element.addEventListener("contextmenu", (event) => event.preventDefault());
}
