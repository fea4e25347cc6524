// SPDX-License-Identifier: MIT
#pragma once
// A recorded device in the evemu format, turned into samples: all of it before the first one is
// used.

#include <string>
#include <string_view>
#include <vector>

#include "batuta/port/input.hpp"

namespace batuta::host {

struct Recording {
  std::vector<InputSample> samples;  ///< time 0: the first event; never empty
  std::string device;                ///< its name, as far as known
  double duration = 0;               ///< first to last event, s
  std::uint32_t losses = 0;          ///< times that the device had lost events
  std::string note;                  ///< what had to be guessed; one line, or empty
};

struct LoadedRecording {
  Recording recording;
  std::string error;  ///< one line; empty: the recording may be used
};

/// Reads a file and, where the file holds no device description, the one beside it (.desc, .device
/// or .prop): a plain file of at most 1 MiB. One that is there and cannot be read is an error.
LoadedRecording load_recording(const std::string& path);

/// The file, and those beside it that may describe its device, whether they exist or not.
std::vector<std::string> files_of_recording(const std::string& path);

/// The same from memory.
/// @param name         for messages: "<name>:<line>: ..."
/// @param description  used if the text holds none; may be empty
LoadedRecording parse_recording(std::string_view text, const std::string& name,
                                const std::string& description);

}  // namespace batuta::host
