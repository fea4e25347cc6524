// SPDX-License-Identifier: MIT
#include "programs/mass/report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "batuta/mechanics/compound.hpp"

namespace batuta::mesh {
namespace {

/// A format of one number, and what stands between two of them.
struct Style {
  const char* format;
  const char* between;
};
constexpr Style kText = {"%.10g", "  "};
constexpr Style kCode = {"%#.9gF", ", "};  // with a point always, so that F may follow

/// Rows follow each other; +0.0 turns -0 into 0.
template <class Derived>
void print(std::FILE* out, const Style& style, const Eigen::MatrixBase<Derived>& numbers) {
  for (int i = 0; i < numbers.rows(); ++i) {    // Bound: 3 rows, 4 of a quaternion
    for (int j = 0; j < numbers.cols(); ++j) {  // Bound: 3 columns
      if (i + j > 0) std::fputs(style.between, out);
      std::fprintf(out, style.format, numbers(i, j) + 0.0);
    }
  }
}

/// A line of the text: name, numbers, unit.
template <class Derived>
void print_line(std::FILE* out, const char* name, const Eigen::MatrixBase<Derived>& numbers,
                const char* unit) {
  std::fprintf(out, "%-9s", name);
  print(out, kText, numbers);
  std::fprintf(out, "  %s\n", unit);
}

void print_line(std::FILE* out, const char* name, double number, const char* unit) {
  print_line(out, name, Eigen::Matrix<double, 1, 1>(number), unit);
}

Eigen::Vector4d wxyz(const Quat<double>& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

/// What rounding leaves of a zero, relative to the largest number beside it: principal_frame() errs
/// by up to 24 u, sums over the mesh by less.
constexpr double kNoise = 32 * kRoundOff<double>;

/// The same numbers for people, who take 1e-19 for something.
template <class Numbers>
Numbers without_noise(Numbers numbers) {
  const double least = kNoise * numbers.cwiseAbs().maxCoeff();
  for (int i = 0; i < numbers.size(); ++i) {  // Bound: 9 numbers
    double& number = numbers.data()[i];
    if (std::abs(number) <= least) number = 0;
  }
  return numbers;
}

void print_code(std::FILE* out, const MassProperties<double>& mass,
                const PrincipalFrame<double>& frame) {
  const Eigen::Matrix<double, 1, 1> kilograms(mass.mass);
  std::fputs(
      "\n// Frame S is that of the file; SI units.\n"
      "const batuta::MassProperties<float> mass = {\n    ",
      out);
  print(out, kCode, kilograms);
  std::fputs(",\n    {", out);
  print(out, kCode, mass.center_S);
  std::fputs("},\n    (batuta::Mat3<float>() <<\n     ", out);
  for (int i = 0; i < 3; ++i) {  // Bound: 3 rows
    if (i > 0) std::fputs(",\n     ", out);
    print(out, kCode, mass.inertia_S.row(i));
  }
  std::fputs(
      ").finished()};\n"
      "// The body where it was modelled; make_compound(mass, capsules_S, X_WS) puts it\n"
      "// elsewhere, with the capsules that stand for it.\n"
      "const auto body = batuta::make_body<float>(\n    {{",
      out);
  print(out, kCode, frame.center_S);
  std::fputs("},\n     {", out);
  print(out, kCode, without_noise(wxyz(frame.q_SB)));
  std::fputs("}},\n    ", out);
  print(out, kCode, kilograms);
  std::fputs(",\n    {", out);
  print(out, kCode, frame.moments);
  std::fputs("});\n", out);
}

template <class Derived>
std::vector<double> array_of(const Eigen::MatrixBase<Derived>& numbers) {
  std::vector<double> array;
  array.reserve(static_cast<std::size_t>(numbers.size()));
  for (int i = 0; i < numbers.size(); ++i) {  // Bound: 4 numbers
    array.push_back(numbers[i] + 0.0);
  }
  return array;
}

}  // namespace

void print_text(std::FILE* out, const Mesh& mesh, const MeshMass& mass) {
  MassProperties<double> properties = mass.properties;
  properties.inertia_S = without_noise(properties.inertia_S);
  const PrincipalFrame<double> frame = batuta::detail::settled_frame(properties);
  std::fprintf(out, "mesh     %zu triangles, %zu vertices\n", mesh.triangles.size(),
               mesh.vertices.size());
  print_line(out, "density", properties.mass / mass.volume, "kg/m^3");
  print_line(out, "mass", properties.mass, "kg");
  print_line(out, "volume", mass.volume, "m^3");
  print_line(out, "area", mass.area, "m^2");
  print_line(out, "centre", properties.center_S.transpose(), "m");
  print_line(out, "inertia", properties.inertia_S.row(0), "kg m^2, about the centre");
  print_line(out, "", properties.inertia_S.row(1), "");
  print_line(out, "", properties.inertia_S.row(2), "");
  print_line(out, "moments", frame.moments.transpose(), "kg m^2, about the principal axes");
  print_line(out, "axes", without_noise(wxyz(frame.q_SB)).transpose(), "q_SB (w x y z)");
  print_code(out, properties, frame);
}

void print_json(std::FILE* out, const Mesh& mesh, const MeshMass& mass) {
  const MassProperties<double>& properties = mass.properties;
  const PrincipalFrame<double> frame = batuta::detail::settled_frame(properties);
  const Mat3<double>& inertia_S = properties.inertia_S;
  const nlohmann::ordered_json told = {
      {"triangles", mesh.triangles.size()},
      {"vertices", mesh.vertices.size()},
      {"density", properties.mass / mass.volume},
      {"mass", properties.mass},
      {"volume", mass.volume},
      {"area", mass.area},
      {"center", array_of(properties.center_S)},
      {"moments", array_of(frame.moments)},
      {"axes", array_of(wxyz(frame.q_SB))},
      {"inertia",
       {array_of(inertia_S.row(0)), array_of(inertia_S.row(1)), array_of(inertia_S.row(2))}},
  };
  std::fprintf(out, "%s\n", told.dump().c_str());
}

}  // namespace batuta::mesh
