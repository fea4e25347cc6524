// SPDX-License-Identifier: MIT
#pragma once
// Pairs: which may meet in the rest of a step, when, and which is first (src/world/world.md,
// "Pairs"). One of the five that make a step (general_world.hpp).

#include <cstdint>

#include "batuta/geometry/direction.hpp"
#include "batuta/world/detail/bodies.hpp"
#include "batuta/world/detail/pair_lengths.hpp"
#include "batuta/world/detail/seed_memory.hpp"
#include "batuta/world/detail/sweep.hpp"

namespace batuta::detail {

template <class SceneT>
class Pairs : private SeedsOf<SceneT> {
 public:
  using Scalar = Scalar_of<SceneT>;
  using BodiesT = Bodies<SceneT>;
  using Search = typename SceneT::Search;
  using PairQuery = typename BodiesT::Kinematics::PairQuery;
  using CandidateType = CandidatePair<Scalar>;

  /// Nothing is known of the step that begins.
  void begin_step() {
    candidates.clear();
    queries_.forget();
  }
  /// The boxes of a body that was planned.
  void put_boxes(BodiesT& bodies, std::size_t slot, bool idle);
  /// The body has no boxes any more.
  void remove_boxes(std::size_t slot);
  /// Its boxes at the start of a step in which contacts are solved before anybody is planned.
  void put_wide_boxes(BodiesT& bodies, std::size_t slot, bool idle);
  /// Whether its planned motion stays within these.
  bool holds_course(const BodiesT& bodies, std::size_t slot) const;

  /// Calls found(pair) for each pair of boxes that meet, of which not both are idle.
  template <class Found>
  void for_each_pair(const Found& found) {
    sweep_.sort();
    sweep_.for_each_pair(found);
  }
  /// All pairs, of the boxes as they are.
  void collect_all(BodiesT& bodies);
  /// Plans who has changed, and collects the pairs of those. Bound: kMaxBodies + 1 passes.
  void refresh(BodiesT& bodies, bool is_begin);
  /// Asks for every candidate that was not asked for, and drops those that are free.
  /// @param parts_along  the normal, out of the first, of a pair whose contact was solved for the
  ///   rest of the step; of others zero
  template <class PartsAlong>
  void search_all(BodiesT& bodies, const PartsAlong& parts_along);

  /// The candidate that ends the round, taken out; false: none does.
  /// @param has_had  tells of a pair and a time whether it was answered at that time
  template <class HasHad>
  bool take_first(Scalar before, const HasHad& has_had, CandidateType& first, Scalar& time);
  /// What is known of the contact of a candidate at its time, or found out now.
  PairQuery& seen(const BodiesT& bodies, ProxyPair pair, bool is_own_time);

  /// A capsule's box at present, and whether it has one.
  const SweepList<Scalar, BodiesT::kProxies, SceneT::kSweepAxis>& boxes() const { return sweep_; }
  /// Forgets what is known of a body.
  void forget(int proxy) { SeedsOf<SceneT>::forget(static_cast<std::uint16_t>(proxy)); }
  /// The normal that parted a pair last, out of the first; zero: none known.
  Vec3<Scalar> seed(ProxyPair pair) const {
    if constexpr (Search::kUsesSeed) {
      return this->recall(pair);
    } else {
      return Vec3<Scalar>::Zero();
    }
  }
  void keep_seed(ProxyPair pair, const Vec3<Scalar>& normal) {
    if constexpr (Search::kUsesSeed) this->remember(pair, normal);
  }
  void copy(const Pairs& saved) { this->copy_seeds(saved); }
  template <class Archive>
  void archive(Archive& ar) {
    this->archive_seeds(ar);
  }

  FixedList<CandidateType, SceneT::kMaxPairs> candidates;

 private:
  /// There may be more pairs than candidates. In 64 bits: the product of two counts to 65,535.
  static constexpr bool kCanOverflow =
      SceneT::kMaxPairs < std::int64_t{BodiesT::kProxies} * (BodiesT::kProxies - 1) / 2;

  void plan(BodiesT& bodies, std::size_t slot, bool is_begin);
  void drop_changed(const BodiesT& bodies);
  void collect_fresh(BodiesT& bodies);
  void collect(BodiesT& bodies, ProxyPair pair);
  template <class PartsAlong>
  void search(BodiesT& bodies, CandidateType& candidate, const PartsAlong& parts_along);
  void search_pair(BodiesT& bodies, ProxyPair pair, Scalar until, bool is_solved, PairQuery& query);

  SweepList<Scalar, BodiesT::kProxies, SceneT::kSweepAxis> sweep_;
  EarliestQuery<PairQuery, Scalar, (SceneT::kMaxPairs > 1)> queries_;
};

template <class SceneT>
void Pairs<SceneT>::put_boxes(BodiesT& bodies, std::size_t slot, bool idle) {
  const auto& actor = bodies.actor(slot);
  bodies.states[slot].boxed = true;
  for (int part = 0; part < BodiesT::kParts; ++part) {  // Bound: kCapsulesPerBody
    const auto proxy = BodiesT::proxy_of(slot, part);
    if (part < parts_of(actor)) {
      sweep_.set(proxy, BodiesT::Kinematics::bound(bodies.mover(proxy, bodies.dt)), idle);
    } else {
      sweep_.remove(proxy);
    }
  }
}

template <class SceneT>
void Pairs<SceneT>::remove_boxes(std::size_t slot) {
  for (int part = 0; part < BodiesT::kParts; ++part) {  // Bound: kCapsulesPerBody
    sweep_.remove(BodiesT::proxy_of(slot, part));
  }
}

/// Where a part may be by the end of a step, to a box: its way in a straight line, and as far
/// aside as its ends turn. Without bounds where numbers end.
template <class SceneT>
Aabb<Scalar_of<SceneT>> way_box(const Bodies<SceneT>& bodies, int proxy, Scalar_of<SceneT> slack) {
  using Scalar = Scalar_of<SceneT>;
  const auto moving = bodies.mover(proxy, bodies.dt);
  const Capsule<Scalar> shape = to_world(moving.motion.X_WB, moving.capsule_B);
  const Segment<Scalar>& from = shape.axis;
  const Vec3<Scalar> way = moving.motion.duration * moving.motion.twist.v_W;
  const Segment<Scalar> to = {from.a + way, from.b + way};
  const Scalar turn = moving.motion.duration * length(moving.motion.twist.w_W);
  const Scalar reach = max_of(length(moving.capsule_B.axis.a), length(moving.capsule_B.axis.b));
  const Scalar aside = min_of(turn, Scalar(2)) * reach + slack;
  const Scalar size =
      length(moving.motion.X_WB.p_W) + length(way) + reach + moving.capsule_B.radius + aside;
  if (!(size < kLargestCoordinate<Scalar>)) {  // beyond the numbers: the whole space
    Aabb<Scalar> all;
    all.low.fill(std::numeric_limits<Scalar>::lowest());
    all.high.fill(std::numeric_limits<Scalar>::max());
    return all;
  }
  return kdop_of<Scalar, 6>(from, to, shape.radius + aside);
}

template <class SceneT>
void Pairs<SceneT>::put_wide_boxes(BodiesT& bodies, std::size_t slot, bool idle) {
  const auto& actor = bodies.actor(slot);
  Scalar fall = 0;
  if constexpr (SceneT::kGravity) {
    fall = bodies.dt * bodies.dt * length(bodies.settings.gravity_W);
  }
  bodies.states[slot].boxed = true;
  for (int part = 0; part < BodiesT::kParts; ++part) {  // Bound: kCapsulesPerBody
    const auto proxy = BodiesT::proxy_of(slot, part);
    if (part < parts_of(actor)) {
      sweep_.set(proxy, way_box(bodies, proxy, fall + own_rest_gap(bodies, proxy)), idle);
    } else {
      sweep_.remove(proxy);
    }
  }
}

template <class SceneT>
bool Pairs<SceneT>::holds_course(const BodiesT& bodies, std::size_t slot) const {
  bool holds = true;
  for (int part = 0; part < parts_of(bodies.actor(slot)); ++part) {  // Bound: kCapsulesPerBody
    const auto proxy = BodiesT::proxy_of(slot, part);
    const Aabb<Scalar> way = way_box(bodies, proxy, Scalar(0));
    const Aabb<Scalar>& box = sweep_.box(proxy);
    for (std::size_t i = 0; i < 3; ++i) {  // Bound: 3
      holds = holds && !(way.low[i] < box.low[i]) && !(box.high[i] < way.high[i]);
    }
  }
  return holds;
}

template <class SceneT>
void Pairs<SceneT>::collect_all(BodiesT& bodies) {
  for_each_pair([this, &bodies](ProxyPair pair) { collect(bodies, pair); });
}

template <class SceneT>
void Pairs<SceneT>::plan(BodiesT& bodies, std::size_t slot, bool is_begin) {
  auto& state = bodies.states[slot];
  const bool stayed = state.stands;
  state.changed = false;
  bodies.plan(slot);
  state.fresh = true;
  state.stands = is_begin && BodiesT::Kinematics::is_still(state.plan.motion);
  const bool idle = stayed && state.stands;
  if (idle && state.boxed && sweep_.is_idle(BodiesT::proxy_of(slot, 0))) return;
  put_boxes(bodies, slot, idle);
}

/// A pair that finds no room goes on together, which changes its bodies in turn: each time there is
/// one body or group less.
template <class SceneT>
void Pairs<SceneT>::refresh(BodiesT& bodies, bool is_begin) {
  constexpr std::size_t kSlots = BodiesT::kSlots;
  constexpr int kMaxPasses = SceneT::kMaxBodies + 1;
  for (int pass = 0; bodies.is_changed && pass < kMaxPasses; ++pass) {  // Bound: kMaxPasses
    bodies.is_changed = false;
    drop_changed(bodies);
    for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
      if (bodies.states[slot].changed) plan(bodies, slot, is_begin && pass == 0);
    }
    // Of two bodies, nothing is known any more that is not found now.
    if (SceneT::kMaxBodies == 2 || (is_begin && pass == 0)) {
      collect_all(bodies);
    } else {
      sweep_.sort();
      collect_fresh(bodies);
    }
    for (auto& state : bodies.states) state.fresh = false;  // Bound: kMaxBodies
  }
}

/// What was known of a body whose planned motion changes is no longer true.
template <class SceneT>
void Pairs<SceneT>::drop_changed(const BodiesT& bodies) {
  const auto is_stale = [&bodies](ProxyPair pair) {
    return bodies.states[BodiesT::body_of(pair.first)].changed ||
           bodies.states[BodiesT::body_of(pair.second)].changed;
  };
  for (int i = candidates.size() - 1; i >= 0; --i) {  // Bound: kMaxPairs
    if (is_stale(candidates[i].pair)) candidates.remove_swapping(i);
  }
  if (is_stale(queries_.pair())) queries_.forget();
}

template <class SceneT>
void Pairs<SceneT>::collect_fresh(BodiesT& bodies) {
  using Slot = std::uint16_t;
  for (int i = 0; i < BodiesT::kProxies; ++i) {  // Bound: all capsules
    const auto proxy = static_cast<Slot>(i);
    if (!bodies.states[BodiesT::body_of(i)].fresh || !sweep_.contains(proxy)) continue;
    sweep_.for_each_partner(proxy, [this, &bodies, proxy](Slot other) {
      // Found from there already.
      if (other < proxy && bodies.states[BodiesT::body_of(other)].fresh) return;
      collect(bodies, {min_of(proxy, other), max_of(proxy, other)});
    });
  }
}

/// What is still and cannot be pushed may stand in other such bodies.
template <class SceneT>
bool may_pair(const Bodies<SceneT>& bodies, std::size_t a, std::size_t b) {
  if (a == b || (bodies.is_wall(a) && bodies.is_wall(b))) return false;
  const auto group = bodies.states[a].group;
  if (group != Bodies<SceneT>::kAlone && group == bodies.states[b].group) return false;
  return may_meet(bodies.actor(a), bodies.actor(b));
}

template <class SceneT>
void Pairs<SceneT>::collect(BodiesT& bodies, ProxyPair pair) {
  const std::size_t a = BodiesT::body_of(pair.first);
  const std::size_t b = BodiesT::body_of(pair.second);
  if (!may_pair(bodies, a, b)) return;
  CandidateType candidate;
  candidate.pair = pair;
  const bool has_room = candidates.push(candidate);
  if constexpr (kCanOverflow) {
    if (has_room) return;
    ++bodies.report.pairs_dropped;
    if constexpr (SceneT::kResponse) bodies.weld(a, b, bodies.dt);
  }
}

template <class SceneT>
template <class PartsAlong>
void Pairs<SceneT>::search_all(BodiesT& bodies, const PartsAlong& parts_along) {
  for (int i = 0; i < candidates.size(); ++i) {  // Bound: kMaxPairs
    if (!candidates[i].asked) search(bodies, candidates[i], parts_along);
  }
  for (int i = candidates.size() - 1; i >= 0; --i) {  // Bound: kMaxPairs
    if (candidates[i].outcome == Outcome::kFree) candidates.remove_swapping(i);
  }
}

}  // namespace batuta::detail

#include "batuta/world/detail/pair_search.hpp"
