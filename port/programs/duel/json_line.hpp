// SPDX-License-Identifier: MIT
#pragma once
// One JSON object on one line, member by member.

#include <cstdint>
#include <cstdio>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "batuta/core/types.hpp"

namespace batuta::host {

/// An object that begins with its "type"; the destructor writes it as one line.
class JsonLine {
 public:
  JsonLine(std::FILE* out, std::string_view type);
  JsonLine(const JsonLine&) = delete;
  JsonLine& operator=(const JsonLine&) = delete;
  ~JsonLine();

  /// What is no UTF-8 becomes U+FFFD.
  JsonLine& text(const char* key, std::string_view value);
  /// With nine digits, as many as a float has. JSON knows no infinity and no NaN: they become null.
  JsonLine& number(const char* key, double value);
  JsonLine& count(const char* key, std::uint64_t value);
  JsonLine& flag(const char* key, bool value);
  JsonLine& vector(const char* key, const Vec3<float>& value);

 private:
  std::FILE* out_;
  std::unique_ptr<nlohmann::ordered_json> object_;
};

}  // namespace batuta::host
