// SPDX-License-Identifier: MIT
// batuta-mass: mass properties of a modelled weapon.

#include <cmath>
#include <cstdio>
#include <exception>

#include "batuta/mechanics/compound.hpp"
#include "programs/files/output_file.hpp"
#include "programs/files/standard_output.hpp"
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

/// Whether the body that the printed lines make is one: nothing of it is beyond float, which
/// make_body() would take for fixed, or so small that its inverse is.
bool fits_float(const MassProperties<double>& mass) {
  const PrincipalFrame<double> frame = batuta::detail::settled_frame(mass);
  const Pose<float> X_SB = {frame.center_S.cast<float>(), frame.q_SB.cast<float>()};
  const Mat3<float> inertia = mass.inertia_S.cast<float>();
  const Vec3<float> moments = frame.moments.cast<float>();
  const auto kilograms = static_cast<float>(mass.mass);
  return std::isfinite(kilograms) && moments.allFinite() && inertia.allFinite() &&
         make_body<float>(X_SB, kilograms, moments).ok();
}

int run(const Options& options) {
  const std::string clash = batuta::host::clash_of({{"the mesh's name", options.file}}, {});
  if (!clash.empty()) return complain(kExitUsage, clash);
  OpenedMesh opened = open_mesh(options.file);
  const std::string& problem = opened.file.error;
  if (!opened.readable) return complain(kExitUsage, options.file + ": " + problem);
  if (!opened.file.ok()) return complain(kExitRefused, options.file + ": " + problem);

  Mesh& mesh = opened.file.mesh;
  for (Vec3<double>& vertex : mesh.vertices) vertex *= options.scale;  // Bound: vertices
  const MeshMass mass = mass_of(mesh, options);
  if (!mass.ok()) return complain(kExitRefused, options.file + ": " + mass.text);

  if (!fits_float(mass.properties)) {
    return complain(kExitRefused,
                    options.file + ": too large or too small for a body of floats (--scale?)");
  }
  if (options.json) {
    print_json(stdout, mesh, mass);
  } else {
    print_text(stdout, mesh, mass);
  }
  return kExitOk;
}

int run_program(int count, char** words) {
  try {
    const auto line = read_command_line(count, words);
    return line.run ? run(line.options) : line.exit_code;
  } catch (const std::exception& problem) {
    return complain(kExitRefused, problem.what());
  }
}

}  // namespace
}  // namespace batuta::mesh

int main(int count, char** words) {
  batuta::host::begin_output();
  return batuta::host::finish_output("batuta-mass", batuta::mesh::run_program(count, words));
}
