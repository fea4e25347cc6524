// SPDX-License-Identifier: MIT
#pragma once
// What the two scenes of blades by hand have in common: two blades in free flight, their boxes,
// their search and their events, from the kernels alone.

#include "../runs.hpp"
#include "batuta/core/fixed_list.hpp"
#include "batuta/detection/advancement.hpp"
#include "batuta/detection/swept_volume.hpp"
#include "batuta/mechanics/motion.hpp"
#include "batuta/world/event.hpp"

namespace batuta::price {

struct Blade {
  Body<float> body;
  Capsule<float> capsule_B;
  float restitution = 0;
  std::uint16_t owner = 0;
  bool present = false;  ///< takes part in the step
  Motion<float> motion;  ///< over the rest of the step
};

/// D, and what counts as rest: the defaults of a WorldSettings.
inline constexpr float kSeparation = 1e-4F;
inline constexpr float kRestSpeed = 0.01F;
inline constexpr float kLeastHold = 1e-4F;

class Blades {
 public:
  bool place(float restitution) {
    for (int i = 0; i < 2; ++i) {  // Bound: 2
      Blade& blade = blades[i];
      blade.body = turning_blade(i, true);
      blade.capsule_B = {{{0, 0, -kBladeHalf}, {0, 0, kBladeHalf}}, kBladeRadius};
      blade.restitution = restitution;
      if (!is_usable(blade)) return false;
      blade.body.X_WB.q_WB = renewed(blade.body.X_WB.q_WB);
      blade.body.spin_shows = !detail::hides_spin(blade.body, blade.capsule_B);
    }
    return true;
  }

 protected:
  static bool is_usable(const Blade& blade) {
    const Body<float>& body = blade.body;
    return is_finite(body.X_WB.p_W) && is_finite(body.X_WB.q_WB) &&
           is_finite(body.momentum.linear_W) && is_finite(body.momentum.angular_W) &&
           is_finite(body.inverse_mass) && body.inverse_mass >= 0.F &&
           is_finite(body.inverse_moments) && body.inverse_moments.minCoeff() >= 0.F &&
           is_valid(blade.capsule_B) && can_hold(body.X_WB.p_W, blade.capsule_B) &&
           blade.restitution >= 0.F && blade.restitution <= 1.F;
  }

  void begin() {
    report = {};
    events.clear();
    now = 0;
    for (Blade& blade : blades) {  // Bound: 2
      blade.present = is_usable(blade);
      if (!blade.present) ++report.plans_invalid;
    }
  }

  /// Where both fly for so long. @returns whether the two may meet
  bool plan(float duration) {
    bool both = true;
    for (Blade& blade : blades) {  // Bound: 2
      both = both && blade.present;
      if (blade.present) plan(blade, duration);
    }
    const bool fixed = is_fixed(blades[0].body) && is_fixed(blades[1].body);
    const bool strangers = blades[0].owner == 0 || blades[0].owner != blades[1].owner;
    return both && !fixed && strangers;
  }

  /// What turns too far goes without a turn; what is too fast even so stands.
  void plan(Blade& blade, float duration) {
    const Body<float>& body = blade.body;
    blade.motion = free_flight(body, duration);
    if (is_valid(blade.motion)) return;
    ++report.plans_invalid;
    blade.motion = linear<float>(body.X_WB, body.inverse_mass * body.momentum.linear_W, duration);
    if (is_valid(blade.motion)) return;
    blade.motion = still(body.X_WB, duration);
    report.time_held = max_of(report.time_held, duration);
  }

  bool boxes_meet() const { return overlaps<float, 6>(swept_aabb(mover(0)), swept_aabb(mover(1))); }
  MovingCapsule<float> mover(int i) const { return {blades[i].capsule_B, blades[i].motion}; }

  void move(float t) {
    for (Blade& blade : blades) {  // Bound: 2
      if (blade.present) move_along(blade.body, blade.motion, t);
    }
  }

  void tell(EventKind kind, ContactKind contact_kind, const CapsuleGap<float>& witness,
            const Vec3<float>& origin_W, float v_rel, float impulse) {
    ContactEvent<float> event;
    event.kind = kind;
    event.contact_kind = contact_kind;
    event.body_B = 1;
    event.time = now;
    event.contact = contact_from(witness, origin_W);
    event.v_rel = v_rel;
    event.impulse = impulse;
    event.place_A = witness.axes.s;
    event.place_B = witness.axes.u;
    if (!events.push(event)) ++report.events_dropped;
  }
  /// A contact that was answered. @param is_overlap  it was found in each other
  void tell_contact(ContactKind contact_kind, const CapsuleGap<float>& witness,
                    const Vec3<float>& origin_W, float v_rel, float impulse, bool is_overlap) {
    if (is_overlap) {
      ++report.overlaps_at_start;
      report.deepest_overlap = max_of(report.deepest_overlap, -witness.gap);
    }
    tell(touches ? EventKind::kPersist : EventKind::kBegin, contact_kind, witness, origin_W, v_rel,
         impulse);
    touches = true;
  }
  /// A contact that has opened ends.
  void end() {
    if (!touches) return;
    const auto gap = capsule_gap(to_world(blades[0].body.X_WB, blades[0].capsule_B),
                                 to_world(blades[1].body.X_WB, blades[1].capsule_B));
    if (!(gap.gap > 2 * kSeparation)) return;
    tell(EventKind::kEnd, ContactKind::kReceding, gap, Vec3<float>::Zero(), 0, 0);
    touches = false;
  }

  /// @returns kFree where the boxes part them
  SearchResult<float> search(Result<MovingPair<float>>& pair) {
    SearchResult<float> found;
    found.outcome = Outcome::kFree;
    if (!boxes_meet()) return found;
    ++report.pairs;
    found.outcome = Outcome::kInvalid;
    pair = make_moving_pair(mover(0), mover(1));
    if (!pair.ok()) return found;
    search(pair.value, pair.value, seed, found);
    if (found.outcome != Outcome::kInvalid) seed = found.witness.axes.normal_AB;
    return found;
  }
  /// @param asked  the pair, or a thinner one: what was found is told of the pair
  void search(const MovingPair<float>& asked, const MovingPair<float>& pair,
              const Vec3<float>& seed_AB, SearchResult<float>& found) {
    found = search_advancement(asked, AdvancementOptions<float>{}, seed_AB);
    found.witness = capsule_gap(found.witness.axes, pair.A.radius, pair.B.radius);
    report.evaluations += found.evaluations;
  }
  /// Whether the blades were in each other when the search began.
  static bool is_in_touch(const SearchResult<float>& found) {
    return found.outcome == Outcome::kTouching && !(found.witness.gap > 0.F);
  }
  static bool is_contact(Outcome outcome) {
    return outcome == Outcome::kContact || outcome == Outcome::kTouching;
  }
  void count_cut(Outcome outcome) {
    if (is_contact(outcome)) {
      ++report.contacts_dropped;
    } else if (outcome == Outcome::kBudget) {
      ++report.searches_cut;
    } else {
      ++report.searches_invalid;
    }
  }

 public:
  Blade blades[2];
  StepReport<float> report;
  FixedList<ContactEvent<float>, 16> events;

 protected:
  Vec3<float> seed = Vec3<float>::Zero();
  float now = 0;
  bool touches = false;
};

inline std::uint32_t state_of(const Blades& scene) {
  return mixed(mixed(kEmptyHash, scene.blades[0].body), scene.blades[1].body);
}

}  // namespace batuta::price
