// SPDX-License-Identifier: MIT
#pragma once
// ContactGroups: between two sweeps the normal impulses of a group go on the way that the sweeps
// lead, to the least energy on that line. Derivation: src/world/world.md, "Along a line". Included
// by contact_solution.hpp.

#include <limits>

#include "batuta/world/detail/contact_groups.hpp"

namespace batuta::detail {

/// Contacts of one group, in the order in which they are visited: from the first one to before the
/// last one.
struct GroupRange {
  int first = 0;
  int last = 0;
};

/// Calls visit(point, A, B) for each point of a group. Bound: kMaxContacts, of two points.
template <class Groups, class Visit>
void for_each_point(Groups& groups, GroupRange group, const Visit& visit) {
  using SceneT = typename Groups::SceneType;
  for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
    auto& contact = groups.solved_at(k);
    auto& A = groups.solved[a_of<SceneT>(contact)];
    auto& B = groups.solved[b_of<SceneT>(contact)];
    for (int i = 0; i < contact.count; ++i) {  // Bound: 2
      visit(contact.points[static_cast<std::size_t>(i)], A, B);
    }
  }
}

/// Does something to both bodies of a contact, and adds what that changed to what is known of them.
template <class SceneT, class Change>
void watch(ContactGroups<SceneT>& groups, const LastingContactOf<SceneT>& contact,
           const Change& change) {
  using Scalar = Scalar_of<SceneT>;
  const std::array<std::size_t, 2> slots = {a_of<SceneT>(contact), b_of<SceneT>(contact)};
  std::array<Vec3<Scalar>, 4> before;
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: 2
    before[2 * i] = groups.solved[slots[i]].v_W;
    before[2 * i + 1] = groups.solved[slots[i]].w_W;
  }
  change(groups.solved[slots[0]], groups.solved[slots[1]]);
  const auto& point = contact.points[0];
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: 2
    const auto& solved = groups.solved[slots[i]];
    const Vec3<Scalar> arm_W = point.arm_A_W + (groups.solved[slots[0]].place_W - solved.place_W);
    const Scalar reach = arm_W.cwiseAbs().sum();
    groups.changes.changed[slots[i]] += (solved.v_W - before[2 * i]).cwiseAbs().sum() +
                                        reach * (solved.w_W - before[2 * i + 1]).cwiseAbs().sum();
  }
}

/// A line of impulses, and how far one may go on it.
template <class Scalar>
struct SearchLine {
  Scalar longest = std::numeric_limits<Scalar>::max();  ///< there an impulse is nothing
  Scalar room = 0;                                      ///< what a share of 1 takes of the room, J
};

/// The way that the last sweep has led, and `share` of that of the line before it. What does not
/// press has nothing to lose.
template <class SceneT>
SearchLine<Scalar_of<SceneT>> find_line(ContactGroups<SceneT>& groups, GroupRange group,
                                        Scalar_of<SceneT> share) {
  using Scalar = Scalar_of<SceneT>;
  SearchLine<Scalar> line;
  for_each_point(groups, group, [&](auto& point, const auto&, const auto&) {
    point.ahead = (point.normal - point.start) + share * point.ahead;
    if (point.ahead < Scalar(0)) {
      if (point.normal > Scalar(0)) {
        line.longest = min_of(line.longest, -point.normal / point.ahead);
      } else {
        point.ahead = 0;
      }
    }
    line.room += point.ahead * point.room;
  });
  return line;
}

/// How the energy, and that of the room, begins to change along the line, J.
template <class SceneT>
Scalar_of<SceneT> slope_of_line(const ContactGroups<SceneT>& groups, GroupRange group) {
  Scalar_of<SceneT> sum = 0;
  for_each_point(groups, group, [&sum](const auto& point, const auto& A, const auto& B) {
    sum += point.ahead * (point.normal_W.dot(velocity_across(point, A, B)) + point.room);
  });
  return sum;
}

/// Gives the bodies of a group `share` of the line.
template <class SceneT>
void push_along(ContactGroups<SceneT>& groups, GroupRange group, Scalar_of<SceneT> share) {
  using Scalar = Scalar_of<SceneT>;
  for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
    const auto& contact = groups.solved_at(k);
    watch(groups, contact, [&](SolvedBody<Scalar>& A, SolvedBody<Scalar>& B) {
      for (int i = 0; i < contact.count; ++i) {  // Bound: 2
        const auto& point = contact.points[static_cast<std::size_t>(i)];
        push_at(point, A, B, Vec3<Scalar>((share * point.ahead) * point.normal_W));
      }
    });
  }
}

/// From where the last sweep has led, on to the least energy of the line.
/// @param[in,out] led     how far the sweep before the last one has led, J; that of the last one
/// @param[in,out] energy  what was added to that of the group so far, J, <= 0
template <class SceneT>
void search_line(ContactGroups<SceneT>& groups, GroupRange group, Scalar_of<SceneT>& led,
                 Scalar_of<SceneT>& energy) {
  using Scalar = Scalar_of<SceneT>;
  Scalar now = 0;
  for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
    now += led_by_sweep(groups.solved_at(k));
  }
  const SearchLine<Scalar> line = find_line(groups, group, now < led ? now / led : Scalar(0));
  led = now;
  const Scalar slope = slope_of_line(groups, group);
  Scalar share = 0;
  if (slope < Scalar(0)) {
    push_along(groups, group, Scalar(1));
    const Scalar bend = slope_of_line(groups, group) - slope;
    if (bend > Scalar(0)) share = min_of(-slope / bend, line.longest);
    const Scalar gain = share * ((slope - line.room) + share * bend / 2);
    if (gain > Scalar(0) && energy + gain > Scalar(0)) {
      share = 0;
    } else {
      energy += gain;
    }
    push_along(groups, group, share - 1);
  }
  for_each_point(groups, group, [share](auto& point, const auto&, const auto&) {
    point.normal += share * point.ahead;
    point.start = point.normal;
  });
}

}  // namespace batuta::detail
