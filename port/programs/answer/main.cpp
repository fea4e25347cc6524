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
#include "programs/files/standard_output.hpp"

namespace {

using namespace batuta::answer;
namespace host = batuta::host;

constexpr const char* kStandardStream = "-";

int fail(const std::string& what, int exit_code = kExitUsage) {
  std::cerr << "batuta-answer: " << what << '\n';
  return exit_code;
}

std::string last_system_error() {
  return errno == 0 ? std::string("failed") : std::string(std::strerror(errno));
}

/// Where the answers go: a file, which is there when it is whole, or standard output.
class Answers {
 public:
  explicit Answers(const Command& command) : to_file_(command.out != kStandardStream) {}

  /// @returns an empty text | which file would be read and written
  std::string clash(const Command& command) const {
    std::vector<host::NamedFile> outputs;
    if (to_file_) outputs.push_back({"--out", command.out});
    return host::clash_of(inputs_of(command), outputs);
  }
  /// @returns an empty text | why they cannot be written there
  std::string open(const Command& command) {
    return to_file_ ? told(command, file_.open(command.out)) : "";
  }
  std::ostream& stream() { return to_file_ ? file_.stream() : std::cout; }
  /// @returns an empty text | why not all of them are in the file; main() looks after standard
  /// output
  std::string commit(const Command& command) {
    return to_file_ ? told(command, file_.commit()) : "";
  }

 private:
  static std::string told(const Command& command, const std::string& problem) {
    return problem.empty() ? "" : "cannot write " + command.out + ": " + problem;
  }
  /// What is read, where it has a name: standard input that of --out, if it is that file; or where
  /// systems have one for it.
  static std::vector<host::NamedFile> inputs_of(const Command& command) {
    if (command.in != kStandardStream) return {{"--in", command.in}};
    if (host::is_standard_input(command.out)) return {{"--in", command.out}};
    return {{"--in", "/dev/stdin"}};
  }

  bool to_file_;
  host::OutputFile file_;
};

int run(const Command& command) {
  if (command.out.empty()) return fail("--out: a name is missing");
  std::ifstream in_file;
  errno = 0;
  if (command.in != kStandardStream) in_file.open(command.in, std::ios::binary);
  if (!in_file) return fail("cannot read " + command.in + ": " + last_system_error());
  if (command.in != kStandardStream && std::filesystem::is_directory(command.in)) {
    return fail("cannot read " + command.in + ": it is a directory");
  }
  batuta::host::QueryFile queries(command.in == kStandardStream ? std::cin : in_file);
  const QueryKind kind = kind_of(command.kind);
  if (queries.is_broken()) return fail("cannot read " + command.in + ": " + last_system_error());
  queries.require(kind.needed_columns());
  if (!queries.ok()) return fail(command.in + ": " + queries.error());

  Answers answers(command);
  const std::string clash = answers.clash(command);
  if (!clash.empty()) return fail(clash);
  std::string problem = answers.open(command);
  if (!problem.empty()) return fail(problem, kExitIncomplete);
  const RowAnswer answer = command.in_float ? kind.in_float : kind.in_double;
  const long invalid =
      answer_file(queries, kind.columns, answer, command.search, answers.stream(), std::cerr);
  if (queries.is_broken())
    return fail("cannot read " + command.in + " to its end", kExitIncomplete);
  problem = answers.commit(command);
  if (!problem.empty()) return fail(problem, kExitIncomplete);
  return invalid == 0 ? 0 : kExitIncomplete;
}

int run_program(int argc, char** argv) {
  const auto asked = read_command_line(argc, argv);
  if (const auto* exit = std::get_if<Exit>(&asked)) return exit->status;
  return run(std::get<Command>(asked));
}

}  // namespace

int main(int argc, char** argv) {
  host::begin_output();
  return host::finish_output("batuta-answer", run_program(argc, argv));
}
