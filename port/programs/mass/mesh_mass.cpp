// SPDX-License-Identifier: MIT
#include "programs/mass/mesh_mass.hpp"

#include <cmath>
#include <limits>

#include "programs/mass/mesh_check.hpp"

namespace batuta::mesh {
namespace {

/// A sum that keeps what each addition rounds away (Neumaier), so that millions of triangles add no
/// error of their own.
class Sum {
 public:
  void add(double x) {
    const double next = sum_ + x;
    lost_ += std::abs(sum_) >= std::abs(x) ? (sum_ - next) + x : (x - next) + sum_;
    sum_ = next;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0;
  double lost_ = 0;
};

/// One signed tetrahedron: origin and a triangle.
struct Tetrahedron {
  Vec3<double> a, b, c;
  double det;  ///< a . (b x c): six times the volume

  Tetrahedron(const Mesh& mesh, const Triangle& t, const Vec3<double>& origin)
      : a(mesh.vertices[t[0]] - origin),
        b(mesh.vertices[t[1]] - origin),
        c(mesh.vertices[t[2]] - origin),
        det(a.dot(b.cross(c))) {}
};

/// Integrals of 1 and x over the solid, and the area of its surface.
struct FirstMoments {
  double volume = 0;
  double uncertain = 0;  ///< most that rounding may have put into the volume
  double area = 0;
  Vec3<double> center = Vec3<double>::Zero();  ///< of the solid; without meaning if volume is 0
};

/// a . (b x c) errs by 6 u of |a| |b| |c|, its factors by u each: 9 u, and as much in reserve.
constexpr double kDeterminantError = 18 * kRoundOff<double>;

FirstMoments first_moments(const Mesh& mesh, const Vec3<double>& origin) {
  Sum sixfold;
  Sum area;
  Sum largest;
  std::array<Sum, 3> first;
  for (const Triangle& triangle : mesh.triangles) {  // Bound: triangles
    const Tetrahedron t(mesh, triangle, origin);
    const Vec3<double> normal = Vec3<double>(t.b - t.a).cross(Vec3<double>(t.c - t.a));
    const Vec3<double> corners = t.a + t.b + t.c;
    sixfold.add(t.det);
    area.add(normal.norm() / 2);
    largest.add(t.a.norm() * t.b.norm() * t.c.norm());
    for (int i = 0; i < 3; ++i) {  // Bound: 3 components
      first[static_cast<std::size_t>(i)].add(t.det * corners(i));
    }
  }
  FirstMoments moments;
  moments.volume = sixfold.value() / 6;
  moments.uncertain = kDeterminantError * largest.value() / 6;
  moments.area = area.value();
  const Vec3<double> sums(first[0].value(), first[1].value(), first[2].value());
  moments.center = origin + sums / (4 * sixfold.value());
  return moments;
}

/// Integral of x x^T over the solid, x from the origin: over a tetrahedron with one corner there it
/// is det/120 (a a^T + b b^T + c c^T + s s^T), s = a + b + c.
Mat3<double> second_moments(const Mesh& mesh, const Vec3<double>& origin) {
  std::array<Sum, 6> sums;
  for (const Triangle& triangle : mesh.triangles) {  // Bound: triangles
    const Tetrahedron t(mesh, triangle, origin);
    const Vec3<double> s = t.a + t.b + t.c;
    std::size_t k = 0;
    for (int i = 0; i < 3; ++i) {    // Bound: 3 rows
      for (int j = i; j < 3; ++j) {  // Bound: 3 columns
        sums[k++].add(t.det * (t.a(i) * t.a(j) + t.b(i) * t.b(j) + t.c(i) * t.c(j) + s(i) * s(j)));
      }
    }
  }
  Mat3<double> C;
  std::size_t k = 0;
  for (int i = 0; i < 3; ++i) {                                                 // Bound: 3 rows
    for (int j = i; j < 3; ++j) C(i, j) = C(j, i) = sums[k++].value() / 120.0;  // Bound: 3 columns
  }
  return C;
}

/// Middle of the box around the triangles: near it, differences of coordinates are exact or nearly
/// so, however far away the mesh is.
Vec3<double> box_center(const Mesh& mesh) {
  Vec3<double> low = mesh.vertices[mesh.triangles[0][0]];
  Vec3<double> high = low;
  for (const Triangle& triangle : mesh.triangles) {  // Bound: triangles
    for (const std::uint32_t corner : triangle) {    // Bound: 3 corners
      low = low.cwiseMin(mesh.vertices[corner]);
      high = high.cwiseMax(mesh.vertices[corner]);
    }
  }
  return low + (high - low) / 2;
}

MeshMass refused(MeshFault fault, const std::string& text) {
  MeshMass answer;
  answer.fault = fault;
  answer.text = text;
  return answer;
}

/// Every moment of a body is positive and less than the sum of the other two.
bool are_of_a_solid(const Vec3<double>& moments) {
  return moments(0) > 0 && moments(2) < moments(0) + moments(1);
}

MeshMass checked(const MeshMass& answer) {
  const MassProperties<double>& properties = answer.properties;
  const double largest = properties.inertia_S.cwiseAbs().maxCoeff();
  const bool in_range = is_positive(properties.mass) && is_finite(properties.inertia_S) &&
                        largest >= std::numeric_limits<double>::min();
  if (!in_range) {
    return refused(MeshFault::kNotFinite, "mass or inertia is too large or too small for a number");
  }
  if (!are_of_a_solid(principal_frame(properties).moments)) {
    return refused(MeshFault::kNotABody,
                   "moments of inertia that no body has: parts of the surface are turned round, or "
                   "cut through others");
  }
  return answer;
}

}  // namespace

MeshMass mass_of_mesh(const Mesh& mesh, double density) {
  if (!is_positive(density)) {
    return refused(MeshFault::kInvalidDensity, "the density is not a number above 0");
  }
  const MeshProblem problem = problem_of(mesh);
  if (problem.fault != MeshFault::kNone) return refused(problem.fault, problem.text);

  const FirstMoments first = first_moments(mesh, box_center(mesh));
  if (!is_finite(first.volume)) return refused(MeshFault::kNotFinite, "the volume is too large");
  if (std::abs(first.volume) <= first.uncertain) {
    return refused(MeshFault::kNoVolume, "the surface encloses no volume");
  }
  if (first.volume < 0) {
    return refused(MeshFault::kInverted,
                   "inverted: the volume is negative, so the triangles show their inside; turn "
                   "the triangles round");
  }
  MeshMass answer;
  answer.volume = first.volume;
  answer.area = first.area;
  const Mat3<double> C = second_moments(mesh, first.center);
  answer.properties.mass = density * first.volume;
  answer.properties.center_S = first.center;
  answer.properties.inertia_S = density * (C.trace() * Mat3<double>::Identity() - C);
  return checked(answer);
}

MeshMass with_mass(const MeshMass& of_mesh, double mass) {
  const double factor = mass / of_mesh.properties.mass;
  if (!is_positive(factor)) {
    return refused(MeshFault::kInvalidDensity, "the mass is not a number above 0, or out of range");
  }
  MeshMass answer = of_mesh;
  answer.properties.mass = mass;
  answer.properties.inertia_S *= factor;
  return checked(answer);
}

}  // namespace batuta::mesh
