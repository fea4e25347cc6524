// SPDX-License-Identifier: MIT
#pragma once
// What can be seen of a world from outside, in long double: poses, momenta, shapes. What the laws
// are checked with owes nothing to the library but the numbers that it stores.

#include <algorithm>
#include <cmath>
#include <vector>

#include "batuta/world/world.hpp"

namespace batuta::test {

using Real = long double;
using Real3 = Eigen::Matrix<Real, 3, 1>;
using RealQuat = Eigen::Quaternion<Real>;

struct SeenPart {
  Real3 a = Real3::Zero();  ///< ends of the axis, in W, m
  Real3 b = Real3::Zero();
  Real radius = 0;
};
struct SeenBody {
  int slot = 0;
  bool led = false;    ///< a controller moves it, or nothing can
  bool moves = false;  ///< a controller takes it somewhere
  bool asleep = false;
  Real inverse_mass = 0;
  Real mass = 0;  ///< 0: nothing pushes it
  Real3 inverse_moments = Real3::Zero();
  Real3 x = Real3::Zero();
  RealQuat q = RealQuat::Identity();
  Real3 p = Real3::Zero();
  Real3 b = Real3::Zero();
  Real friction = 0;
  Real reach = 0;  ///< from its point to its furthest surface, m
  std::vector<SeenPart> parts;

  Real3 v() const { return inverse_mass * p; }
  Real3 w() const {
    const Real3 b_B = q.conjugate() * b;
    return q * inverse_moments.cwiseProduct(b_B);
  }
  Real turning() const { return b.dot(w()) / 2; }  ///< J
  Real kinetic() const { return inverse_mass * p.squaredNorm() / 2 + turning(); }
  /// The energy if it turned about its softest axis, J.
  Real soft() const {
    return inverse_mass * p.squaredNorm() / 2 + inverse_moments.maxCoeff() * b.squaredNorm() / 2;
  }
  /// Three moments that differ by more than a share of the largest inverse one.
  bool is_unlike(Real share = 1e-4L) const {
    const Real3& j = inverse_moments;
    const Real near = share * j.maxCoeff();
    const auto differ = [&](int i, int k) { return std::abs(j[i] - j[k]) > near; };
    return differ(0, 1) && differ(1, 2) && differ(0, 2);
  }
};
using Seen = std::vector<SeenBody>;

/// From the nearest point of an axis to a point.
inline Real3 way_to(const SeenPart& part, const Real3& point) {
  const Real3 along = part.b - part.a;
  const Real square = along.squaredNorm();
  const Real share = square > 0 ? std::clamp<Real>(along.dot(point - part.a) / square, 0, 1) : 0;
  return point - (part.a + share * along);
}

/// From A's axis to B's, the shortest way: the least of four ends against the other axis, and of
/// where both lines come nearest.
inline Real3 way_between(const SeenPart& A, const SeenPart& B) {
  Real3 least = way_to(A, B.a);
  const auto offer = [&least](const Real3& way) {
    if (way.squaredNorm() < least.squaredNorm()) least = way;
  };
  offer(way_to(A, B.b));
  offer(-way_to(B, A.a));
  offer(-way_to(B, A.b));
  const Real3 d = A.b - A.a;
  const Real3 e = B.b - B.a;
  const Real3 n = d.cross(e);
  const Real square = n.squaredNorm();
  if (square > 0) {
    const Real3 r = B.a - A.a;
    const Real s = r.cross(e).dot(n) / square;
    const Real t = r.cross(d).dot(n) / square;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) offer(r.dot(n) / square * n);
  }
  return least;
}
inline Real gap_of(const SeenPart& A, const SeenPart& B) {
  return way_between(A, B).norm() - A.radius - B.radius;
}

template <class S>
SeenPart seen_part(const Real3& x, const RealQuat& q, const Capsule<S>& shape) {
  return {x + q * shape.axis.a.template cast<Real>(), x + q * shape.axis.b.template cast<Real>(),
          static_cast<Real>(shape.radius)};
}

template <class S>
void see_state(SeenBody& seen, const Body<S>& body) {
  seen.x = body.X_WB.p_W.template cast<Real>();
  seen.q = body.X_WB.q_WB.template cast<Real>();
  seen.q.normalize();
  seen.p = body.momentum.linear_W.template cast<Real>();
  seen.b = body.momentum.angular_W.template cast<Real>();
  seen.inverse_moments = body.inverse_moments.template cast<Real>();
}
template <class S>
void see_state(SeenBody& seen, const StraightBody<S>& body) {
  seen.x = body.p_W.template cast<Real>();
  seen.p = body.momentum_W.template cast<Real>();
}

template <class SceneT>
SeenBody see(const Actor<SceneT>& actor) {
  SeenBody seen;
  see_state(seen, actor.body);
  seen.inverse_mass = static_cast<Real>(actor.body.inverse_mass);
  seen.mass = seen.inverse_mass > 0 ? 1 / seen.inverse_mass : 0;
  seen.led = !(seen.inverse_mass > 0);
  if constexpr (SceneT::kFriction) seen.friction = static_cast<Real>(actor.friction);
  if constexpr (SceneT::Search::kForSpheres) {
    seen.parts.push_back({seen.x, seen.x, static_cast<Real>(actor.radius)});
  } else {
    for (int i = 0; i < parts_of(actor); ++i) {
      seen.parts.push_back(seen_part(seen.x, seen.q, part_of(actor, i)));
    }
  }
  for (const SeenPart& part : seen.parts) {
    const Real end = std::max((part.a - seen.x).norm(), (part.b - seen.x).norm());
    seen.reach = std::max(seen.reach, end + part.radius);
  }
  return seen;
}

/// How deep any two bodies are in each other, all parts of both; 0: nowhere, m.
template <class SceneT>
Real true_overlap(const World<SceneT>& world) {
  Seen seen;
  for (int i = 0; i < SceneT::kMaxBodies; ++i) {
    const auto* actor = world.get(world.id_at(static_cast<std::uint16_t>(i)));
    if (actor != nullptr) seen.push_back(see(*actor));
  }
  Real deepest = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (seen[i].led && seen[k].led) continue;
      for (const SeenPart& A : seen[i].parts) {
        for (const SeenPart& B : seen[k].parts) deepest = std::max(deepest, -gap_of(A, B));
      }
    }
  }
  return deepest;
}

}  // namespace batuta::test
