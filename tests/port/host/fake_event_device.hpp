// SPDX-License-Identifier: MIT
#pragma once
// A kernel with event devices that are not there: open(), close(), read() and ioctl() of this
// program are asked first, by libevdev's code as by ours. What belongs to no fake goes on to the
// real ones.

#include <linux/input.h>

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace batuta::test {

/// One device, there for as long as this lives. Files that were opened share its state, each with
/// its own queue of events, as the kernel has it.
class FakeEventDevice {
 public:
  explicit FakeEventDevice(std::string path);
  FakeEventDevice(const FakeEventDevice&) = delete;
  FakeEventDevice& operator=(const FakeEventDevice&) = delete;
  ~FakeEventDevice();

  // What it is, before anything opens it.
  FakeEventDevice& name(const std::string& name);
  FakeEventDevice& has(unsigned type, unsigned code);
  FakeEventDevice& axis(unsigned code, const input_absinfo& info);
  FakeEventDevice& room_for_effects(int count);

  /// An event, seen by all open files. Absolute axes and keys remember it.
  void event(unsigned type, unsigned code, int value, std::uint64_t time_us = 1);
  void sync(std::uint64_t time_us = 1) { event(EV_SYN, SYN_REPORT, 0, time_us); }
  /// The state changes, and nobody is told: what a lost event does.
  void change(unsigned type, unsigned code, int value);
  /// Something that is no whole event.
  void bytes(const void* data, std::size_t count);

  void unplug();
  void plug_in();
  /// Opening fails with this; 0: it does not.
  void refuse(int error);
  /// Uploading an effect fails with this; 0: it does not.
  void refuse_effects(int error);

  // What was done to it.
  std::vector<ff_effect> effects();
  bool is_playing(int effect);
  /// Of FF_GAIN and the like; -1: not set.
  int property(unsigned code);
  int uploads();
  int open_files();

  // For the calls of the kernel.
  int open_file();
  void close_file(int file);
  long read_file(int file, void* data, std::size_t count);
  int control(int file, unsigned long request, void* argument);
  const std::string& path() const { return path_; }

 private:
  int bits(unsigned type, void* data, std::size_t size) const;
  int upload(ff_effect& effect);
  void drain_writes(int file);

  std::mutex mutex_;
  std::string path_;
  std::string name_ = "fake";
  std::map<unsigned, std::set<unsigned>> codes_;
  std::map<unsigned, input_absinfo> axes_;
  std::set<unsigned> keys_;
  std::map<int, int> files_;  ///< the program's end -> this end
  bool there_ = true;
  int refusal_ = 0;
  int effect_refusal_ = 0;
  int room_ = 0;
  int uploads_ = 0;
  std::map<int, ff_effect> effects_;
  std::set<int> playing_;
  std::map<unsigned, int> properties_;
};

}  // namespace batuta::test
