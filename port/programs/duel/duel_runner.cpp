// SPDX-License-Identifier: MIT

#include "programs/duel/duel_runner.hpp"

#include <algorithm>
#include <cmath>

#include "batuta/fencing/observation.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

double bout_length(const Source& left, const Source& right, double limit) {
  double longest = 0;
  for (const Source* source : {&left, &right}) {
    if (std::isfinite(source->duration())) longest = std::max(longest, source->duration());
  }
  const bool ends = longest > 0;
  return std::isfinite(limit) ? limit : (ends ? longest : DuelRunner::kBoutLength);
}

}  // namespace

std::array<int, 2> score_of(const Bout<float>& bout) {
  std::array<int, 2> score = {bout.score[0], bout.score[1]};
  if (bout.state == BoutState::kLockout) ++score[index_of(bout.touches[0].by)];
  return score;
}

DuelRunner::DuelRunner(Source& left, Source& right, double limit, const BoutRules& rules)
    : sources_{&left, &right},
      rules_(rules),
      bout_(make_bout(rules.search)),
      limit_(bout_length(left, right, limit)) {}

Status DuelRunner::start() {
  haptics::BoutSettings settings;
  settings.step_us = kStep_us;
  settings.touches = rules_.touches;
  settings.distance = rules_.distance;
  return bout_->start(settings);
}

bool DuelRunner::step() {
  std::array<InputSample, 2> samples;
  const InputSample* left = read(Side::kLeft, samples[0]);
  const InputSample* right = read(Side::kRight, samples[1]);
  const auto before = std::chrono::steady_clock::now();
  status_ = bout_->step(left, right);
  const auto spent = std::chrono::steady_clock::now() - before;
  if (status_ != Status::kOk) return false;
  add_up(spent);
  ending_ = judge();
  return ending_ == Ending::kNone;
}

const InputSample* DuelRunner::read(Side side, InputSample& sample) {
  Source& source = *sources_[index_of(side)];
  DeviceTally& tally = tally_.devices[index_of(side)];
  if (source.sees()) source.see(observation_of(duel(), side), kStep_us);
  const auto now_us = static_cast<Microseconds>(std::uint64_t{bout_->steps()} * kStep_us);
  const Status status = source.read(now_us, sample);
  if (status == Status::kInvalidArgument) ++tally.refused;
  if (status == Status::kOk) ++tally.samples;
  if (!tally.ended && now() > source.duration()) {
    tally.ended = true;
    tally.ended_at = source.duration();
  }
  return status == Status::kOk ? &sample : nullptr;
}

void DuelRunner::add_up(std::chrono::nanoseconds spent) {
  const auto& report = duel().step_report();
  for (const auto& event : duel().events()) {  // Bound: DuelScene::kMaxEvents
    const bool blow = event.contact_kind == ContactKind::kColliding;
    tally_.beats += event.kind == EventKind::kBegin && blow ? 1 : 0;
    tally_.begins += event.kind == EventKind::kBegin ? 1 : 0;
    tally_.persists += event.kind == EventKind::kPersist ? 1 : 0;
    tally_.ends += event.kind == EventKind::kEnd ? 1 : 0;
  }
  tally_.events_dropped += report.events_dropped;
  tally_.contacts_dropped += report.contacts_dropped;
  const float gap = capsule_gap(duel().blade_W(Side::kLeft), duel().blade_W(Side::kRight)).gap;
  tally_.smallest_gap = std::min(tally_.smallest_gap, gap);
  tally_.deepest_overlap = std::max(tally_.deepest_overlap, report.deepest_overlap);
  tally_.longest_hold = std::max(tally_.longest_hold, report.time_held);
  const auto ns = static_cast<std::uint64_t>(spent.count());
  tally_.host_ns += ns;
  tally_.host_ns_worst = std::max(tally_.host_ns_worst, ns);
}

Ending DuelRunner::judge() const {
  const Bout<float>& bout = duel().bout();
  if (!bout.is_over() && now() < limit_) return Ending::kNone;
  const auto [left, right] = score_of(bout);
  if (left != right) return Ending::kWon;
  return bout.is_over() ? Ending::kDouble : Ending::kDraw;
}

}  // namespace batuta::host
