// SPDX-License-Identifier: MIT
// batuta_digest_pack: puts query files and the samples of recordings into one file for
// batuta_digest (its form: section.hpp), and says what is in it and what had to be left out.
// usage: batuta_digest_pack SHARED OUT
// Queries that SHARED lacks are those of the committed part, tests/vectors/committed.
// Exit status: 0 written, also where SHARED lacks recordings; 1 a file cannot be used.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "../answer.hpp"
#include "../section.hpp"
#include "batuta/fencing/fencer.hpp"
#include "programs/devices/source.hpp"
#include "programs/query_file.hpp"

namespace batuta::digest {
using namespace fencing;
namespace {

constexpr std::uint32_t kStep_us = 1000;

using WordList = std::vector<std::uint32_t>;
using Names = std::vector<std::string>;

/// Columns of a query by their prefixes: "c" stands for cx, cy, cz.
void add_vector(Names& names, const std::string& prefix) {
  for (const char axis : {'x', 'y', 'z'}) names.push_back(prefix + axis);
}

void add_quaternion(Names& names, const std::string& prefix) {
  names.push_back(prefix + 'w');
  add_vector(names, prefix);
}

Names toc_columns() {
  Names names = {"T"};
  for (const std::string body : {"A", "B"}) {
    add_vector(names, body + 'c');
    add_quaternion(names, body + 'q');
    for (const char* part : {"v", "w", "e0", "e1"}) add_vector(names, body + part);
    names.push_back(body + 'r');
  }
  return names;
}

Names distance_columns() {
  Names names;
  for (const char* end : {"A0", "A1", "B0", "B1"}) add_vector(names, end);
  return names;
}

Names impulse_columns() {
  Names names;
  for (const std::string body : {"A", "B"}) {
    names.push_back(body + 'm');
    add_vector(names, body + 'J');
    add_vector(names, body + 'c');
    add_quaternion(names, body + 'q');
    add_vector(names, body + 'v');
    add_vector(names, body + 'w');
  }
  add_vector(names, "p");
  add_vector(names, "n");
  names.emplace_back("e");
  return names;
}

/// The file under way, and whether everything so far could be used.
class Pack {
 public:
  explicit Pack(const std::string& path) : out_(path, std::ios::binary) { put({kMagic}); }

  void add_queries(const std::string& path, Chunk chunk, const Names& columns);
  void add_bout(const std::string& left, const std::string& right);
  bool finish() {
    out_.flush();
    return good_ && out_.good();
  }

 private:
  bool skip(const std::string& path) const {
    if (std::filesystem::exists(path)) return false;
    std::printf("skipped: there is no %s\n", path.c_str());
    return true;
  }
  void refuse(const std::string& what) {
    std::printf("error: %s\n", what.c_str());
    good_ = false;
  }
  void put(const WordList& words) {
    for (const std::uint32_t word : words) {  // little-endian on any host
      for (const unsigned shift : {0U, 8U, 16U, 24U}) {
        out_.put(static_cast<char>(static_cast<unsigned char>(word >> shift & 255U)));
      }
    }
  }
  void put_chunk(Chunk chunk, std::size_t words, std::uint32_t parameter, const WordList& records) {
    put({static_cast<std::uint32_t>(chunk), static_cast<std::uint32_t>(records.size() / words),
         static_cast<std::uint32_t>(words), parameter});
    put(records);
  }

  std::ofstream out_;
  bool good_ = true;
  int bouts_ = 0;
};

void Pack::add_queries(const std::string& path, Chunk chunk, const Names& columns) {
  std::ifstream in(path, std::ios::binary);
  host::QueryFile file(in);
  WordList records;
  host::QueryRow row;
  while (file.next(row)) {  // Bound: lines of the file
    for (const std::string& column : columns) records.push_back(bits_of(row.number(column)));
    if (!row.ok()) return refuse(path + ": " + row.error());
  }
  if (!file.ok()) return refuse(path + ": " + file.error());
  put_chunk(chunk, columns.size(), 0, records);
  std::printf("queries: %s %zu\n", path.c_str(), records.size() / columns.size());
}

/// One fencer's samples at the steps at which a program that reads every step gets them.
void sample(host::Source& source, Side side, std::uint32_t step, WordList& records) {
  InputSample given;
  if (source.read(step * kStep_us, given) != Status::kOk) return;
  const auto number = static_cast<std::uint32_t>(index_of(side));
  records.insert(records.end(), {step, number, given.time, bits_of(given.x), bits_of(given.y),
                                 given.buttons, given.sequence});
}

void Pack::add_bout(const std::string& left, const std::string& right) {
  const bool is_file = left.find('/') != std::string::npos;
  if (is_file && skip(left)) return;
  const host::OpenedSource a = host::open_source(left);
  const host::OpenedSource b = host::open_source(right);
  if (!a.source || !b.source) return refuse(a.error + b.error);
  const auto steps = static_cast<std::uint32_t>(std::ceil(1e6 * a.source->duration() / kStep_us));
  WordList records;
  for (std::uint32_t step = 0; step < steps; ++step) {  // Bound: the length of the recording
    sample(*a.source, Side::kLeft, step, records);
    sample(*b.source, Side::kRight, step, records);
  }
  put_chunk(Chunk::kBout, kSampleWords, steps, records);
  std::printf("bout: %d %s against %s, %u steps\n", bouts_, left.c_str(), right.c_str(), steps);
  ++bouts_;
}

/// Every recording in a folder, in the order of their names.
Names recordings_in(const std::string& folder) {
  Names paths;
  if (!std::filesystem::exists(folder)) return {folder + "/*.events"};
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".events") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// The whole file of queries, or the committed part of it.
std::string queries_in(const std::string& shared, const std::string& name) {
  const std::string whole = shared + "/vectors/" + name;
  if (std::filesystem::exists(whole)) return whole;
  std::printf("only the committed part: there is no %s\n", whole.c_str());
  return std::string(BATUTA_COMMITTED_VECTORS "/") + name;
}

int pack(const std::string& shared, const std::string& out) {
  Pack file(out);
  file.add_queries(queries_in(shared, "toc.csv"), Chunk::kToc, toc_columns());
  file.add_queries(queries_in(shared, "dist.csv"), Chunk::kDistance, distance_columns());
  file.add_queries(queries_in(shared, "resp.csv"), Chunk::kImpulse, impulse_columns());
  file.add_bout("default", "script:parry");
  for (const std::string& path : recordings_in(shared + "/recordings")) {
    file.add_bout(path, "script:parry");
  }
  return file.finish() ? 0 : 1;
}

}  // namespace
}  // namespace batuta::digest

int main(int count, char** words) {
  if (count == 3) return batuta::digest::pack(words[1], words[2]);
  std::fputs("usage: batuta_digest_pack SHARED OUT\n", stderr);
  return 1;
}
