// SPDX-License-Identifier: MIT
// batuta-answer: answers query files, so that anyone can hold the library against their own truth.
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "answer_file.hpp"
#include "command_line.hpp"
#include "programs/files/output_file.hpp"

namespace {

using namespace batuta::answer;
namespace host = batuta::host;

constexpr const char* kStandardStream = "-";

QueryKind kind_of(Kind kind) {
  if (kind == Kind::kTimeOfContact) return time_of_contact_kind();
  return kind == Kind::kDistance ? distance_kind() : impulse_kind();
}

int fail(const std::string& what) {
  std::cerr << "batuta-answer: " << what << '\n';
  return kExitUsage;
}

std::string last_system_error() {
  return errno == 0 ? std::string("failed") : std::string(std::strerror(errno));
}

int run(const Command& command) {
  std::ifstream in_file;
  errno = 0;
  if (command.in != kStandardStream) in_file.open(command.in, std::ios::binary);
  if (!in_file) return fail("cannot read " + command.in + ": " + last_system_error());
  if (command.in != kStandardStream && std::filesystem::is_directory(command.in)) {
    return fail("cannot read " + command.in + ": it is a directory");
  }
  batuta::host::QueryFile queries(command.in == kStandardStream ? std::cin : in_file);
  if (!queries.ok()) return fail(command.in + ": " + queries.error());

  const QueryKind kind = kind_of(command.kind);
  const std::string missing = kind.missing_column(queries);
  if (!missing.empty()) return fail(command.in + ": header: there is no column " + missing);

  const bool to_file = command.out != kStandardStream;
  if (to_file && command.in != kStandardStream) {
    const std::string clash = host::clash_of({{"--in", command.in}}, {{"--out", command.out}});
    if (!clash.empty()) return fail(clash);
  }
  host::OutputFile out_file;
  std::string problem = to_file ? out_file.open(command.out) : "";
  if (!problem.empty()) return fail("cannot write " + command.out + ": " + problem);
  std::ostream& out = to_file ? out_file.stream() : std::cout;

  const RowAnswer answer = command.in_float ? kind.in_float : kind.in_double;
  const long invalid = answer_file(queries, kind.columns, answer, command.search, out, std::cerr);
  errno = 0;
  out.flush();
  if (to_file) {
    problem = out_file.commit();
  } else if (!out) {
    problem = last_system_error();
  }
  if (!problem.empty()) return fail("cannot write " + command.out + ": " + problem);
  return invalid == 0 ? 0 : kExitInvalidLines;
}

}  // namespace

int main(int argc, char** argv) {
  const auto asked = read_command_line(argc, argv);
  if (const auto* exit = std::get_if<Exit>(&asked)) return exit->status;
  return run(std::get<Command>(asked));
}
