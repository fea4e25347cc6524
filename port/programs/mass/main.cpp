// SPDX-License-Identifier: MIT
// batuta-mass: mass properties of a modelled weapon.

#include <cstdio>
#include <exception>

#include "programs/mass/mesh_file.hpp"
#include "programs/mass/options.hpp"
#include "programs/mass/report.hpp"

namespace batuta::mesh {
namespace {

int complain(int exit_code, const std::string& what) {
  std::fprintf(stderr, "batuta-mass: %s\n", what.c_str());
  return exit_code;
}

MeshMass mass_of(const Mesh& mesh, const Options& options) {
  const MeshMass of_mesh = mass_of_mesh(mesh, options.density);
  return options.mass && of_mesh.ok() ? with_mass(of_mesh, *options.mass) : of_mesh;
}

int run(const Options& options) {
  OpenedMesh opened = open_mesh(options.file);
  const std::string& problem = opened.file.error;
  if (!opened.readable) return complain(kExitUsage, options.file + ": " + problem);
  if (!opened.file.ok()) return complain(kExitRefused, options.file + ": " + problem);

  Mesh& mesh = opened.file.mesh;
  for (Vec3<double>& vertex : mesh.vertices) vertex *= options.scale;  // Bound: vertices
  const MeshMass mass = mass_of(mesh, options);
  if (!mass.ok()) return complain(kExitRefused, options.file + ": " + mass.text);

  if (options.json) {
    print_json(stdout, mesh, mass);
  } else {
    print_text(stdout, mesh, mass);
  }
  const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  return written ? kExitOk : complain(kExitRefused, "the output cannot be written");
}

}  // namespace
}  // namespace batuta::mesh

int main(int count, char** words) {
  try {
    const auto line = batuta::mesh::read_command_line(count, words);
    return line.run ? batuta::mesh::run(line.options) : line.exit_code;
  } catch (const std::exception& problem) {
    return batuta::mesh::complain(batuta::mesh::kExitRefused, problem.what());
  }
}
