// SPDX-License-Identifier: MIT
// Gamepads: who holds which, what became of one that is gone, and rumble. A pad is known by its place and its name, so that
// one that comes back, or two that swap places, do not move the other's stick; two of one name are told apart by place alone.

const kDead = 0.08;
const kRumbleMs = 70;
// An impulse of this many N s is as hard as a pad can tell.
const kHardest = 0.35;

// Of a pad by the standard mapping: the second stick, and the hat's buttons.
const kFeetAxis = 3, kHatUp = 12, kHatDown = 13;

const outside = (value) => (Math.abs(value) < kDead ? 0 : (value - Math.sign(value) * kDead) / (1 - kDead));

export class Pads {
  /** @param say  tells the player what happened */
  constructor(say) {
    this.say = say;
    this.held = [null, null]; // by side: {index, id}
    this.lost = [false, false];
  }

  all() {
    return [...(navigator.getGamepads?.() ?? [])].filter((pad) => pad?.connected);
  }

  /** The pad of a side: the same place and name; else the same name elsewhere, which is told. */
  find(side, pads) {
    const held = this.held[side];
    const other = this.held[1 - side];
    const taken = (pad) => other && pad.index === other.index && pad.id === other.id;
    const same = pads.find((pad) => pad.index === held.index && pad.id === held.id);
    if (same) return same;
    const moved = pads.find((pad) => pad.id === held.id && !taken(pad));
    if (moved) {
      this.say(`${moved.id} is now at place ${moved.index + 1}; its hand stays the same`);
      this.held[side] = { index: moved.index, id: moved.id };
    }
    return moved ?? null;
  }

  take(side, pad) {
    this.held[side] = { index: pad.index, id: pad.id };
    this.lost[side] = false;
    this.say(`pad ${pad.index + 1} (${pad.id}) fences ${side === 0 ? "on the left" : "on the right"}`);
  }

  /** A side that no hand fences any more gives its pad back, with all that it holds of it. */
  release(side, stick) {
    if (!this.held[side]) return;
    this.held[side] = null;
    this.lost[side] = false;
    if (stick.leader === "pad") stick.put("none", 0, 0);
    stick.feetBy.pad = 0;
  }

  /** Hands what the pads say to the sticks. @param sides  those that a hand fences, in the order of the pads */
  poll(sides, sticks) {
    const pads = this.all();
    for (const side of [0, 1]) if (!sides.includes(side)) this.release(side, sticks[side]);
    for (const side of sides) {
      if (!this.held[side]) {
        const free = pads.find((pad) => !this.held.some((held) => held && held.index === pad.index && held.id === pad.id));
        if (free && this.moves(free)) this.take(side, free);
        else continue;
      }
      const pad = this.find(side, pads);
      if (!pad) {
        if (!this.lost[side]) {
          this.say(`${this.held[side].id} is unplugged: its stick stays at the centre until it is back; mouse, touch and keys go on`);
          sticks[side].put("pad", 0, 0);
          sticks[side].feetBy.pad = 0;
        }
        this.lost[side] = true;
        continue;
      }
      if (this.lost[side]) this.say(`${pad.id} is back`);
      this.lost[side] = false;
      this.move(pad, sticks[side]);
    }
  }

  moves(pad) {
    return pad.axes.some((axis) => Math.abs(axis) > 0.3) || pad.buttons.some((button) => button.pressed);
  }

  /** The second stick, or else the hat. */
  feet(pad) {
    const hat = (at) => (pad.buttons[at]?.pressed ? 1 : 0);
    return -outside(pad.axes[kFeetAxis] ?? 0) || hat(kHatUp) - hat(kHatDown);
  }

  // A pad at rest leaves the stick to whoever moves it.
  move(pad, stick) {
    stick.feetBy.pad = this.feet(pad);
    const x = outside(pad.axes[0] ?? 0);
    const y = -outside(pad.axes[1] ?? 0);
    const isHeld = this.moves({ axes: pad.axes.slice(0, 2), buttons: pad.buttons.filter((_, i) => i !== kHatUp && i !== kHatDown) });
    if (stick.leader !== "pad" && !isHeld) return;
    const buttons = pad.buttons.reduce((bits, button, i) => (button.pressed && i < 32 ? bits | (1 << i) : bits), 0) >>> 0;
    stick.put("pad", x, y, buttons);
  }

  /** Blows, as far as a pad can tell them. */
  rumble(sides, impulse) {
    const pads = this.all();
    const strength = Math.min(1, impulse / kHardest);
    for (const side of sides) {
      const pad = this.held[side] && pads.find((one) => one.index === this.held[side].index);
      const answer = pad?.vibrationActuator?.playEffect?.("dual-rumble",
        { duration: kRumbleMs, strongMagnitude: strength, weakMagnitude: Math.sqrt(strength) });
      answer?.catch?.(() => {}); // a pad that cannot rumble is none the worse
    }
  }
}
