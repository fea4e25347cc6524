// SPDX-License-Identifier: MIT
#pragma once
// Reads a mesh from the text of a file. Strict: what is not understood is refused, because a mesh
// that is read in part has the wrong mass.

#include <string>
#include <string_view>

#include "programs/mass/mesh.hpp"

namespace batuta::mesh {

/// A mesh, or why there is none.
struct MeshFile {
  Mesh mesh;
  std::string error;  ///< empty, or "line 7: ..."

  bool ok() const { return error.empty(); }
};

/// Wavefront OBJ: v with 3 coordinates (a weight or a colour behind them is read over), f with
/// corners v, v/vt, v//vn, v/vt/vn, counted from 1 or, if negative, from the last vertex. A polygon
/// becomes a fan about its first corner, which is exact if it is flat. vt, vn, g, o, s, usemtl and
/// mtllib are read over; every other word is refused.
MeshFile read_obj(std::string_view text);

/// STL, ASCII or binary: binary if its size is the one that its count of triangles asks for.
/// Corners with equal coordinates are one vertex. Normals and attributes are read over: the order
/// of the corners tells the outside.
MeshFile read_stl(std::string_view text);

/// The file at `path`, read by the ending of its name: .obj or .stl, in letters of any size.
/// `readable` is false where the file itself is the problem; then `error` says why.
struct OpenedMesh {
  MeshFile file;
  bool readable = false;
};
OpenedMesh open_mesh(const std::string& path);

}  // namespace batuta::mesh
