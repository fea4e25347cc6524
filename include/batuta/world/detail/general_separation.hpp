// SPDX-License-Identifier: MIT
#pragma once
// GeneralWorld: what moves two bodies apart, and f(D) (src/world/world.md, "Separation"). Included
// by general_contact.hpp.

#include "batuta/world/detail/general_load.hpp"
#include "batuta/world/detail/general_world.hpp"

namespace batuta::detail {

/// Who has no room for his share of a shift leaves it to the other, where something holds them:
/// that takes the momentum. @param[in,out] soft_A, soft_B  inverse masses that share it
template <class SceneT>
void GeneralWorld<SceneT>::leave_share([[maybe_unused]] std::size_t a,
                                       [[maybe_unused]] std::size_t b,
                                       [[maybe_unused]] const SeparationOptions<Scalar>& options,
                                       [[maybe_unused]] Scalar shift,
                                       [[maybe_unused]] Scalar& soft_A,
                                       [[maybe_unused]] Scalar& soft_B) const {
  if constexpr (kSolves) {
    if (!(min_of(options.limit_A, options.limit_B) < shift)) return;
    const bool is_shared = soft_A > Scalar(0) && soft_B > Scalar(0);
    if (!is_shared || !(groups_.contacts.is_held_up(a) || groups_.contacts.is_held_up(b))) return;
    Scalar& soft = options.limit_A < options.limit_B ? soft_A : soft_B;
    soft = 0;
  }
}

/// The gap of a contact whose bodies were moved apart, m.
template <class Scalar>
Scalar gap_after(const Contact<Scalar>& contact, const Separation<Scalar>& made) {
  const Vec3<Scalar>& n_W = contact.normal_BA_W;
  return contact.gap + (n_W.dot(made.shift_A_W) - n_W.dot(made.shift_B_W));
}

template <class SceneT>
bool GeneralWorld<SceneT>::stays_deep([[maybe_unused]] const Contact<Scalar>& contact,
                                      [[maybe_unused]] const Separation<Scalar>& made,
                                      [[maybe_unused]] Scalar margin) const {
  if constexpr (SceneT::kMaxBodies > 2 || SceneT::kCapsulesPerBody > 1) {
    const bool is_first = !(bodies_.now > Scalar(0)) && answers_of_pair_ <= 1;
    return !is_first && gap_after(contact, made) < -margin;
  } else {
    return false;
  }
}

/// @param is_charged  it goes to D, and takes time
template <class SceneT>
SeparationOptions<typename GeneralWorld<SceneT>::Scalar> GeneralWorld<SceneT>::separation_options(
    Scalar margin, [[maybe_unused]] bool is_charged) const {
  SeparationOptions<Scalar> options;
  options.distance = margin;
  options.rest_speed = options.min_duration = std::numeric_limits<Scalar>::min();
  if constexpr (kSeparates) {
    options.rest_speed = bodies_.settings.rest_speed;
    options.min_duration = bodies_.settings.min_separation_time;
    if (is_charged) options.distance = max_of(margin, bodies_.settings.separation);
  }
  return options;
}

/// The paper's separation to D, for which the two go on together for f(D); or, where the pair is in
/// each other by less than can be told from touching, just clear of it.
template <class SceneT>
[[gnu::cold]] void GeneralWorld<SceneT>::separate_pair(ProxyPair pair, const PairQuery& query,
                                                       const Contact<Scalar>& contact,
                                                       const Answer<Scalar>& result,
                                                       bool is_resting) {
  const std::size_t a = BodiesT::body_of(pair.first);
  const std::size_t b = BodiesT::body_of(pair.second);
  const Scalar margin = search_margin(bodies_, query, pair);
  const bool is_deep = kSeparates && contact.gap < -margin;
  const bool is_charged = is_resting || is_deep;
  SeparationOptions<Scalar> options = separation_options(margin, is_charged);
  const Scalar shift = options.distance - min_of(contact.gap, Scalar(0));
  if constexpr (SceneT::kMaxBodies > 2 || SceneT::kCapsulesPerBody > 1) {
    options.limit_A = room_of(a, pair, contact.normal_BA_W, shift);
    options.limit_B = room_of(b, pair, -contact.normal_BA_W, shift);
  }
  Scalar soft_A = bodies_.actor(a).body.inverse_mass;
  Scalar soft_B = bodies_.actor(b).body.inverse_mass;
  leave_share(a, b, options, shift, soft_A, soft_B);
  const auto made = separate(contact, result.v_rel, soft_A, soft_B, options);
  if (!made.ok()) {
    ++bodies_.report.resolutions_invalid;
    return bodies_.weld(a, b, bodies_.dt);
  }
  if constexpr (kSolves) {
    note_shift(bodies_, a, made.value.shift_A_W);
    note_shift(bodies_, b, made.value.shift_B_W);
    groups_.note_shift(bodies_.actor(a).body, a, made.value.shift_A_W);
    groups_.note_shift(bodies_.actor(b).body, b, made.value.shift_B_W);
  }
  add_to(bodies_.actor(a).body.X_WB.p_W, made.value.shift_A_W);
  add_to(bodies_.actor(b).body.X_WB.p_W, made.value.shift_B_W);
  tell_controllers(pair, contact, result, made.value);
  if (stays_deep(contact, made.value, margin)) {
    if constexpr (kSolves) {
      // What presses them together may be what opens gaps of others.
      if (end_openings(bodies_, a, b)) return void(++bodies_.report.separations);
    }
    ++bodies_.report.frozen;
    return bodies_.weld(a, b, bodies_.dt);
  }
  ++bodies_.report.separations;
  if (is_charged) apply_separation_time(pair, contact, made.value, options.distance);
}

/// f(D). @param distance  D, m
template <class SceneT>
void GeneralWorld<SceneT>::apply_separation_time(ProxyPair pair, const Contact<Scalar>& contact,
                                                 const Separation<Scalar>& made, Scalar distance) {
  const Scalar until = min_of(bodies_.dt, bodies_.now + made.duration);
  if (!holds_one(pair)) {
    return bodies_.weld(BodiesT::body_of(pair.first), BodiesT::body_of(pair.second), until);
  }
  // Who is pressed where there is no room to move it away is carried, as under kNone: between two
  // that are fixed its time would stand still for ever.
  const bool is_narrow = gap_after(contact, made) < distance / 2;
  if (!(kCarries<SceneT> && is_narrow)) hold(pair, until);
}

/// Whether one of the two is moved by nothing that the other does, and the other by momentum.
template <class SceneT>
[[gnu::noinline]] bool GeneralWorld<SceneT>::holds_one(ProxyPair pair) const {
  if constexpr (!kHolds<SceneT>) return false;
  return bodies_.holds(BodiesT::body_of(pair.first)) !=
         bodies_.holds(BodiesT::body_of(pair.second));
}

/// f(D) of such a pair: the other one is carried no more, so that it falls from then on.
/// @pre both are alone
template <class SceneT>
[[gnu::cold, gnu::noinline]] void GeneralWorld<SceneT>::hold(ProxyPair pair, Scalar until) {
  if constexpr (kHolds<SceneT>) {
    const std::size_t a = BodiesT::body_of(pair.first);
    const std::size_t b = BodiesT::body_of(pair.second);
    for (const std::size_t slot : {a, b}) {  // Bound: 2
      if (!bodies_.is_wall(slot)) bodies_.advance_to_now(slot);
      if constexpr (kCarries<SceneT>) release(slot);
      drop_reactions(slot);
    }
    bodies_.hold(a, b, until);
  }
}

/// For the rest of the step: there is no answer for the two.
template <class SceneT>
[[gnu::cold]] void GeneralWorld<SceneT>::stop_both(ProxyPair pair) {
  const std::size_t a = BodiesT::body_of(pair.first);
  const std::size_t b = BodiesT::body_of(pair.second);
  const bool are_alone =
      bodies_.states[a].group == BodiesT::kAlone && bodies_.states[b].group == BodiesT::kAlone;
  if (are_alone && holds_one(pair)) return hold(pair, bodies_.dt);
  bodies_.weld(a, b, bodies_.dt);
}

/// How far a body of a pair may be shifted: half the way to its nearest neighbour, because both may
/// be shifted towards each other. What the shift does not lead towards stays as far away as it is.
/// @param away_W  direction of the shift
/// @param shift   the longest that may be asked for, m; what is further away is no neighbour
template <class SceneT>
typename GeneralWorld<SceneT>::Scalar GeneralWorld<SceneT>::room_of(std::size_t slot,
                                                                    ProxyPair pair,
                                                                    const Vec3<Scalar>& away_W,
                                                                    Scalar shift) const {
  Scalar room = std::numeric_limits<Scalar>::max();
  for (int part = 0; part < parts_of(bodies_.actor(slot)); ++part) {  // Bound: kCapsulesPerBody
    const int own = BodiesT::proxy_of(slot, part);
    const Capsule<Scalar> shape = bodies_.shape_W(own);
    const Aabb<Scalar> near = kdop_of<Scalar, 6>(shape.axis, shape.axis, shape.radius + 2 * shift);
    for (int k = 0; k < BodiesT::kProxies; ++k) {  // Bound: all capsules
      const std::size_t other = BodiesT::body_of(k);
      const bool is_pair =
          (own == pair.first && k == pair.second) || (own == pair.second && k == pair.first);
      if (other == slot || is_pair || !pairs_.boxes().contains(static_cast<std::uint16_t>(k)) ||
          !overlaps<Scalar, 6>(near, pairs_.boxes().box(static_cast<std::uint16_t>(k))) ||
          !may_meet(bodies_.actor(slot), bodies_.actor(other))) {
        continue;
      }
      const CapsuleGap<Scalar> gap = capsule_gap(shape, bodies_.shape_W(k));
      const bool leads_away = gap.gap > Scalar(0) && !(gap.axes.normal_AB.dot(away_W) > Scalar(0));
      if (!leads_away) room = min_of(room, gap.gap / Scalar(2));
    }
  }
  return max_of(room, Scalar(0));
}

}  // namespace batuta::detail
