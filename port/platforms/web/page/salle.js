// SPDX-License-Identifier: MIT
// The salle with three.js: a lit strip, two fencers of capsules, blades that glint, traces of the points, blows and touches.
// Frame of the library: x along the strip from the left fencer to the right one, z up; three.js is told so.

import {
  AmbientLight, BufferAttribute, BufferGeometry, CapsuleGeometry, Color, DirectionalLight, Fog, Group,
  HemisphereLight, Line, LineBasicMaterial, Mesh, MeshStandardMaterial, PCFShadowMap, PerspectiveCamera, PlaneGeometry,
  RingGeometry, Scene, SphereGeometry, SpotLight, Vector3, WebGLRenderer, MeshBasicMaterial,
} from "three";
import { apartOf, bladeAt, controlAt, kParts, kSteps, middleOf, partAt, touchesOf } from "./layout.js";
import { kStripLength, kStripLines, kStripWidth } from "./strip.js";
import { kBodyColours, kTraceColours } from "./colours.js";

const kTraceLength = 90;
const kMostRings = 24, kFadeSeconds = 0.5;
const kHead = 2, kHand = 5;
// Between the fencers when they are on guard, m.
const kOnGuard = 2.25;
const kLampBeside = 0.5;
const kUp = new Vector3(0, 1, 0);
const a = new Vector3(), b = new Vector3(), way = new Vector3();

const metal = () => new MeshStandardMaterial({ color: 0xe8edf2, metalness: 0.85, roughness: 0.22, emissive: 0x222831 });

/** A capsule whose ends are told anew for every picture; its shape is made once, for its length stays. */
class Limb {
  constructor(material) {
    this.material = material;
    this.mesh = null;
  }
  place(group, state, at, radius = state[at + 6]) {
    a.set(state[at], state[at + 1], state[at + 2]);
    b.set(state[at + 3], state[at + 4], state[at + 5]);
    const length = a.distanceTo(b);
    if (!this.mesh || Math.abs(length - this.length) > 0.003 || Math.abs(radius - this.radius) > 1e-4) {
      this.mesh?.geometry.dispose();
      const shape = new CapsuleGeometry(radius, length, 4, 10);
      if (this.mesh) this.mesh.geometry = shape;
      else {
        this.mesh = new Mesh(shape, this.material);
        this.mesh.castShadow = true;
        group.add(this.mesh);
      }
      [this.length, this.radius] = [length, radius];
    }
    this.mesh.position.addVectors(a, b).multiplyScalar(0.5);
    if (length > 1e-6) this.mesh.quaternion.setFromUnitVectors(kUp, way.subVectors(b, a).normalize());
  }
}

class FencerView {
  constructor(scene, side) {
    this.side = side;
    this.group = new Group();
    scene.add(this.group);
    const cloth = new MeshStandardMaterial({ color: kBodyColours[side], roughness: 0.75 });
    const mask = new MeshStandardMaterial({ color: 0x23262b, roughness: 0.45, metalness: 0.4 });
    this.parts = Array.from({ length: kParts }, (_, i) => new Limb(i === kHead || i === kHand ? mask : cloth));
    this.steel = metal();
    this.blade = new Limb(this.steel);
    this.bell = new Mesh(new SphereGeometry(0.055, 20, 12, 0, Math.PI * 2, 0, Math.PI / 2), metal());
    this.bell.castShadow = true;
    this.group.add(this.bell);
    this.trace = new Float32Array(kTraceLength * 3);
    this.count = 0;
    this.line = new Line(new BufferGeometry().setAttribute("position", new BufferAttribute(this.trace, 3)),
      new LineBasicMaterial({ color: kTraceColours[side], transparent: true, opacity: 0.75 }));
    this.line.frustumCulled = false;
    this.group.add(this.line);
  }
  show(state, isNewBout) {
    for (let i = 0; i < kParts; i += 1) this.parts[i].place(this.group, state, partAt(this.side, i));
    const at = bladeAt(this.side);
    this.blade.place(this.group, state, at, Math.max(state[at + 6], 0.007));
    a.set(state[at], state[at + 1], state[at + 2]);
    b.set(state[at + 3], state[at + 4], state[at + 5]);
    this.bell.position.copy(a);
    this.bell.quaternion.setFromUnitVectors(kUp, way.subVectors(b, a).normalize());
    // A blade that the hand has lost glows until it is held again.
    this.steel.emissive.setHex(0x222831).lerp(new Color(0xd04000), 0.8 * (1 - state[controlAt(this.side)]));
    if (isNewBout) this.count = 0;
    this.follow();
  }
  follow() {
    if (this.count === 0) for (let i = 0; i < kTraceLength; i += 1) b.toArray(this.trace, 3 * i);
    this.trace.copyWithin(0, 3);
    b.toArray(this.trace, 3 * (kTraceLength - 1));
    this.count += 1;
    this.line.geometry.attributes.position.needsUpdate = true;
  }
}

function buildRoom(scene) {
  scene.background = new Color(0x1b2230);
  scene.fog = new Fog(0x1b2230, 9, 30);
  const floor = new Mesh(new PlaneGeometry(40, 40), new MeshStandardMaterial({ color: 0x6b4a2f, roughness: 0.85 }));
  const strip = new Mesh(new PlaneGeometry(kStripLength, kStripWidth), new MeshStandardMaterial({ color: 0x8d959e, roughness: 0.55, metalness: 0.25 }));
  strip.position.z = 0.004;
  floor.receiveShadow = strip.receiveShadow = true;
  scene.add(floor, strip);
  const chalk = new MeshBasicMaterial({ color: 0xf2f2ee });
  for (const [x, broad] of kStripLines) {
    const line = new Mesh(new PlaneGeometry(broad, kStripWidth), chalk);
    line.position.set(x, 0, 0.008);
    scene.add(line);
  }
  scene.add(new HemisphereLight(0xdfe8ff, 0x5a4030, 1.1), new AmbientLight(0xffffff, 0.25));
  const lamp = new SpotLight(0xfff1d8, 90, 0, 0.75, 0.6, 1.8);
  lamp.up.set(0, 0, 1);
  lamp.position.set(kLampBeside, -2.2, 5.2);
  lamp.castShadow = true;
  lamp.shadow.mapSize.set(1024, 1024);
  const glint = new DirectionalLight(0xbcd4ff, 1.1);
  glint.position.set(-3, 3, 4);
  scene.add(lamp, lamp.target, glint);
  return lamp;
}

/** @throws where there is no WebGL */
export class Salle {
  constructor(canvas) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.detail = 1;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(38, 1, 0.05, 60);
    this.camera.up.set(0, 0, 1);
    this.lamp = buildRoom(this.scene);
    this.fencers = [0, 1].map((side) => new FencerView(this.scene, side));
    this.marks = new Group();
    this.scene.add(this.marks);
    this.circle = new RingGeometry(0.72, 1, 28);
    this.lastSteps = 0;
  }

  resize(width, height) {
    this.renderer.setPixelRatio(Math.min(globalThis.devicePixelRatio ?? 1, 1.5) * this.detail);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(height, 1);
    // A tall screen sees as much of the strip as a broad one.
    this.camera.fov = this.camera.aspect < 1.2 ? Math.min(75, (38 * 1.2) / this.camera.aspect) : 38;
    this.camera.updateProjectionMatrix();
  }

  /** Fewer pixels, where a machine draws too slowly. @returns whether there was something to save */
  coarser() {
    if (this.detail < 0.5) return false;
    this.detail *= 0.7;
    this.renderer.shadowMap.enabled = this.detail > 0.6;
    return true;
  }

  ring(point, size, colour, opacity = 0.9) {
    const mesh = new Mesh(this.circle, new MeshBasicMaterial({ color: colour, transparent: true, opacity, side: 2, depthTest: false }));
    mesh.scale.setScalar(size);
    mesh.position.fromArray(point);
    mesh.quaternion.copy(this.camera.quaternion);
    this.marks.add(mesh);
  }

  /** Blows fade; touches stay. */
  mark(state, blows) {
    for (const mark of this.marks.children) mark.material.dispose();
    this.marks.clear();
    const now = state[kSteps] / 1000;
    for (const blow of blows.slice(-kMostRings)) {
      const left = 1 - (now - blow.time) / kFadeSeconds;
      if (left > 0 && left <= 1) this.ring(blow.point, Math.min(0.02 + 0.12 * Math.sqrt(blow.impulse), 0.1), 0xffc340, 0.9 * left);
    }
    for (const touch of touchesOf(state)) {
      this.ring(touch.point, 0.13, 0xff3b30);
      this.ring(touch.point, 0.06, 0xff3b30);
    }
  }

  /** @param view  {turn, lift, far}: where the camera is, seen from between the fencers */
  draw(state, blows, view) {
    const isNew = state[0] < this.lastSteps;
    this.lastSteps = state[0];
    for (const fencer of this.fencers) fencer.show(state, isNew);
    // Lamp and camera go along, and back where the fencers are further apart than on guard.
    const middle = middleOf(state);
    const far = view.far + Math.max(0, apartOf(state) - kOnGuard);
    const flat = Math.cos(view.lift) * far;
    this.lamp.position.x = middle + kLampBeside;
    this.lamp.target.position.x = middle;
    this.camera.position.set(middle + Math.sin(view.turn) * flat, -Math.cos(view.turn) * flat, 1.05 + Math.sin(view.lift) * far);
    this.camera.lookAt(middle, 0, 1.0);
    this.mark(state, blows);
    this.renderer.render(this.scene, this.camera);
  }
}
