// SPDX-License-Identifier: MIT

#include "programs/live/sdl_stick.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>
#include <optional>

namespace batuta::host {
namespace {

/// Of the device behind a stick: the same as that of its event device, where SDL reads it through
/// one; else one that only SDL's sticks have.
DeviceNumber number_of(SDL_Joystick* stick, SDL_JoystickID instance) {
  const char* const path = SDL_JoystickPath(stick);
  const DeviceNumber number = path == nullptr ? kNoDevice : number_at(path);
  // Numbers of the kernel are smaller by far.
  constexpr DeviceNumber kSdl = DeviceNumber{1} << 63U;
  return number == kNoDevice ? kSdl + static_cast<DeviceNumber>(instance) : number;
}

/// SDL's list of joysticks stays as it is.
class ListLock {
 public:
  ListLock() { SDL_LockJoysticks(); }
  ListLock(const ListLock&) = delete;
  ListLock& operator=(const ListLock&) = delete;
  ~ListLock() { SDL_UnlockJoysticks(); }
};

std::string name_at(int index) {
  const char* const name = SDL_JoystickNameForIndex(index);
  return name == nullptr ? "without a name" : name;
}

std::string lower_case(std::string words) {
  std::transform(words.begin(), words.end(), words.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return words;
}

std::optional<int> place_of(const std::string& words) {
  int place = 0;
  const char* const end = words.data() + words.size();
  const std::from_chars_result read = std::from_chars(words.data(), end, place);
  const bool number = !words.empty() && read.ec == std::errc() && read.ptr == end;
  return number ? std::optional<int>(place) : std::nullopt;
}

bool same(const SDL_JoystickGUID& a, const SDL_JoystickGUID& b) {
  return std::memcmp(a.data, b.data, sizeof a.data) == 0;
}

std::string serial_of(SDL_Joystick* stick) {
  const char* const serial = SDL_JoystickGetSerial(stick);
  return serial == nullptr ? "" : serial;
}

}  // namespace

SdlSession::SdlSession() {
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // the user's interrupt ends the program
  SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
  SDL_SetMainReady();
  open_ = SDL_InitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER) == 0;
  haptics_ = open_ && SDL_InitSubSystem(SDL_INIT_HAPTIC) == 0;
  if (!open_) return;
  // Nobody reads the queue of events: the state is asked for.
  (void)SDL_JoystickEventState(SDL_IGNORE);
  (void)SDL_GameControllerEventState(SDL_IGNORE);
  for (const Uint32 type : {SDL_JOYDEVICEADDED, SDL_JOYDEVICEREMOVED, SDL_CONTROLLERDEVICEADDED,
                            SDL_CONTROLLERDEVICEREMOVED, SDL_CONTROLLERDEVICEREMAPPED}) {
    (void)SDL_EventState(type, SDL_IGNORE);
  }
}

SdlSession::~SdlSession() {
  if (haptics_) SDL_QuitSubSystem(SDL_INIT_HAPTIC);
  if (open_) SDL_QuitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER);
}

/// A stick that is plugged in anew has a new number: one of its kind that was there beside it is
/// another one. Its path says no more: a twin may have it by now.
bool SdlStick::may_be_back(int index) const {
  const SDL_JoystickID instance = SDL_JoystickGetDeviceInstanceID(index);
  const bool is_new = instance == instance_ || instance > latest_;
  return is_new && same(SDL_JoystickGetDeviceGUID(index), guid_);
}

bool SdlStick::is_back(SDL_Joystick* stick) const {
  const std::string serial = serial_of(stick);
  return serial.empty() || serial_.empty() || serial == serial_;
}

void SdlStick::note_others() {
  const ListLock lock;
  const int count = SDL_NumJoysticks();
  for (int i = 0; i < count; ++i) {  // Bound: the sticks that SDL sees
    latest_ = std::max(latest_, SDL_JoystickGetDeviceInstanceID(i));
  }
}

bool SdlStick::is_chosen(int index) const {
  if (known_) return may_be_back(index);
  if (choice_.empty()) return true;
  const std::optional<int> place = place_of(choice_);
  if (place) return index == *place;
  return lower_case(name_at(index)).find(lower_case(choice_)) != std::string::npos;
}

bool SdlStick::open() {
  close();
  problem_ = "no such stick";
  const ListLock lock;
  const int count = SDL_NumJoysticks();
  for (int i = 0; i < count; ++i) {  // Bound: the sticks that SDL sees
    if (is_chosen(i) && open_at(i)) return true;
  }
  return false;
}

bool SdlStick::open_at(int index) {
  const Handle handle(SDL_JoystickOpen(index), [](SDL_Joystick* stick) {
    if (stick != nullptr) SDL_JoystickClose(stick);
  });
  if (handle == nullptr) {
    problem_ = name_at(index) + ": " + SDL_GetError();
    return false;
  }
  if (known_ && !is_back(handle.get())) {
    problem_ = name_at(index) + " is another one";
    return false;
  }
  if (SDL_JoystickNumAxes(handle.get()) < 2) {
    problem_ = name_at(index) + " has too few axes";
    return false;
  }
  if (!claim_.take(number_of(handle.get(), SDL_JoystickGetDeviceInstanceID(index)))) {
    problem_ = name_at(index) + " is the other fencer's already";
    return false;
  }
  take(index, handle);
  return true;
}

void SdlStick::take(int index, const Handle& handle) {
  name_ = name_at(index);
  guid_ = SDL_JoystickGetDeviceGUID(index);
  serial_ = serial_of(handle.get());
  instance_ = SDL_JoystickGetDeviceInstanceID(index);
  known_ = true;
  note_others();
  if (SDL_IsGameController(index) == SDL_TRUE) {
    pad_.reset(SDL_GameControllerOpen(index), [](SDL_GameController* pad) {
      if (pad != nullptr) SDL_GameControllerClose(pad);
    });
  }
  const std::lock_guard<std::mutex> guard(mutex_);
  handle_ = handle;
}

void SdlStick::close() {
  pad_.reset();
  claim_.release();
  Handle last;  // closed without mutex_: SDL takes a lock of its own for it
  const std::lock_guard<std::mutex> guard(mutex_);
  last.swap(handle_);
}

SdlStick::Handle SdlStick::handle() const {
  const std::lock_guard<std::mutex> guard(mutex_);
  return handle_;
}

std::string list_sdl() {
  const ListLock lock;
  std::string list;
  const int count = SDL_NumJoysticks();
  for (int i = 0; i < count; ++i) {  // Bound: the sticks that SDL sees
    if (i > 0) list += ", ";
    list += std::to_string(i) + " (" + name_at(i) + ")";
  }
  return list;
}

}  // namespace batuta::host
