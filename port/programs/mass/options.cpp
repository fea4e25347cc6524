// SPDX-License-Identifier: MIT
#include "programs/mass/options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

namespace batuta::mesh {
namespace {

constexpr const char* kAbout =
    "Mass, centre and inertia of the solid inside a closed triangle mesh.";

constexpr const char* kFooter =
    R"(FILE is a Wavefront OBJ (.obj) or an STL, ASCII or binary (.stl). Its surface must be closed,
with the corners of each triangle counter-clockwise when seen from outside. Density is the same
throughout. The frame is that of the file; --scale 0.001 for a file in millimetres.

Printed are SI units, the inertia about the centre, the principal moments with their axes as a
quaternion q_SB (w x y z, turns components along the axes into those of the file), and the lines
of C++ that make the body. With --json the same as one object on one line, without the C++.

Exit codes: 0; 1 the mesh is refused (a bad line, a hole, triangles turned round ...), or the
            output cannot be written; 2 wrong usage, or a file that cannot be read)";

std::string positive_number(const std::string& words) {
  double value = 0;
  const bool number = CLI::detail::lexical_cast(words, value);
  return number && std::isfinite(value) && value > 0 ? "" : words + " is not a number above 0";
}

void declare(CLI::App& app, Options& options) {
  app.add_option("FILE", options.file, "the mesh")->required();
  CLI::Option* density = app.add_option("--density", options.density, "kg/m^3; steel by default")
                             ->type_name("KG_M3")
                             ->check(positive_number)
                             ->capture_default_str();
  app.add_option("--mass", options.mass, "what the whole weighs, in place of a density")
      ->type_name("KG")
      ->check(positive_number)
      ->excludes(density);
  app.add_option("--scale", options.scale, "length of one unit of the file")
      ->type_name("METRES_PER_UNIT")
      ->check(positive_number)
      ->capture_default_str();
  app.add_flag("--json", options.json, "print one JSON object");
  app.footer(kFooter);
}

}  // namespace

CommandLine read_command_line(int count, char** words) {
  CommandLine line;
  CLI::App app(kAbout, "batuta-mass");
  app.allow_windows_style_options(false);  // a word that begins with / is a path
  declare(app, line.options);
  try {
    app.parse(count, words);
    line.run = true;
  } catch (const CLI::ParseError& stop) {
    if (stop.get_exit_code() == 0) {
      line.exit_code = app.exit(stop);  // --help
    } else {
      std::fprintf(stderr, "batuta-mass: %s (--help tells more)\n", stop.what());
      line.exit_code = kExitUsage;
    }
  }
  return line;
}

}  // namespace batuta::mesh
