// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "programs/mass/mesh_file.hpp"
#include "programs/mass/words.hpp"

namespace batuta::mesh {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::array<std::string_view, 7> kReadOver = {"vt", "vn",     "g",     "o",
                                                       "s",  "usemtl", "mtllib"};

/// Takes in one line after the other.
class ObjReader {
 public:
  /// @returns what is wrong with the line; empty: nothing
  std::string take(Words& words) {
    drop_comment(words);
    if (words.empty()) return {};
    if (words.size() > kMostWords) return "more than " + std::to_string(kMostWords) + " words";
    if (words[0] == "v") return take_vertex(words);
    if (words[0] == "f") return take_face(words);
    const bool read_over =
        std::find(kReadOver.begin(), kReadOver.end(), words[0]) != kReadOver.end();
    return read_over ? std::string() : "unknown keyword " + quoted(words[0]);
  }
  Mesh& mesh() { return mesh_; }

 private:
  static void drop_comment(Words& words) {
    const auto is_comment = [](std::string_view word) { return word[0] == '#'; };
    words.erase(std::find_if(words.begin(), words.end(), is_comment), words.end());
  }

  std::string take_vertex(const Words& words) {
    const std::size_t count = words.size() - 1;
    if (count != 3 && count != 4 && count != 6) {
      return "a vertex has 3 coordinates; here are " + std::to_string(count) + " numbers";
    }
    if (mesh_.vertices.size() == kMostVertices) return "more vertices than can be taken";
    Vec3<double> x;
    for (std::size_t i = 0; i < count; ++i) {  // Bound: 6 numbers
      const std::optional<double> number = finite_number(words[i + 1]);
      if (!number) return quoted(words[i + 1]) + " is not a finite number";
      if (i < 3) x(static_cast<int>(i)) = *number;
    }
    mesh_.vertices.push_back(x);
    return {};
  }

  std::string take_face(const Words& words) {
    if (words.size() < 4) return "a face has at least 3 corners";
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 1; i < words.size(); ++i) {  // Bound: words of the line
      std::string problem = take_corner(words[i], corners);
      if (!problem.empty()) return problem;
    }
    if (mesh_.triangles.size() + corners.size() - 2 > kMostTriangles) {
      return "more triangles than can be taken";
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {  // Bound: corners of the face
      mesh_.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
    return {};
  }

  /// v, v/vt, v//vn or v/vt/vn.
  std::string take_corner(std::string_view word, std::vector<std::uint32_t>& corners) const {
    const std::size_t slash = std::min(word.find('/'), word.size());
    const std::optional<long> vertex = whole_number(word.substr(0, slash));
    if (!vertex || !is_tail(word.substr(slash))) {
      return quoted(word) + " is not a corner (v, v/vt, v//vn or v/vt/vn)";
    }
    const auto count = static_cast<long>(mesh_.vertices.size());
    const long at = *vertex < 0 ? count + *vertex : *vertex - 1;
    if (at < 0 || at >= count) {
      return "there is no vertex " + std::to_string(*vertex) + " among the " +
             std::to_string(count) + " before this line";
    }
    corners.push_back(static_cast<std::uint32_t>(at));
    return {};
  }

  /// What may follow the vertex: nothing, /vt, //vn, /vt/vn.
  static bool is_tail(std::string_view tail) {
    if (tail.empty()) return true;
    tail.remove_prefix(1);
    const std::size_t slash = tail.find('/');
    if (slash == std::string_view::npos) return is_reference(tail);
    const std::string_view texture = tail.substr(0, slash);
    return (texture.empty() || is_reference(texture)) && is_reference(tail.substr(slash + 1));
  }
  static bool is_reference(std::string_view word) { return whole_number(word).value_or(0) != 0; }

  Mesh mesh_;
};

}  // namespace

MeshFile read_obj(std::string_view text) {
  MeshFile file;
  ObjReader reader;
  Lines lines(text);
  Words words;
  while (lines.next(words)) {  // Bound: lines of the text
    const std::string problem = reader.take(words);
    if (problem.empty()) continue;
    file.error = "line " + std::to_string(lines.number()) + ": " + problem;
    return file;
  }
  file.mesh = std::move(reader.mesh());
  return file;
}

}  // namespace batuta::mesh
