// SPDX-License-Identifier: MIT
#pragma once
// Lengths of a pair of capsules: what a search cannot tell from contact, and D, the one length that
// rules rest (src/world/world.md, "One length").

#include "batuta/geometry/direction.hpp"
#include "batuta/world/detail/bodies.hpp"

namespace batuta::detail {

/// The gap from which a search lets parting bodies go, m (src/world/detail/margin.md).
/// @param query  the PairQuery of its search
template <class SceneT, class Query>
Scalar_of<SceneT> search_margin(const Bodies<SceneT>& bodies, const Query& query, ProxyPair pair) {
  using Scalar = Scalar_of<SceneT>;
  using BodiesT = Bodies<SceneT>;
  constexpr Scalar kContactGaps = 2;
  constexpr Scalar kUlps = 64;
  const Scalar size = length(position_of(bodies.actor(BodiesT::body_of(pair.first)))) +
                      length(position_of(bodies.actor(BodiesT::body_of(pair.second)))) +
                      query.scale;
  return kContactGaps * query.contact_gap + kUlps * kRoundOff<Scalar> * size;
}

/// What the solution of a contact may leave, m/s, <= 0: no more in the rest of a step than what the
/// search cannot tell from contact; the opening of the gap makes up for it.
template <class SceneT, class Query>
inline Scalar_of<SceneT> slowest_closing(const Bodies<SceneT>& bodies, const Query& query,
                                         bool is_solved) {
  using Scalar = Scalar_of<SceneT>;
  return is_solved ? -query.contact_gap / (bodies.dt - bodies.now) : Scalar(0);
}

/// What a part adds to the lengths of a pair, m.
template <class Scalar>
struct PartSize {
  Scalar length = 0;
  Scalar turn = 0;
  Scalar from_origin = 0;
};

/// What the search cannot tell from contact, twice, between things whose sizes, ways and distance
/// from each other add up to `scale`, and that are `from_origin` from the world's origin.
template <class SceneT>
Scalar_of<SceneT> twice_margin(const Bodies<SceneT>& bodies, Scalar_of<SceneT> scale,
                               Scalar_of<SceneT> turned) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kMargins = 2;
  constexpr Scalar kContactGaps = 2;
  MovingPair<Scalar> query;
  query.scale = scale;
  query.duration = 1;
  query.A.turn_rate = 1;
  query.A.bounding_radius = turned;
  return kMargins * kContactGaps * SceneT::Search::contact_gap(query, bodies.settings.search);
}

/// How fast any of its matter goes at most, m/s.
template <class SceneT>
Scalar_of<SceneT> most_speed(const Actor<SceneT>& actor, const Twist<Scalar_of<SceneT>>& twist) {
  using Vector = Vec3<Scalar_of<SceneT>>;
  const Vector w_B = actor.body.X_WB.q_WB.conjugate() * twist.w_W;
  const auto turn = length(w_B);
  Scalar_of<SceneT> around = 0;
  for (int i = 0; i < parts_of(actor); ++i) {  // Bound: kCapsulesPerBody
    const Capsule<Scalar_of<SceneT>>& part = part_of(actor, i);
    const auto at_a = length<Scalar_of<SceneT>>(w_B.cross(part.axis.a));
    const auto at_b = length<Scalar_of<SceneT>>(w_B.cross(part.axis.b));
    around = max_of(around, max_of(at_a, at_b) + turn * part.radius);
  }
  return length(twist.v_W) + around;
}

/// What a part adds to the length of a pair, and how far it turns.
template <class SceneT>
PartSize<Scalar_of<SceneT>> size_of(const Bodies<SceneT>& bodies, int proxy) {
  using Scalar = Scalar_of<SceneT>;
  using BodiesT = Bodies<SceneT>;
  const auto& actor = bodies.actor(BodiesT::body_of(proxy));
  const Capsule<Scalar>& part = part_of(actor, BodiesT::part_at(proxy));
  const Twist<Scalar>& twist = bodies.states[BodiesT::body_of(proxy)].plan.motion.twist;
  const Scalar reach = max_of(length(part.axis.a), length(part.axis.b));
  return {reach + part.radius, bodies.dt * length(twist.w_W) * reach, length(position_of(actor))};
}

/// What D has to be for one part alone; for a pair it is at most the sum of both.
template <class SceneT>
Scalar_of<SceneT> own_rest_gap(const Bodies<SceneT>& bodies, int proxy) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kUlps = 2 * 64 * 2;  // twice the margin, which counts places twice
  const PartSize<Scalar> size = size_of(bodies, proxy);
  const Vec3<Scalar>& v_W = bodies.states[Bodies<SceneT>::body_of(proxy)].plan.motion.twist.v_W;
  const Scalar scale = size.from_origin + size.length + bodies.dt * length(v_W);
  const Scalar rounding = kUlps * kRoundOff<Scalar> * scale;
  Scalar D = max_of(bodies.settings.separation, rounding + twice_margin(bodies, scale, size.turn));
  if constexpr (SceneT::kGravity) {
    D = max_of(D, bodies.dt * bodies.dt * length(bodies.settings.gravity_W) / 4);
  }
  return D;
}

/// The gap from which a search lets parting bodies go, m, before anybody is planned.
template <class SceneT>
Scalar_of<SceneT> margin_at_start(const Bodies<SceneT>& bodies, ProxyPair pair) {
  using Scalar = Scalar_of<SceneT>;
  using BodiesT = Bodies<SceneT>;
  constexpr Scalar kUlps = 2 * 64;  // twice the margin
  const PartSize<Scalar> A = size_of(bodies, pair.first);
  const PartSize<Scalar> B = size_of(bodies, pair.second);
  const Scalar apart = length<Scalar>(position_of(bodies.actor(BodiesT::body_of(pair.first))) -
                                      position_of(bodies.actor(BodiesT::body_of(pair.second))));
  // The way is that of one past the other: a velocity that both have makes no difference.
  const Scalar way =
      bodies.dt *
      length<Scalar>(bodies.states[BodiesT::body_of(pair.first)].plan.motion.twist.v_W -
                     bodies.states[BodiesT::body_of(pair.second)].plan.motion.twist.v_W);
  const Scalar scale = apart + A.length + B.length + way;
  const Scalar rounding = kUlps * kRoundOff<Scalar> * (A.from_origin + B.from_origin + scale);
  return (rounding + twice_margin(bodies, scale, A.turn + B.turn)) / 2;
}

/// D of a pair, m: the one length that rules rest.
template <class SceneT>
Scalar_of<SceneT> rest_gap(const Bodies<SceneT>& bodies, ProxyPair pair) {
  using Scalar = Scalar_of<SceneT>;
  Scalar D = max_of(bodies.settings.separation, 2 * margin_at_start(bodies, pair));
  if constexpr (SceneT::kGravity) {
    D = max_of(D, bodies.dt * bodies.dt * length(bodies.settings.gravity_W) / 4);
  }
  return D;
}

}  // namespace batuta::detail
