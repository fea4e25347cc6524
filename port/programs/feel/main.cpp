// SPDX-License-Identifier: MIT
// batuta-feel: how a firmware closes the loop between a stick with motors and its blade. A hand
// leads a simulated stick forward and to the left, beats the opponent's blade and feels that.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "batuta/fencing/fencer.hpp"
#include "batuta/haptics/duel_hand.hpp"
#include "batuta/haptics/gain_advisor.hpp"
#include "batuta/haptics/output_stage.hpp"
#include "batuta/haptics/stick_gains.hpp"
#include "programs/feel/measure.hpp"
#include "programs/files/standard_output.hpp"
#include "shared/simulated/stick.hpp"

namespace batuta {
using namespace haptics;
using namespace fencing;
namespace {

constexpr float kForceLimit = 10;    // N m for each unit of the stick
constexpr float kDamping = 0.05F;    // of the stick, N m s for each unit
constexpr float kTurnShare = 0.01F;  // N m/rad for each N/m: a wrist is 10 cm long
constexpr int kTold = 100;           // ms from one line to the next
constexpr int kEnd = 2000;           // ms

port_simulated::StickSettings device() {
  port_simulated::StickSettings settings;
  settings.x.damping = static_cast<double>(kDamping);
  settings.x.mass = 0.01;
  settings.x.hand_stiffness = 5;
  settings.x.hand_damping = 0.02;
  settings.y = settings.x;
  settings.force_limit = static_cast<double>(kForceLimit);
  return settings;
}

DeviceProfile<float> profile(float period) {
  DeviceProfile<float> of_device;
  of_device.period = period;
  of_device.damping = kDamping;
  of_device.force_limit = kForceLimit;
  of_device.travel = 1;
  return of_device;
}

const char* name_of(GainVerdict verdict) {
  switch (verdict) {
    case GainVerdict::kInside:
      return "inside";
    case GainVerdict::kBeyondSampling:
      return "beyond: too much for this period and damping";
    case GainVerdict::kBeyondEncoder:
      return "beyond: too much for this encoder";
    default:
      return "no gains";
  }
}

/// Where the hand wants the stick.
Vec2<double> will(int ms) {
  const double way = 0.6 * std::min(1.0, ms / 1500.0);
  return {-way, way};
}

void tell(int ms, const port_simulated::SimulatedStick& stick) {
  const Vec2<double> hand = will(ms);
  std::printf("%5d  %6.3f %6.3f   %6.3f %6.3f   %6.2f %6.2f\n", ms, hand.x(), hand.y(),
              stick.x().position(), stick.y().position(), stick.held().x(), stick.held().y());
}

int usage(std::FILE* out = stderr) {
  std::fprintf(out,
               "batuta-feel [stiffness of the coupling, N/m, >= 0; 100]\n"
               "batuta-feel --measure\n");
  return out == stderr ? 2 : 0;
}

/// Duel, felt force and output stage about the simulated stick.
class Loop {
 public:
  explicit Loop(const HandForceSettings<float>& feel) : stage_(stick_.force()) {
    StageSettings stage;
    stage.gain = {1 / kForceLimit, 1 / kForceLimit};
    good_ = stick_.configure(device()) == Status::kOk && felt_.configure(feel) == Status::kOk &&
            duel_.configure(duel_settings(), first_fencer<float>, second_fencer<float>) ==
                Status::kOk &&
            stage_.configure(stage) == Status::kOk && stage_.enable() == Status::kOk;
  }

  bool is_good() const { return good_; }
  const Duel<>& duel() const { return duel_; }
  const port_simulated::SimulatedStick& stick() const { return stick_; }
  const OutputStage& stage() const { return stage_; }
  const HandForceReport<float>& felt() const { return felt_report_; }

  /// What a firmware does each millisecond; the first line is what the world does in it.
  void tick(int ms) {
    stick_.advance(will(ms));
    InputSample sample;
    const bool fresh = stick_.input().read(stick_.now(), sample) == Status::kOk;
    const bool stepped = duel_.step(fresh ? &sample : nullptr, nullptr) == Status::kOk;
    StageInput input;
    input.time = stick_.now();
    input.position = duel_.stick(Side::kLeft).position();
    if (stepped) feel(input);
    input.fresh_sample = stepped && fresh;
    input.fresh_command = stepped;
    (void)stage_.step(input);
  }

 private:
  /// The force of the step that the duel has just made; without a step there is none.
  void feel(StageInput& input) {
    if (duel_.bout().exchange != exchange_) felt_.leap();  // both have been put on guard anew
    exchange_ = duel_.bout().exchange;
    input.demanded = felt_.advance(hand_state(duel_, Side::kLeft), duel_.dt());
    felt_report_.take(felt_);
    input.clipped = felt_.is_clipped();
    input.excess = felt_.excess();
    input.velocity = duel_.stick(Side::kLeft).velocity();
  }

  Duel<> duel_;
  HandForce<float> felt_;
  HandForceReport<float> felt_report_;
  port_simulated::SimulatedStick stick_;
  OutputStage stage_;
  std::uint32_t exchange_ = 1;  ///< of the bout, that was felt last
  bool good_ = false;
};

HandForceSettings<float> feel_of(float stiffness) {
  HandForceSettings<float> feel;
  feel.coupling.stiffness = stiffness;
  feel.coupling.turn_stiffness = kTurnShare * stiffness;
  feel.coupling.damping = 0;
  feel.coupling.turn_damping = 0;
  feel.transient.max_force = kForceLimit;
  return feel;
}

int run(float stiffness) {
  const HandForceSettings<float> feel = feel_of(stiffness);
  Loop loop(feel);
  if (!loop.is_good()) return usage();
  const auto gains = gains_at_stick(loop.duel().hand(Side::kLeft).jacobian, feel.coupling);
  const auto limit = largest_stiffness(profile(loop.duel().dt()), gains.damping);
  std::printf(
      "%g N/m at the hand are %.3g N m for each unit of the stick, of %.3g that it bears: %s\n",
      static_cast<double>(stiffness), static_cast<double>(gains.stiffness),
      static_cast<double>(limit.value.largest), name_of(check(profile(loop.duel().dt()), gains)));
  std::printf("   ms        hand            stick        felt, N m\n");
  for (int ms = 0; ms < kEnd; ++ms) {
    loop.tick(ms);
    if (ms % kTold == 0) tell(ms, loop.stick());
  }
  const StageReport& report = loop.stage().report();
  std::printf(
      "%u ms; clipped in %.1f %% of them, by %.3g ranges at most; the coupling at its own limit in "
      "%.1f %%\n",
      report.steps, 100.0 * static_cast<double>(report.clipped_share()),
      static_cast<double>(report.worst_excess), 100.0 * loop.felt().limited / report.steps);
  return 0;
}

int run_program(int count, char** words) {
  if (count > 2) return usage();
  if (count == 2 && std::strcmp(words[1], "--help") == 0) return usage(stdout);
  if (count == 2 && std::strcmp(words[1], "--measure") == 0) return measure();
  if (count < 2) return run(100.0F);
  char* end = nullptr;
  const float stiffness = std::strtof(words[1], &end);
  return end != words[1] && *end == '\0' ? run(stiffness) : usage();
}

}  // namespace
}  // namespace batuta

int main(int count, char** words) {
  batuta::host::begin_output();
  return batuta::host::finish_output("batuta-feel", batuta::run_program(count, words));
}
