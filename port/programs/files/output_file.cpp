// SPDX-License-Identifier: MIT

#include "programs/files/output_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "programs/files/unfinished_files.hpp"

#ifdef _WIN32
#include <process.h>
#else
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace batuta::host {
namespace {

using std::filesystem::path;

std::string system_words() {
  return errno != 0 ? std::strerror(errno) : "failed";
}

/// Tells the files of two programs that run at once apart.
std::string process_number() {
#ifdef _WIN32
  return std::to_string(_getpid());
#else
  return std::to_string(getpid());
#endif
}

constexpr int kMostLinks = 40;  // as Linux follows

/// A link to what is not there yet, or round and round.
bool is_dangling(const path& place) {
  std::error_code error;
  return std::filesystem::is_symlink(std::filesystem::symlink_status(place, error)) &&
         !std::filesystem::exists(place, error);
}

/// Links followed, also one to what is not there yet; a link remains of those that go round. What
/// /dev/stdout leads to may have no name: a link to something that is there is left to the system.
path resolved(const std::string& text) {
  std::error_code error;
  path place = text;
  for (int i = 0; i < kMostLinks && is_dangling(place); ++i) {  // Bound: kMostLinks
    place = place.parent_path() / std::filesystem::read_symlink(place, error);
  }
  path found = std::filesystem::weakly_canonical(place, error);
  if (error) return place;
  return found.is_absolute() ? found : std::filesystem::absolute(found, error);
}

#ifndef _WIN32

constexpr mode_t kPermissions = S_IRWXU | S_IRWXG | S_IRWXO;

/// A file has the owner, the group and the permissions of the one whose place it takes; where the
/// group cannot be kept, no other group may do anything with it. Of a new one the system has said
/// who may do what. @returns whether that could be done
bool keep_owners(int file, const path& place) {
  struct stat there = {};
  if (stat(place.c_str(), &there) != 0) return true;
  mode_t permissions = there.st_mode & kPermissions;
  const bool is_all_kept = fchown(file, there.st_uid, there.st_gid) == 0;
  if (!is_all_kept && fchown(file, static_cast<uid_t>(-1), there.st_gid) != 0)
    permissions &= ~static_cast<mode_t>(S_IRWXG);
  return fchmod(file, permissions) == 0;
}

/// A new file, and none that is there already, whoever has put it there. Where it is to take the
/// place of another one, nobody else may read it yet.
/// @returns what it is known by; < 0: it cannot be made, and errno says why
int make_beside(const std::string& beside, const path& place) {
  struct stat there = {};
  const bool is_new = stat(place.c_str(), &there) != 0;
  const mode_t mode = S_IRUSR | S_IWUSR;
  const mode_t for_all = mode | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH;  // less the user's mask
  return ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                is_new ? for_all : mode);
}

void close_number(int file) {
  if (file >= 0) (void)close(file);
}

/// @returns make_beside(); the file is removed when a signal ends the program. It is noted before
/// it is there: a signal comes on any thread, and holding them back on this one holds none back.
int make_watched(const std::string& beside, const path& place) {
  remove_when_ended(beside);
  const int file = make_beside(beside, place);
  if (file < 0) keep_when_ended(beside);
  return file;
}

/// Another name of a file that is open: a name in a folder may be somebody else's link by now.
/// Where the system has none (no /proc), the name that it was made by.
std::string name_of_open(int file, const std::string& made_as) {
  std::string name = "/dev/fd/" + std::to_string(file);
  return access(name.c_str(), W_OK) == 0 ? name : made_as;
}

#else

std::string name_of_open(int /*file*/, const std::string& made_as) {
  return made_as;
}

int make_watched(const std::string& /*beside*/, const path& /*place*/) {
  return 0;
}
bool keep_owners(int /*file*/, const path& /*place*/) {
  return true;
}
void close_number(int /*file*/) {}

#endif

/// Something that is there and is no plain file: a pipe, a terminal, /dev/full, a folder.
bool is_special(const path& place) {
  std::error_code error;
  const auto status = std::filesystem::status(place, error);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

/// Whether a stream that the shell has opened is this file. Not told on Windows.
bool is_stream([[maybe_unused]] int stream, [[maybe_unused]] const std::string& path) {
#ifdef _WIN32
  return false;
#else
  struct stat opened = {};
  struct stat named = {};
  return fstat(stream, &opened) == 0 && S_ISREG(opened.st_mode) &&
         stat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
#endif
}

constexpr int kStandardInput = 0;
constexpr int kStandardOutput = 1;
constexpr int kStandardError = 2;

/// Whether the shell sends what is printed to this file.
bool is_printed_to(const std::string& path) {
  return is_stream(kStandardOutput, path) || is_stream(kStandardError, path);
}

}  // namespace

std::string OutputFile::open(const std::string& path) {
  discard();
  const std::filesystem::path place = resolved(path);
  if (is_dangling(place))
    return std::make_error_code(std::errc::too_many_symbolic_link_levels).message();
  place_ = place.string();
  if (is_special(place)) return open_stream(place_);
  if (is_printed_to(path)) return "it is what is printed to";
  const std::string beside = place_ + "." + process_number() + ".part";
  errno = 0;
  const int file = make_watched(beside, place);
  if (file < 0) return system_words();
  beside_ = beside;
  std::string problem = open_stream(name_of_open(file, beside_));
  if (problem.empty() && !keep_owners(file, place)) problem = system_words();
  close_number(file);
  if (!problem.empty()) discard();
  return problem;
}

/// @returns an empty text | why it cannot be written, in the system's words
std::string OutputFile::open_stream(const std::string& path) {
  errno = 0;
  file_ = std::ofstream(path, std::ios::binary | std::ios::trunc);
  return file_ ? "" : system_words();
}

std::string OutputFile::commit() {
  if (!file_.is_open()) return "it is not open";
  errno = 0;
  file_.close();  // fails where something could not be written, now or before
  std::string problem = file_ ? "" : system_words();
  if (problem.empty() && !beside_.empty()) {
    std::error_code error;
    std::filesystem::rename(beside_, place_, error);  // on Windows, too, over what is there
    if (error) problem = error.message();
  }
  if (problem.empty()) forget_beside();
  discard();
  return problem;
}

void OutputFile::forget_beside() {
  if (!beside_.empty()) keep_when_ended(beside_);
  beside_.clear();
}

void OutputFile::discard() {
  if (file_.is_open()) file_.close();
  file_.clear();
  if (!beside_.empty()) (void)std::remove(beside_.c_str());
  forget_beside();
}

bool are_same_file(const std::string& one, const std::string& other) {
  std::error_code error;
  const bool linked = std::filesystem::equivalent(one, other, error);
  return (!error && linked) || resolved(one) == resolved(other);
}

namespace {

/// @param before  how many of the outputs were looked at before this one
std::string clash_of(const NamedFile& out, const std::vector<NamedFile>& inputs,
                     const std::vector<NamedFile>& outputs, std::size_t before) {
  if (is_special(out.path)) return {};
  if (is_printed_to(out.path))
    return out.option + ": " + out.path + " is what is printed to: one would replace the other";
  for (const NamedFile& in : inputs) {  // Bound: inputs
    if (are_same_file(out.path, in.path))
      return out.option + ": " + out.path + " is read by " + in.option + ": it would be lost";
  }
  for (std::size_t j = 0; j < before; ++j) {  // Bound: outputs
    if (are_same_file(out.path, outputs[j].path))
      return out.option + ": " + out.path + " is what " + outputs[j].option + " writes";
  }
  return {};
}

/// Where what is complained goes to one of these files, nothing is from now on.
void keep_out_of(const std::vector<NamedFile>& inputs) {
  const bool is_told_there = std::any_of(inputs.begin(), inputs.end(), [](const NamedFile& in) {
    return is_stream(kStandardError, in.path);
  });
  // NOLINTNEXTLINE(cppcoreguidelines-owning-memory) deviation: standard-error
  if (is_told_there) (void)std::freopen("/dev/null", "w", stderr);
}

}  // namespace

bool is_standard_input(const std::string& path) {
  return is_stream(kStandardInput, path);
}

std::string clash_of(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  const auto read = std::find_if(inputs.begin(), inputs.end(),
                                 [](const NamedFile& in) { return is_printed_to(in.path); });
  if (read != inputs.end()) {
    keep_out_of(inputs);
    return "what is printed goes to what " + read->option +
           " reads: it would be lost, or have no end";
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {  // Bound: outputs
    std::string clash = clash_of(outputs[i], inputs, outputs, i);
    if (!clash.empty()) return clash;
  }
  return {};
}

}  // namespace batuta::host
