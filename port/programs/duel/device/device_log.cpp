// SPDX-License-Identifier: MIT

#include "programs/duel/device/device_log.hpp"

#include "programs/duel/json_line.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

/// By link::Rejection.
constexpr std::array<const char*, link::kRejections> kReasons = {
    "too_long", "cobs", "too_short", "crc", "version", "type", "payload", "repeated", "old"};

const char* name_of(link::Mode mode) {
  return mode == link::Mode::kPaced ? "paced" : "free";
}

/// The device's own list of faults (port/platforms/cortex_m/fault.hpp).
const char* fault_name(std::uint32_t code) {
  constexpr std::array<const char*, 7> kNames = {
      "none", "start-up", "hard fault", "stack overflow", "assert", "watchdog", "main returned"};
  return code < kNames.size() ? kNames[code] : "unknown";
}

void print_reasons(std::FILE* out, const link::LinkCounters& counters) {
  for (std::size_t i = 0; i < kReasons.size(); ++i) {  // Bound: kRejections
    if (counters.rejected_for[i] == 0) continue;
    std::fprintf(out, ", %s %u", kReasons[i], counters.rejected_for[i]);
  }
}

}  // namespace

void print_device(std::FILE* out, const DevicePartner& partner) {
  const DeviceLink& link = partner.link();
  const link::LinkCounters& counters = link.counters();
  const link::StepReport& report = partner.report();
  const link::Welcome& welcome = link.welcome();
  std::fprintf(out,
               "device  %s mode; steps that were the same to the last bit %u; lost sessions %u\n",
               name_of(partner.mode()), partner.compared(), partner.lost_sessions());
  std::fprintf(out,
               "device  overruns %u, ticks skipped %u, silences %u, steps with a stale stick %u\n",
               report.overruns, report.skipped, report.silences, report.stale_steps);
  std::fprintf(out,
               "device  commands that its motor did not take %u, samples of its stick refused %u\n",
               report.force_failures, report.stick_invalid);
  if (welcome.fault_code != 0) {
    std::fprintf(out, "device  its last run ended with a fault: %s (%u, 0x%08x, 0x%08x)\n",
                 fault_name(welcome.fault_code), welcome.fault_code, welcome.fault_detail[0],
                 welcome.fault_detail[1]);
  }
  std::fprintf(out, "link    to the device: frames %u, rejected %u, missing %u; asked again %u\n",
               link.sent(), report.rejected, report.lost, link.sums().resends);
  std::fprintf(out, "link    to the host: frames %u, without room %u, missing %u, rejected %u",
               counters.accepted, report.unsent, counters.lost, counters.rejected());
  print_reasons(out, counters);
  std::fputc('\n', out);
}

void print_device_json(std::FILE* out, const DevicePartner& partner) {
  const DeviceLink& link = partner.link();
  const link::LinkCounters& counters = link.counters();
  const link::StepReport& report = partner.report();
  JsonLine line(out, "link");
  line.text("mode", name_of(partner.mode()))
      .count("steps_compared", partner.compared())
      .count("forces_not_zero", partner.forces_not_zero())
      .count("sessions", link.sums().sessions)
      .count("lost_sessions", partner.lost_sessions())
      .count("resends", link.sums().resends)
      .count("refusals", link.sums().refusals)
      .count("frames_sent", link.sent())
      .count("frames_received", counters.accepted)
      .count("missing", counters.lost)
      .count("rejected", counters.rejected());
  for (std::size_t i = 0; i < kReasons.size(); ++i) {  // Bound: kRejections
    line.count((std::string("rejected_") + kReasons[i]).c_str(), counters.rejected_for[i]);
  }
  line.count("device_rejected", report.rejected)
      .count("device_missing", report.lost)
      .count("device_unsent", report.unsent)
      .count("device_overruns", report.overruns)
      .count("device_skipped", report.skipped)
      .count("device_silences", report.silences)
      .count("device_stale_steps", report.stale_steps)
      .count("device_force_failures", report.force_failures)
      .count("device_stick_invalid", report.stick_invalid)
      .count("device_fault", link.welcome().fault_code)
      .text("problem", partner.problem());
}

}  // namespace batuta::host
