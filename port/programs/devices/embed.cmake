# SPDX-License-Identifier: MIT
# cmake -DINPUT=<file> -DOUTPUT=<file.cpp> -P embed.cmake: the file's bytes as a constant of the program.
file(READ ${INPUT} bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
string(REPLACE "'\\x0a'," "'\\n',\n" bytes "${bytes}")
file(WRITE ${OUTPUT} "// Generated from a file of port/programs/recordings; do not edit.
#include \"programs/devices/default_recording.hpp\"

namespace batuta::host {
namespace {
constexpr char kBytes[] = {
${bytes}};
}  // namespace

const std::string_view kDefaultRecording{kBytes, sizeof kBytes};
}  // namespace batuta::host
")
