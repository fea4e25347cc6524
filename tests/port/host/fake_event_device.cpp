// SPDX-License-Identifier: MIT

#include "fake_event_device.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <utility>

namespace batuta::test {
namespace {

struct Registry {
  std::mutex mutex;
  std::map<std::string, FakeEventDevice*> by_path;
  std::map<int, FakeEventDevice*> by_file;
  unsigned last_number = 0;
};

Registry& registry() {
  static Registry registry;
  return registry;
}

FakeEventDevice* device_at(const char* path) {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  const auto found = registry().by_path.find(path);
  return found == registry().by_path.end() ? nullptr : found->second;
}

FakeEventDevice* device_of(int file) {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  const auto found = registry().by_file.find(file);
  return found == registry().by_file.end() ? nullptr : found->second;
}

/// @returns whose it was
FakeEventDevice* forget(int file) {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  const auto found = registry().by_file.find(file);
  if (found == registry().by_file.end()) return nullptr;
  FakeEventDevice* const device = found->second;
  registry().by_file.erase(found);
  return device;
}

int fail(int error) {
  errno = error;
  return -1;
}

int copy(void* to, std::size_t size, const void* from, std::size_t count) {
  std::memset(to, 0, size);
  std::memcpy(to, from, std::min(size, count));
  return static_cast<int>(std::min(size, count));
}

}  // namespace

FakeEventDevice::FakeEventDevice(std::string path) : paths_{std::move(path)} {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  registry().by_path[paths_[0]] = this;
  number_ = ++registry().last_number;
}

FakeEventDevice::~FakeEventDevice() {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  for (const std::string& path : paths_) registry().by_path.erase(path);
  for (const auto& [file, end] : files_) {
    registry().by_file.erase(file);
    (void)::syscall(SYS_close, end);
  }
}

FakeEventDevice& FakeEventDevice::name(const std::string& name) {
  name_ = name;
  return *this;
}

FakeEventDevice& FakeEventDevice::has(unsigned type, unsigned code) {
  codes_[type].insert(code);
  return *this;
}

FakeEventDevice& FakeEventDevice::axis(unsigned code, const input_absinfo& info) {
  axes_[code] = info;
  return has(EV_ABS, code);
}

FakeEventDevice& FakeEventDevice::room_for_effects(int count, int really) {
  room_ = count;
  real_room_ = really;
  return *this;
}

FakeEventDevice& FakeEventDevice::also_at(const std::string& path) {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  registry().by_path[path] = this;
  paths_.push_back(path);
  return *this;
}

void FakeEventDevice::give_name_to(FakeEventDevice& other) {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  for (const std::string& path : paths_) {
    registry().by_path[path] = &other;
    other.paths_.push_back(path);
  }
  paths_.clear();
}

void FakeEventDevice::change(unsigned type, unsigned code, int value) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (type == EV_ABS) axes_[code].value = value;
  if (type == EV_KEY && value != 0) keys_.insert(code);
  if (type == EV_KEY && value == 0) keys_.erase(code);
}

void FakeEventDevice::event(unsigned type, unsigned code, int value, std::uint64_t time_us) {
  change(type, code, value);
  input_event event{};
  event.input_event_sec = static_cast<decltype(event.input_event_sec)>(time_us / 1000000);
  event.input_event_usec = static_cast<decltype(event.input_event_usec)>(time_us % 1000000);
  event.type = static_cast<std::uint16_t>(type);
  event.code = static_cast<std::uint16_t>(code);
  event.value = value;
  bytes(&event, sizeof event);
}

void FakeEventDevice::bytes(const void* data, std::size_t count) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [file, end] : files_) {
    if (::send(end, data, count, MSG_NOSIGNAL | MSG_DONTWAIT) < 0) continue;  // its queue is full
  }
}

void FakeEventDevice::unplug() {
  const std::lock_guard<std::mutex> lock(mutex_);
  there_ = false;
  effects_.clear();
  playing_.clear();
}

void FakeEventDevice::plug_in() {
  const std::lock_guard<std::mutex> lock(mutex_);
  there_ = true;
  const std::lock_guard<std::mutex> all(registry().mutex);
  for (const auto& [file, end] : files_) {  // the files of before stay dead
    registry().by_file.erase(file);
    (void)::syscall(SYS_close, end);
  }
  files_.clear();
}

void FakeEventDevice::refuse(int error) {
  const std::lock_guard<std::mutex> lock(mutex_);
  refusal_ = error;
}

void FakeEventDevice::refuse_writing(int error) {
  const std::lock_guard<std::mutex> lock(mutex_);
  writing_refusal_ = error;
}

void FakeEventDevice::refuse_clock() {
  const std::lock_guard<std::mutex> lock(mutex_);
  has_clocks_ = false;
}

int FakeEventDevice::open_file(int flags) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (refusal_ != 0) return fail(refusal_);
  if (!there_) return fail(ENOENT);
  if (writing_refusal_ != 0 && (flags & O_ACCMODE) != O_RDONLY) return fail(writing_refusal_);
  ++openings_;
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends.data()) != 0) return -1;
  const std::lock_guard<std::mutex> all(registry().mutex);
  files_[ends[0]] = ends[1];
  registry().by_file[ends[0]] = this;
  return ends[0];
}

long FakeEventDevice::read_file(int file, void* data, std::size_t count) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!there_) return fail(ENODEV);
  return ::syscall(SYS_read, file, data, count);
}

int FakeEventDevice::bits(unsigned type, void* data, std::size_t size) const {
  std::array<unsigned char, KEY_CNT / 8> map{};
  const auto set = [&](unsigned bit) {
    map[bit / 8] = static_cast<unsigned char>(map[bit / 8] | 1U << bit % 8);
  };
  if (type == 0) set(EV_SYN);
  for (const auto& [known, codes] : codes_) {
    if (type == 0) set(known);
    if (type == known) std::for_each(codes.begin(), codes.end(), set);
  }
  return copy(data, size, map.data(), map.size());
}

int FakeEventDevice::upload(ff_effect& effect) {
  for (const unsigned type : {0U, unsigned{effect.type}}) {
    if (effect_refusals_[type] != 0) return fail(effect_refusals_[type]);
  }
  if (effect.id < 0) {
    if (static_cast<int>(effects_.size()) >= std::min(room_, real_room_)) return fail(ENOSPC);
    effect.id = static_cast<std::int16_t>(effects_.empty() ? 0 : effects_.rbegin()->first + 1);
  } else if (effects_.count(effect.id) == 0) {
    return fail(EINVAL);
  }
  effects_[effect.id] = effect;
  strongest_[effect.type] = std::max(strongest_[effect.type], strength(effect));
  ++uploads_;
  return 0;
}

int FakeEventDevice::control(int file, unsigned long request, void* argument) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!there_) return fail(ENODEV);
  const unsigned number = _IOC_NR(request);
  const std::size_t size = _IOC_SIZE(request);
  constexpr unsigned kBits = 0x20;
  constexpr unsigned kAxes = 0x40;
  if (request == EVIOCSCLOCKID && !has_clocks_) return fail(EINVAL);
  if (request == EVIOCSFF) return upload(*static_cast<ff_effect*>(argument));
  if (request == EVIOCGEFFECTS) return copy(argument, sizeof(int), &room_, sizeof room_) - 4;
  if (request == EVIOCRMFF) {
    drain_writes(file);
    const auto id = static_cast<int>(reinterpret_cast<std::intptr_t>(argument));
    playing_.erase(id);
    const auto found = effects_.find(id);
    if (found == effects_.end()) return fail(EINVAL);
    removed_.push_back(found->second);
    effects_.erase(found);
    return 0;
  }
  if (number == _IOC_NR(EVIOCGNAME(0))) {
    return copy(argument, size, name_.c_str(), name_.size() + 1);
  }
  if (number == _IOC_NR(EVIOCGKEY(0))) {
    std::array<unsigned char, KEY_CNT / 8> map{};
    for (const unsigned key : keys_) {
      map[key / 8] = static_cast<unsigned char>(map[key / 8] | 1U << key % 8);
    }
    return copy(argument, size, map.data(), map.size());
  }
  if (number >= kAxes && number < kAxes + ABS_CNT) {
    return copy(argument, size, &axes_[number - kAxes], sizeof(input_absinfo)), 0;
  }
  if (number >= kBits && number < kBits + EV_CNT) return bits(number - kBits, argument, size);
  if (_IOC_DIR(request) == _IOC_READ) std::memset(argument, 0, size);
  return 0;  // the driver's version, the clock, and the like
}

int FakeEventDevice::openings() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return openings_;
}

int FakeEventDevice::open_files() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return static_cast<int>(files_.size());
}

void FakeEventDevice::close_file(int file) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = files_.find(file);
  if (found == files_.end()) return;
  drain_writes(file);
  (void)::syscall(SYS_close, found->second);
  files_.erase(found);
}

}  // namespace batuta::test

// The linker takes these instead of the C library's, for every library of the program.
extern "C" {

int open(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  batuta::test::FakeEventDevice* const device = batuta::test::device_at(path);
  if (device != nullptr) return device->open_file(flags);
  return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}

int fstat(int file, struct stat* about) noexcept {
  const int answer = ::fstatat(file, "", about, AT_EMPTY_PATH);
  const batuta::test::FakeEventDevice* const device = batuta::test::device_of(file);
  if (answer == 0 && device != nullptr) {
    constexpr unsigned kInputDevices = 13;
    about->st_mode = S_IFCHR | 0660U;
    about->st_rdev = makedev(kInputDevices, device->number());
  }
  return answer;
}

int close(int file) {
  batuta::test::FakeEventDevice* const device = batuta::test::forget(file);
  if (device != nullptr) device->close_file(file);
  return static_cast<int>(::syscall(SYS_close, file));
}

ssize_t read(int file, void* data, std::size_t count) {
  batuta::test::FakeEventDevice* const device = batuta::test::device_of(file);
  if (device != nullptr) return device->read_file(file, data, count);
  return ::syscall(SYS_read, file, data, count);
}

int ioctl(int file, unsigned long request, ...) noexcept {
  std::va_list rest;
  va_start(rest, request);
  void* const argument = va_arg(rest, void*);
  va_end(rest);
  batuta::test::FakeEventDevice* const device = batuta::test::device_of(file);
  if (device != nullptr) return device->control(file, request, argument);
  return static_cast<int>(::syscall(SYS_ioctl, file, request, argument));
}
}
