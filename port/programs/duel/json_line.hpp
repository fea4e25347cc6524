// SPDX-License-Identifier: MIT
#pragma once
// One JSON object on one line, written member by member without the heap.

#include <cstdint>
#include <cstdio>
#include <string_view>

#include "batuta/core/types.hpp"

namespace batuta::host {

/// Opens an object with its "type"; the destructor closes it and ends the line.
class JsonLine {
 public:
  JsonLine(std::FILE* out, std::string_view type);
  JsonLine(const JsonLine&) = delete;
  JsonLine& operator=(const JsonLine&) = delete;
  ~JsonLine();

  JsonLine& text(const char* key, std::string_view value);
  /// JSON knows no infinity and no NaN: they become null.
  JsonLine& number(const char* key, double value);
  JsonLine& count(const char* key, std::uint64_t value);
  JsonLine& flag(const char* key, bool value);
  JsonLine& vector(const char* key, const Vec3<float>& value);

 private:
  void write_key(const char* key);
  void write_string(std::string_view value);
  void write_number(double value);

  std::FILE* out_;
};

}  // namespace batuta::host
