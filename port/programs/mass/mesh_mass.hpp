// SPDX-License-Identifier: MIT
#pragma once
// Mass, centre and inertia of the solid inside a closed surface of triangles: integrals over the
// volume as sums over the surface, by the divergence theorem (the paper's [14], B. Mirtich).

#include <cstdint>
#include <string>

#include "batuta/mechanics/mass.hpp"
#include "programs/mass/mesh.hpp"

namespace batuta::mesh {

/// Why a mesh has no mass properties.
enum class MeshFault : std::uint8_t {
  kNone,
  kInvalidDensity,      ///< not positive and finite
  kTooFewTriangles,     ///< fewer than 4 enclose nothing
  kIndexOutOfRange,     ///< a corner that is no vertex
  kNotFinite,           ///< a coordinate, or a result; also one that vanishes
  kDegenerateTriangle,  ///< two corners are one, or all three are in line
  kOpen,                ///< an edge belongs to one triangle only: a hole
  kNonManifold,         ///< an edge belongs to more than two triangles
  kInconsistent,        ///< two neighbours go the same way along their edge: one is turned round
  kNoVolume,            ///< no more than rounding error
  kInverted,            ///< negative volume: all triangles are turned round
  kNotABody,            ///< moments that no body has: parts are turned round, or cut through others
};

struct MeshMass {
  MeshFault fault = MeshFault::kNone;
  std::string text;                   ///< empty, or what is wrong and where
  MassProperties<double> properties;  ///< frame S: that of the mesh
  double volume = 0;                  ///< m^3
  double area = 0;                    ///< m^2

  bool ok() const { return fault == MeshFault::kNone; }
};

/// Vertices and triangles are counted from 1 in the text. A cavity is a second surface inside,
/// turned inwards. Surfaces that overlap count twice where they do; this is not noticed, unless the
/// moments become impossible. A mesh far from its origin loses no digits but those that its
/// vertices have lost. @param density kg/m^3; vertices in m
MeshMass mass_of_mesh(const Mesh& mesh, double density);

/// The same body, as heavy as it was found on a balance. kInvalidDensity where no density makes it
/// so. @pre of_mesh.ok()
MeshMass with_mass(const MeshMass& of_mesh, double mass);

}  // namespace batuta::mesh
