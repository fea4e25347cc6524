// SPDX-License-Identifier: MIT
// TwoBlades as one writes it by hand, against the kernels alone: two blades that collide, rest, and
// tell of it.

#include "../scene.hpp"
#include "batuta/geometry/direction.hpp"
#include "batuta/response/impulse.hpp"
#include "batuta/response/separation.hpp"
#include "blades.hpp"

namespace {

using namespace batuta;

class Duelists : public price::Blades {
 public:
  Status step(float dt) {
    if (!is_positive(dt)) return Status::kInvalidArgument;
    begin();
    contacts_ = 0;
    // Bound: a contact and the end of its hold in turn, and the end of the step.
    for (int round = 0; round <= 2 * kMaxContacts + 1 && now < dt; ++round) fly(dt);
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
    if (found.outcome == Outcome::kFree) {
      move(left);
      now = dt;
      return;
    }
    move(found.t_free);
    now += found.t_free;
    if (is_contact(found.outcome) && contacts_ < kMaxContacts) {
      ++contacts_;
      answer(found, pair.value, dt);
    } else {
      count_cut(found.outcome);
      hold(dt, dt);
    }
  }

  void hold(float until, float dt) {
    const float end = min_of(until, dt);
    report.time_held = max_of(report.time_held, end - now);
    now = end;
  }

  /// The gap from which the next search lets parting blades go.
  float margin_of(const MovingPair<float>& pair) const {
    const AdvancementOptions<float> options;
    const float size =
        length(blades[0].body.X_WB.p_W) + length(blades[1].body.X_WB.p_W) + pair.scale;
    return 2 * (contact_tolerance_of(pair, options) + detail::inflation_of(pair)) +
           64 * kRoundOff<float> * size;
  }

  void answer(const SearchResult<float>& found, const MovingPair<float>& pair, float dt) {
    const Contact<float> contact = contact_from(found.witness, pair.origin_W);
    Body<float>& A = blades[0].body;
    Body<float>& B = blades[1].body;
    const float restitution = max_of(blades[0].restitution, blades[1].restitution);
    const auto hit = collision_impulse(collider_of(A), collider_of(B), contact, restitution);
    const ContactKind kind = classify(hit.value.v_rel, price::kRestSpeed);
    const float margin = margin_of(pair);
    const bool separates = kind == ContactKind::kResting || contact.gap < -margin;
    SeparationOptions<float> how;
    how.distance = separates ? max_of(price::kSeparation, margin) : margin;
    how.rest_speed = price::kRestSpeed;
    how.min_duration = price::kLeastHold;
    const auto shifts = separate(contact, hit.value.v_rel, A.inverse_mass, B.inverse_mass, how);
    if (!hit.ok() || !shifts.ok()) {
      ++report.resolutions_invalid;
      return hold(dt, dt);
    }
    A.X_WB.p_W += shifts.value.shift_A_W;
    B.X_WB.p_W += shifts.value.shift_B_W;
    const bool pushes = kind == ContactKind::kColliding;
    if (pushes) push(hit.value);
    tell_contact(kind, found.witness, pair.origin_W, hit.value.v_rel,
                 pushes ? hit.value.magnitude : 0.F);
    if (!separates) return;
    ++report.separations;
    hold(now + shifts.value.duration, dt);
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
