// SPDX-License-Identifier: MIT
#pragma once
// What a program prints may be lost: on a full device, or in a pipe that nobody reads. That is
// told, and is no success.

namespace batuta::host {

/// Exit code of a program whose output is lost.
inline constexpr int kExitOutputLost = 1;

/// To be called first: makes a pipe that nobody reads, and a file beyond the size that the user may
/// write, a failed write, as a full device is, in place of a silent end of the program; and no file
/// gets what is printed, where the caller has closed standard output.
void begin_output();

/// Whether something that was printed is known to be lost: what goes on only in order to be printed
/// may end.
bool is_output_lost();

/// To be called last: prints what is still kept back.
/// @param program  its name, for the message
/// @returns `exit_code`, or kExitOutputLost where something that was printed is lost, which then
///   has been told on stderr
int finish_output(const char* program, int exit_code);

}  // namespace batuta::host
