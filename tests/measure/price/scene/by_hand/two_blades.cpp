// SPDX-License-Identifier: MIT
// TwoBlades as one writes it by hand, against the kernels alone: two blades that collide, rest, and
// tell of it (src/world/world.md). Nobody else meets two that go on together, so that is done at
// once.

#include "../scene.hpp"
#include "batuta/geometry/direction.hpp"
#include "batuta/response/impulse.hpp"
#include "batuta/response/separation.hpp"
#include "batuta/world/detail/group_motion.hpp"
#include "blades.hpp"

namespace {

using namespace batuta;

class Duelists : public price::Blades {
 public:
  Status step(float dt) {
    if (!is_positive(dt)) return Status::kInvalidArgument;
    begin();
    contacts_ = 0;
    // Bound: contacts, and one that is dropped or the end of the step.
    for (int round = 0; round <= kMaxContacts && now < dt; ++round) fly(dt);
    end();
    return Status::kOk;
  }

 private:
  static constexpr int kMaxContacts = 8;

  /// To the next contact, or the end of the step.
  void fly(float dt) {
    const float left = dt - now;
    Result<MovingPair<float>> pair;
    SearchResult<float> found;
    found.outcome = Outcome::kFree;
    if (plan(left)) found = search(pair);
    if (found.outcome == Outcome::kTouching) let_part(pair.value, found);
    const float time = now + found.t_free;
    if (found.outcome == Outcome::kFree || dt < time) {
      move(left);
      now = dt;
    } else if (is_contact(found.outcome) && contacts_ < kMaxContacts) {
      ++contacts_;
      move(found.t_free);
      now = time;
      answer(found, pair.value, dt);
    } else {
      count_cut(found.outcome);
      move(time - now);
      now = time;
      go_together(dt);
    }
  }

  /// The largest gap at which a search may speak of contact.
  static float contact_gap_of(const MovingPair<float>& pair) {
    return contact_tolerance_of(pair, AdvancementOptions<float>{}) + detail::inflation_of(pair);
  }
  /// How deep blades may be in each other by rounding and what a search calls contact.
  float margin_of(const MovingPair<float>& pair) const {
    const float size =
        length(blades[0].body.X_WB.p_W) + length(blades[1].body.X_WB.p_W) + pair.scale;
    return 2 * contact_gap_of(pair) + 64 * kRoundOff<float> * size;
  }

  /// Blades that touch and part are searched as if they were thinner: clear of contact where they
  /// are, and stopped before they overlap by more than the margin should they turn back.
  void let_part(const MovingPair<float>& pair, SearchResult<float>& found) {
    const float gap = found.witness.gap;
    const float margin = margin_of(pair);
    if (gap < -margin) report.deepest_overlap = max_of(report.deepest_overlap, -gap);
    if (found.gap_rate < 0.F) return;
    if (gap < -margin) ++report.overlaps_at_start;
    const float contact_gap = contact_gap_of(pair);
    const float rounding = (margin - 2 * contact_gap) / 4;
    const float clear = max_of(rounding, contact_gap / 4);
    const float left = margin - contact_gap + min_of(gap, 0.F);
    const float share = (contact_gap + max_of(clear, left) - gap) / (pair.A.radius + pair.B.radius);
    if (!(share < 1.F)) return;
    MovingPair<float> thinner = pair;
    thinner.A.radius *= 1 - share;
    thinner.B.radius *= 1 - share;
    search(thinner, pair, found.witness.axes.normal_AB, found);
  }

  void answer(const SearchResult<float>& found, const MovingPair<float>& pair, float dt) {
    const Contact<float> contact = contact_from(found.witness, pair.origin_W);
    const float restitution = max_of(blades[0].restitution, blades[1].restitution);
    const auto hit = collision_impulse(collider_of(blades[0].body), collider_of(blades[1].body),
                                       contact, restitution);
    if (!hit.ok()) return give_up(dt);
    const float v_rel = hit.value.v_rel;
    const ContactKind kind = classify(v_rel, price::kRestSpeed);
    const bool pushes = kind == ContactKind::kColliding;
    if (pushes) push(hit.value);
    const bool is_deep = contact.gap < -contact_gap_of(pair);
    tell_contact(kind, found.witness, pair.origin_W, v_rel, pushes ? hit.value.magnitude : 0.F,
                 is_deep || is_in_touch(found));
    const bool rests = kind == ContactKind::kResting;
    if (rests || is_deep) move_apart(contact, v_rel, margin_of(pair), rests, dt);
  }

  void push(const Impulse<float>& impulse) {
    if (impulse.magnitude > 0.F) ++report.collisions;
    add(blades[0].body, impulse.on_A);
    add(blades[1].body, impulse.on_B);
  }
  static void add(Body<float>& body, const Momentum<float>& change) {
    if (body.inverse_mass > 0.F) body.momentum.linear_W += change.linear_W;
    if (body.inverse_moments != Vec3<float>::Zero()) body.momentum.angular_W += change.angular_W;
  }

  /// The paper's separation to D, which takes its time; where blades that are not at rest are in
  /// each other by less than the margin, just clear of it.
  void move_apart(const Contact<float>& contact, float v_rel, float margin, bool rests, float dt) {
    const bool takes_time = rests || contact.gap < -margin;
    Body<float>& A = blades[0].body;
    Body<float>& B = blades[1].body;
    SeparationOptions<float> how;
    how.distance = takes_time ? max_of(margin, price::kSeparation) : margin;
    how.rest_speed = price::kRestSpeed;
    how.min_duration = price::kLeastHold;
    const auto shifts = separate(contact, v_rel, A.inverse_mass, B.inverse_mass, how);
    if (!shifts.ok()) return give_up(dt);
    A.X_WB.p_W += shifts.value.shift_A_W;
    B.X_WB.p_W += shifts.value.shift_B_W;
    ++report.separations;
    if (takes_time) go_together(min_of(dt, now + shifts.value.duration));
  }

  void give_up(float dt) {
    ++report.resolutions_invalid;
    go_together(dt);
  }

  /// As one rigid body, and each has the velocity of its place in the end; what rounding leaves of
  /// the sums goes to the heavier one. Where one of them cannot be pushed, both stand.
  void go_together(float until) {
    const float time = until - now;
    now = until;
    report.time_held = max_of(report.time_held, time);
    Body<float>& A = blades[0].body;
    Body<float>& B = blades[1].body;
    Motion<float> motion = still<float>({}, time);
    Momentum<float> left;
    Twist<float> twist;
    bool goes = A.inverse_mass > 0.F && B.inverse_mass > 0.F;
    bool turns = false;
    if (goes) {
      const auto whole = both();
      const auto planned = detail::group_motion(whole, time);
      goes = is_valid(planned);
      if (goes) motion = planned;
      left = whole.momentum;
      turns = whole.turns;
    }
    const Pose<float> X_WG = pose_at(motion, time);
    const bool stays = detail::is_zero(motion.twist.v_W) && detail::is_zero(motion.twist.w_W);
    for (price::Blade& blade : blades) {  // Bound: 2
      if (time > 0.F && !stays) detail::take_along(blade.body, motion.X_WB.p_W, X_WG);
    }
    if (goes) twist = detail::group_twist(both(), left.angular_W);
    for (price::Blade& blade : blades) {  // Bound: 2
      if (!(blade.body.inverse_mass > 0.F)) continue;
      detail::give_momentum(blade.body, X_WG.p_W, twist, left);
    }
    if (!goes) return;
    Momentum<float>& heavier = (B.inverse_mass < A.inverse_mass ? B : A).momentum;
    heavier.linear_W += left.linear_W;
    if (turns) heavier.angular_W += left.angular_W;
  }

  detail::RigidGroup<float> both() const {
    detail::RigidGroup<float> whole;
    for (const price::Blade& blade : blades) detail::add_to_group(whole, blade.body);  // Bound: 2
    return whole;
  }

  int contacts_ = 0;
};

Duelists scene;

}  // namespace

bool price_scene_place(float restitution) {
  return scene.place(restitution);
}
Status price_scene_step(float dt) {
  return scene.step(dt);
}
std::uint32_t price_scene_contacts() {
  return static_cast<std::uint32_t>(scene.events.size());
}
std::uint32_t price_scene_state() {
  return price::state_of(scene);
}
