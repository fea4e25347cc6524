// SPDX-License-Identifier: MIT
// The library's worlds for what a step costs: a scene for each number of bodies, with room for no
// more, and without what the other engine does not do (events).

#include "batuta_engine.hpp"

namespace batuta::worlds {
namespace {

template <int N>
constexpr SceneOptions bars_options() {
  SceneOptions scene;
  scene.max_bodies = N;
  scene.max_pairs = 16 * N;
  scene.max_contacts = 8 * N;
  scene.max_events = 0;
  scene.owners = false;
  scene.friction = true;
  scene.line_contact = true;
  scene.gravity = true;
  scene.resting = RestingContact::kSettling;
  return scene;
}

/// Room for two neighbours each, and for a contact of every second one: fewer than half as many
/// pairs are near at once, and one contact in a hundred bodies.
template <int N>
constexpr SceneOptions sparse_options() {
  SceneOptions scene;
  scene.max_bodies = N;
  scene.max_pairs = N;
  scene.max_contacts = N / 4;
  scene.max_events = 0;
  scene.owners = false;
  scene.resting = RestingContact::kSettling;
  return scene;
}

template <int N>
void add_bars(EnginePtr& engine, int bodies, int hz) {
  if (bodies == N) engine = std::make_unique<BatutaEngine<Scene<bars_options<N>>>>(hz);
}
template <int N>
void add_crowd(EnginePtr& engine, int bodies, int hz) {
  if (bodies == N) engine = std::make_unique<BatutaEngine<Scene<sparse_options<N>>>>(hz);
}

}  // namespace

EnginePtr batuta_bars(int bodies, int hz) {
  EnginePtr engine;
  add_bars<32>(engine, bodies, hz);
  add_bars<64>(engine, bodies, hz);
  add_bars<128>(engine, bodies, hz);
  return engine;
}

EnginePtr batuta_crowd(int bodies, int hz) {
  EnginePtr engine;
  add_crowd<32>(engine, bodies, hz);
  add_crowd<64>(engine, bodies, hz);
  add_crowd<128>(engine, bodies, hz);
  add_crowd<256>(engine, bodies, hz);
  add_crowd<512>(engine, bodies, hz);
  add_crowd<1024>(engine, bodies, hz);
  add_crowd<2048>(engine, bodies, hz);
  add_crowd<4096>(engine, bodies, hz);
  return engine;
}

}  // namespace batuta::worlds
