// SPDX-License-Identifier: MIT
#pragma once
// A surface of triangles, as a modelling program writes it. Its frame is S, the one in which the
// shape is modelled. Corners of a triangle go round counter-clockwise when seen from outside.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "batuta/core/types.hpp"

namespace batuta::mesh {

using Triangle = std::array<std::uint32_t, 3>;  ///< positions in the list of vertices

struct Mesh {
  std::vector<Vec3<double>> vertices;
  std::vector<Triangle> triangles;
};

/// No file makes a reader take more memory than these need.
inline constexpr std::size_t kMostVertices = std::size_t{1} << 22;
inline constexpr std::size_t kMostTriangles = std::size_t{1} << 22;
inline constexpr std::size_t kMostBytes = std::size_t{1} << 30;

}  // namespace batuta::mesh
