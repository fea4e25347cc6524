// SPDX-License-Identifier: MIT
#pragma once
// Scenes, bodies and draws that the tests of the small world share.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "batuta/record/world.hpp"
#include "batuta/world/scene_cost.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta::test {

/// All features that a small scene can have.
constexpr SceneOptions lean_scene_options() {
  SceneOptions scene = straight_spheres();
  scene.max_contacts = 64;
  scene.owners = true;
  scene.filters = true;
  scene.gravity = true;
  return scene;
}
template <template <class> class SearchT, class S>
using LeanScene = Scene<lean_scene_options, SearchT<S>>;
/// The same, in a general world.
template <class SceneT>
constexpr SceneOptions told_options() {
  SceneOptions scene = SceneT::kStated;
  scene.engine = Engine::kGeneral;
  scene.max_pairs = 28;  // all of them
  scene.max_events = 64;
  return scene;
}
template <class SceneT>
using Told = Scene<told_options<SceneT>, typename SceneT::Search>;

static_assert(std::is_base_of_v<detail::SmallWorld<StraightSpheres>, World<StraightSpheres>>);
static_assert(std::is_base_of_v<detail::GeneralWorld<TwoBlades>, World<TwoBlades>>);
static_assert(scene_cost<StraightSpheres>.rounds == 8 + 8 + 1);
static_assert(scene_cost<StraightSpheres>.evaluations == 17 * 28);

template <class S>
Vec3<S> vec(double x, double y, double z) {
  return {static_cast<S>(x), static_cast<S>(y), static_cast<S>(z)};
}

template <class SceneT>
void put_shape(Actor<SceneT>& actor, const Vec3<double>& half, double radius) {
  using S = typename SceneT::Scalar;
  if constexpr (SceneT::Search::kForSpheres) {
    actor.radius = static_cast<S>(radius);
  } else {
    const Vec3<S> end = half.cast<S>();
    actor.capsule_B = {{-end, end}, static_cast<S>(radius)};
  }
}

/// On the x axis, C = 1.
template <class SceneT>
Actor<SceneT> ball(double x, double vx, double mass = 1) {
  using S = typename SceneT::Scalar;
  Actor<SceneT> actor;
  actor.body = make_straight_body<S>(vec<S>(x, 0, 0), static_cast<S>(mass)).value;
  if (std::isfinite(mass)) actor.body.momentum_W = vec<S>(mass * vx, 0, 0);
  actor.restitution = 1;
  put_shape(actor, {0, 0, 0.5}, 0.1);
  return actor;
}

template <class SceneT>
Segment<double> axis_of(const Actor<SceneT>& actor) {
  const Vec3<double> p = actor.body.p_W.template cast<double>();
  if constexpr (SceneT::Search::kForSpheres) {
    return {p, p};
  } else {
    return {p + actor.capsule_B.axis.a.template cast<double>(),
            p + actor.capsule_B.axis.b.template cast<double>()};
  }
}
template <class SceneT>
double radius_of(const Actor<SceneT>& actor) {
  if constexpr (SceneT::Search::kForSpheres) {
    return static_cast<double>(actor.radius);
  } else {
    return static_cast<double>(actor.capsule_B.radius);
  }
}

/// In double, by the distance of the axes.
template <class SceneT>
double gap_of(const Actor<SceneT>& A, const Actor<SceneT>& B) {
  return capsule_gap(Capsule<double>{axis_of(A), radius_of(A)},
                     Capsule<double>{axis_of(B), radius_of(B)})
      .gap;
}

template <class SceneT>
double least_gap(const World<SceneT>& world) {
  double least = INFINITY;
  for (std::uint16_t a = 0; a < SceneT::kMaxBodies; ++a) {
    for (std::uint16_t b = 0; b < a; ++b) {
      const auto* A = world.get(world.id_at(a));
      const auto* B = world.get(world.id_at(b));
      if (A == nullptr || B == nullptr || !detail::may_meet(*A, *B)) continue;
      if (A->body.inverse_mass == 0 && B->body.inverse_mass == 0) continue;
      least = std::min(least, gap_of(*A, *B));
    }
  }
  return least;
}

/// Random bodies, none of which overlaps another.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec3<double> vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(random_) == 1; }

  template <class SceneT>
  Actor<SceneT> actor(bool bouncy) {
    using S = typename SceneT::Scalar;
    Actor<SceneT> actor;
    const S mass = one_in(5) ? S(INFINITY) : static_cast<S>(in(0.5, 3));
    actor.body = make_straight_body<S>(vector(0.35).cast<S>(), mass).value;
    actor.body.momentum_W = (in(0.5, 3) * vector(4)).cast<S>();
    actor.restitution = bouncy ? S(1) : static_cast<S>(in(0, 1));
    if (one_in(8)) actor.owner = 7;
    if (one_in(8)) actor.filter = {2, 1};
    put_shape(actor, vector(0.15), in(0.03, 0.1) * (SceneT::Search::kForSpheres ? 1.5 : 1));
    return actor;
  }
  template <class SceneT>
  std::vector<Actor<SceneT>> actors(int count, bool bouncy = false) {
    std::vector<Actor<SceneT>> all;
    while (static_cast<int>(all.size()) < count) {
      const auto next = actor<SceneT>(bouncy);
      bool fits = true;
      for (const auto& other : all) fits = fits && gap_of(next, other) > 0.01;
      if (fits) all.push_back(next);
    }
    return all;
  }

 private:
  std::mt19937 random_;
};

template <class SceneT>
Actor<Told<SceneT>> told(const Actor<SceneT>& actor) {
  Actor<Told<SceneT>> same;
  static_cast<detail::ShapeOf<SceneT>&>(same) = actor;
  static_cast<detail::Owned&>(same) = actor;
  static_cast<detail::Filtered&>(same) = actor;
  same.restitution = actor.restitution;
  same.body = actor.body;
  return same;
}

template <class SceneT>
class Small : public ::testing::Test {
 protected:
  static constexpr bool kIsFloat = std::is_same_v<typename SceneT::Scalar, float>;
  static constexpr double kRounding = kIsFloat ? 1e-6 : 1e-14;
  /// Capsules are answered within a contact tolerance, and not at one instant.
  static constexpr double kSame = kIsFloat ? 2e-3 : SceneT::Search::kForSpheres ? 1e-9 : 1e-4;
};
using SmallScenes = ::testing::Types<LeanScene<Spheres, float>, LeanScene<Spheres, double>,
                                     LeanScene<Translation, float>, LeanScene<Translation, double>>;

}  // namespace batuta::test
