// SPDX-License-Identifier: MIT

#include "programs/duel/json_line.hpp"

#include <cinttypes>
#include <cmath>

#include "programs/duel/utf8.hpp"

namespace batuta::host {
JsonLine::JsonLine(std::FILE* out, std::string_view type) : out_(out) {
  std::fputs("{\"type\": ", out_);
  write_string(type);
}

JsonLine::~JsonLine() {
  std::fputs("}\n", out_);
}

JsonLine& JsonLine::text(const char* key, std::string_view value) {
  write_key(key);
  write_string(value);
  return *this;
}

JsonLine& JsonLine::number(const char* key, double value) {
  write_key(key);
  write_number(value);
  return *this;
}

JsonLine& JsonLine::count(const char* key, std::uint64_t value) {
  write_key(key);
  std::fprintf(out_, "%" PRIu64, value);
  return *this;
}

JsonLine& JsonLine::flag(const char* key, bool value) {
  write_key(key);
  std::fputs(value ? "true" : "false", out_);
  return *this;
}

JsonLine& JsonLine::vector(const char* key, const Vec3<float>& value) {
  write_key(key);
  for (int i = 0; i < 3; ++i) {
    std::fputs(i == 0 ? "[" : ", ", out_);
    write_number(static_cast<double>(value[i]));
  }
  std::fputc(']', out_);
  return *this;
}

void JsonLine::write_key(const char* key) {
  std::fputs(", ", out_);
  write_string(key);
  std::fputs(": ", out_);
}

void JsonLine::write_string(std::string_view value) {
  std::fputc('"', out_);
  while (!value.empty()) {  // Bound: the bytes of the text
    const std::size_t length = utf8_length(value);
    const char c = value.front();
    if (length == 0) {
      std::fputs("\\ufffd", out_);
    } else if (c == '"' || c == '\\') {
      std::fprintf(out_, "\\%c", c);
    } else if (static_cast<unsigned char>(c) < 0x20) {
      std::fprintf(out_, "\\u%04x", static_cast<unsigned>(c));
    } else {
      std::fwrite(value.data(), 1, length, out_);
    }
    value.remove_prefix(length == 0 ? 1 : length);
  }
  std::fputc('"', out_);
}

void JsonLine::write_number(double value) {
  if (std::isfinite(value)) {
    std::fprintf(out_, "%.9g", value);
  } else {
    std::fputs("null", out_);
  }
}

}  // namespace batuta::host
