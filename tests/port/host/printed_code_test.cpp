// SPDX-License-Identifier: MIT
// What batuta-mass prints to be pasted, pasted.
#include <gtest/gtest.h>

#include "batuta/mechanics/compound.hpp"
#include "programs/mass/mesh_file.hpp"
#include "programs/mass/mesh_mass.hpp"

namespace {

#include "guard.inc"

TEST(PrintedCode, IsTheBodyOfTheMesh) {
  batuta::mesh::Mesh mesh = batuta::mesh::open_mesh(BATUTA_GUARD_MESH).file.mesh;
  for (auto& vertex : mesh.vertices) vertex *= 1e-3;
  const batuta::mesh::MeshMass truth = batuta::mesh::mass_of_mesh(mesh, 7850);
  ASSERT_TRUE(truth.ok()) << truth.text;
  const double u = batuta::kRoundOff<float>;
  const batuta::Mat3<double>& I = truth.properties.inertia_S;
  EXPECT_NEAR(static_cast<double>(mass.mass) / truth.properties.mass, 1, 2 * u);
  EXPECT_LE((mass.center_S.cast<double>() - truth.properties.center_S).norm(), 2 * u);
  EXPECT_LE((mass.inertia_S.cast<double>() - I).cwiseAbs().maxCoeff(), 2 * u * I.maxCoeff());

  ASSERT_TRUE(body.ok());
  const batuta::Mat3<float> inverse = batuta::detail::inverse_inertia_W(body.value);
  const batuta::Mat3<double> one = inverse.cast<double>() * I;
  EXPECT_LE((one - batuta::Mat3<double>::Identity()).cwiseAbs().maxCoeff(), 200 * u);

  const batuta::Capsule<float> bar = {{{0.005F, 0.005F, 0.005F}, {0.085F, 0.005F, 0.005F}}, 0.005F};
  const auto same = batuta::make_compound(mass, {bar}, {});
  ASSERT_TRUE(same.ok());
  EXPECT_LE((same.value.body.X_WB.p_W - body.value.X_WB.p_W).norm(), 1e-7F);
  EXPECT_LE((batuta::detail::inverse_inertia_W(same.value.body) - inverse).cwiseAbs().maxCoeff(),
            200 * batuta::kRoundOff<float> * inverse.maxCoeff());
}

}  // namespace
