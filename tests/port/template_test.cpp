// SPDX-License-Identifier: MIT
// The port that does nothing keeps the contract.

#include "contract_suite.hpp"
#include "template/clock.hpp"
#include "template/force.hpp"
#include "template/input.hpp"

namespace batuta::test {
namespace {

struct TemplateStick {
  static constexpr bool kHasSamples = false;
  InputDevice& device() { return device_; }
  Microseconds next() { return now_ += 1000; }

 private:
  port_template::TemplateInput device_;
  Microseconds now_ = 0;
};

struct TemplateTime {
  Clock& clock() { return clock_; }

 private:
  port_template::TemplateClock clock_;
};

struct TemplateMotor {
  ForceDevice& device() { return device_; }

 private:
  port_template::TemplateForce device_;
};

INSTANTIATE_TYPED_TEST_SUITE_P(Template, InputContract, ::testing::Types<TemplateStick>);
INSTANTIATE_TYPED_TEST_SUITE_P(Template, ClockContract, ::testing::Types<TemplateTime>);
INSTANTIATE_TYPED_TEST_SUITE_P(Template, ForceContract, ::testing::Types<TemplateMotor>);

}  // namespace
}  // namespace batuta::test
