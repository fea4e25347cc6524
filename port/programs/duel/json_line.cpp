// SPDX-License-Identifier: MIT

#include "programs/duel/json_line.hpp"

#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

namespace batuta::host {
namespace {

/// The number that nine digits tell: it is written with as many.
double with_nine_digits(double value) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.9g", value);
  return std::strtod(digits.data(), nullptr);
}

}  // namespace

JsonLine::JsonLine(std::FILE* out, std::string_view type)
    : out_(out), object_(std::make_unique<nlohmann::ordered_json>()) {
  text("type", type);
}

JsonLine::~JsonLine() {
  using Json = nlohmann::ordered_json;
  const std::string line = object_->dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
  std::fwrite(line.data(), 1, line.size(), out_);
}

JsonLine& JsonLine::text(const char* key, std::string_view value) {
  (*object_)[key] = value;
  return *this;
}

JsonLine& JsonLine::number(const char* key, double value) {
  (*object_)[key] = with_nine_digits(value);
  return *this;
}

JsonLine& JsonLine::count(const char* key, std::uint64_t value) {
  (*object_)[key] = value;
  return *this;
}

JsonLine& JsonLine::flag(const char* key, bool value) {
  (*object_)[key] = value;
  return *this;
}

JsonLine& JsonLine::vector(const char* key, const Vec3<float>& value) {
  auto& array = (*object_)[key];
  for (const float number : value) array.push_back(with_nine_digits(static_cast<double>(number)));
  return *this;
}

}  // namespace batuta::host
