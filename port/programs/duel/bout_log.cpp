// SPDX-License-Identifier: MIT

#include "programs/duel/bout_log.hpp"

#include <algorithm>

namespace batuta::host {
using namespace fencing;

void BoutLog::on_start(const DuelRunner& runner) {
  std::fprintf(out_, "left   %s\n", runner.source(Side::kLeft).description().c_str());
  std::fprintf(out_, "right  %s\n", runner.source(Side::kRight).description().c_str());
  const BoutRules& rules = runner.rules();
  std::fprintf(out_, "bout   to %d touch%s, search %s\n", rules.touches,
               rules.touches == 1 ? "" : "es", name_of(rules.search));
  std::fprintf(out_, "%9.3f s  en garde\n", 0.0);
}

void BoutLog::on_step(const DuelRunner& runner) {
  if (touches_.is_next(runner.duel())) {
    engagement_ = {};
    std::fprintf(out_, "%9.3f s  en garde\n", time_of(runner.duel()) - 1e-6 * DuelRunner::kStep_us);
  }
  for (const auto& event : runner.duel().events()) {  // Bound: DuelScene::kMaxEvents
    print_contact(time_of(runner, event), event);
  }
  touches_.for_each_new(runner.duel(), [&](const Touch<float>& touch) {
    std::fprintf(out_, "%9.3f s  touch   %s touches the %s at %.2f m height%s\n",
                 time_of(runner, touch), name_of(touch.by), fencing::name_of(touch.part),
                 static_cast<double>(touch.contact.point_W.z()),
                 touch.certain ? "" : " (perhaps not the first)");
  });
  if (!touches_.is_halt(runner.duel())) return;
  const Bout<float>& bout = runner.duel().bout();
  std::fprintf(out_, "%9.3f s  halt    %d : %d%s%s\n", runner.now(), bout.score[0], bout.score[1],
               bout.annulled ? ", the double touch is annulled" : "",
               bout.is_corps_a_corps() ? ", corps a corps" : "");
}

void BoutLog::print_contact(double time, const ContactEvent<float>& event) {
  if (event.kind == EventKind::kBegin) {
    if (engagement_.pairs++ == 0) engagement_ = {time, 0, 1};
    std::fprintf(out_, "%9.3f s  %s    left blade at %3.0f %%, right at %3.0f %%", time,
                 is_beat(event) ? "beat" : "lean", 100.0 * static_cast<double>(event.place_A),
                 100.0 * static_cast<double>(event.place_B));
    if (is_beat(event)) {
      std::fprintf(out_, "  %6.3f N s at %5.2f m/s", static_cast<double>(event.impulse),
                   -static_cast<double>(event.v_rel));
    }
    std::fputc('\n', out_);
  }
  if (event.kind == EventKind::kEnd) {
    engagement_.pairs = std::max(engagement_.pairs - 1, 0);
    if (engagement_.pairs == 0) print_parting(time);
  } else {
    engagement_.impulse += static_cast<double>(event.impulse);
  }
}

void BoutLog::print_parting(double time) {
  constexpr double kNoticeable = 0.03;  // s
  const double together = time - engagement_.since;
  if (together < kNoticeable) return;
  std::fprintf(out_, "%9.3f s  part    after %.0f ms on each other, %.3f N s in all\n", time,
               1e3 * together, engagement_.impulse);
}

void BoutLog::on_end(const DuelRunner& runner) {
  const DuelReport& report = runner.duel().report();
  const Tally& tally = runner.tally();
  const bool won = runner.ending() == Ending::kWon;
  const auto [left, right] = score_of(runner.duel().bout());
  std::fprintf(out_, "%9.3f s  halt    %s%s, %d : %d\n", runner.now(), result_of(runner),
               won ? " wins" : "", left, right);
  std::fprintf(out_, "\nbeats %u; contacts begun %u, kept %u, ended %u; blows %u, rests %u\n",
               tally.beats, tally.begins, tally.persists, tally.ends, report.blows, report.rests);
  std::fprintf(out_, "smallest gap between the blades %.4f mm, deepest overlap %.4f mm\n",
               1e3 * static_cast<double>(tally.smallest_gap),
               1e3 * static_cast<double>(tally.deepest_overlap));
  print_device(runner, Side::kLeft);
  print_device(runner, Side::kRight);
  print_holds(runner);
  std::fprintf(out_, "steps %u of %u us; on this host %.1f us a step, worst %.1f us\n",
               runner.duel().steps(), static_cast<unsigned>(DuelRunner::kStep_us),
               mean_step_ns(runner) * 1e-3, static_cast<double>(tally.host_ns_worst) * 1e-3);
}

void BoutLog::print_device(const DuelRunner& runner, Side side) {
  const StickReport& stick = runner.duel().stick(side).report();
  const DeviceTally& device = runner.tally().devices[index_of(side)];
  std::fprintf(out_, "%-5s  samples used %u, refused %u, overwritten %u", name_of(side), stick.used,
               rejected(runner, side), stick.lost);
  if (runner.source(side).losses() > 0) {
    std::fprintf(out_, ", lost by the device %u", runner.source(side).losses());
  }
  if (runner.source(side).unplugs() > 0) {
    std::fprintf(out_, ", unplugged %u times", runner.source(side).unplugs());
  }
  if (device.ended) std::fprintf(out_, "; ended at %.3f s, the stick stayed", device.ended_at);
  std::fputc('\n', out_);
}

void BoutLog::print_holds(const DuelRunner& runner) {
  const DuelReport& report = runner.duel().report();
  const Tally& tally = runner.tally();
  if (report.incomplete_steps + report.budget_outs + report.searches_invalid +
          tally.events_dropped ==
      0) {
    return;
  }
  std::fprintf(
      out_,
      "note   steps in which a blade was held %u (longest %.6f s): contacts beyond the limit %u, "
      "searches out of budget %u, searches that could not be asked %u; events not recorded %u\n",
      report.incomplete_steps, static_cast<double>(tally.longest_hold), tally.contacts_dropped,
      report.budget_outs, report.searches_invalid, tally.events_dropped);
}

}  // namespace batuta::host
