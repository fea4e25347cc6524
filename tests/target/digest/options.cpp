// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <cstring>

namespace batuta::digest {
namespace {

bool is(const char* word, const char* other) {
  return std::strcmp(word, other) == 0;
}

bool read_number(const char* word, std::uint32_t& number) {
  constexpr int kMostDigits = 9;
  number = 0;
  int digits = 0;
  for (; word[digits] != '\0'; ++digits) {  // Bound: kMostDigits
    if (word[digits] < '0' || word[digits] > '9' || digits == kMostDigits) return false;
    number = 10 * number + static_cast<std::uint32_t>(word[digits] - '0');
  }
  return digits > 0;
}

bool read_section(const char* word, Section& section) {
  for (std::size_t i = 0; i < kSections; ++i) {  // Bound: kSections
    if (!is(word, kSectionNames[i])) continue;
    section = static_cast<Section>(i);
    return true;
  }
  return false;
}

/// Takes words one after the other; once one is missing or makes no sense, all that follow are.
class Reader {
 public:
  explicit Reader(const Words& words) : words_(words) {}

  bool ok() const { return ok_; }
  bool has_more() const { return ok_ && next_ < words_.count; }
  const char* text() {
    if (!has_more()) {
      ok_ = false;
      return "";
    }
    const char* word = words_.word[static_cast<std::size_t>(next_)];
    ++next_;
    return word;
  }
  std::uint32_t number() {
    std::uint32_t value = 0;
    ok_ = read_number(text(), value) && ok_;
    return value;
  }
  Section section() {
    Section value{};
    ok_ = read_section(text(), value) && ok_;
    return value;
  }
  QueryName query() {
    const Section of = section();
    return {true, of, number()};
  }
  void refuse() { ok_ = false; }

 private:
  const Words& words_;
  int next_ = 0;
  bool ok_ = true;
};

void read_option(Reader& reader, Options& options) {
  const char* name = reader.text();
  if (is(name, "--in")) {
    options.in = reader.text();
  } else if (is(name, "--hashes")) {
    options.hashes = reader.text();
  } else if (is(name, "--every")) {
    options.every = reader.number();
  } else if (is(name, "--only")) {
    options.sections = 1U << static_cast<unsigned>(reader.section());
  } else if (is(name, "--show")) {
    options.shown = reader.query();
    options.sections = 1U << static_cast<unsigned>(options.shown.section);
  } else if (is(name, "--doctor")) {
    options.doctored = reader.query();
  } else {
    reader.refuse();
  }
}

}  // namespace

bool read_options(const Words& words, Options& options) {
  Reader reader(words);
  while (reader.has_more()) read_option(reader, options);  // Bound: Words::kMost
  return reader.ok() && options.every > 0;
}

}  // namespace batuta::digest
