// SPDX-License-Identifier: MIT
#pragma once
// Whether triangles form a closed surface with one side inside.

#include "programs/mass/mesh_mass.hpp"

namespace batuta::mesh {

struct MeshProblem {
  MeshFault fault = MeshFault::kNone;
  std::string text;
};

/// The first fault that needs no integral: kTooFewTriangles, kIndexOutOfRange, kNotFinite,
/// kDegenerateTriangle, kOpen, kNonManifold, kInconsistent. Bound: n log n in the triangles.
MeshProblem problem_of(const Mesh& mesh);

}  // namespace batuta::mesh
