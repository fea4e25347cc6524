// SPDX-License-Identifier: MIT
#include "programs/mass/mesh_check.hpp"

#include <algorithm>
#include <cstdio>

namespace batuta::mesh {
namespace {

/// Sine of the least angle between two edges of a triangle: that of two vectors in line is at most
/// this by rounding alone. The cross product of differences errs by 2 u in the products, u in their
/// difference and 2 u in the factors, on each of three components.
constexpr double kInLine = 8 * kRoundOff<double>;

std::string name_of(const Mesh& mesh, std::uint32_t vertex) {
  const Vec3<double>& x = mesh.vertices[vertex];
  std::array<char, 128> text{};
  (void)std::snprintf(text.data(), text.size(), "vertex %lu (%g %g %g)",
                      static_cast<unsigned long>(vertex) + 1, x.x(), x.y(), x.z());
  return text.data();
}

std::string name_of_triangle(std::size_t triangle) {
  return "triangle " + std::to_string(triangle + 1);
}

MeshProblem problem_of_triangle(const Mesh& mesh, std::size_t at) {
  const Triangle& corners = mesh.triangles[at];
  for (const std::uint32_t corner : corners) {  // Bound: 3 corners
    if (corner >= mesh.vertices.size()) {
      return {MeshFault::kIndexOutOfRange, name_of_triangle(at) + ": vertex " +
                                               std::to_string(std::uint64_t{corner} + 1) + " of " +
                                               std::to_string(mesh.vertices.size())};
    }
    if (!is_finite(mesh.vertices[corner])) {
      return {MeshFault::kNotFinite,
              name_of_triangle(at) + ": " + name_of(mesh, corner) + " is not finite"};
    }
  }
  const Vec3<double>& a = mesh.vertices[corners[0]];
  const Vec3<double> ab = mesh.vertices[corners[1]] - a;
  const Vec3<double> ac = mesh.vertices[corners[2]] - a;
  if (ab.cross(ac).norm() > kInLine * ab.norm() * ac.norm()) return {};
  return {MeshFault::kDegenerateTriangle,
          name_of_triangle(at) + ": no area between " + name_of(mesh, corners[0]) + ", " +
              name_of(mesh, corners[1]) + " and " + name_of(mesh, corners[2])};
}

/// One side of one triangle.
struct Side {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t triangle;
  bool upwards;  ///< the triangle goes from low to high

  bool is_beside(const Side& other) const { return low == other.low && high == other.high; }
};

/// All sides, those of one edge next to each other.
std::vector<Side> sides_of(const Mesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {  // Bound: triangles
    for (std::size_t i = 0; i < 3; ++i) {                    // Bound: 3 sides
      const std::uint32_t from = mesh.triangles[t][i];
      const std::uint32_t to = mesh.triangles[t][(i + 1) % 3];
      sides.push_back(
          {std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(t), from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    if (!a.is_beside(b)) return a.low != b.low ? a.low < b.low : a.high < b.high;
    return a.triangle < b.triangle;
  });
  return sides;
}

/// What is wrong with an edge that `count` sides share.
MeshProblem problem_of_edge(const Mesh& mesh, const Side* sides, std::size_t count) {
  const std::string edge =
      "the edge from " + name_of(mesh, sides[0].low) + " to " + name_of(mesh, sides[0].high);
  const std::string first = name_of_triangle(sides[0].triangle);
  if (count == 1) {
    return {MeshFault::kOpen, "open: " + edge + " belongs to " + first + " only"};
  }
  if (count > 2) {
    return {MeshFault::kNonManifold,
            edge + " belongs to " + std::to_string(count) + " triangles, the first is " + first};
  }
  if (sides[0].upwards != sides[1].upwards) return {};
  return {MeshFault::kInconsistent, first + " and " + name_of_triangle(sides[1].triangle) +
                                        " go the same way along " + edge +
                                        ": one of them is turned round"};
}

MeshProblem problem_of_edges(const Mesh& mesh) {
  const std::vector<Side> sides = sides_of(mesh);
  std::size_t from = 0;
  while (from < sides.size()) {  // Bound: edges
    std::size_t to = from + 1;
    while (to < sides.size() && sides[to].is_beside(sides[from])) ++to;  // Bound: sides
    const bool good = to - from == 2 && sides[from].upwards != sides[from + 1].upwards;
    if (!good) return problem_of_edge(mesh, &sides[from], to - from);
    from = to;
  }
  return {};
}

}  // namespace

MeshProblem problem_of(const Mesh& mesh) {
  if (mesh.triangles.size() < 4) {
    return {MeshFault::kTooFewTriangles,
            std::to_string(mesh.triangles.size()) + " triangles enclose nothing; 4 may"};
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {  // Bound: triangles
    MeshProblem problem = problem_of_triangle(mesh, i);
    if (problem.fault != MeshFault::kNone) return problem;
  }
  return problem_of_edges(mesh);
}

}  // namespace batuta::mesh
