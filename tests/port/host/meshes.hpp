// SPDX-License-Identifier: MIT
#pragma once
// Closed meshes whose mass properties are known, and a second way to integrate over any of them.

#include <cmath>
#include <map>
#include <utility>

#include "programs/mass/mesh_mass.hpp"

namespace batuta::mesh::samples {

using Real = long double;

inline Mesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// Edges x, y, z; its first corner at the origin.
inline Mesh box(double x, double y, double z) {
  return {{{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}, {0, 0, z}, {x, 0, z}, {x, y, z}, {0, y, z}},
          {{0, 2, 1},
           {0, 3, 2},
           {4, 5, 6},
           {4, 6, 7},
           {0, 1, 5},
           {0, 5, 4},
           {1, 2, 6},
           {1, 6, 5},
           {2, 3, 7},
           {2, 7, 6},
           {3, 0, 4},
           {3, 4, 7}}};
}

inline Mesh octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// A ball of radius 1 from an octahedron: each level cuts triangles into four and lifts the new
/// corners to the sphere.
inline Mesh ball(int levels) {
  Mesh mesh = octahedron();
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
      const auto [place, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)}, next);
      if (is_new) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
      return place->second;
    };
    std::vector<Triangle> finer;
    for (const auto [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  return mesh;
}

/// A capsule from the ball: its upper half moved up by `core`, and the seam (z = 0) drawn out into
/// a wall, whose lower edge is the old seam.
inline Mesh capsule(int levels, double radius, double core) {
  Mesh mesh = ball(levels);
  const std::size_t old = mesh.vertices.size();
  std::map<std::uint32_t, std::uint32_t> raised;
  for (std::uint32_t i = 0; i < old; ++i) {
    if (std::abs(mesh.vertices[i].z()) > 1e-9) continue;
    raised[i] = static_cast<std::uint32_t>(mesh.vertices.size());
    const Vec3<double> copy = mesh.vertices[i];
    mesh.vertices.push_back(copy);
  }
  std::vector<Triangle> wall;
  for (Triangle& t : mesh.triangles) {
    const double height =
        mesh.vertices[t[0]].z() + mesh.vertices[t[1]].z() + mesh.vertices[t[2]].z();
    if (height < 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      if (raised.count(a) + raised.count(b) < 2) continue;
      wall.push_back({a, b, raised[b]});
      wall.push_back({a, raised[b], raised[a]});
    }
    for (std::uint32_t& corner : t) {
      if (raised.count(corner) != 0) corner = raised[corner];
    }
  }
  mesh.triangles.insert(mesh.triangles.end(), wall.begin(), wall.end());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const bool above = i >= old || mesh.vertices[i].z() > 1e-9;
    mesh.vertices[i] *= radius;
    if (above) mesh.vertices[i].z() += core;
  }
  return mesh;
}

inline Mesh moved(Mesh mesh, const Vec3<double>& by) {
  for (Vec3<double>& x : mesh.vertices) x += by;
  return mesh;
}

inline Mesh turned_round(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Both surfaces in one mesh.
inline Mesh together(Mesh one, const Mesh& other) {
  const auto first = static_cast<std::uint32_t>(one.vertices.size());
  one.vertices.insert(one.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto [a, b, c] : other.triangles) {
    one.triangles.push_back({a + first, b + first, c + first});
  }
  return one;
}

/// Volume, centre and inertia for density 1, in long double: tetrahedra from a point inside, each
/// by the four-point rule that is exact for squares. No formula of the code under test.
struct Quadrature {
  Real volume = 0;
  Vec3<Real> center = Vec3<Real>::Zero();
  Mat3<Real> inertia = Mat3<Real>::Zero();

  Quadrature(const Mesh& mesh, const Vec3<double>& inside) {
    const Vec3<Real> o = inside.cast<Real>();
    Mat3<Real> second = Mat3<Real>::Zero();
    for (const Triangle& t : mesh.triangles) {
      const std::array<Vec3<Real>, 4> corners = {
          Vec3<Real>::Zero(), mesh.vertices[t[0]].cast<Real>() - o,
          mesh.vertices[t[1]].cast<Real>() - o, mesh.vertices[t[2]].cast<Real>() - o};
      Mat3<Real> edges;
      edges << corners[1], corners[2], corners[3];
      const Real quarter = edges.determinant() / 24;
      volume += 4 * quarter;
      for (const Vec3<Real>& heavy : corners) {
        const Vec3<Real> all = corners[1] + corners[2] + corners[3];
        const Vec3<Real> x = kFew * all + (kMuch - kFew) * heavy;
        center += quarter * x;
        second += quarter * x * x.transpose();
      }
    }
    center /= volume;
    second -= volume * center * center.transpose();
    center += o;
    inertia = second.trace() * Mat3<Real>::Identity() - second;
  }

 private:
  inline static const Real kFew = (5 - std::sqrt(Real(5))) / 20;
  inline static const Real kMuch = 1 - 3 * kFew;
};

}  // namespace batuta::mesh::samples
