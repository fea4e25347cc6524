// SPDX-License-Identifier: MIT
#pragma once
// ContactGroups: between two sweeps the normal impulses of a group go on the way that the sweeps
// lead, to the least energy on that line. Derivation: src/world/world.md, "Along a line". Included
// by contact_solution.hpp.

#include <limits>

#include "batuta/world/detail/contact_groups.hpp"

namespace batuta::detail {

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
/// @param share  of the change that counts
template <class SceneT, class Change>
void watch(ContactGroups<SceneT>& groups, const LastingContactOf<SceneT>& contact,
           const Change& change, Scalar_of<SceneT> share = 1) {
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
    const Scalar moved = (solved.v_W - before[2 * i]).cwiseAbs().sum();
    const Scalar turned = (solved.w_W - before[2 * i + 1]).cwiseAbs().sum();
    groups.changes.changed[slots[i]] += share * (moved + reach * turned);
  }
}

/// A line of impulses, ContactPoint::ahead: how far one may go on it.
template <class Scalar>
struct SearchLine {
  Scalar longest = std::numeric_limits<Scalar>::max();  ///< share at which an impulse is nothing
  Scalar room = 0;                                      ///< what all of it takes of the room, J
};

/// The way that the last sweep has led, and `kept` of the line before. What does not press has
/// nothing to lose.
template <class SceneT>
SearchLine<Scalar_of<SceneT>> find_line(ContactGroups<SceneT>& groups, GroupRange group,
                                        Scalar_of<SceneT> kept) {
  using Scalar = Scalar_of<SceneT>;
  SearchLine<Scalar> line;
  for_each_point(groups, group, [&](auto& point, const auto&, const auto&) {
    point.ahead = (point.normal - point.start) + kept * point.ahead;
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

/// Whether a contact is on the line at all. Bound: two points.
template <class Contact>
bool is_on_line(const Contact& contact) {
  bool is_on = false;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    is_on = is_on || contact.points[static_cast<std::size_t>(i)].ahead != 0;
  }
  return is_on;
}

/// Gives the bodies of a group `share` of the line. @param counts  of it, to who watches
template <class SceneT>
void push_along(ContactGroups<SceneT>& groups, GroupRange group, Scalar_of<SceneT> share,
                Scalar_of<SceneT> counts) {
  using Scalar = Scalar_of<SceneT>;
  for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
    const auto& contact = groups.solved_at(k);
    const auto push = [&](SolvedBody<Scalar>& A, SolvedBody<Scalar>& B) {
      for (int i = 0; i < contact.count; ++i) {  // Bound: 2
        const auto& point = contact.points[static_cast<std::size_t>(i)];
        push_at(point, A, B, Vec3<Scalar>((share * point.ahead) * point.normal_W));
      }
    };
    if (is_on_line(contact)) watch(groups, contact, push, counts);
  }
}

/// To the least energy on the line. @pre its slope is negative
/// @param[in,out] energy  what was added to that of the group so far, J, <= 0
/// @returns how far that is, a share of the line
template <class SceneT>
Scalar_of<SceneT> go_along(ContactGroups<SceneT>& groups, GroupRange group,
                           const SearchLine<Scalar_of<SceneT>>& line, Scalar_of<SceneT> slope,
                           Scalar_of<SceneT>& energy) {
  using Scalar = Scalar_of<SceneT>;
  // Back first, so that the way on from there is longer than what counts of it.
  push_along(groups, group, Scalar(-1), Scalar(0));
  const Scalar bend = slope - slope_of_line(groups, group);
  Scalar share = bend > Scalar(0) ? min_of(-slope / bend, line.longest) : Scalar(0);
  const Scalar gain = share * ((slope - line.room) + share * bend / 2);
  if (gain > Scalar(0) && energy + gain > Scalar(0)) {
    share = 0;
  } else {
    energy += gain;
  }
  push_along(groups, group, share + 1, share / (share + 1));
  return share;
}

/// After a sweep: where sweeps lead slowly, on to the least energy on the way that they lead.
/// @param[in,out] led     how far the sweep before the last one has led, J; that of the last one
/// @param[in,out] energy  what was added to that of the group so far, J, <= 0
template <class SceneT>
void search_line(ContactGroups<SceneT>& groups, GroupRange group, Scalar_of<SceneT>& led,
                 Scalar_of<SceneT>& energy) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kSlow = Scalar(0.75);  // of what the sweep before has led
  const Scalar before = led;
  led = 0;
  for (int k = group.first; k < group.last; ++k) {  // Bound: kMaxContacts
    led += led_by_sweep(groups.solved_at(k));
  }
  const bool is_slow = before > Scalar(0) && !(led < kSlow * before);
  Scalar share = 0;
  if (is_slow) {
    const auto line = find_line(groups, group, led < before ? led / before : Scalar(0));
    const Scalar slope = slope_of_line(groups, group);
    if (slope < Scalar(0)) share = go_along(groups, group, line, slope, energy);
  }
  for_each_point(groups, group, [&](auto& point, const auto&, const auto&) {
    point.normal += share * point.ahead;
    point.start = point.normal;
    if (!is_slow) point.ahead = 0;
  });
}

}  // namespace batuta::detail
