// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "programs/mass/mesh_file.hpp"
#include "programs/mass/words.hpp"

namespace batuta::mesh {
namespace {

using Words = std::vector<std::string_view>;

/// Collects corners; those with equal coordinates become one vertex.
class Welder {
 public:
  /// @returns false where a mesh may not be larger
  bool add(const Vec3<double>& corner) {
    const Key key = {corner.x(), corner.y(), corner.z()};  // -0 equals 0
    const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto [place, is_new] = known_.try_emplace(key, next);
    if (is_new) mesh_.vertices.push_back(corner);
    corners_[count_++] = place->second;
    if (count_ < corners_.size()) return true;
    count_ = 0;
    mesh_.triangles.push_back(corners_);
    return mesh_.triangles.size() <= kMostTriangles && mesh_.vertices.size() <= kMostVertices;
  }
  Mesh& mesh() { return mesh_; }

 private:
  using Key = std::array<double, 3>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::size_t mixed = 0;
      for (const double x : key) {  // Bound: 3 coordinates
        mixed = mixed * 0x9E3779B1U + std::hash<double>()(x);
      }
      return mixed;
    }
  };

  Mesh mesh_;
  std::unordered_map<Key, std::uint32_t, Hash> known_;
  Triangle corners_{};
  std::size_t count_ = 0;
};

constexpr const char* kTooMany = "more triangles or vertices than can be taken";

// Binary: a header of 80 bytes, the count of triangles, then for each of them its normal, three
// corners and two bytes; all little-endian.
constexpr std::size_t kCountAt = 80;
constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kFacetBytes = 50;
constexpr std::size_t kNormalBytes = 12;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) {  // Bound: 4 bytes
    word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return word;
}

double float_at(std::string_view bytes, std::size_t at) {
  const std::uint32_t word = word_at(bytes, at);
  float value = 0;
  static_assert(sizeof value == sizeof word, "float is the file's IEEE-754 binary32");
  std::memcpy(&value, &word, sizeof value);
  return static_cast<double>(value);
}

std::size_t binary_size(std::string_view bytes) {
  return kHeaderBytes + kFacetBytes * std::size_t{word_at(bytes, kCountAt)};
}

MeshFile read_binary(std::string_view bytes) {
  MeshFile file;
  Welder welder;
  const std::size_t count = word_at(bytes, kCountAt);
  for (std::size_t i = 0; i < 3 * count; ++i) {  // Bound: corners of the file
    const std::size_t at = kHeaderBytes + kFacetBytes * (i / 3) + kNormalBytes + 12 * (i % 3);
    const Vec3<double> x(float_at(bytes, at), float_at(bytes, at + 4), float_at(bytes, at + 8));
    const std::string where = "triangle " + std::to_string(i / 3 + 1) + ": ";
    if (!is_finite(x)) {
      file.error = where + "a coordinate is not finite";
    } else if (!welder.add(x)) {
      file.error = where + kTooMany;
    }
    if (!file.ok()) return file;
  }
  file.mesh = std::move(welder.mesh());
  return file;
}

/// The lines of an ASCII file, in their order.
enum class Expected { kSolid, kFacet, kLoop, kCorner, kEndLoop, kEndFacet, kNothing };

class AsciiReader {
 public:
  /// @returns what is wrong with the line; empty: nothing
  std::string take(const Words& words) {
    if (words.empty()) return {};
    switch (expected_) {
      case Expected::kSolid:
        return step(words[0] == "solid", Expected::kFacet, "solid");
      case Expected::kFacet:
        if (words[0] == "endsolid") return step(true, Expected::kNothing, "");
        return step(is_facet(words), Expected::kLoop, "facet normal X Y Z, or endsolid");
      case Expected::kLoop:
        return step(is(words, "outer", "loop"), Expected::kCorner, "outer loop");
      case Expected::kCorner:
        return take_corner(words);
      case Expected::kEndLoop:
        return step(is(words, "endloop"), Expected::kEndFacet, "endloop");
      case Expected::kEndFacet:
        return step(is(words, "endfacet"), Expected::kFacet, "endfacet");
      case Expected::kNothing:
        break;
    }
    return "the solid has ended, and " + quoted(words[0]) + " follows; one solid a file";
  }
  bool at_end() const { return expected_ == Expected::kNothing; }
  Mesh& mesh() { return welder_.mesh(); }

 private:
  static bool is(const Words& words, std::string_view first, std::string_view second = {}) {
    const std::size_t count = second.empty() ? 1 : 2;
    return words.size() == count && words[0] == first && (count == 1 || words[1] == second);
  }
  static bool is_number(std::string_view word) { return finite_number(word).has_value(); }
  static bool is_facet(const Words& words) {
    if (words.size() != 5 || words[0] != "facet" || words[1] != "normal") return false;
    // Read over, but it has to be three numbers; some programs write nan for what they do not know.
    return numbers_from(words, 2, [](std::string_view word) {
      return is_number(word) || word == "nan" || word == "-nan";
    });
  }
  template <class Accept>
  static bool numbers_from(const Words& words, std::size_t first, const Accept& accept) {
    for (std::size_t i = first; i < words.size(); ++i) {  // Bound: 3 words
      if (!accept(words[i])) return false;
    }
    return true;
  }

  std::string step(bool good, Expected next, const char* wanted) {
    if (!good) return std::string("expected: ") + wanted;
    expected_ = next;
    return {};
  }

  std::string take_corner(const Words& words) {
    const bool shape = words.size() == 4 && words[0] == "vertex";
    if (!shape || !numbers_from(words, 1, is_number)) {
      return "expected: vertex X Y Z, with finite numbers";
    }
    const Vec3<double> x(*finite_number(words[1]), *finite_number(words[2]),
                         *finite_number(words[3]));
    if (!welder_.add(x)) return kTooMany;
    if (++corners_ < 3) return {};
    corners_ = 0;
    return step(true, Expected::kEndLoop, "");
  }

  Expected expected_ = Expected::kSolid;
  int corners_ = 0;
  Welder welder_;
};

MeshFile read_ascii(std::string_view text) {
  MeshFile file;
  AsciiReader reader;
  Lines lines(text);
  Words words;
  while (lines.next(words)) {  // Bound: lines of the text
    const std::string problem = reader.take(words);
    if (problem.empty()) continue;
    file.error = "line " + std::to_string(lines.number()) + ": " + problem;
    return file;
  }
  if (!reader.at_end()) {
    file.error = "line " + std::to_string(lines.number()) + ": the file ends before endsolid";
    return file;
  }
  file.mesh = std::move(reader.mesh());
  return file;
}

}  // namespace

MeshFile read_stl(std::string_view text) {
  const bool has_header = text.size() >= kHeaderBytes;
  if (has_header && text.size() == binary_size(text)) return read_binary(text);
  const bool is_text = text.substr(0, kHeaderBytes).find('\0') == std::string_view::npos;
  if (text.substr(0, 5) == "solid" && is_text) return read_ascii(text);
  MeshFile file;
  file.error = "is neither an ASCII STL (begins with \"solid\") nor a binary one";
  if (has_header) {
    file.error += ": " + std::to_string(word_at(text, kCountAt)) + " triangles take " +
                  std::to_string(binary_size(text)) + " bytes, and it has " +
                  std::to_string(text.size());
  } else {
    file.error += " (at least " + std::to_string(kHeaderBytes) + " bytes)";
  }
  return file;
}

}  // namespace batuta::mesh
