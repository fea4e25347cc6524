// SPDX-License-Identifier: MIT
// DetectionOnly as one writes it by hand, against the kernels alone.

#include "../scene.hpp"
#include "blades.hpp"

namespace {

using namespace batuta;

class Detection : public price::Blades {
 public:
  Status step(float dt) {
    if (!is_positive(dt)) return Status::kInvalidArgument;
    begin();
    if (plan(dt)) ask();
    move(dt);
    now = dt;
    end();
    return Status::kOk;
  }

 private:
  void ask() {
    Result<MovingPair<float>> pair;
    const auto found = search(pair);
    if (found.outcome == Outcome::kFree) return;
    if (!is_contact(found.outcome)) return count_cut(found.outcome);
    now = found.t_free;
    tell_contact(classify(found.gap_rate, price::kRestSpeed), found.witness, pair.value.origin_W,
                 found.gap_rate, 0, is_in_touch(found));
  }
};

Detection scene;

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
