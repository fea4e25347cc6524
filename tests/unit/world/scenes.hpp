// SPDX-License-Identifier: MIT
#pragma once
// Scenes and bodies that the world's tests share.

#include "batuta/world/any_controller.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta::test {

constexpr SceneOptions flight_scene_options() {
  SceneOptions scene;
  scene.max_bodies = 6;
  scene.max_pairs = 15;
  return scene;
}
template <class S>
using AnyFlight = AnyController<S, FreeFlight<S>, Fixed<S>, Hand<S>>;
template <class S, template <class> class SearchT = Advancement>
using FlightScene = Scene<flight_scene_options, SearchT<S>, AnyFlight<S>>;

template <class S>
Vec3<S> vec(double x, double y, double z) {
  return {static_cast<S>(x), static_cast<S>(y), static_cast<S>(z)};
}

/// A solid ball of mass 1 kg, in flight.
template <class SceneT>
Actor<SceneT> ball(double x, double radius, double vx) {
  using S = typename SceneT::Scalar;
  Actor<SceneT> actor;
  const S inertia = static_cast<S>(0.4 * radius * radius);
  actor.body =
      make_body<S>({vec<S>(x, 0, 0), Quat<S>::Identity()}, S(1), {inertia, inertia, inertia}).value;
  actor.body.momentum.linear_W = vec<S>(vx, 0, 0);
  actor.capsule_B = Capsule<S>::sphere(Vec3<S>::Zero(), static_cast<S>(radius));
  actor.restitution = 1;
  return actor;
}

/// A rod of 1 kg along z, 2 half_length between the ends of its axis, at (x, 0, 0), in flight.
template <class SceneT>
Actor<SceneT> rod(double x, double half_length, double radius) {
  using S = typename SceneT::Scalar;
  const Segment<S> axis{vec<S>(0, 0, -half_length), vec<S>(0, 0, half_length)};
  const Capsule<S> capsule{axis, static_cast<S>(radius)};
  const auto mass = solid_capsule(capsule, S(1)).value;
  Actor<SceneT> actor;
  const S scale = S(1) / mass.mass;
  const Vec3<S> moments = scale * mass.inertia_S.diagonal();
  actor.body = make_body<S>({vec<S>(x, 0, 0), Quat<S>::Identity()}, S(1), moments).value;
  actor.capsule_B = capsule;
  return actor;
}

/// A fixed wall: a post along y through (x, 0, 0).
template <class SceneT>
Actor<SceneT> post(double x, double radius) {
  using S = typename SceneT::Scalar;
  Actor<SceneT> actor;
  actor.body.X_WB.p_W = vec<S>(x, 0, 0);
  actor.capsule_B = {{vec<S>(0, -2, 0), vec<S>(0, 2, 0)}, static_cast<S>(radius)};
  actor.controller = Fixed<S>{};
  return actor;
}

template <class SceneT>
double total_energy(World<SceneT>& world) {
  double sum = 0;
  for (std::uint16_t slot = 0; slot < SceneT::kMaxBodies; ++slot) {
    if (auto* actor = world.get(world.id_at(slot)))
      sum += static_cast<double>(kinetic_energy(actor->body));
  }
  return sum;
}

}  // namespace batuta::test
