// SPDX-License-Identifier: MIT

#include "programs/live/claim.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <mutex>
#include <vector>

namespace batuta::host {
namespace {

/// Those that the fencers of this program have.
class Register {
 public:
  bool add(DeviceNumber device) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool free = std::find(taken_.begin(), taken_.end(), device) == taken_.end();
    if (free) taken_.push_back(device);
    return free;
  }
  void remove(DeviceNumber device) {
    const std::lock_guard<std::mutex> lock(mutex_);
    taken_.erase(std::remove(taken_.begin(), taken_.end(), device), taken_.end());
  }

 private:
  std::mutex mutex_;
  std::vector<DeviceNumber> taken_;
};

Register& all() {
  static Register all;
  return all;
}

DeviceNumber number_of(const struct stat& about) {
  return S_ISCHR(about.st_mode) ? static_cast<DeviceNumber>(about.st_rdev) : kNoDevice;
}

}  // namespace

DeviceNumber number_of(int file) {
  struct stat about {};
  return ::fstat(file, &about) == 0 ? number_of(about) : kNoDevice;
}

DeviceNumber number_at(const std::string& path) {
  struct stat about {};
  return ::stat(path.c_str(), &about) == 0 ? number_of(about) : kNoDevice;
}

bool Claim::take(DeviceNumber device) {
  release();
  if (device == kNoDevice) return true;
  const bool free = all().add(device);
  if (free) device_ = device;
  return free;
}

void Claim::release() {
  const DeviceNumber device = device_.exchange(kNoDevice);
  if (device != kNoDevice) all().remove(device);
}

}  // namespace batuta::host
