// SPDX-License-Identifier: MIT
#pragma once
// ContactGroups: what opens gaps shifts bodies that carry momentum, and so changes the sum of
// x x p; at the end of the step a group that nothing holds gives it back (src/world/world.md,
// "Opening"). Included by contact_groups.hpp.

#include "batuta/world/detail/contact_groups.hpp"

namespace batuta::detail {

/// Those of one group: some of the list of bodies that have changed.
template <class SceneT>
struct GroupMembers {
  const FixedList<std::uint16_t, SceneT::kMaxBodies>& list;
  int first = 0;
  bool is_held = false;  ///< something that is led touches one of them
};

/// All whom solved contacts join to a body; what is led belongs to no group.
/// Bound: the bodies of the group, and their contacts.
template <class SceneT>
GroupMembers<SceneT> members_with(const Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups,
                                  std::size_t slot) {
  auto& changes = groups.changes;
  const auto& contacts = groups.contacts;
  GroupMembers<SceneT> members = {changes.dirty, changes.dirty.size()};
  changes.mark(slot);
  for (int d = members.first; d < changes.dirty.size(); ++d) {  // Bound: kMaxBodies
    const std::size_t one = changes.dirty[d];
    // Bound: the contacts of a body.
    for (int i = contacts.first_of(one); i >= 0; i = contacts.next_of(i, one)) {
      const auto& contact = contacts[i];
      if (!contact.is_solved) continue;
      const std::size_t a = a_of<SceneT>(contact);
      const std::size_t other = a == one ? b_of<SceneT>(contact) : a;
      members.is_held = members.is_held || bodies.holds(other) || bodies.holds(one);
      if (!bodies.is_led(other) && !changes.is_dirty[other]) changes.mark(other);
    }
  }
  return members;
}

/// How a body moves that is at a place of a rigid group. @param whole  of the group, at its centre
template <class Scalar>
Twist<Scalar> twist_at_place(const RigidGroup<Scalar>& group, const Twist<Scalar>& whole,
                             const Body<Scalar>& body) {
  const Vec3<Scalar> r_W = body.X_WB.p_W - group.center_W;
  return {whole.v_W + whole.w_W.cross(r_W), whole.w_W};
}

/// How a body moves besides what it goes along with its group.
template <class Scalar>
Twist<Scalar> own_twist(const RigidGroup<Scalar>& group, const Twist<Scalar>& whole,
                        const Body<Scalar>& body) {
  const Twist<Scalar> at_place = twist_at_place(group, whole, body);
  const Twist<Scalar> twist = twist_of(body);
  return {twist.v_W - at_place.v_W, twist.w_W - at_place.w_W};
}

/// What is left of a group's motions within itself where its turn takes up `more` energy: it comes
/// from those. 1: nothing is taken; < 0: there is not as much. Bound: the bodies of the group.
template <class SceneT>
Scalar_of<SceneT> share_left(const Bodies<SceneT>& bodies, const GroupMembers<SceneT>& members,
                             const RigidGroup<Scalar_of<SceneT>>& group,
                             const Twist<Scalar_of<SceneT>>& whole, Scalar_of<SceneT> more) {
  using Scalar = Scalar_of<SceneT>;
  using std::sqrt;
  if (!(more > Scalar(0))) return Scalar(1);
  Scalar own = 0;
  for (int d = members.first; d < members.list.size(); ++d) {  // Bound: kMaxBodies
    const auto& body = bodies.actor(members.list[d]).body;
    const Twist<Scalar> twist = own_twist(group, whole, body);
    const Momentum<Scalar> momentum = momentum_of(body, twist);
    own += (momentum.linear_W.dot(twist.v_W) + momentum.angular_W.dot(twist.w_W)) / 2;
  }
  return own > more ? sqrt(1 - more / own) : Scalar(-1);
}

/// What a group gives back, of which each member takes its part.
template <class Scalar>
struct GivenBack {
  Twist<Scalar> whole;                          ///< of the group as it moves
  Twist<Scalar> change;                         ///< by which it turns more slowly, or faster
  Scalar left = 1;                              ///< of its inner motions
  Vec3<Scalar> drift_W = Vec3<Scalar>::Zero();  ///< what the members' parts sum to, over the mass
};

template <class Scalar>
Twist<Scalar> part_of_member(const RigidGroup<Scalar>& group, const GivenBack<Scalar>& given,
                             const Body<Scalar>& body) {
  Twist<Scalar> part = twist_at_place(group, given.change, body);
  if (given.left < Scalar(1)) {
    const Twist<Scalar> own = own_twist(group, given.whole, body);
    part.v_W -= (1 - given.left) * own.v_W;
    part.w_W -= (1 - given.left) * own.w_W;
  }
  part.v_W -= given.drift_W;
  return part;
}

/// The parts have no sum of momenta, but by what the centre is rounded: far from the origin that is
/// more than rounding of momenta may be.
template <class SceneT>
void take_drift_out(const Bodies<SceneT>& bodies, const GroupMembers<SceneT>& members,
                    const RigidGroup<Scalar_of<SceneT>>& group,
                    GivenBack<Scalar_of<SceneT>>& given) {
  Vec3<Scalar_of<SceneT>> sum_W = Vec3<Scalar_of<SceneT>>::Zero();
  for (int d = members.first; d < members.list.size(); ++d) {  // Bound: kMaxBodies
    const auto& body = bodies.actor(members.list[d]).body;
    sum_W += momentum_of(body, part_of_member(group, given, body)).linear_W;
  }
  given.drift_W = sum_W / group.mass;
}

/// Whether it adds no energy but what rounding adds: the inertia of bodies at one place, or of thin
/// ones, is rounded too. Bound: the bodies of the group.
template <class SceneT>
bool adds_no_energy(const Bodies<SceneT>& bodies, const GroupMembers<SceneT>& members,
                    const RigidGroup<Scalar_of<SceneT>>& group,
                    const GivenBack<Scalar_of<SceneT>>& given) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kEnergyRounding = 16 * kRoundOff<Scalar>;  // of each body's own
  Scalar energy = 0;
  Scalar more = 0;
  for (int d = members.first; d < members.list.size(); ++d) {  // Bound: kMaxBodies
    const auto& body = bodies.actor(members.list[d]).body;
    const Twist<Scalar> twist = twist_of(body);
    const Twist<Scalar> part = part_of_member(group, given, body);
    const Momentum<Scalar> momentum = momentum_of(body, part);
    energy += kinetic_energy(body);
    more += momentum.linear_W.dot(twist.v_W + part.v_W / 2) +
            momentum.angular_W.dot(twist.w_W + part.w_W / 2);
  }
  return more <= kEnergyRounding * energy;
}

/// A group turns more slowly, or faster, by what its shifts have changed of its angular momentum.
/// Where that would add energy and its inner motions do not have as much, it keeps the change.
template <class SceneT>
void give_back(Bodies<SceneT>& bodies, const GroupMembers<SceneT>& members) {
  using Scalar = Scalar_of<SceneT>;
  RigidGroup<Scalar> group;
  Vec3<Scalar> moment_W = Vec3<Scalar>::Zero();
  for (int d = members.first; d < members.list.size(); ++d) {  // Bound: kMaxBodies
    add_to_group(group, bodies.actor(members.list[d]).body);
    moment_W += bodies.states[members.list[d]].moment_W;
  }
  if (!group.turns || is_zero(moment_W)) return;
  GivenBack<Scalar> given;
  given.whole = group_twist(group, group.momentum.angular_W);
  given.change = {Vec3<Scalar>::Zero(), -group_twist(group, moment_W).w_W};
  const Scalar more = -moment_W.dot(given.whole.w_W + given.change.w_W / 2);
  given.left = share_left(bodies, members, group, given.whole, more);
  if (given.left < Scalar(0)) return;
  take_drift_out(bodies, members, group, given);
  if (!adds_no_energy(bodies, members, group, given)) return;
  for (int d = members.first; d < members.list.size(); ++d) {  // Bound: kMaxBodies
    auto& body = bodies.actor(members.list[d]).body;
    const Momentum<Scalar> momentum = momentum_of(body, part_of_member(group, given, body));
    body.momentum.linear_W += momentum.linear_W;
    body.momentum.angular_W += momentum.angular_W;
  }
}

/// At the end of a step: groups of which somebody was shifted. Where something holds a group, that
/// has taken it. Bound: kMaxBodies, and their contacts.
template <class SceneT>
void give_back_moments(Bodies<SceneT>& bodies, ContactGroups<SceneT>& groups) {
  if (!bodies.is_shifted) return;
  bodies.is_shifted = false;
  groups.changes.clear();
  for (std::size_t slot = 0; slot < Bodies<SceneT>::kSlots; ++slot) {  // Bound: kMaxBodies
    const auto& state = bodies.states[slot];
    if (!state.present || is_zero(state.moment_W) || groups.changes.is_dirty[slot]) continue;
    if (bodies.is_led(slot)) continue;
    const auto members = members_with(bodies, groups, slot);
    if (!members.is_held) give_back(bodies, members);
  }
}

}  // namespace batuta::detail
