// SPDX-License-Identifier: MIT
#include "knobs.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "programs/files/output_file.hpp"

namespace fight {
namespace {

constexpr double kLengthStep = 0.02;  // m
constexpr double kAimStep = 0.05;     // of a direction whose x is 1
constexpr double kShareStep = 0.08;

void add_place(std::vector<Knob>& all, const std::string& name) {
  for (const char* axis : {".x", ".y", ".z"}) all.push_back({name + axis, kLengthStep});
}
void add_aim(std::vector<Knob>& all, const std::string& name) {
  for (const char* axis : {".y", ".z"}) all.push_back({name + axis, kAimStep});
}

std::vector<Knob> all_knobs() {
  std::vector<Knob> all;
  for (const char* pose : {"guard", "retreat", "quarte", "septime", "octave", "sixte"}) {
    add_place(all, std::string(pose) + ".hand");
    add_aim(all, std::string(pose) + ".aim");
  }
  for (const char* line : {"high_inside", "low_inside", "low_outside", "high_outside", "middle"}) {
    add_place(all, std::string(line) + ".hand");
    add_place(all, std::string(line) + ".spot");
    add_place(all, std::string(line) + ".extension");
  }
  all.push_back({"extension.forward", kShareStep});
  all.push_back({"extension.across", kShareStep});
  for (const char* parry : {"septime", "octave"}) {
    const std::string name = std::string(parry) + ".drop";
    all.push_back({name + ".hand", kShareStep});
    all.push_back({name + ".aim", kShareStep});
    all.push_back({name + ".aside", kAimStep});
    all.push_back({name + ".lift", kLengthStep});
  }
  all.push_back({"beat.place", 0});  // 0: none; 1: at (0, 0.5); 2: at (-0.25, 0)
  add_place(all, "beat.hand");
  add_aim(all, "beat.aim");
  all.push_back({"retreat.feet", 0});
  all.push_back({"retreat.half_feet", 0});
  return all;
}

/// The place of a name; as many as there are where there is none.
std::size_t place_of(const std::string& name) {
  std::size_t i = 0;
  while (i < knobs().size() && knobs()[i].name != name) ++i;
  return i;
}

std::string trimmed(const std::string& text) {
  const char* const kBlank = " \t\r";
  const auto first = text.find_first_not_of(kBlank);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

}  // namespace

const std::vector<Knob>& knobs() {
  static const std::vector<Knob> kAll = all_knobs();
  return kAll;
}

std::string Knobs::parse(const std::string& text) {
  std::vector<double> values(knobs().size(), 0.0);
  std::vector<bool> is_there(knobs().size(), false);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) continue;
    const auto equals = line.find('=');
    if (equals == std::string::npos) return "no value: " + line;
    const std::size_t i = place_of(trimmed(line.substr(0, equals)));
    if (i == knobs().size()) return "unknown: " + line;
    const std::string number = trimmed(line.substr(equals + 1));
    char* end = nullptr;
    values[i] = std::strtod(number.c_str(), &end);
    if (number.empty() || *end != '\0' || !std::isfinite(values[i])) return "no number: " + line;
    if (is_there[i]) return "twice: " + line;
    is_there[i] = true;
  }
  for (std::size_t i = 0; i < is_there.size(); ++i) {
    if (!is_there[i]) return "missing: " + knobs()[i].name;
  }
  values_ = values;
  return {};
}

std::string Knobs::load(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) return path + ": cannot be read";
  const std::string wrong = parse(text.str());
  return wrong.empty() ? wrong : path + ": " + wrong;
}

std::string Knobs::save(const std::string& path) const {
  batuta::host::OutputFile file;
  const std::string wrong = file.open(path);
  if (!wrong.empty()) return wrong;
  file.stream() << "# What the keys of the map are made of (knobs.hpp); batuta-fight search\n";
  for (std::size_t i = 0; i < values_.size(); ++i) {
    file.stream() << knobs()[i].name << '=' << values_[i] << '\n';  // 6 digits
  }
  return file.commit();
}

double& Knobs::at(const std::string& name) {
  const std::size_t i = place_of(name);
  if (i == values_.size()) {
    std::fprintf(stderr, "batuta-fight: no knob %s\n", name.c_str());
    std::abort();
  }
  return values_[i];
}

double Knobs::at(const std::string& name) const {
  return const_cast<Knobs*>(this)->at(name);
}

}  // namespace fight
