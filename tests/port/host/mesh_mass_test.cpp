// SPDX-License-Identifier: MIT
#include "programs/mass/mesh_mass.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <random>

#include "batuta/mechanics/rotation.hpp"
#include "meshes.hpp"

namespace batuta::mesh {
namespace {

using ::testing::HasSubstr;

constexpr double kPi = 0x1.921fb54442d18p+1;
constexpr double kRounding = 64 * kRoundOff<double>;

double error_of(const Mat3<double>& is, const Mat3<double>& want) {
  return (is - want).cwiseAbs().maxCoeff() / want.cwiseAbs().maxCoeff();
}

void expect_agreement(const Mesh& mesh, const Vec3<double>& inside, double bound) {
  const samples::Quadrature truth(mesh, inside);
  const MeshMass is = mass_of_mesh(mesh, 3);
  ASSERT_TRUE(is.ok()) << is.text;
  const auto volume = static_cast<double>(truth.volume);
  EXPECT_NEAR(is.volume, volume, bound * volume);
  EXPECT_NEAR(is.properties.mass, 3 * volume, bound * 3 * volume);
  EXPECT_LE((is.properties.center_S - truth.center.cast<double>()).norm(), bound);
  EXPECT_LE(error_of(is.properties.inertia_S, 3 * truth.inertia.cast<double>()), bound);
}

TEST(MeshMass, Box_IsTheTextbookBox) {
  const MeshMass box = mass_of_mesh(samples::box(1, 2, 4), 2);
  ASSERT_TRUE(box.ok()) << box.text;
  EXPECT_NEAR(box.volume, 8, 8 * kRounding);
  EXPECT_NEAR(box.area, 28, 28 * kRounding);
  EXPECT_NEAR(box.properties.mass, 16, 16 * kRounding);
  EXPECT_LE((box.properties.center_S - Vec3<double>(0.5, 1, 2)).norm(), kRounding);
  const Vec3<double> moments(16.0 / 12 * (4 + 16), 16.0 / 12 * (1 + 16), 16.0 / 12 * (1 + 4));
  EXPECT_LE(error_of(box.properties.inertia_S, moments.asDiagonal()), kRounding);
}

TEST(MeshMass, Tetrahedron_HasItsExactTensor) {
  const MeshMass is = mass_of_mesh(samples::tetrahedron(), 1);
  ASSERT_TRUE(is.ok()) << is.text;
  EXPECT_NEAR(is.volume, 1.0 / 6, kRounding / 6);
  EXPECT_NEAR(is.area, 1.5 + std::sqrt(0.75), 3 * kRounding);
  EXPECT_LE((is.properties.center_S - Vec3<double>::Constant(0.25)).norm(), kRounding);
  // Integral of x^2: 1/60, of x y: 1/120; less volume times 1/16: 1/160 and -1/480.
  const Mat3<double> truth =
      Mat3<double>::Constant(1.0 / 480) + Mat3<double>::Identity() * (2.0 / 160 - 1.0 / 480);
  EXPECT_LE(error_of(is.properties.inertia_S, truth), kRounding);
}

TEST(MeshMass, DentedBalls_AgreeWithTheQuadrature) {
  std::mt19937 bits(7);
  for (int i = 0; i < 20; ++i) {
    Mesh mesh = samples::ball(3);
    for (Vec3<double>& x : mesh.vertices) x *= 0.2 + static_cast<double>(bits() >> 12) * 0x1p-20;
    expect_agreement(mesh, {0, 0, 0}, kRounding);
    expect_agreement(samples::moved(mesh, {1, -2, 3}), {1, -2, 3}, kRounding);
  }
}

TEST(MeshMass, Balls_ConvergeAtSecondOrderToTheSphere) {
  const double volume = 4 * kPi / 3;
  const double moment = 2.0 / 5 * volume;
  double last_volume = 0;
  double last_moment = 0;
  for (int levels = 2; levels <= 6; ++levels) {
    const MeshMass is = mass_of_mesh(samples::ball(levels), 1);
    ASSERT_TRUE(is.ok()) << is.text;
    const double missing_volume = volume - is.volume;
    const double missing_moment = moment - is.properties.inertia_S(0, 0);
    if (levels > 2) {
      EXPECT_NEAR(last_volume / missing_volume, 4, 0.25) << levels;
      EXPECT_NEAR(last_moment / missing_moment, 4, 0.35) << levels;
    }
    last_volume = missing_volume;
    last_moment = missing_moment;
    EXPECT_LE(is.properties.center_S.norm(), kRounding);
  }
  EXPECT_LT(last_volume / volume, 1e-3);
}

TEST(MeshMass, CapsuleMesh_ConvergesToTheSolidCapsule) {
  const Capsule<double> shape = {{{0, 0, 0}, {0, 0, 0.9}}, 0.25};
  const auto truth = solid_capsule(shape, 7850.0).value;
  double last = 0;
  for (int levels = 3; levels <= 6; ++levels) {
    const MeshMass is = mass_of_mesh(samples::capsule(levels, 0.25, 0.9), 7850);
    ASSERT_TRUE(is.ok()) << is.text;
    EXPECT_LE((is.properties.center_S - truth.center_S).norm(), kRounding);
    const double error = error_of(is.properties.inertia_S, truth.inertia_S);
    if (levels > 3) {
      EXPECT_NEAR(last / error, 4, 0.2) << levels;
    }
    last = error;
    EXPECT_NEAR(is.properties.mass / truth.mass, 1, error * 2);
  }
  EXPECT_LT(last, 1e-3);
}

TEST(MeshMass, FarFromItsOrigin_LosesNoDigits) {
  // Coordinates that are exact near and far, so that the two solids are the same.
  const Mesh near = samples::box(0.25, 0.5, 0.0625);
  const MeshMass truth = mass_of_mesh(near, 1000);
  const Vec3<double> far(1e4, -1e4, 1e4);
  const MeshMass is = mass_of_mesh(samples::moved(near, far), 1000);
  ASSERT_TRUE(is.ok()) << is.text;
  EXPECT_NEAR(is.volume / truth.volume, 1, kRounding);
  EXPECT_LE(error_of(is.properties.inertia_S, truth.properties.inertia_S), kRounding);
  EXPECT_LE((is.properties.center_S - far - truth.properties.center_S).norm(),
            1e4 * 4 * kRoundOff<double>);
}

TEST(MeshMass, Cavity_IsLeftOut) {
  const Mesh hole = samples::moved(samples::box(1, 1, 1), {0.5, 0.5, 0.5});
  const Mesh hollow = samples::together(samples::box(2, 2, 2), samples::turned_round(hole));
  const MeshMass is = mass_of_mesh(hollow, 1);
  ASSERT_TRUE(is.ok()) << is.text;
  EXPECT_NEAR(is.volume, 7, 7 * kRounding);
  const Mat3<double> truth = Mat3<double>::Identity() * (8 * 8.0 / 12 - 2.0 / 12);
  EXPECT_LE(error_of(is.properties.inertia_S, truth), kRounding);
}

TEST(MeshMass, WithMass_ScalesTheInertiaAlone) {
  const MeshMass of_water = mass_of_mesh(samples::box(1, 2, 4), 1000);
  const MeshMass is = with_mass(of_water, 16);
  ASSERT_TRUE(is.ok());
  const MeshMass truth = mass_of_mesh(samples::box(1, 2, 4), 2);
  EXPECT_EQ(is.properties.mass, 16);
  EXPECT_EQ(is.volume, truth.volume);
  EXPECT_LE(error_of(is.properties.inertia_S, truth.properties.inertia_S), kRounding);
  for (const double mass : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(with_mass(of_water, mass).fault, MeshFault::kInvalidDensity);
  }
}

/// The fault of a mesh, whose text must hold the given part.
MeshFault fault_of(const Mesh& mesh, const char* part) {
  const MeshMass is = mass_of_mesh(mesh, 1);
  EXPECT_THAT(is.text, HasSubstr(part));
  EXPECT_EQ(is.properties.mass, 0) << "nothing that could be used by mistake";
  return is.fault;
}

TEST(MeshMass, Density_IsPositiveAndFinite) {
  using Limits = std::numeric_limits<double>;
  for (const double density : {0.0, -1.0, Limits::infinity(), Limits::quiet_NaN()}) {
    EXPECT_EQ(mass_of_mesh(samples::tetrahedron(), density).fault, MeshFault::kInvalidDensity);
  }
}

TEST(MeshMass, TooFewTriangles_AreRefused) {
  EXPECT_EQ(fault_of({}, "0 triangles"), MeshFault::kTooFewTriangles);
  Mesh mesh = samples::tetrahedron();
  mesh.triangles.pop_back();
  EXPECT_EQ(fault_of(mesh, "3 triangles"), MeshFault::kTooFewTriangles);
}

TEST(MeshMass, Hole_IsRefusedWithItsEdge) {
  Mesh mesh = samples::box(1, 1, 1);
  mesh.triangles.erase(mesh.triangles.begin() + 2);  // 4 5 6, so that 5 remains beside 6
  EXPECT_EQ(fault_of(mesh,
                     "open: the edge from vertex 5 (0 0 1) to vertex 6 (1 0 1) belongs to "
                     "triangle 5 only"),
            MeshFault::kOpen);
}

TEST(MeshMass, TriangleTurnedRound_IsRefused) {
  Mesh mesh = samples::box(1, 1, 1);
  std::swap(mesh.triangles[3][1], mesh.triangles[3][2]);
  EXPECT_EQ(fault_of(mesh, "and triangle 4 go the same way along the edge from vertex 5"),
            MeshFault::kInconsistent);
}

TEST(MeshMass, EdgeOfManyTriangles_IsRefused) {
  // Two tetrahedra that share an edge, and so its two vertices.
  Mesh mesh = samples::tetrahedron();
  mesh.vertices.push_back({0.5, -1, 0});
  mesh.vertices.push_back({0.5, -1, -1});
  for (const Triangle t : {Triangle{0, 1, 4}, {0, 4, 5}, {0, 5, 1}, {1, 5, 4}}) {
    mesh.triangles.push_back(t);
  }
  EXPECT_EQ(fault_of(mesh, "vertex 1 (0 0 0) to vertex 2 (1 0 0) belongs to 4 triangles"),
            MeshFault::kNonManifold);
}

TEST(MeshMass, InsideOut_IsRefusedWithTheCure) {
  EXPECT_EQ(fault_of(samples::turned_round(samples::box(1, 2, 3)), "turn the triangles round"),
            MeshFault::kInverted);
}

TEST(MeshMass, FlatSurface_EnclosesNothing) {
  // Both sides of a sheet that lies askew in space: closed, without volume.
  Mesh sheet = samples::box(1, 1, 0);
  for (Vec3<double>& x : sheet.vertices) x = {x.x() + 0.1, x.y() - x.x() / 3, x.y() / 7 + x.x()};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};
  // The diagonal belongs to four triangles: cut one side the other way.
  sheet.triangles[2] = {0, 3, 1};
  sheet.triangles[3] = {1, 3, 2};
  EXPECT_EQ(fault_of(sheet, "no volume"), MeshFault::kNoVolume);
}

TEST(MeshMass, DegenerateTriangles_AreRefused) {
  Mesh in_line = samples::box(1, 1, 1);
  in_line.vertices[2] = {0.5, 0.0, 0.0};  // between 0 and 1
  EXPECT_EQ(fault_of(in_line, "triangle 1: no area between vertex 1"),
            MeshFault::kDegenerateTriangle);
  Mesh twice = samples::box(1, 1, 1);
  twice.triangles[4] = {5, 5, 0};
  EXPECT_EQ(fault_of(twice, "triangle 5: no area"), MeshFault::kDegenerateTriangle);
  Mesh askew = samples::tetrahedron();  // in line but for rounding
  askew.vertices[1] = {0.1, 0.2, 0.3};
  askew.vertices[2] = {0.3, 0.6, 0.9};
  EXPECT_EQ(fault_of(askew, "triangle 1: no area"), MeshFault::kDegenerateTriangle);
}

TEST(MeshMass, ThinButRealTriangles_AreTaken) {
  const MeshMass blade = mass_of_mesh(samples::box(1, 1e-5, 1e-7), 1);
  ASSERT_TRUE(blade.ok()) << blade.text;
  EXPECT_NEAR(blade.volume, 1e-12, 1e-12 * kRounding);
}

TEST(MeshMass, BadNumbersAndIndices_AreRefused) {
  Mesh mesh = samples::tetrahedron();
  mesh.triangles[2][1] = 4;
  EXPECT_EQ(fault_of(mesh, "triangle 3: vertex 5 of 4"), MeshFault::kIndexOutOfRange);
  mesh = samples::tetrahedron();
  mesh.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault_of(mesh, "triangle 2: vertex 4"), MeshFault::kNotFinite);
  mesh = samples::tetrahedron();
  for (Vec3<double>& x : mesh.vertices) x *= 1e150;
  EXPECT_EQ(fault_of(mesh, "too large"), MeshFault::kNotFinite);
  for (Vec3<double>& x : mesh.vertices) x *= 1e-230;  // 1e-80: the fifth power vanishes
  EXPECT_EQ(fault_of(mesh, "too small"), MeshFault::kNotFinite);
}

TEST(MeshMass, CavityOutsideOfTheBody_IsRefused) {
  const Mesh away = samples::moved(samples::box(1, 1, 1), {9, 0, 0});
  const Mesh mesh = samples::together(samples::box(2, 2, 2), samples::turned_round(away));
  EXPECT_EQ(fault_of(mesh, "that no body has"), MeshFault::kNotABody);
}

}  // namespace
}  // namespace batuta::mesh
