// SPDX-License-Identifier: MIT
#pragma once
// A kernel with event devices that are not there: open(), close(), read(), ioctl() and fstat() of
// this program are asked first, by libevdev's code as by ours. What belongs to no fake goes on to
// the real ones.

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
  /// @param really  of those that it says it has room for
  FakeEventDevice& room_for_effects(int count, int really = FF_MAX);
  /// Another name of the same device.
  FakeEventDevice& also_at(const std::string& path);

  /// An event, seen by all open files. Absolute axes and keys remember it.
  void event(unsigned type, unsigned code, int value, std::uint64_t time_us = 1);
  void sync(std::uint64_t time_us = 1) { event(EV_SYN, SYN_REPORT, 0, time_us); }
  /// The state changes, and nobody is told: what a lost event does.
  void change(unsigned type, unsigned code, int value);
  /// Something that is no whole event.
  void bytes(const void* data, std::size_t count);

  /// As a driver does that was reset.
  void forget_effects();
  void unplug();
  void plug_in();
  /// Opening fails with this; 0: it does not.
  void refuse(int error);
  /// Opening for writing fails with this; 0: it does not.
  void refuse_writing(int error);
  /// Uploading an effect fails with this; 0: it does not. @param type  of these effects alone
  void refuse_effects(int error, unsigned type = 0);
  /// The kernel is an old one: its stamps are of the time of day, whatever it is told.
  void refuse_clock();
  /// Another device gets its name; this one is not there any more under it.
  void give_name_to(FakeEventDevice& other);

  // What was done to it.
  std::vector<ff_effect> effects();
  bool is_playing(int effect);
  /// The device's time goes on; what was told before was told before.
  void pass(std::int32_t microseconds);
  /// Times that an effect was told to play.
  int plays();
  /// Of FF_GAIN and the like; -1: not set.
  int property(unsigned code);
  int uploads();
  /// As they were when they were taken back.
  std::vector<ff_effect> removed();
  /// Of all effects of a type that were ever uploaded.
  int strongest(unsigned type);
  /// Times that it was opened.
  int openings();
  int open_files();

  // For the calls of the kernel.
  int open_file(int flags);
  void close_file(int file);
  long read_file(int file, void* data, std::size_t count);
  int control(int file, unsigned long request, void* argument);
  unsigned number() const { return number_; }

 private:
  int bits(unsigned type, void* data, std::size_t size) const;
  int upload(ff_effect& effect);
  void drain_writes(int file);
  void play(int effect, int times);

  std::mutex mutex_;
  std::vector<std::string> paths_;
  unsigned number_;  ///< of the kernel's, minor
  std::string name_ = "fake";
  std::map<unsigned, std::set<unsigned>> codes_;
  std::map<unsigned, input_absinfo> axes_;
  std::set<unsigned> keys_;
  std::map<int, int> files_;  ///< the program's end -> this end
  bool there_ = true;
  int refusal_ = 0;
  int writing_refusal_ = 0;
  bool has_clocks_ = true;
  std::map<unsigned, int> effect_refusals_;
  int room_ = 0;
  int real_room_ = FF_MAX;
  int uploads_ = 0;
  std::vector<ff_effect> removed_;
  std::map<unsigned, int> strongest_;
  int openings_ = 0;
  std::map<int, ff_effect> effects_;
  std::map<int, std::int64_t> playing_;  ///< its end, us of the device's time
  std::int64_t time_us_ = 0;
  int plays_ = 0;
  std::map<unsigned, int> properties_;
};

/// Level or coefficient along the first axis, without its sign.
int strength(const ff_effect& effect);

}  // namespace batuta::test
