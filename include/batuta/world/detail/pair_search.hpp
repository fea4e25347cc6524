// SPDX-License-Identifier: MIT
#pragma once
// Pairs: the search of one pair, and what may spare it (src/world/world.md, "No search"). Included
// by pairs.hpp.

#include "batuta/world/detail/pairs.hpp"

namespace batuta::detail {

/// The ends of a capsule along a normal: where they are, and how fast they go.
template <class Scalar>
struct EndsAlong {
  Scalar first = 0;   ///< the furthest at the start, m
  Scalar last = 0;    ///< at the end of the time, m, were they to go straight on
  Scalar bend = 0;    ///< as far as they may be off that, m
  Scalar length = 0;  ///< what rounding is proportional to, m
};

/// @param sign  +1: the furthest along the normal; -1: along its opposite
template <class Scalar>
EndsAlong<Scalar> ends_along(const MovingCapsule<Scalar>& moving, const Vec3<Scalar>& origin_W,
                             const Vec3<Scalar>& origin_v_W, const Vec3<Scalar>& normal_W,
                             Scalar sign) {
  const Motion<Scalar>& motion = moving.motion;
  const Vec3<Scalar> at_W = motion.X_WB.p_W - origin_W;
  const Vec3<Scalar> v_W = motion.twist.v_W - origin_v_W;
  const Scalar place = normal_W.dot(at_W);
  const Scalar way = motion.duration * normal_W.dot(v_W);
  EndsAlong<Scalar> ends;
  Scalar reach = 0;
  for (int i = 0; i < 2; ++i) {  // Bound: two ends
    const Vec3<Scalar> arm_W =
        motion.X_WB.q_WB * (i == 0 ? moving.capsule_B.axis.a : moving.capsule_B.axis.b);
    const Scalar here = place + normal_W.dot(arm_W);
    const Scalar there = here + way + motion.duration * normal_W.dot(motion.twist.w_W.cross(arm_W));
    reach = max_of(reach, length(arm_W));
    ends.first = i == 0 ? here : sign * max_of(sign * ends.first, sign * here);
    ends.last = i == 0 ? there : sign * max_of(sign * ends.last, sign * there);
  }
  const Scalar turn = motion.duration * length(motion.twist.w_W);
  ends.bend = turn * turn * reach / 2;
  ends.length =
      length(at_W) + reach + motion.duration * length(v_W) + turn * reach + moving.capsule_B.radius;
  return ends;
}

/// Where many pairs wait, and their search remembers a normal. One pair has no other to wait for:
/// there it would be code for what the search tells as well.
template <class SceneT>
inline constexpr bool kSparesSearches = kLasts<SceneT> ||
                                        (SceneT::kRotation && SceneT::Search::kUsesSeed &&
                                         SceneT::kMaxPairs > 1);

/// What has to be left between two that are proven apart without a search, as a share of the length
/// of the query. Where contacts do not last, a gap that the search calls contact is one.
template <class SceneT>
Scalar_of<SceneT> spare_share([[maybe_unused]] const Bodies<SceneT>& bodies) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kNoise = 2 * kInflation<Scalar>;
  if constexpr (kLasts<SceneT>) {
    return kNoise;
  } else {
    return kNoise +
           max_of(bodies.settings.search.contact_tolerance, kLeastContactTolerance<Scalar>);
  }
}

/// Whether the normal that parted the pair last parts it for all the time to come: ends go straight
/// on but for half of (w t)^2 times their arm, so that what is between them along a fixed normal is
/// least at one of both ends of the time (world.md, "No search").
template <class SceneT>
bool stays_apart(const Bodies<SceneT>& bodies, ProxyPair pair,
                 const Vec3<Scalar_of<SceneT>>& normal) {
  using Scalar = Scalar_of<SceneT>;
  if (is_zero(normal)) return false;
  const auto A = bodies.mover(pair.first, bodies.dt);
  const auto B = bodies.mover(pair.second, bodies.dt);
  const Vec3<Scalar> origin_W = A.motion.X_WB.p_W;
  const Vec3<Scalar> origin_v_W = A.motion.twist.v_W;
  const auto a = ends_along<Scalar>(A, origin_W, origin_v_W, normal, Scalar(1));
  const auto b = ends_along<Scalar>(B, origin_W, origin_v_W, normal, Scalar(-1));
  const Scalar at_end = (b.last - a.last) - (a.bend + b.bend);
  const Scalar between = min_of(b.first - a.first, at_end);
  const Scalar least = spare_share(bodies) * (a.length + b.length);
  return between - (A.capsule_B.radius + B.capsule_B.radius) > least;
}

/// What was seen of the earliest candidate is kept: its contact then needs no other evaluation.
template <class SceneT>
template <class PartsAlong>
void Pairs<SceneT>::search(BodiesT& bodies, CandidateType& candidate,
                           const PartsAlong& parts_along) {
  candidate.asked = true;
  if constexpr (kSparesSearches<SceneT>) {
    Vec3<Scalar> normal = seed(candidate.pair);
    // Of two pairs with one place in the memory one is forgotten: its contact still knows.
    if (kLasts<SceneT> && is_zero(normal)) normal = parts_along(candidate.pair);
    if (stays_apart(bodies, candidate.pair, normal)) {
      candidate.outcome = Outcome::kFree;
      return;
    }
  }
  ++bodies.report.pairs;
  Scalar until = bodies.dt;
  if constexpr (SceneT::kResting == RestingContact::kSeparation) {
    for (const int proxy : {int{candidate.pair.first}, int{candidate.pair.second}}) {  // Bound: 2
      const auto& state = bodies.states[BodiesT::body_of(proxy)];
      if (state.group != BodiesT::kAlone) until = min_of(until, state.held_until);
    }
  }
  until = min_of(until, min_of(bodies.plan_end(BodiesT::body_of(candidate.pair.first)),
                               bodies.plan_end(BodiesT::body_of(candidate.pair.second))));
  PairQuery& query = queries_.spare();
  const bool is_solved = kLasts<SceneT> && !is_zero(parts_along(candidate.pair));
  search_pair(bodies, candidate.pair, until, is_solved, query);
  bodies.report.evaluations += query.evaluations();
  candidate.outcome = query.outcome();
  candidate.since = bodies.now;
  candidate.free_for = query.t_free();
  candidate.near_after = query.near_after();
  const bool is_seen = candidate.outcome != Outcome::kFree && !query.is_early;
  if (is_seen) queries_.offer(candidate.pair, candidate.free_until());
}

/// Radii smaller by `missing` together. @returns false: they are not that large
template <class Scalar>
bool make_thinner(MovingPair<Scalar>& pair, Scalar missing) {
  const Scalar radii = pair.A.radius + pair.B.radius;
  if (!(missing < radii)) return false;
  pair.A.radius *= Scalar(1) - missing / radii;
  pair.B.radius *= Scalar(1) - missing / radii;
  return true;
}

/// By how much a pair is to be thinner, so that it is clear of contact where it is and turns back
/// before it overlaps by more than the margin: it has `share` of what is left to there.
template <class Scalar>
Scalar thinner_by(Scalar margin, Scalar contact_gap, Scalar gap, Scalar share) {
  constexpr Scalar kContactGaps = 2;  // in a margin; the rest of it is rounding
  constexpr Scalar kOfRest = 4;       // a part of that, and of a contact gap, is clear of it
  const Scalar rounding = (margin - kContactGaps * contact_gap) / kOfRest;
  const Scalar left = margin - contact_gap + min_of(gap, Scalar(0));
  const Scalar clear = max_of(rounding, contact_gap / kOfRest);
  return contact_gap + max_of(clear, share * left) - gap;
}

/// What touches and parts is searched as if it were thinner by what is missing to be clear of
/// contact (world.md, "Touching and parting").
template <class SceneT, class Query>
void search_thinner(const Bodies<SceneT>& bodies, MovingPair<Scalar_of<SceneT>>& moving_pair,
                    Query& query, Scalar_of<SceneT> missing) {
  if (!make_thinner(moving_pair, missing)) return;
  const std::uint32_t evaluations = query.search.evaluations;
  const Vec3<Scalar_of<SceneT>> seed = query.search.witness.axes.normal_AB;
  query.search = SceneT::Search::search(moving_pair, bodies.settings.search, seed);
  query.search.evaluations += evaluations;
}

/// What is let part by more than the margin is answered before it has come back as deep, to first
/// order (world.md, "Touching and parting").
/// @param moving_pair  as it was searched
/// @param beyond       by how much more than the margin it is thinner, m, > 0
template <class Scalar, class Query>
void stop_early(const MovingPair<Scalar>& moving_pair, Query& query, Scalar beyond) {
  constexpr Scalar kTwice = 2;             // as it may come faster at its end
  constexpr Scalar kMost = Scalar(3) / 4;  // of the time: the rest is progress
  SearchResult<Scalar>& found = query.search;
  Scalar sooner = 0;
  if (found.outcome == Outcome::kContact && found.gap_rate < Scalar(0)) {
    sooner = min_of(kTwice * beyond / -found.gap_rate, kMost * found.t_free);
  } else if (found.outcome == Outcome::kFree &&
             gap_at(moving_pair, moving_pair.duration).gap < beyond) {
    found.outcome = Outcome::kContact;
    sooner = kMost * found.t_free;
  }
  found.t_free -= sooner;
  query.is_early = sooner > Scalar(0);
}

/// How fast the gap of what touches opens, m/s, by the momenta of the two where their planned turn
/// is the chord of a bent one (world.md, "Touching and parting"); where it is not, or one goes with
/// others: the least there is.
template <class SceneT, class Query>
Scalar_of<SceneT> rate_of_momenta([[maybe_unused]] const Bodies<SceneT>& bodies,
                                  [[maybe_unused]] ProxyPair pair,
                                  [[maybe_unused]] const Query& query) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kUnknown = std::numeric_limits<Scalar>::lowest();
  if constexpr (SceneT::kCapsulesPerBody == 1) {
    return kUnknown;
  } else {
    using BodiesT = Bodies<SceneT>;
    if (bodies.states[BodiesT::body_of(pair.first)].group != BodiesT::kAlone ||
        bodies.states[BodiesT::body_of(pair.second)].group != BodiesT::kAlone) {
      return kUnknown;
    }
    const auto velocity = [&](int proxy, const Vec3<Scalar>& surface_P) {
      const std::size_t slot = BodiesT::body_of(proxy);
      Twist<Scalar> twist = bodies.twist_now(slot);
      twist.v_W = bodies.states[slot].plan.motion.twist.v_W;
      const Vec3<Scalar> arm_W = surface_P + query.origin_W - place_now(bodies, slot);
      return Vec3<Scalar>(twist.v_W + twist.w_W.cross(arm_W));
    };
    const auto& witness = query.search.witness;
    return witness.axes.normal_AB.dot(velocity(pair.second, witness.surface_B) -
                                      velocity(pair.first, witness.surface_A));
  }
}

/// What the velocity of any of a body's matter is rounded by, in units of a rounding, m/s: what it
/// is summed of. Its centre counts from the world's origin: arms are differences of places.
template <class SceneT>
Scalar_of<SceneT> pace_of(const Bodies<SceneT>& bodies, int proxy) {
  const PartSize<Scalar_of<SceneT>> size = size_of(bodies, proxy);
  const auto twist = bodies.twist_now(Bodies<SceneT>::body_of(proxy));
  return length(twist.v_W) + length(twist.w_W) * (size.length + size.from_origin);
}

/// How fast what touches may close and count as parting, m/s, <= 0. Where a load is carried without
/// a contact that lasts, this is what rounding makes of its velocity, and no more than the search
/// cannot tell from contact in the rest of the step: a contact would have nothing to answer, and
/// would be found again at the same time (world.md, "Touching and parting").
/// @param gap  of the two, m
template <class SceneT, class Query>
Scalar_of<SceneT> least_rate(const Bodies<SceneT>& bodies, [[maybe_unused]] ProxyPair pair,
                             const Query& query, [[maybe_unused]] Scalar_of<SceneT> gap,
                             bool is_solved) {
  using Scalar = Scalar_of<SceneT>;
  if constexpr (kCarries<SceneT>) {
    const Scalar rest = bodies.dt - bodies.now;
    const Scalar pace = pace_of(bodies, pair.first) + pace_of(bodies, pair.second) +
                        rest * length(bodies.settings.gravity_W);
    const Scalar noise = kLoadRoundings * kRoundOff<Scalar> * pace;
    return -min_of(noise, max_of(gap + query.contact_gap, Scalar(0)) / rest);
  } else {
    return slowest_closing(bodies, query, is_solved);
  }
}

/// What touches and parts is searched as thinner, and told where it is in each other.
/// @param so_far  by how much it is thinner already: above zero where its contact was solved
template <class SceneT, class Query>
void let_part(Bodies<SceneT>& bodies, ProxyPair pair, MovingPair<Scalar_of<SceneT>>& moving_pair,
              Scalar_of<SceneT> so_far, Query& query) {
  using Scalar = Scalar_of<SceneT>;
  // Where nothing is moved apart within a step, a pair may come back more than once.
  constexpr Scalar kShare = kLasts<SceneT> ? Scalar(0.5) : Scalar(1);
  const Scalar margin = search_margin(bodies, query, pair);
  const Scalar gap = query.search.witness.gap - so_far;
  if (gap < -margin) bodies.report.deepest_overlap = max_of(bodies.report.deepest_overlap, -gap);
  const Scalar rate = max_of(query.search.gap_rate, rate_of_momenta(bodies, pair, query));
  if (rate < least_rate(bodies, pair, query, gap, so_far > Scalar(0))) return;
  if (gap < -margin) ++bodies.report.overlaps_at_start;
  const Scalar thinner = thinner_by(margin, query.contact_gap, gap, kShare);
  search_thinner(bodies, moving_pair, query, thinner - so_far);
  const Scalar beyond = thinner - max_of(margin, -gap);
  // Elsewhere nothing is opened, and what comes back is moved clear or goes together.
  if (kLasts<SceneT> && SceneT::kMaxPairs > 1 && beyond > Scalar(0)) {
    stop_early(moving_pair, query, beyond);
  }
}

/// Of bodies that do not turn. Those that part from in each other are told.
template <class SceneT>
void search_straight(Bodies<SceneT>& bodies, ProxyPair pair, Scalar_of<SceneT> until,
                     typename Pairs<SceneT>::PairQuery& query) {
  query = KinematicsOf<SceneT>::search(bodies.mover(pair.first, until),
                                       bodies.mover(pair.second, until), bodies.settings.search);
  const bool parts = SceneT::kResponse && query.outcome() == Outcome::kFree;
  if (!parts || !(query.gap() < Scalar_of<SceneT>(0))) return;
  ++bodies.report.overlaps_at_start;
  bodies.report.deepest_overlap = max_of(bodies.report.deepest_overlap, -query.gap());
}

template <class SceneT>
void Pairs<SceneT>::search_pair(BodiesT& bodies, ProxyPair pair, Scalar until, bool is_solved,
                                PairQuery& query) {
  if constexpr (!SceneT::kRotation) {
    search_straight(bodies, pair, until, query);
  } else {
    auto moving_pair =
        make_moving_pair(bodies.mover(pair.first, until), bodies.mover(pair.second, until));
    query.search.outcome = Outcome::kInvalid;
    query.is_early = false;
    query.search.t_free = query.search.t_hit = 0;
    query.search.evaluations = 0;
    if (!moving_pair.ok()) return;
    query.origin_W = moving_pair.value.origin_W;
    query.scale = moving_pair.value.scale;
    query.contact_gap = Search::contact_gap(moving_pair.value, bodies.settings.search);
    const Scalar radius_A = moving_pair.value.A.radius;
    const Scalar radius_B = moving_pair.value.B.radius;
    // Half of what the search calls contact: as much again is left for what closes slowly.
    const Scalar so_far = is_solved ? query.contact_gap / 2 : Scalar(0);
    if (is_solved) make_thinner(moving_pair.value, so_far);
    // The seed is a direction in W, and as good a guess in the next round or step.
    query.search = Search::search(moving_pair.value, bodies.settings.search, seed(pair));
    if (query.outcome() != Outcome::kInvalid) keep_seed(pair, query.search.witness.axes.normal_AB);
    if (SceneT::kResponse && query.outcome() == Outcome::kTouching) {
      let_part(bodies, pair, moving_pair.value, so_far, query);
    }
    // What was found is told of the pair as it is.
    query.search.witness = capsule_gap(query.search.witness.axes, radius_A, radius_B);
  }
}

template <class SceneT>
template <class HasHad>
bool Pairs<SceneT>::take_first(Scalar before, const HasHad& has_had, CandidateType& first,
                               Scalar& time) {
  const int earliest = CandidateOrder::earliest(candidates);
  if (earliest == CandidateOrder::kNone || before < candidates[earliest].free_until()) return false;
  time = min_of(candidates[earliest].free_until(), before);
  const auto has_had_now = [&](ProxyPair pair) { return has_had(pair, time); };
  const int chosen = SceneT::kMaxPairs > 1
                         ? CandidateOrder::among_ties(candidates, earliest, has_had_now)
                         : earliest;
  first = candidates[chosen];
  candidates.remove_swapping(chosen);
  return true;
}

/// A pair as it is now, without a search, where its search was not kept.
template <class SceneT>
typename Pairs<SceneT>::PairQuery& Pairs<SceneT>::seen(const BodiesT& bodies, ProxyPair pair,
                                                       bool is_own_time) {
  PairQuery& query = queries_.earliest();
  if (SceneT::kMaxPairs == 1 || (is_own_time && is_same(pair, queries_.pair()))) return query;
  query = {};
  queries_.forget();
  const auto moving_pair =
      make_moving_pair(bodies.mover(pair.first, bodies.dt), bodies.mover(pair.second, bodies.dt));
  if (!moving_pair.ok()) return query;
  query.origin_W = moving_pair.value.origin_W;
  query.scale = moving_pair.value.scale;
  query.contact_gap = Search::contact_gap(moving_pair.value, bodies.settings.search);
  query.search.outcome = Outcome::kContact;
  query.search.witness = gap_at(moving_pair.value, Scalar(0));
  query.search.gap_rate = gap_rate_at(moving_pair.value, query.search.witness, Scalar(0));
  return query;
}

}  // namespace batuta::detail
