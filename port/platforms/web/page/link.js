// SPDX-License-Identifier: MIT
// The serial link of port/shared/link/link.md: frames and the messages of a paced session, from the host's end. Bytes in, bytes
// out; it knows no port. A test holds it against the examples of that page.

export const kVersion = 3;
export const kHello = 0x01, kStep = 0x02, kWelcome = 0x81, kForce = 0x84, kReport = 0x87, kRefused = 0x88;
const kHead = 4, kSum = 4;
export const kSample = 28;
const kLongest = 75; // bytes of a frame on the wire

const kTable = Uint32Array.from({ length: 256 }, (_, byte) => {
  let sum = byte;
  for (let bit = 0; bit < 8; bit += 1) sum = sum & 1 ? (sum >>> 1) ^ 0xedb88320 : sum >>> 1;
  return sum;
});

export function crc32(bytes) {
  let sum = 0xffffffff;
  for (const byte of bytes) sum = kTable[(sum ^ byte) & 0xff] ^ (sum >>> 8);
  return (sum ^ 0xffffffff) >>> 0;
}

function stuffed(bytes) {
  const out = [];
  let piece = [];
  for (const byte of [...bytes, 0]) {
    if (byte !== 0) {
      piece.push(byte);
      continue;
    }
    out.push(piece.length + 1, ...piece);
    piece = [];
  }
  return out;
}

/** @returns null: this is no stuffing */
function unstuffed(bytes) {
  const out = [];
  for (let at = 0; at < bytes.length; at += bytes[at]) {
    if (at + bytes[at] > bytes.length) return null;
    if (at > 0) out.push(0);
    out.push(...bytes.slice(at + 1, at + bytes[at]));
  }
  return Uint8Array.from(out);
}

/** A message as it goes over the line. */
export function frame(type, number, payload) {
  const body = new Uint8Array(kHead + payload.length + kSum);
  const view = new DataView(body.buffer);
  body.set([kVersion, type]);
  view.setUint16(2, number & 0xffff, true);
  body.set(payload, kHead);
  view.setUint32(body.length - kSum, crc32(body.subarray(0, body.length - kSum)), true);
  return Uint8Array.from([0, ...stuffed(body), 0]);
}

/** Finds the frames in what comes. What is damaged is counted and dropped; the next delimiter is in step again. */
export class FrameReader {
  constructor() {
    this.bytes = [];
    this.damaged = 0;
    this.otherVersion = 0;
  }

  /** @returns messages: {type, number, view of the payload} */
  take(bytes) {
    const messages = [];
    for (const byte of bytes) {
      if (byte !== 0) {
        if (this.bytes.length <= kLongest) this.bytes.push(byte);
        continue;
      }
      if (this.bytes.length > 0) {
        const message = this.open(this.bytes);
        if (message) messages.push(message);
      }
      this.bytes = [];
    }
    return messages;
  }

  open(stuffing) {
    const body = unstuffed(stuffing);
    const size = body === null ? 0 : body.length;
    const view = size >= kHead + kSum ? new DataView(body.buffer) : null;
    if (!view || crc32(body.subarray(0, size - kSum)) !== view.getUint32(size - kSum, true)) {
      this.damaged += 1;
      return null;
    }
    if (body[0] !== kVersion) {
      this.otherVersion += 1;
      return null;
    }
    return { type: body[1], number: view.getUint16(2, true), view: new DataView(body.buffer, kHead, size - kHead - kSum) };
  }
}

/** A paced session. @param touches  to which its bout goes */
export function hello(session, touches) {
  const view = new DataView(new ArrayBuffer(6));
  view.setUint32(0, session, true);
  view.setUint8(5, touches);
  return new Uint8Array(view.buffer);
}

/** @param samples  of both sides; null where a step has none */
export function step(number, samples) {
  const told = samples.filter(Boolean);
  const view = new DataView(new ArrayBuffer(5 + told.length * kSample));
  view.setUint32(0, number, true);
  view.setUint8(4, (samples[0] ? 1 : 0) | (samples[1] ? 2 : 0));
  told.forEach((sample, i) => putSample(view, 5 + i * kSample, sample));
  return new Uint8Array(view.buffer);
}

function putSample(view, at, sample) {
  view.setUint32(at, sample.time, true);
  [sample.x, sample.y, sample.feetX, sample.feetY].forEach((value, i) => view.setFloat32(at + 4 + 4 * i, value, true));
  view.setUint32(at + 20, sample.buttons, true);
  view.setUint32(at + 24, sample.sequence, true);
}

/** An InputSample as a Step and a recording have it. */
export function sampleAt(view, at) {
  const [x, y, feetX, feetY] = [4, 8, 12, 16].map((offset) => view.getFloat32(at + offset, true));
  return { time: view.getUint32(at, true), x, y, feetX, feetY, buttons: view.getUint32(at + 20, true), sequence: view.getUint32(at + 24, true) };
}
