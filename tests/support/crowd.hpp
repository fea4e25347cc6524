// SPDX-License-Identifier: MIT
#pragma once
// Crowds of N capsules in flight, for what a step costs against N: the same on a host and on a
// part. Nothing is lost in a blow (C = 1) and the caller turns back what leaves a cube, so that a
// crowd is as dense at the end as at the beginning.

#include "batuta/world/world.hpp"
#include "draws.hpp"

namespace batuta::test {

enum class Crowd : std::uint8_t {
  kSparse,  ///< half a metre to the next one, and 0.24 m long: few meet
  kDense,   ///< 0.2 m to the next one: each has several neighbours
  kWorst,   ///< long, side by side along the diagonal of space: all boxes overlap
};
inline constexpr Crowd kCrowds[] = {Crowd::kSparse, Crowd::kDense, Crowd::kWorst};

constexpr const char* name(Crowd crowd) {
  constexpr const char* kNames[] = {"sparse", "dense", "worst"};
  return kNames[static_cast<int>(crowd)];
}

/// N bodies, and room for so many pairs that each has a few neighbours: far fewer than all pairs.
template <int N>
constexpr SceneOptions crowd_scene_options() {
  SceneOptions scene;
  scene.max_bodies = N;
  scene.max_pairs = 8 * N;
  scene.max_contacts = N < 16 ? 16 : N;
  scene.max_events = 2 * scene.max_contacts;
  scene.owners = false;
  scene.resting = RestingContact::kSettling;
  return scene;
}
template <class S, int N>
using CrowdScene = Scene<crowd_scene_options<N>, Advancement<S>>;

inline constexpr double kStep = 1e-3;  ///< s
inline constexpr double kSpeed = 1;    ///< m/s, largest component
inline constexpr double kSpin = 5;     ///< rad/s, about

/// A crowd of N, drawn anew from (seed, number); of all the same, whatever the scalar.
template <class S, int N>
class CrowdRun {
 public:
  using SceneT = CrowdScene<S, N>;

  void begin(Crowd crowd, std::uint64_t number);
  /// Turns back who is outside the cube and goes further out. Not part of a step.
  void turn_back();
  Status step() { return world_.step(static_cast<S>(kStep)); }
  World<SceneT>& world() { return world_; }

 private:
  static constexpr std::uint64_t kSeed = 20061107;

  Actor<SceneT> draw(Crowd crowd, Draws& draws, int i) const;
  bool is_free(const Actor<SceneT>& actor);
  void launch(Actor<SceneT>& actor, Draws& draws, double speed) const;
  static Vec3<S> rounded(const Vec3<double>& x) { return x.cast<S>(); }
  Pose<double> place(Crowd crowd, Draws& draws, int i) const;

  World<SceneT> world_;
  double half_ = 0;  ///< half the edge of the cube, m
};

/// Edge of a cube of N spacings cubed.
inline double edge_of(int n, double spacing) {
  double edge = 1;
  for (int i = 0; i < 40; ++i) edge -= (edge * edge * edge - n) / (3 * edge * edge);  // Bound: 40
  return spacing * edge;
}

template <class S, int N>
void CrowdRun<S, N>::begin(Crowd crowd, std::uint64_t number) {
  constexpr double kSpacing[] = {0.5, 0.2, 1};  // m
  constexpr int kTries = 1000;
  half_ = edge_of(N, kSpacing[static_cast<int>(crowd)]) / 2;
  for (int i = 0; i < N; ++i) (void)world_.remove(world_.id_at(static_cast<std::uint16_t>(i)));
  Draws draws(kSeed, static_cast<std::uint64_t>(crowd), number);
  for (int i = 0; i < N; ++i) {
    Actor<SceneT> actor = draw(crowd, draws, i);
    // Bound: kTries; a crowd fills a thirtieth of its cube.
    for (int k = 0; k < kTries && !is_free(actor); ++k) actor = draw(crowd, draws, i);
    (void)world_.add(actor);
  }
}

template <class S, int N>
Pose<double> CrowdRun<S, N>::place(Crowd crowd, Draws& draws, int i) const {
  Pose<double> X_WB;
  if (crowd == Crowd::kWorst) {  // a square lattice across the diagonal, 2 cm wide
    const Vec3<double> along = Vec3<double>::Ones().normalized();
    const Vec3<double> right = Vec3<double>(1, -1, 0).normalized();
    const Vec3<double> up = along.cross(right);
    constexpr int kRow = 23;
    X_WB.p_W = 0.02 * ((i % kRow - kRow / 2) * right + (i / kRow - kRow / 2) * up);
    const double half_angle_cos = std::sqrt((1 + along.z()) / 2);
    const double part = std::sqrt((1 - along.z()) / 4);
    X_WB.q_WB = {half_angle_cos, -part, part, 0};  // z to the diagonal
  } else {
    const double x = draws.signed_unit();
    const double y = draws.signed_unit();
    const double z = draws.signed_unit();
    X_WB.p_W = half_ * Vec3<double>(x, y, z);
    X_WB.q_WB = draws.rotation();
  }
  return X_WB;
}

template <class S, int N>
Actor<CrowdScene<S, N>> CrowdRun<S, N>::draw(Crowd crowd, Draws& draws, int i) const {
  const bool is_long = crowd == Crowd::kWorst;
  const S half_length = is_long ? S(1) : S(0.1);
  const S radius = is_long ? S(0.002) : S(0.02);
  Actor<SceneT> actor;
  actor.capsule_B = {{{0, 0, -half_length}, {0, 0, half_length}}, radius};
  actor.restitution = 1;
  const Pose<double> X_WB = place(crowd, draws, i);
  const auto solid = solid_capsule(actor.capsule_B, S(1000)).value;
  actor.body = make_body<S>({rounded(X_WB.p_W), X_WB.q_WB.template cast<S>()}, solid.mass,
                            solid.inertia_S.diagonal())
                   .value;
  launch(actor, draws, is_long ? 0.1 * kSpeed : kSpeed);
  return actor;
}

template <class S, int N>
void CrowdRun<S, N>::launch(Actor<SceneT>& actor, Draws& draws, double speed) const {
  const Vec3<double> v = draws.in_ball(speed);
  const Vec3<double> w = draws.in_ball(kSpin * speed);
  actor.body.momentum = momentum_of(actor.body, {rounded(v), rounded(w)});
}

template <class S, int N>
bool CrowdRun<S, N>::is_free(const Actor<SceneT>& actor) {
  const Capsule<S> shape = to_world(actor.body.X_WB, actor.capsule_B);
  for (std::uint16_t i = 0; i < N; ++i) {  // Bound: N
    const auto* other = world_.get(world_.id_at(i));
    if (other != nullptr &&
        capsule_gap(shape, to_world(other->body.X_WB, other->capsule_B)).gap < S(1e-3)) {
      return false;
    }
  }
  return true;
}

template <class S, int N>
void CrowdRun<S, N>::turn_back() {
  const World<SceneT>& seen = world_;
  for (std::uint16_t i = 0; i < N; ++i) {  // Bound: N
    const auto* actor = seen.get(seen.id_at(i));
    if (actor == nullptr) continue;
    const Vec3<S>& p = actor->body.X_WB.p_W;
    const Vec3<S>& momentum = actor->body.momentum.linear_W;
    for (int k = 0; k < 3; ++k) {  // Bound: 3
      if (std::abs(p[k]) < static_cast<S>(half_) || p[k] * momentum[k] < S(0)) continue;
      world_.get(seen.id_at(i))->body.momentum.linear_W[k] *= S(-1);
    }
  }
}

}  // namespace batuta::test
