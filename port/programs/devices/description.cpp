// SPDX-License-Identifier: MIT

#include "programs/devices/description.hpp"

#include <evemu.h>

#include <cstdio>
#include <memory>
#include <utility>

namespace batuta::host {

std::optional<Description> Description::parse(const std::string& text) {
  std::string copy = text;  // fmemopen wants it writable
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
      copy.empty() ? nullptr : fmemopen(copy.data(), copy.size(), "r"), &std::fclose);
  if (file == nullptr) return std::nullopt;
  Description description;
  description.device_ = evemu_new(nullptr);
  int read = 0;
  if (description.device_ != nullptr) read = evemu_read(description.device_, file.get());
  if (read <= 0) return std::nullopt;
  return description;
}

Description::Description(Description&& other) noexcept
    : device_(std::exchange(other.device_, nullptr)) {}

Description& Description::operator=(Description&& other) noexcept {
  std::swap(device_, other.device_);
  return *this;
}

Description::~Description() {
  if (device_ != nullptr) evemu_delete(device_);
}

std::string Description::name() const {
  const char* name = evemu_get_name(device_);
  return name == nullptr ? "" : name;
}

std::optional<AxisRange> Description::range(int code) const {
  if (evemu_has_event(device_, EV_ABS, code) == 0) return std::nullopt;
  AxisRange range;
  range.min = evemu_get_abs_minimum(device_, code);
  range.max = evemu_get_abs_maximum(device_, code);
  range.flat = evemu_get_abs_flat(device_, code);
  if (range.min >= range.max) return std::nullopt;
  return range;
}

}  // namespace batuta::host
