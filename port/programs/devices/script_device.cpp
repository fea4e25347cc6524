// SPDX-License-Identifier: MIT

#include "programs/devices/script_device.hpp"

#include <array>
#include <limits>
#include <string>

namespace batuta::host {
namespace {

constexpr std::array<ScriptMove, 4> kGuard = {{
    {700, 0.04F, 0.05F},
    {800, -0.03F, 0.02F},
    {700, 0.02F, -0.04F},
    {900, -0.04F, 0.00F},
}};

// Quarte, a beat and sixte.
constexpr std::array<ScriptMove, 9> kParry = {{
    {500, 0.04F, 0.00F},
    {180, -0.95F, 0.00F},
    {260, 0.00F, 0.00F},
    {100, 0.00F, 0.50F},
    {300, 0.03F, 0.02F},
    {180, 0.95F, 0.00F},
    {260, 0.00F, 0.00F},
    {350, -0.04F, 0.02F},
    {400, 0.00F, 0.00F},
}};

constexpr std::array<ScriptMove, 9> kAttack = {{
    {600, 0.05F, 0.03F},
    {160, -0.40F, 0.40F},
    {160, -0.10F, 0.05F},
    {350, 0.05F, 0.00F},
    {160, -0.40F, 0.40F},
    {160, -0.15F, 0.10F},
    {250, -0.98F, 0.98F},
    {300, -0.98F, 0.98F},
    {600, 0.00F, 0.05F},
}};

constexpr std::array<Script, 3> kScripts = {{
    {"guard", kGuard.data(), kGuard.size()},
    {"parry", kParry.data(), kParry.size()},
    {"attack", kAttack.data(), kAttack.size()},
}};

/// 0 ... 1 with no slope at either end.
float eased(float share) {
  return share * share * (3.0F - 2.0F * share);
}

/// Where the script is at `phase_ms` of its circle.
void place(const Script& script, std::uint32_t phase_ms, InputSample& sample) {
  const ScriptMove* from = &script.moves[script.count - 1];
  for (std::size_t i = 0; i < script.count; ++i) {  // Bound: the moves of the script
    const ScriptMove* to = &script.moves[i];
    if (phase_ms < to->duration_ms) {
      const float share = eased(static_cast<float>(phase_ms) / static_cast<float>(to->duration_ms));
      sample.x = from->x + (to->x - from->x) * share;
      sample.y = from->y + (to->y - from->y) * share;
      return;
    }
    phase_ms -= to->duration_ms;
    from = to;
  }
}

}  // namespace

std::optional<Script> script_named(std::string_view name) {
  for (const Script& script : kScripts) {
    if (script.name == name) return script;
  }
  return std::nullopt;
}

ScriptDevice::ScriptDevice(const Script& script) : script_(script) {
  for (std::size_t i = 0; i < script.count; ++i) length_ms_ += script.moves[i].duration_ms;
}

std::string ScriptDevice::description() const {
  return "script " + std::string(script_.name);
}

double ScriptDevice::duration() const {
  return std::numeric_limits<double>::infinity();
}

void ScriptDevice::rewind() {
  phase_ms_ = 0;
  latest_ = InputSample();
  started_ = false;
}

Status ScriptDevice::do_read(Microseconds now, InputSample& sample) {
  const std::int32_t since_us = elapsed_us(latest_.time, now);
  const std::uint32_t periods =
      since_us < 0 ? 0 : static_cast<std::uint32_t>(since_us) / kPeriod_us;
  if (started_ && periods == 0) return Status::kUnavailable;
  latest_.time += periods * kPeriod_us;
  latest_.sequence += periods;
  phase_ms_ = static_cast<std::uint32_t>((std::uint64_t{phase_ms_} + periods) % length_ms_);
  place(script_, phase_ms_, latest_);
  started_ = true;
  sample = latest_;
  return Status::kOk;
}

}  // namespace batuta::host
