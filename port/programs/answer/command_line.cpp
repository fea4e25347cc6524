// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <map>

#include "batuta/detection/advancement.hpp"

namespace batuta::answer {

namespace {

std::string require_positive(const std::string& text) {
  const std::optional<double> number = host::double_of_decimal(text);
  const bool good = number && *number > 0 && std::isfinite(*number);
  return good ? std::string() : text + " is not a number above 0";
}

std::string one_line(const CLI::App* app, const CLI::Error& error) {
  return app->get_name() + ": " + error.what() + " (--help shows the usage)\n";
}

constexpr const char* kNumbers = R"(Numbers of queries are float32:
  0x3f8      its bits, big-endian, trailing zero digits left out: 1
  3f8        the same, in lines whose numbers all are bits
  1.0 -3 1e-3 inf   decimal: with a point or a sign in it
A line is invalid where a number may be meant either way.
Answers are decimal, with 17 digits.)";

const std::map<std::string, Method> kMethods = {{"advancement", Method::kAdvancement},
                                                {"translation", Method::kTranslation},
                                                {"stepping", Method::kStepping}};

/// The columns of queries and of answers, in lines of a terminal's width.
std::string columns_text(const QueryKind& kind) {
  constexpr std::size_t kWidth = 80;
  std::string text = "Columns of queries, in any order, with any others beside them:";
  std::size_t room = 0;
  for (const std::string& column : kind.needed_columns()) {  // Bound: columns of a query
    text += column.size() + 1 > room ? "\n  " : " ";
    if (column.size() + 1 > room) room = kWidth - 2;
    text += column;
    room -= column.size() + 1;
  }
  return text + "\nColumns of answers:\n  " + kind.columns + "\n\n" + kNumbers;
}

constexpr const char* kFooter = R"(Methods of toc:
  advancement  misses no contact (default)
  translation  misses none; a capsule that turns makes its line invalid
  stepping     the paper's; passes over touches that are shallower than its tolerance)";

/// Every kind takes the same options, so that one script can ask all of them.
void add_options(CLI::App& app, Command& command, std::string& scalar, std::string& method,
                 const QueryKind& kind) {
  app.add_option("--in", command.in, "query file (CSV); - reads standard input")->required();
  app.add_option("--out", command.out, "answer file (CSV); - writes standard output")->required();
  app.add_option("--scalar", scalar, "precision of the library")
      ->check(CLI::IsMember({"float", "double"}))
      ->capture_default_str();
  app.add_option("--method", method, "search for the time of contact (toc)")
      ->check(CLI::IsMember(kMethods))
      ->capture_default_str();
  app.add_option("--budget", command.search.budget,
                 "most distance evaluations of a search (toc), 1 ... 4096 (default); with stepping "
                 "most steps, default 100000000. Where they do not suffice the answer is BUDGET")
      ->check(CLI::Range(std::uint32_t{1}, std::numeric_limits<std::uint32_t>::max()));
  app.add_option("--tolerance", command.search.tolerance,
                 "gap that counts as contact (toc), over the query's length S, at most 1, default "
                 "1e-6; with stepping the deepest touch that may be missed, over the thinner "
                 "radius, default 0.5")
      ->check(require_positive, "NUMBER > 0");
  app.footer(columns_text(kind) + "\n\n" + kFooter);
}
static_assert(kMaxBudget == 4096 && kAmpleSteps == 100'000'000, "the help says so");

constexpr const char* kKinds = "A kind of query (toc, distance or impulse)";

/// What is wrong with options that are right one by one; empty: nothing.
std::string conflict_in(const SearchSettings& search) {
  if (search.method == Method::kStepping) return {};
  if (search.budget.value_or(1) > kMaxBudget) return "--budget: at most 4096 but for stepping";
  if (search.tolerance.value_or(1) > 1) return "--tolerance: at most 1 but for stepping";
  return {};
}

}  // namespace

QueryKind kind_of(Kind kind) {
  if (kind == Kind::kTimeOfContact) return time_of_contact_kind();
  return kind == Kind::kDistance ? distance_kind() : impulse_kind();
}

std::variant<Command, Exit> read_command_line(int argc, char** argv) {
  Command command;
  std::string scalar = "double";
  std::string method = "advancement";
  CLI::App app(
      "Answers query files: when moving capsules touch, how far segments are apart, what a "
      "collision does.\nExit status: 0; 1 if a line was invalid, or the output cannot be written; "
      "2 on wrong usage, or for a file that cannot be read.",
      "batuta-answer");
  app.failure_message(one_line);
  app.allow_windows_style_options(false);  // a word that begins with / is a path
  app.require_subcommand(0, 1);            // one, of which too_few() can say more
  CLI::App* toc = app.add_subcommand("toc", "time of contact of two moving capsules");
  CLI::App* distance = app.add_subcommand("distance", "distance of two segments");
  CLI::App* impulse = app.add_subcommand("impulse", "collision of two bodies without friction");
  add_options(*toc, command, scalar, method, kind_of(Kind::kTimeOfContact));
  add_options(*distance, command, scalar, method, kind_of(Kind::kDistance));
  add_options(*impulse, command, scalar, method, kind_of(Kind::kImpulse));
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) throw CLI::RequiredError(kKinds);
  } catch (const CLI::ParseError& error) {
    return Exit{app.exit(error) == 0 ? 0 : kExitUsage};
  }
  command.kind = toc->parsed()        ? Kind::kTimeOfContact
                 : distance->parsed() ? Kind::kDistance
                                      : Kind::kImpulse;
  command.in_float = scalar == "float";
  command.search.method = kMethods.at(method);
  const std::string conflict = conflict_in(command.search);
  if (conflict.empty()) return command;
  std::cerr << one_line(&app, CLI::ValidationError(conflict));
  return Exit{kExitUsage};
}

}  // namespace batuta::answer
