// SPDX-License-Identifier: MIT
#include "batuta/record/world.hpp"

#include "batuta/world/make_actor.hpp"
#include "numbers.hpp"
#include "scene_for_c.hpp"
#include "storage.hpp"

namespace batuta::detail {
namespace {

struct WorldForC {
  static constexpr std::uint32_t kMark = file_id("batuta_world");

  std::uint32_t mark = kMark;
  World<SceneForC> world;
};
static_assert(holds_closely<WorldForC, batuta_world>(), "BATUTA_WORLD_BYTES, or an alignment");

using BodyId = World<SceneForC>::BodyId;

BodyId id_of(const WorldForC& own, std::int32_t number) {
  const bool is_slot = number >= 0 && number < kMostBodies;
  return is_slot ? own.world.id_at(static_cast<std::uint16_t>(number)) : BodyId{};
}

std::int32_t add_body(WorldForC& own, const Actor<SceneForC>& actor, std::int32_t& number) {
  const auto added = own.world.add(actor);
  if (!added.ok()) return code_of(added.status);
  number = added.value.index1 - 1;  // its slot, as events name it
  return BATUTA_OK;
}

}  // namespace
}  // namespace batuta::detail

using batuta::detail::WorldForC;

std::size_t batuta_world_size() {
  return sizeof(WorldForC);
}

std::size_t batuta_world_align() {
  return alignof(WorldForC);
}

std::int32_t batuta_world_init(batuta_world* world, std::size_t bytes) {
  if (!batuta::detail::has_room<WorldForC>(world, bytes)) return BATUTA_INVALID_ARGUMENT;
  if (!batuta::rounds_each_operation<float>()) return BATUTA_UNAVAILABLE;
  batuta::detail::make_in<WorldForC>(world);
  return BATUTA_OK;
}

std::int32_t batuta_world_set_gravity(batuta_world* world, const float* gravity_W) {
  auto* const own = batuta::detail::found_in<WorldForC>(world);
  if (own == nullptr || gravity_W == nullptr) return BATUTA_INVALID_ARGUMENT;
  auto settings = own->world.settings();
  settings.gravity_W = batuta::detail::vector_of(gravity_W);
  return batuta::detail::code_of(own->world.configure(settings));
}

std::int32_t batuta_world_add(batuta_world* world, const float* moving,
                              const batuta_material* material, std::int32_t* number) {
  auto* const own = batuta::detail::found_in<WorldForC>(world);
  if (own == nullptr || moving == nullptr || material == nullptr || number == nullptr) {
    return BATUTA_INVALID_ARGUMENT;
  }
  const auto body = batuta::detail::moving_of(moving, 0.0F);
  if (!body.ok()) return BATUTA_INVALID_ARGUMENT;
  const batuta::Twist<float>& twist = body.value.motion.twist;
  if (!batuta::is_finite(twist.v_W.squaredNorm() + twist.w_W.squaredNorm())) {
    return BATUTA_INVALID_ARGUMENT;  // no float holds what a blow makes of it
  }
  auto actor = batuta::make_actor<batuta::detail::SceneForC>(
      body.value.capsule_B, material->density, body.value.motion.X_WB, twist);
  if (!actor.ok()) return BATUTA_INVALID_ARGUMENT;
  actor.value.restitution = material->restitution;
  actor.value.friction = material->friction;
  return batuta::detail::add_body(*own, actor.value, *number);
}

std::int32_t batuta_world_remove(batuta_world* world, std::int32_t number) {
  auto* const own = batuta::detail::found_in<WorldForC>(world);
  if (own == nullptr) return BATUTA_INVALID_ARGUMENT;
  return batuta::detail::code_of(own->world.remove(batuta::detail::id_of(*own, number)));
}

std::int32_t batuta_world_step(batuta_world* world, float dt) {
  auto* const own = batuta::detail::found_in<WorldForC>(world);
  return own == nullptr ? BATUTA_INVALID_ARGUMENT : batuta::detail::code_of(own->world.step(dt));
}

std::int32_t batuta_world_complete(const batuta_world* world) {
  const auto* const own = batuta::detail::found_in<WorldForC>(world);
  return own != nullptr && own->world.report().complete() ? 1 : 0;
}

std::int32_t batuta_world_body(const batuta_world* world, std::int32_t number, batuta_body* out) {
  const auto* const own = batuta::detail::found_in<WorldForC>(world);
  if (own == nullptr || out == nullptr) return BATUTA_INVALID_ARGUMENT;
  const auto id = batuta::detail::id_of(*own, number);
  const auto* const actor = own->world.get(id);
  if (actor == nullptr) return BATUTA_STALE_HANDLE;
  const auto twist = batuta::twist_of(actor->body);
  batuta::detail::put(batuta::to_world(actor->body.X_WB, actor->capsule_B), out->capsule_W);
  batuta::detail::put(twist.v_W, out->v_W);
  batuta::detail::put(twist.w_W, out->w_W);
  out->asleep = own->world.is_asleep(id) ? 1 : 0;
  return BATUTA_OK;
}

std::int32_t batuta_world_event_count(const batuta_world* world) {
  const auto* const own = batuta::detail::found_in<WorldForC>(world);
  return own == nullptr ? 0 : own->world.events().size();
}

std::int32_t batuta_world_event(const batuta_world* world, std::int32_t index, batuta_event* out) {
  const auto* const own = batuta::detail::found_in<WorldForC>(world);
  if (own == nullptr || out == nullptr) return BATUTA_INVALID_ARGUMENT;
  const auto& events = own->world.events();
  if (index < 0 || index >= events.size()) return BATUTA_INVALID_ARGUMENT;
  const auto& event = events[index];
  out->kind = static_cast<std::int32_t>(event.kind);
  out->body_A = event.body_A;
  out->body_B = event.body_B;
  out->time = event.time;
  out->impulse = event.impulse;
  batuta::detail::put(event.contact.point_W, out->point_W);
  batuta::detail::put(event.contact.normal_BA_W, out->normal_W);
  return BATUTA_OK;
}

std::int32_t batuta_world_hash(const batuta_world* world, std::uint64_t* out) {
  const auto* const own = batuta::detail::found_in<WorldForC>(world);
  if (own == nullptr || out == nullptr) return BATUTA_INVALID_ARGUMENT;
  *out = batuta::hash_of(own->world);
  return BATUTA_OK;
}
