// SPDX-License-Identifier: MIT
// The port that does nothing keeps the contract.

#include "contract_suite.hpp"
#include "template_rigs.hpp"

namespace batuta::test {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(Template, InputContract, ::testing::Types<TemplateStick>);
INSTANTIATE_TYPED_TEST_SUITE_P(Template, ClockContract, ::testing::Types<TemplateTime>);
INSTANTIATE_TYPED_TEST_SUITE_P(Template, ForceContract, ::testing::Types<TemplateMotor>);

}  // namespace
}  // namespace batuta::test
