// SPDX-License-Identifier: MIT
// When two capsules in a plane meet, by numbers of 64 bits and code that knows nothing of the library: distances of segments,
// and steps that nothing can pass.

const kClose = 1e-11; // m
const kMostSteps = 200000;

const minus = (a, b) => [a[0] - b[0], a[1] - b[1]];
const cross = (a, b) => a[0] * b[1] - a[1] * b[0];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1];

function pointToSegment(p, a, b) {
  const way = minus(b, a);
  const length = dot(way, way);
  const share = length > 0 ? Math.min(1, Math.max(0, dot(minus(p, a), way) / length)) : 0;
  return Math.hypot(p[0] - a[0] - share * way[0], p[1] - a[1] - share * way[1]);
}

export function segmentDistance([a, b], [c, d]) {
  const ab = minus(b, a), cd = minus(d, c);
  const crosses = cross(ab, minus(c, a)) * cross(ab, minus(d, a)) < 0 && cross(cd, minus(a, c)) * cross(cd, minus(b, c)) < 0;
  if (crosses) return 0;
  return Math.min(pointToSegment(a, c, d), pointToSegment(b, c, d), pointToSegment(c, a, b), pointToSegment(d, a, b));
}

/** Both ends of a body's axis at a time. */
export function endsAt(body, t) {
  const angle = body.angle + body.turn_rate * t;
  const half = [Math.cos(angle) * body.half_length, Math.sin(angle) * body.half_length];
  const middle = [body.x + body.v_x * t, body.y + body.v_y * t];
  return [minus(middle, half), [middle[0] + half[0], middle[1] + half[1]]];
}

export const gapAt = ([A, B], t) => segmentDistance(endsAt(A, t), endsAt(B, t)) - A.radius - B.radius;

/** @returns the time of the first contact, or null where there is none */
export function firstContact(bodies, duration) {
  const [A, B] = bodies;
  const fastest = Math.hypot(A.v_x - B.v_x, A.v_y - B.v_y) + Math.abs(A.turn_rate) * A.half_length + Math.abs(B.turn_rate) * B.half_length;
  let t = 0;
  for (let i = 0; i < kMostSteps; i += 1) { // Bound: kMostSteps
    const gap = gapAt(bodies, t);
    if (gap <= kClose) return t;
    if (fastest === 0) return null;
    t += gap / fastest;
    if (t > duration) return null;
  }
  return t;
}
