// SPDX-License-Identifier: MIT

#include "programs/duel/device/step_difference.hpp"

#include <cstdio>
#include <cstring>

#include "shared/firmware/step_messages.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

std::uint32_t bits_of(float value) {
  std::uint32_t bits = 0;
  static_assert(sizeof(bits) == sizeof(value));
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

/// Keeps the first of the differences that it is shown.
class Comparison {
 public:
  explicit Comparison(std::uint32_t step) : step_(step) {}

  /// What the next fields belong to.
  void of(const std::string& subject) { subject_ = subject; }

  void field(const char* name, float here, float there) {
    if (!first_.empty() || bits_of(here) == bits_of(there)) return;
    std::array<char, 64> values{};
    std::snprintf(values.data(), values.size(), " differs: 0x%08x here, 0x%08x there",
                  bits_of(here), bits_of(there));
    first_ = place() + name + values.data();
  }
  /// A count, a flag or a kind.
  template <class Here, class There>
  void number(const char* name, Here here, There there) {
    if (!first_.empty() || static_cast<std::uint64_t>(here) == static_cast<std::uint64_t>(there)) {
      return;
    }
    first_ = place() + name + " differs: " + std::to_string(static_cast<std::uint64_t>(here)) +
             " here, " + std::to_string(static_cast<std::uint64_t>(there)) + " there";
  }
  template <std::size_t N>
  void fields(const char* name, const char* const (&parts)[N], const std::array<float, N>& here,
              const std::array<float, N>& there) {
    for (std::size_t i = 0; i < N; ++i) {  // Bound: N
      field((std::string(name) + " " + parts[i]).c_str(), here[i], there[i]);
    }
  }
  void missing() {
    if (first_.empty()) first_ = place() + "was not told";
  }
  const std::string& first() const { return first_; }

 private:
  std::string place() const { return "step " + std::to_string(step_) + ": " + subject_ + ": "; }

  std::uint32_t step_;
  std::string subject_;
  std::string first_;
};

constexpr const char* kXyz[] = {"x", "y", "z"};
constexpr const char* kWxyz[] = {"w", "x", "y", "z"};

void compare(Comparison& to, const link::Pose& here, const link::Pose& there) {
  to.fields("position", kXyz, here.position_W, there.position_W);
  to.fields("rotation", kWxyz, here.rotation_WB, there.rotation_WB);
}

void compare(Comparison& to, const link::Force& here, const link::Force& there) {
  to.field("x", here.x, there.x);
  to.field("y", here.y, there.y);
  to.number("stale", here.stale, there.stale);
  to.number("ramped", here.ramped, there.ramped);
  to.number("limited", here.limited, there.limited);
}

void compare(Comparison& to, const link::Event& here, const link::Event& there) {
  to.number("kind", here.kind, there.kind);
  to.number("contact kind", here.contact_kind, there.contact_kind);
  to.number("body A", here.body_A, there.body_A);
  to.number("body B", here.body_B, there.body_B);
  to.field("time", here.time, there.time);
  to.fields("point", kXyz, here.point_W, there.point_W);
  to.fields("normal", kXyz, here.normal_BA_W, there.normal_BA_W);
  to.field("gap", here.gap, there.gap);
  to.field("relative velocity", here.v_rel, there.v_rel);
  to.field("impulse", here.impulse, there.impulse);
  to.field("place A", here.place_A, there.place_A);
  to.field("place B", here.place_B, there.place_B);
}

void compare(Comparison& to, const link::Touch& here, const link::Touch& there) {
  to.number("by", here.by, there.by);
  to.number("part", here.part, there.part);
  to.number("certain", here.certain, there.certain);
  to.number("step", here.when_step, there.when_step);
  to.field("time in step", here.when_in_step, there.when_in_step);
  to.fields("point", kXyz, here.point_W, there.point_W);
  to.fields("normal", kXyz, here.normal_BA_W, there.normal_BA_W);
  to.field("gap", here.gap, there.gap);
  to.field("place", here.place, there.place);
}

void compare(Comparison& to, const link::StepReport& here, const link::StepReport& there) {
  to.number("state", here.bout_state, there.bout_state);
  to.number("touches", here.touches, there.touches);
  to.number("left score", here.score[0], there.score[0]);
  to.number("right score", here.score[1], there.score[1]);
  to.number("left sample", here.used_left, there.used_left);
  to.number("right sample", here.used_right, there.used_right);
  to.number("stale steps", here.stale_steps, there.stale_steps);
  to.number("evaluations", here.evaluations, there.evaluations);
  to.number("incomplete steps", here.incomplete_steps, there.incomplete_steps);
}

template <class Message>
void compare(Comparison& to, const std::string& subject, const Message& here,
             const std::optional<Message>& there) {
  to.of(subject);
  if (there) {
    compare(to, here, *there);
  } else {
    to.missing();
  }
}

}  // namespace

std::string first_difference(const haptics::SteppedBout& here, const StepAnswer& there) {
  const firmware::DuelType& duel = here.duel();
  Comparison to(here.steps());
  to.of("bout");
  to.number("step", here.steps(), there.step());
  compare(to, "bout", firmware::report_message(here), there.report());
  if (there.report()) {
    const bool samples = there.used(0) || there.used(1);  // told in free mode only
    to.number("frames", static_cast<unsigned>(firmware::frames_of(here, samples)),
              there.report()->frames);
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {  // Bound: 2
    const std::string whose = side == Side::kLeft ? "left" : "right";
    const std::size_t i = index_of(side);
    compare(to, whose + " pose", firmware::pose_message(duel, side), there.pose(i));
    compare(to, whose + " force", firmware::force_message(here, side), there.force(i));
  }
  const int events = duel.world().events().size();
  to.of("bout");
  to.number("events", static_cast<unsigned>(events), static_cast<unsigned>(there.events()));
  for (int i = 0; i < events; ++i) {  // Bound: DuelScene::kMaxEvents
    compare(to, "event " + std::to_string(i), firmware::event_message(duel, i),
            there.event(static_cast<std::size_t>(i)));
  }
  const int touches = duel.bout().touches.size();
  for (int i = touches - firmware::new_touches(duel); i < touches; ++i) {  // Bound: 2
    compare(to, "touch " + std::to_string(i), firmware::touch_message(duel, i),
            there.touch(static_cast<std::size_t>(i)));
  }
  return to.first();
}

}  // namespace batuta::host
