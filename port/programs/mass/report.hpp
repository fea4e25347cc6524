// SPDX-License-Identifier: MIT
#pragma once
// What batuta-mass prints.

#include <cstdio>

#include "programs/mass/mesh_mass.hpp"

namespace batuta::mesh {

/// For people, with the lines of C++ at the end.
void print_text(std::FILE* out, const Mesh& mesh, const MeshMass& mass);

/// One JSON object on one line, every number to the last digit.
void print_json(std::FILE* out, const Mesh& mesh, const MeshMass& mass);

}  // namespace batuta::mesh
