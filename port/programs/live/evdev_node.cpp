// SPDX-License-Identifier: MIT

#include "programs/live/evdev_node.hpp"

#include <fcntl.h>
#include <libevdev/libevdev.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

namespace batuta::host {

std::string open_error_words(int error) {
  switch (error) {
    case ENOENT:
      return "no such device";
    case EACCES:
    case EPERM:
      return "no permission to open it (is the user in the group input?)";
    case ENODEV:
    case ENXIO:
      return "the device is gone";
    case ENOTTY:
    case EINVAL:
    case EISDIR:
      return "not an event device";
    default:
      return "cannot be opened: " + std::generic_category().message(error);
  }
}

EvdevNode::EvdevNode(EvdevNode&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
      device_(std::exchange(other.device_, nullptr)),
      has_clock_(other.has_clock_) {}

EvdevNode& EvdevNode::operator=(EvdevNode&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(device_, other.device_);
  std::swap(has_clock_, other.has_clock_);
  return *this;
}

std::string EvdevNode::open(const std::string& path) {
  close();
  file_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file_ < 0) return open_error_words(errno);
  const int failure = libevdev_new_from_fd(file_, &device_);
  if (failure < 0) {
    device_ = nullptr;
    close();
    return open_error_words(-failure);
  }
  // Old kernels refuse: their stamps are of another clock, and of no use here.
  has_clock_ = libevdev_set_clock_id(device_, CLOCK_MONOTONIC) == 0;
  return {};
}

void EvdevNode::close() {
  if (device_ != nullptr) libevdev_free(device_);
  if (file_ >= 0) ::close(file_);
  device_ = nullptr;
  file_ = -1;
}

std::string EvdevNode::name() const {
  const char* const name = is_open() ? libevdev_get_name(device_) : nullptr;
  return name == nullptr ? "" : name;
}

std::optional<MotionAxes> EvdevNode::axes() const {
  if (!is_open()) return std::nullopt;
  Abilities abilities;
  abilities.has = [this](std::uint16_t type, std::uint16_t code) {
    return libevdev_has_event_code(device_, type, code) == 1;
  };
  abilities.range = [this](std::uint16_t code) -> std::optional<AxisRange> {
    const input_absinfo* const axis = libevdev_get_abs_info(device_, code);
    if (axis == nullptr || axis->minimum >= axis->maximum) return std::nullopt;
    return AxisRange{axis->minimum, axis->maximum, axis->flat};
  };
  return find_motion_axes(abilities);
}

std::string list_evdev() {
  std::vector<std::string> paths;
  std::error_code error;
  const std::filesystem::directory_iterator end;
  std::filesystem::directory_iterator entry("/dev/input", error);
  for (; !error && entry != end; entry.increment(error)) {  // Bound: the files there
    const std::string path = entry->path().string();
    if (entry->path().filename().string().compare(0, 5, "event") == 0) paths.push_back(path);
  }
  std::sort(paths.begin(), paths.end());
  std::string list;
  for (const std::string& path : paths) {
    EvdevNode node;
    const bool readable = node.open(path).empty();
    if (readable && !node.axes()) continue;
    if (!list.empty()) list += ", ";
    list += path + " (" + (readable ? node.name() : "no permission") + ")";
  }
  return list;
}

}  // namespace batuta::host
