// SPDX-License-Identifier: MIT
#pragma once
// The members of a contact, for record/archive.hpp.

#include "batuta/record/detail/detection.hpp"
#include "batuta/response/contact.hpp"

namespace batuta {

constexpr ContactKind last_of(ContactKind) {
  return ContactKind::kReceding;
}

template <class Scalar>
void archive(Archive& ar, Contact<Scalar>& contact) {
  auto& [point_W, normal_BA_W, gap] = contact;
  ar(point_W, normal_BA_W, gap);
}

}  // namespace batuta
