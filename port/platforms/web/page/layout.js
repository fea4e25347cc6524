// SPDX-License-Identifier: MIT
// Where the bridge's numbers are: WebState of ../bridge.cpp, float by float. web_state_size() tells whether the two agree.

const kCapsule = 7;
export const kParts = 12;
const kTouch = 6;
const kHandAt = 3; // behind score, place and feet
const kSide = kHandAt + 5 + kCapsule + kParts * kCapsule;

export const kSteps = 0;
export const kBout = 1;
export const kExchange = 2;
export const kAnnulled = 3;
export const kTouches = 4;
const kTouchAt = 5;
export const kGap = kTouchAt + 2 * kTouch;
export const kImpulse = kGap + 1;
export const kHasBlow = kGap + 2;
export const kBlow = kGap + 3;
const kSides = kGap + 6;
export const kSize = kSides + 2 * kSide;
export const kSynced = 6; // numbers of a sample: x, y, feet x, feet y, buttons, sequence

// BoutState.
export const kFencing = 0;
export const kLockout = 1;
export const kTouched = 2;
export const kDouble = 3;
export const kHalt = 4;
export const isOver = (state) => state[kBout] === kTouched || state[kBout] === kDouble;

export const scoreAt = (side) => kSides + side * kSide;
export const placeAt = (side) => kSides + side * kSide + 1;
export const feetAt = (side) => kSides + side * kSide + 2;
const handAt = (side) => kSides + side * kSide + kHandAt;
export const stickAt = (side) => handAt(side);
export const forceAt = (side) => handAt(side) + 2;
export const controlAt = (side) => handAt(side) + 4;
export const bladeAt = (side) => handAt(side) + 5;
export const partAt = (side, part) => handAt(side) + 5 + kCapsule + part * kCapsule;

// BodyPart, as name_of() says it.
const kPartNames = ["pelvis", "torso", "head", "upper weapon arm", "weapon forearm", "weapon hand",
  "other upper arm", "other forearm", "front thigh", "front shin", "rear thigh", "rear shin"];

export function touchOf(state, index) {
  const at = kTouchAt + index * kTouch;
  return {
    by: state[at],
    part: kPartNames[state[at + 1]] ?? "body",
    time: state[at + 2],
    point: [state[at + 3], state[at + 4], state[at + 5]],
  };
}

export const touchesOf = (state) => Array.from({ length: state[kTouches] }, (_, i) => touchOf(state, i));

/** Touches of both, as a bout that ends now has them: with the one whose exchange is not over. */
export function scoreOf(state) {
  const score = [state[scoreAt(0)], state[scoreAt(1)]];
  if (state[kBout] === kLockout) score[touchOf(state, 0).by] += 1;
  return score;
}

/** The middle between the fencers along the strip, and how far they are apart, m. */
export const middleOf = (state) => (state[placeAt(0)] + state[placeAt(1)]) / 2;
export const apartOf = (state) => state[placeAt(1)] - state[placeAt(0)];

// Status of core/status.hpp and Playback of record/player.hpp, in the order of their values.
export const kOk = 0;
export const kPlayback = ["ready", "step", "end", "waiting", "parted", "gap", "cut", "damaged", "foreign", "other version",
  "other scalar", "other scene", "too large"];
