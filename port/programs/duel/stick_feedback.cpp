// SPDX-License-Identifier: MIT

#include "programs/duel/stick_feedback.hpp"

#include "programs/duel/bout_words.hpp"
#include "programs/duel/json_line.hpp"
#include "shared/firmware/stage_settings.hpp"

namespace batuta::host {
using namespace haptics;
using namespace fencing;
namespace {

Microseconds end_of_step(const DuelRunner& runner) {
  return static_cast<Microseconds>(std::uint64_t{runner.bout().steps()} * DuelRunner::kStep_us);
}

/// What it came to; a device may announce more than it takes.
ForceKind kind_of(LiveForce& force) {
  const ForceReport& report = force.report();
  return report.sent > 0 ? report.kind : force.first_kind();
}

}  // namespace

StickFeedback::StickFeedback(const std::array<LiveForce*, 2>& forces) : forces_(forces) {
  for (std::size_t i = 0; i < forces_.size(); ++i) {  // Bound: 2
    if (forces_[i] != nullptr) stages_[i].emplace(*forces_[i]);
  }
}

StickFeedback::~StickFeedback() {
  for (auto& stage : stages_) {  // Bound: 2
    if (stage) stage->stop(stage->last_command().time);
  }
}

void StickFeedback::on_start(const DuelRunner& runner) {
  const StageSettings settings = firmware::stage_settings({}, runner.duel().dt());
  for (auto& stage : stages_) {  // Bound: 2
    if (!stage) continue;
    const bool ready = stage->configure(settings) == Status::kOk && stage->enable() == Status::kOk;
    BATUTA_INVARIANT(ready);
  }
}

void StickFeedback::on_step(const DuelRunner& runner) {
  for (const Side side : {Side::kLeft, Side::kRight}) {  // Bound: 2
    auto& stage = stages_[index_of(side)];
    if (!stage) continue;
    const auto& force = runner.bout().forces().of(side);
    StageInput input;
    input.time = end_of_step(runner);
    input.position = runner.duel().stick(side).position();
    input.velocity = runner.duel().stick(side).velocity();
    input.demanded = force.demanded;
    input.clipped = force.limited;
    input.excess = force.excess;
    input.allowed = force.allowed;
    input.fresh_sample = runner.bout().is_alive(side);
    input.fresh_command = true;
    (void)stage->step(input);  // an unplugged stick goes without; the stage counts it
  }
}

void StickFeedback::on_end(const DuelRunner& runner) {
  for (auto& stage : stages_) {  // Bound: 2
    if (stage) stage->stop(end_of_step(runner));
  }
}

void ForceLog::on_end(const DuelRunner& /*runner*/) {
  for (const Side side : {Side::kLeft, Side::kRight}) {  // Bound: 2
    LiveForce* const force = feedback_.force(side);
    if (force == nullptr) continue;
    if (json_) {
      write_json(side, *force);
    } else {
      print(side, *force);
    }
  }
}

void ForceLog::print(Side side, LiveForce& force) const {
  const ForceReport& report = force.report();
  std::fprintf(out_, "%-5s  force: %s; effects sent %u", name_of(side), name_of(kind_of(force)),
               report.sent);
  if (report.sent > 0) {
    std::fprintf(out_, ", each %.2f ms (worst %.2f, jitter %.2f), %.2f ms old (worst %.2f)",
                 1e-3 * report.mean_period_us, 1e-3 * report.worst_period_us,
                 1e-3 * report.jitter_us, 1e-3 * report.mean_age_us, 1e-3 * report.worst_age_us);
  }
  std::fprintf(out_, "; clipped in %.1f %% of the steps, taken away by silence %u times",
               100.0 * static_cast<double>(feedback_.stage(side).report().clipped_share()),
               report.silences);
  if (report.stalls > 0) std::fprintf(out_, ", because it was too busy %u times", report.stalls);
  if (!report.left_out.empty()) {
    std::fprintf(out_, "; not taken by the device: %s", names_of(report.left_out).c_str());
  }
  std::fputc('\n', out_);
}

void ForceLog::write_json(Side side, LiveForce& force) const {
  const ForceReport& report = force.report();
  JsonLine(out_, "force")
      .text("side", name_of(side))
      .text("kind", name_of(kind_of(force)))
      .text("left_out", names_of(report.left_out))
      .count("sent", report.sent)
      .count("silences", report.silences)
      .count("unplugs", report.unplugs)
      .count("stalls", report.stalls)
      .count("not_taken", feedback_.stage(side).report().refused)
      .number("clipped_share", static_cast<double>(feedback_.stage(side).report().clipped_share()))
      .number("period_mean", 1e-6 * report.mean_period_us)
      .number("period_max", 1e-6 * report.worst_period_us)
      .number("jitter", 1e-6 * report.jitter_us)
      .number("age_mean", 1e-6 * report.mean_age_us)
      .number("age_max", 1e-6 * report.worst_age_us);
}

}  // namespace batuta::host
