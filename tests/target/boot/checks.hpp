// SPDX-License-Identifier: MIT
#pragma once
// Checks of a program that has no test framework: what fails is written and counted.

#include "platforms/cortex_m/semihosting.hpp"

class Checks {
 public:
  void that(bool holds, const char* what) {
    ++made_;
    if (holds) return;
    ++failed_;
    batuta::semihosting::write("fails: ");
    batuta::semihosting::write(what);
    batuta::semihosting::write("\n");
  }

  /// Ends the program: 0 where checks were made and all hold, else 1.
  [[noreturn]] void end() const {
    batuta::semihosting::write_unsigned(made_);
    batuta::semihosting::write(" checks, failed: ");
    batuta::semihosting::write_unsigned(failed_);
    batuta::semihosting::write("\n");
    batuta::semihosting::exit(made_ > 0 && failed_ == 0 ? 0 : 1);
  }

 private:
  std::uint32_t made_ = 0;
  std::uint32_t failed_ = 0;
};
