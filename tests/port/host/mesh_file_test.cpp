// SPDX-License-Identifier: MIT
#include "programs/mass/mesh_file.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <fstream>
#include <random>

#include "meshes.hpp"
#include "programs/mass/words.hpp"

namespace batuta::mesh {
namespace {

using ::testing::HasSubstr;

std::string lines(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& line : all) text += line + '\n';
  return text;
}

constexpr const char* kFourCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

std::string obj_of(const Mesh& mesh) {
  std::string text;
  for (const Vec3<double>& x : mesh.vertices) {
    text += "v " + std::to_string(x.x()) + ' ' + std::to_string(x.y()) + ' ' +
            std::to_string(x.z()) + '\n';
  }
  for (const auto [a, b, c] : mesh.triangles) {
    text += "f " + std::to_string(a + 1) + ' ' + std::to_string(b + 1) + ' ' +
            std::to_string(c + 1) + '\n';
  }
  return text;
}

std::string ascii_stl_of(const Mesh& mesh) {
  std::string text = "solid of the test\n";
  for (const Triangle& triangle : mesh.triangles) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const std::uint32_t corner : triangle) {
      const Vec3<double>& x = mesh.vertices[corner];
      text += "  vertex " + std::to_string(x.x()) + ' ' + std::to_string(x.y()) + ' ' +
              std::to_string(x.z()) + '\n';
    }
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid of the test\n";
}

void append(std::string& bytes, float x) {
  std::uint32_t word = 0;
  std::memcpy(&word, &x, sizeof word);
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>((word >> (8 * i)) & 0xFFU);
}

std::string binary_stl_of(const Mesh& mesh, const std::string& header = "binary") {
  std::string bytes = header;
  bytes.resize(80, ' ');
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>((count >> (8 * i)) & 0xFFU);
  for (const Triangle& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0F);
    for (const std::uint32_t corner : triangle) {
      const Vec3<float> x = mesh.vertices[corner].cast<float>();
      for (int i = 0; i < 3; ++i) append(bytes, x(i));
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

void expect_same(const MeshFile& file, const Mesh& mesh) {
  ASSERT_TRUE(file.ok()) << file.error;
  EXPECT_EQ(file.mesh.triangles.size(), mesh.triangles.size());
  const MeshMass is = mass_of_mesh(file.mesh, 1);
  const MeshMass want = mass_of_mesh(mesh, 1);
  ASSERT_TRUE(is.ok()) << is.text;
  EXPECT_NEAR(is.volume, want.volume, 1e-5 * want.volume);
  EXPECT_LE((is.properties.center_S - want.properties.center_S).norm(), 1e-5);
}

TEST(ObjFile, WrittenMesh_IsReadBack) {
  expect_same(read_obj(obj_of(samples::ball(2))), samples::ball(2));
}

TEST(ObjFile, AllFormsOfCornersAndLines_AreRead) {
  const MeshFile file = read_obj(lines(
      {"# a comment", "mtllib a.mtl", "o body", "v 0 0 0", "v +1.5e0 0 0 1.0",
       "v\t0 1 0 0.1 0.2 0.3\r", "v 0 0 1", "vt 0 0", "vn 0 0 1", "g part", "usemtl steel", "s off",
       "", "f 1 2 3 # behind", "f 1/1 2/1 4/1", "f 2//1 3//1 4//1", "f -4/1/1 -2/-1/-1 -1"}));
  ASSERT_TRUE(file.ok()) << file.error;
  EXPECT_THAT(file.mesh.triangles, ::testing::ElementsAre(Triangle{0, 1, 2}, Triangle{0, 1, 3},
                                                          Triangle{1, 2, 3}, Triangle{0, 2, 3}));
  ASSERT_EQ(file.mesh.vertices.size(), 4U);
  EXPECT_EQ(file.mesh.vertices[1], Vec3<double>(1.5, 0, 0));
  EXPECT_EQ(file.mesh.vertices[2], Vec3<double>(0, 1, 0));
}

TEST(ObjFile, Polygons_BecomeFans) {
  const MeshFile file = read_obj(
      lines({"v 0 0 0", "v 2 0 0", "v 2 2 0", "v 0 2 0", "v 0 0 1", "v 2 0 1", "v 2 2 1", "v 0 2 1",
             "f 1 4 3 2", "f 5 6 7 8", "f 1 2 6 5", "f 2 3 7 6", "f 3 4 8 7", "f 4 1 5 8"}));
  expect_same(file, samples::box(2, 2, 1));
}

TEST(ObjFile, BadLines_AreRefusedWithNumberAndReason) {
  const std::vector<std::pair<const char*, const char*>> bad = {
      {"v 1 2", "has 3 coordinates; here are 2"},
      {"v 1 2 3 4 5", "here are 5"},
      {"v 1 2 x", "'x' is not a finite number"},
      {"v 1 2 nan", "'nan' is not"},
      {"v 1 inf 2", "'inf' is not"},
      {"v 1 2 1e999", "'1e999' is not"},
      {"v 1 2 3z", "'3z' is not"},
      {"v 1 2 0x10", "'0x10' is not"},
      {"v 1 2 +-1", "'+-1' is not"},
      {"f 1 2", "at least 3 corners"},
      {"f 1 2 5", "no vertex 5 among the 4"},
      {"f 1 2 0", "no vertex 0"},
      {"f 1 2 -5", "no vertex -5"},
      {"f 1 2 3/", "'3/' is not a corner"},
      {"f 1 2 3//", "'3//' is not"},
      {"f 1 2 3/1/", "'3/1/' is not"},
      {"f 1 2 3/1/1/1", "'3/1/1/1' is not"},
      {"f 1 2 3/0", "'3/0' is not"},
      {"f 1 2 1.5", "'1.5' is not"},
      {"f 1 2 99999999999999999999", "is not a corner"},
      {"f 1 2 \\", "is not a corner"},
      {"curv 0 1 1 2", "unknown keyword 'curv'"},
      {"l 1 2", "unknown keyword 'l'"},
      {"\x7f\x45\x4c\x46\x01", "unknown keyword '.ELF.'"},
  };
  for (const auto& [line, reason] : bad) {
    const MeshFile file = read_obj(std::string(kFourCorners) + line + "\nf 1 2 3\n");
    EXPECT_THAT(file.error, HasSubstr("line 5: ")) << line;
    EXPECT_THAT(file.error, HasSubstr(reason)) << line;
    EXPECT_TRUE(file.mesh.triangles.empty());
  }
}

TEST(ObjFile, LineWithoutEnd_IsRefused) {
  std::string text = std::string(kFourCorners) + "f";
  for (std::size_t i = 0; i < 2 * kMostWords; ++i) text += " 1";
  EXPECT_EQ(read_obj(text).error, "line 5: more than 4096 words");
}

TEST(ObjFile, NothingInIt_IsAMeshOfNothing) {
  EXPECT_TRUE(read_obj("").ok());
  EXPECT_EQ(mass_of_mesh(read_obj("").mesh, 1).fault, MeshFault::kTooFewTriangles);
}

TEST(StlFile, WrittenMeshes_AreReadBackAndWelded) {
  const Mesh ball = samples::ball(2);
  for (const std::string& text : {ascii_stl_of(ball), binary_stl_of(ball)}) {
    const MeshFile file = read_stl(text);
    expect_same(file, ball);
    EXPECT_EQ(file.mesh.vertices.size(), ball.vertices.size());
  }
}

TEST(StlFile, BinaryThatBeginsWithSolid_IsBinary) {
  expect_same(read_stl(binary_stl_of(samples::ball(1), "solid made by a CAD program")),
              samples::ball(1));
}

TEST(StlFile, NegativeZero_IsZero) {
  Mesh mesh = samples::tetrahedron();
  std::string text = ascii_stl_of(mesh);
  text.replace(text.find("vertex 0.0"), 10, "vertex -0.0");
  const MeshFile file = read_stl(text);
  ASSERT_TRUE(file.ok()) << file.error;
  EXPECT_EQ(file.mesh.vertices.size(), 4U);
}

TEST(StlFile, EveryTruncationOfABinary_IsRefused) {
  const std::string whole = binary_stl_of(samples::tetrahedron());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(read_stl(whole.substr(0, size)).ok()) << size;
  }
  EXPECT_THAT(read_stl(whole.substr(0, 200)).error,
              HasSubstr("4 triangles take 284 bytes, and it has 200"));
  EXPECT_FALSE(read_stl(whole + '\0').ok());
}

TEST(StlFile, EveryTruncationOfAnAscii_IsRefused) {
  const std::string whole = ascii_stl_of(samples::tetrahedron());
  const std::size_t needed = whole.find("endsolid") + 8;
  for (std::size_t size = 0; size < needed; ++size) {
    EXPECT_FALSE(read_stl(whole.substr(0, size)).ok()) << size;
  }
  EXPECT_THAT(read_stl(whole.substr(0, whole.find("endsolid"))).error,
              HasSubstr("line 29: the file ends before endsolid"));
}

TEST(StlFile, Garbage_IsRefused) {
  std::mt19937 bits(11);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes(bits() % 400, '\0');
    for (char& byte : bytes) byte = static_cast<char>(bits());
    if (i % 2 == 0) bytes = "solid " + bytes;
    EXPECT_FALSE(read_stl(bytes).ok());
  }
  // A count that would take 200 GB is not believed.
  std::string vast = binary_stl_of(samples::tetrahedron());
  for (std::size_t i = 80; i < 84; ++i) vast[i] = '\xff';
  EXPECT_THAT(read_stl(vast).error, HasSubstr("4294967295 triangles take 214748364834 bytes"));
}

TEST(StlFile, CoordinateThatIsNotFinite_IsRefused) {
  Mesh mesh = samples::tetrahedron();
  mesh.vertices[3].z() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(read_stl(binary_stl_of(mesh)).error, "triangle 2: a coordinate is not finite");
}

TEST(StlFile, BadLines_AreRefusedWithNumberAndReason) {
  const std::string good = ascii_stl_of(samples::tetrahedron());
  const std::vector<std::array<const char*, 3>> bad = {{
      {"facet normal 0 0 0", "facet normal 0 0", "line 2: expected: facet normal X Y Z"},
      {"facet normal 0 0 0", "facet normal 0 0 x", "line 2: expected: facet"},
      {" outer loop", " outer", "line 3: expected: outer loop"},
      {"  vertex 0.000000 0.000000 0.000000", "  vertex 0 0", "line 4: expected: vertex X Y Z"},
      {"  vertex 0.000000 0.000000 0.000000", "  vertex 0 0 nan", "line 4: expected: vertex"},
      {"  vertex 0.000000 0.000000 0.000000", " endloop", "line 4: expected: vertex"},
      {" endloop", "  vertex 1 1 1", "line 7: expected: endloop"},
      {"endfacet", "", "line 9: expected: endfacet"},
      {"endsolid of the test\n", "endsolid\nsolid b\n", "line 31: the solid has ended"},
  }};
  for (const auto& [from, to, error] : bad) {
    std::string text = good;
    text.replace(text.find(from), std::strlen(from), to);
    EXPECT_THAT(read_stl(text).error, HasSubstr(error));
  }
}

class FileOnDisk : public ::testing::Test {
 protected:
  std::string path(const std::string& name) { return ::testing::TempDir() + "batuta_mesh_" + name; }
  std::string write(const std::string& name, const std::string& bytes) {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }
};

TEST_F(FileOnDisk, EndingOfTheName_ChoosesTheReader) {
  const Mesh box = samples::box(1, 2, 3);
  expect_same(open_mesh(write("a.obj", obj_of(box))).file, box);
  expect_same(open_mesh(write("b.STL", ascii_stl_of(box))).file, box);
  expect_same(open_mesh(write("c.stl", binary_stl_of(box))).file, box);
  const OpenedMesh other = open_mesh(write("d.ply", obj_of(box)));
  EXPECT_FALSE(other.readable);
  EXPECT_THAT(other.file.error, HasSubstr(".obj or .stl"));
}

TEST_F(FileOnDisk, WhatCannotBeRead_IsTold) {
  const OpenedMesh none = open_mesh(path("none.obj"));
  EXPECT_FALSE(none.readable);
  EXPECT_THAT(none.file.error, HasSubstr("No such file"));
  const OpenedMesh bad = open_mesh(write("bad.obj", "v 1 2\n"));
  EXPECT_TRUE(bad.readable);
  EXPECT_THAT(bad.file.error, HasSubstr("line 1: "));
}

}  // namespace
}  // namespace batuta::mesh
