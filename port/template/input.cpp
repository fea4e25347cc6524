// SPDX-License-Identifier: MIT
#include "template/input.hpp"

namespace batuta::port_template {

// Must: hand out the latest complete sample that is not newer than `now`, once; a sample is
// complete where the device has told all its axes (the sync mark). Scale the axes to -1 ... 1,
// right and up positive, with the range the device states. Stamp the sample with the time at which
// the device was read, not the time of this call. Count every sample in `sequence`, also those that
// nobody asked for: a gap tells the reader how many it missed. Must not: wait for the device, or
// hand out half a sample where an interrupt writes while this reads (two buffers and an atomic
// index are enough for one writer and one reader). Returns kOk with a sample; kUnavailable, with
// `sample` as it was, where there is none or the device is gone. InputDevice::read() checks the
// range of what comes out of here.
Status TemplateInput::do_read(Microseconds /*now*/, InputSample& /*sample*/) {
  return Status::kUnavailable;
}

}  // namespace batuta::port_template
