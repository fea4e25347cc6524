// SPDX-License-Identifier: MIT
#pragma once
// A stick or pad of SDL, opened, lost, and found again. The thread that reads it and the one that
// shakes it share it: whoever has hold of it keeps it open.

#include <SDL.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "programs/live/claim.hpp"

namespace batuta::host {

/// SDL's joysticks and haptics for as long as this lives. To be made and destroyed by the main
/// thread.
class SdlSession {
 public:
  SdlSession();
  SdlSession(const SdlSession&) = delete;
  SdlSession& operator=(const SdlSession&) = delete;
  ~SdlSession();

  bool is_open() const { return open_; }
  bool has_haptics() const { return haptics_; }

 private:
  bool open_ = false;
  bool haptics_ = false;
};

class SdlStick {
 public:
  using Handle = std::shared_ptr<SDL_Joystick>;

  /// @param choice  empty: the first that nobody has | its place in SDL's list | a part of its
  ///   name, in whatever case
  explicit SdlStick(std::string choice) : choice_(std::move(choice)) {}
  SdlStick(const SdlStick&) = delete;
  SdlStick& operator=(const SdlStick&) = delete;
  ~SdlStick() { close(); }

  /// The first time: as chosen. Later: the same device, wherever it is plugged in now: by its
  /// serial number, and one of its kind that has come since it went. Twins that tell no serial
  /// number, and are both plugged in anew, are not told apart.
  /// @returns whether it is there
  bool open();
  void close();
  /// While it is there: what else is there, too, is not the same one when that has gone. Of the
  /// thread that opens.
  void note_others();

  /// Null: it is away. Of any thread.
  Handle handle() const;
  /// SDL's mapping of it to the buttons and axes of a pad, or null. Of the thread that opens.
  SDL_GameController* pad() const { return pad_.get(); }
  const std::string& name() const { return name_; }
  /// Why the last open() found none, in a few words.
  const std::string& problem() const { return problem_; }

 private:
  bool is_chosen(int index) const;
  bool may_be_back(int index) const;
  bool is_back(SDL_Joystick* stick) const;
  bool open_at(int index);
  void take(int index, const Handle& handle);

  std::string choice_;
  std::string name_;
  bool known_ = false;       ///< those below are the device's
  SDL_JoystickGUID guid_{};  ///< of its kind: twins have the same
  std::string serial_;       ///< empty: it tells none
  SDL_JoystickID instance_ = 0;
  SDL_JoystickID latest_ = 0;  ///< of all that were there with it; SDL counts them up
  Claim claim_;
  std::string problem_;
  std::shared_ptr<SDL_GameController> pad_;
  mutable std::mutex mutex_;  ///< of handle_
  Handle handle_;
};

/// Those that SDL sees: "0 (Xbox pad), 1 (Wheel)".
std::string list_sdl();

}  // namespace batuta::host
