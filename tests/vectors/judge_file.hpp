// SPDX-License-Identifier: MIT
#pragma once
// Every row of a file of exact answers before a judge.

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "programs/query_file.hpp"

namespace batuta::test {

/// @tparam Judge  has judge(const host::QueryRow&) and report(scalar)
template <class Judge>
void judge_file(const char* name, const char* scalar) {
  const std::string path = std::string(BATUTA_SHARED_DIR "/vectors/") + name;
  std::ifstream in(path);
  if (!in) GTEST_SKIP() << "there is no " << path;
  host::QueryFile file(in);
  ASSERT_TRUE(file.ok()) << file.error();
  Judge judge;
  host::QueryRow row;
  while (file.next(row)) judge.judge(row);  // Bound: the length of the file
  judge.report(scalar);
}

}  // namespace batuta::test
