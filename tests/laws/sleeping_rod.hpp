// SPDX-License-Identifier: MIT
#pragma once
// A rod that sleeps across two rails, which may be led.

#include <gtest/gtest.h>

#include "batuta/world/any_controller.hpp"
#include "law_worlds.hpp"

namespace batuta::test {

inline constexpr double kRadius = 0.05;  // of all rods, m

/// A rod that sleeps across two rails along x, 0.8 m apart.
template <class SceneT>
struct Bed {
  using S = typename SceneT::Scalar;
  using Id = typename World<SceneT>::BodyId;
  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  Id rails[2];
  Id sleeper;

  /// @param put  what a rail has besides its shape: put(actor)
  template <class Put>
  explicit Bed(const Put& put) {
    for (int i = 0; i < 2; ++i) {
      auto rail = fixed_rod<SceneT>(6, kRadius, {0, i == 0 ? -0.4 : 0.4, -kRadius}, along_x());
      put(rail);
      rails[i] = world->add(rail).value;
    }
    auto rod = solid_rod<SceneT>(1.2, kRadius, {0, 0, kRadius + 5e-5}, along_y());
    rod.friction = S(0.3);
    sleeper = world->add(rod).value;
  }
  Bed() : Bed([](Actor<SceneT>& /*rail*/) {}) {}

  const Body<S>& body(Id id) const { return std::as_const(*world).get(id)->body; }
  double height(Id id) const { return static_cast<double>(body(id).X_WB.p_W.z()); }
  double speed(Id id) const {
    return static_cast<double>(body(id).inverse_mass * body(id).momentum.linear_W.x());
  }
  void step(double dt) { ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk); }
  void sleep(double dt) {
    for (int i = 0; i < 3000 && !world->is_asleep(sleeper); ++i) step(dt);
    ASSERT_TRUE(world->is_asleep(sleeper));
  }
};

template <class S>
using Led = Scene<law_options<RestingContact::kSettling, kSleeping>, Advancement<S>,
                  AnyController<S, FreeFlight<S>, Hand<S>>>;

/// Both rails go to where they began and `shift` from there, by the end of the step.
template <class S>
void lead(Bed<Led<S>>& bed, const Vector& shift, double dt) {
  for (int i = 0; i < 2; ++i) {
    auto* hand = bed.world->get(bed.rails[i])->controller.template as<Hand<S>>();
    hand->step = static_cast<S>(dt);
    const Vector start(0, i == 0 ? -0.4 : 0.4, -kRadius);
    hand->target_W.p_W = (start + shift).template cast<S>();
    hand->target_W.q_WB = along_x().template cast<S>();
  }
}

}  // namespace batuta::test
