// SPDX-License-Identifier: MIT

#include "programs/duel/json_log.hpp"

#include <string>

namespace batuta::host {
using namespace fencing;
namespace {

const char* name_of(EventKind kind) {
  switch (kind) {
    case EventKind::kBegin:
      return "begin";
    case EventKind::kPersist:
      return "persist";
    case EventKind::kEnd:
      break;
  }
  return "end";
}

const char* name_of(ContactKind kind) {
  switch (kind) {
    case ContactKind::kColliding:
      return "colliding";
    case ContactKind::kResting:
      return "resting";
    case ContactKind::kReceding:
      break;
  }
  return "receding";
}

void add_result(JsonLine& line, const DuelRunner& runner) {
  line.text("result", result_of(runner))
      .count("steps", runner.duel().steps())
      .number("simulated_seconds", runner.now());
  const auto [left, right] = score_of(runner.duel().bout());
  line.count("score_left", static_cast<unsigned>(left))
      .count("score_right", static_cast<unsigned>(right))
      .count("exchanges", runner.duel().bout().exchange);
}

void add_touch(JsonLine& line, const DuelRunner& runner, const Touch<float>& touch) {
  line.text("touch_by", batuta::host::name_of(touch.by))
      .text("touch_part", fencing::name_of(touch.part))
      .number("touch_time", time_of(runner, touch))
      .flag("touch_certain", touch.certain);
}

void add_contacts(JsonLine& line, const DuelRunner& runner) {
  const DuelReport& report = runner.duel().report();
  const Tally& tally = runner.tally();
  line.count("beats", tally.beats)
      .count("blows", report.blows)
      .count("rests", report.rests)
      .count("begin", tally.begins)
      .count("persist", tally.persists)
      .count("end", tally.ends)
      .number("smallest_gap", static_cast<double>(tally.smallest_gap))
      .number("deepest_overlap", static_cast<double>(tally.deepest_overlap))
      .number("longest_hold", static_cast<double>(tally.longest_hold))
      .count("incomplete_steps", report.incomplete_steps)
      .count("events_not_recorded", tally.events_dropped)
      .count("contacts_not_answered", tally.contacts_dropped)
      .count("budget_outs", report.budget_outs)
      .count("searches_invalid", report.searches_invalid)
      .count("evaluations", report.evaluations);
}

void add_device(JsonLine& line, const DuelRunner& runner, Side side) {
  const StickReport& stick = runner.duel().stick(side).report();
  const DeviceTally& device = runner.tally().devices[index_of(side)];
  const std::string prefix = batuta::host::name_of(side);
  const auto key = [&](const char* what) { return prefix + "_" + what; };
  line.count(key("samples_used").c_str(), stick.used)
      .count(key("samples_rejected").c_str(), rejected(runner, side))
      .count(key("samples_overwritten").c_str(), stick.lost)
      .count(key("device_losses").c_str(), runner.source(side).losses())
      .count(key("unplugs").c_str(), runner.source(side).unplugs())
      .flag(key("source_ended").c_str(), device.ended);
}

}  // namespace

void JsonLog::on_start(const DuelRunner& runner) {
  JsonLine(out_, "start")
      .text("left", runner.source(Side::kLeft).description())
      .text("right", runner.source(Side::kRight).description())
      .text("search", batuta::host::name_of(runner.rules().search))
      .number("step_seconds", 1e-6 * DuelRunner::kStep_us)
      .number("limit_seconds", runner.limit())
      .count("touches", static_cast<unsigned>(runner.rules().touches))
      .number("distance", static_cast<double>(runner.rules().distance));
}

void JsonLog::on_step(const DuelRunner& runner) {
  for (const auto& event : runner.duel().events()) {  // Bound: DuelScene::kMaxEvents
    const bool blow = event.contact_kind == ContactKind::kColliding;
    if (event.kind != EventKind::kPersist || blow) write_contact(time_of(runner, event), event);
  }
  touches_.for_each_new(runner.duel(), [&](const Touch<float>& touch) {
    if (runner.duel().bout().exchange != last_exchange_) last_ = touch;
    last_exchange_ = runner.duel().bout().exchange;
    JsonLine(out_, "touch")
        .number("time", time_of(runner, touch))
        .count("exchange", runner.duel().bout().exchange)
        .text("by", batuta::host::name_of(touch.by))
        .text("part", fencing::name_of(touch.part))
        .number("place", static_cast<double>(touch.place))
        .vector("point", touch.contact.point_W)
        .flag("certain", touch.certain);
  });
  if (touches_.is_halt(runner.duel())) write_halt(runner);
}

void JsonLog::write_halt(const DuelRunner& runner) {
  const Bout<float>& bout = runner.duel().bout();
  JsonLine(out_, "halt")
      .number("time", runner.now())
      .count("exchange", bout.exchange)
      .count("score_left", bout.score[0])
      .count("score_right", bout.score[1])
      .flag("annulled", bout.annulled)
      .flag("corps_a_corps", bout.is_corps_a_corps());
}

void JsonLog::write_contact(double time, const ContactEvent<float>& event) {
  JsonLine(out_, "contact")
      .number("time", time)
      .text("event", name_of(event.kind))
      .text("kind", name_of(event.contact_kind))
      .number("place_left", static_cast<double>(event.place_A))
      .number("place_right", static_cast<double>(event.place_B))
      .number("impulse", static_cast<double>(event.impulse))
      .number("relative_velocity", static_cast<double>(event.v_rel))
      .number("gap", static_cast<double>(event.contact.gap))
      .vector("point", event.contact.point_W)
      .vector("normal", event.contact.normal_BA_W);
}

void JsonLog::on_end(const DuelRunner& runner) {
  JsonLine line(out_, "summary");
  add_result(line, runner);
  if (last_exchange_ > 0) add_touch(line, runner, last_);
  add_contacts(line, runner);
  add_device(line, runner, Side::kLeft);
  add_device(line, runner, Side::kRight);
  line.number("host_ns_per_step_mean", mean_step_ns(runner))
      .count("host_ns_per_step_max", runner.tally().host_ns_worst);
}

}  // namespace batuta::host
