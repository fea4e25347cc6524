// SPDX-License-Identifier: MIT
#pragma once
// A device that fences the same bout as the host. Both make every step; after each one poses,
// events, touches and forces must be the same, to the last bit. The search is the board's.

#include <array>
#include <string>

#include "programs/devices/reported_stick.hpp"
#include "programs/duel/device/device_link.hpp"
#include "programs/duel/duel_runner.hpp"

namespace batuta::host {

/// How a session with a device went so far.
enum class Session : std::uint8_t {
  kGoingOn,
  kLost,  ///< telemetry is missing, or the device was reset: the bout cannot be followed any more,
          ///< a new one may
  kFailed,  ///< problem() says why
};

class DevicePartner {
 public:
  DevicePartner(const DevicePartner&) = delete;
  DevicePartner& operator=(const DevicePartner&) = delete;
  virtual ~DevicePartner() = default;

  /// Opens a session: a new bout on the device, to so many touches. @returns false: problem()
  bool open(int touches = 1);
  /// Before the host's step. @returns whether it is to be made
  bool before_step(const DuelRunner& runner) { return do_before_step(runner); }
  /// After it. @returns whether the bout goes on
  bool after_step(const DuelRunner& runner);

  virtual link::Mode mode() const = 0;
  Session session() const { return session_; }
  /// In one line, with the step; empty: there is none.
  const std::string& problem() const { return problem_; }
  /// Steps that were the same on both sides, over all sessions.
  std::uint32_t compared() const { return compared_; }
  /// Of the forces compared in them, those with a component that is not zero.
  std::uint32_t forces_not_zero() const { return forces_not_zero_; }
  /// Sessions that ended with kLost.
  std::uint32_t lost_sessions() const { return lost_sessions_; }
  /// The device's own counts, as of its last step.
  const link::StepReport& report() const { return report_; }
  const DeviceLink& link() const { return link_; }

 protected:
  explicit DevicePartner(DeviceLink& link) : link_(link) {}

  bool fail(const std::string& problem);
  bool lose(const std::string& problem);
  DeviceLink& line() { return link_; }
  StepAnswer& answer() { return answer_; }

 private:
  virtual void do_open() {}
  virtual bool do_before_step(const DuelRunner& runner) = 0;
  /// Sees to it that answer() is the whole of the runner's last step.
  virtual bool do_after_step(const DuelRunner& runner) = 0;

  DeviceLink& link_;
  StepAnswer answer_;
  link::StepReport report_;
  Session session_ = Session::kGoingOn;
  std::string problem_;
  std::uint32_t compared_ = 0;
  std::uint32_t forces_not_zero_ = 0;
  std::uint32_t lost_sessions_ = 0;
};

/// The host asks for each step, with the samples of its own sources.
class PacedPartner final : public DevicePartner {
 public:
  explicit PacedPartner(DeviceLink& link) : DevicePartner(link) {}
  link::Mode mode() const override { return link::Mode::kPaced; }

 private:
  bool do_before_step(const DuelRunner& /*runner*/) override { return true; }
  bool do_after_step(const DuelRunner& runner) override;
};

/// The device makes its steps by itself; the host follows it with the samples that it reports.
class FreePartner final : public DevicePartner {
 public:
  /// @param faces   what the runner reads; told by this
  /// @param locals  sources whose samples go to the device, or null: the device has its own stick
  FreePartner(DeviceLink& link, std::array<ReportedStick*, 2> faces, std::array<Source*, 2> locals)
      : DevicePartner(link), faces_(faces), locals_(locals) {}
  link::Mode mode() const override { return link::Mode::kFree; }

 private:
  void do_open() override;
  bool do_before_step(const DuelRunner& runner) override;
  bool do_after_step(const DuelRunner& /*runner*/) override { return true; }
  void tell_locals();

  std::array<ReportedStick*, 2> faces_;
  std::array<Source*, 2> locals_;
  Microseconds now_ = 0;  ///< for the locals: it goes on in the next session
};

}  // namespace batuta::host
