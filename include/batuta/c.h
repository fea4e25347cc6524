// SPDX-License-Identifier: MIT
#pragma once
// The library for C and for bindings of other languages: plain numbers in, plain numbers out,
// nothing allocated, nothing thrown, nothing global. Link batuta::c. SI units; frame W is the
// world's. Functions that end in _f take float, those in _d double. A world and a duel live in
// storage of the caller's, and hold no resources: nothing need be given back. Bad input gets a
// status and changes nothing; whoever links this supplies batuta_trap() (batuta/core/assert.hpp),
// where a fault of the library itself ends. Threads: one at a time for each world.
// A duel, its opponents and its recordings: batuta/c/duel.h.
//
// Shapes of arrays:
//   capsule[7]   ends a and b of the axis, m (x y z each); radius, m, >= 0
//   pose[7]      origin of frame B in W, m (x y z); orientation q_WB (w x y z), of any length but 0
//   twist[6]     velocity of B's origin, m/s (x y z); angular velocity, rad/s (x y z), both in W
//   moving[20]   capsule[7] in B, then pose[7] and twist[6] of B

#include <stddef.h>
#include <stdint.h>

// NOLINTBEGIN(readability-identifier-naming): deviation: names-of-c
#ifdef __cplusplus  // deviation: names-of-c
extern "C" {
#endif

/// How a call ended: batuta::Status.
enum {
  BATUTA_OK = 0,                ///< done
  BATUTA_INVALID_ARGUMENT = 1,  ///< null, not finite, out of its range, or storage without init()
  BATUTA_POOL_FULL = 2,         ///< the capacity is used up
  BATUTA_STALE_HANDLE = 3,      ///< there is no such body
  BATUTA_DEGENERATE = 4,        ///< no function here returns it
  BATUTA_UNAVAILABLE = 5        ///< too late: a bout is over or has begun, a recording has ended;
                                ///< no double is built in; or the thread computes in another way
                                ///< than proofs stand on: it rounds elsewhere than to nearest, or
                                ///< flushes small numbers to zero
};

/// What a search says of [0, duration]: batuta::Outcome.
enum {
  BATUTA_FREE = 0,      ///< no contact, proven
  BATUTA_CONTACT = 1,   ///< free up to t_free, where the gap is within the contact tolerance
  BATUTA_TOUCHING = 2,  ///< in contact at the start
  BATUTA_BUDGET = 3     ///< free up to t_free, unknown after: never to be taken for BATUTA_FREE
};

/// Sizes.
enum {
  BATUTA_CAPSULE_NUMBERS = 7,  ///< of capsule[]
  BATUTA_POSE_NUMBERS = 7,     ///< of pose[]
  BATUTA_TWIST_NUMBERS = 6,    ///< of twist[]
  BATUTA_MOVING_NUMBERS = 20,  ///< of moving[]
  BATUTA_WORLD_BODIES = 16,    ///< most bodies of a world
  BATUTA_WORLD_EVENTS = 64,    ///< most events of a step
  BATUTA_WORLD_BYTES = 44032   ///< batuta_world_size(), rounded up
};

// --- Closest points ---------------------------------------------------------------------------

/// Where two capsules are closest.
typedef struct batuta_closest_f {
  float gap;           ///< distance of the surfaces, m; negative: depth of the overlap
  float distance;      ///< of the axes, m, >= 0
  float s;             ///< place on A's axis, 0 at a ... 1 at b
  float u;             ///< place on B's axis
  float p_A[3];        ///< point of A's axis, m
  float p_B[3];        ///< point of B's axis, m
  float normal_AB[3];  ///< unit, from p_A to p_B
  int32_t arbitrary;   ///< 1: the axes meet, and the normal's sign or direction is a convention
} batuta_closest_f;

/// The same in double.
typedef struct batuta_closest_d {
  double gap;           ///< distance of the surfaces, m; negative: depth of the overlap
  double distance;      ///< of the axes, m, >= 0
  double s;             ///< place on A's axis, 0 at a ... 1 at b
  double u;             ///< place on B's axis
  double p_A[3];        ///< point of A's axis, m
  double p_B[3];        ///< point of B's axis, m
  double normal_AB[3];  ///< unit, from p_A to p_B
  int32_t arbitrary;    ///< 1: the axes meet, and the normal's sign or direction is a convention
} batuta_closest_d;

/// Closest points of two capsules (capsule_gap(), batuta/geometry/capsule.hpp).
/// @param A, B  capsule[7], in one frame
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT | BATUTA_UNAVAILABLE (arithmetic): `out` is as it
///   was. Bound: one query.
int32_t batuta_closest_points_f(const float* A, const float* B, batuta_closest_f* out);
/// The same in double. @returns also BATUTA_UNAVAILABLE: the library is built without double
int32_t batuta_closest_points_d(const double* A, const double* B, batuta_closest_d* out);

/// Closest points of many pairs: A[i] and B[i].
/// @param A, B  count times capsule[7]  @param out  room for `count`
/// @returns how many were answered: `count`, or the index of the first pair that is refused; it and
///   those after it are as they were. Bound: count queries.
size_t batuta_closest_points_many_f(const float* A, const float* B, size_t count,
                                    batuta_closest_f* out);
/// The same in double; 0 where the library is built without.
size_t batuta_closest_points_many_d(const double* A, const double* B, size_t count,
                                    batuta_closest_d* out);

// --- Time of contact --------------------------------------------------------------------------

/// What is asked of two moving capsules.
typedef struct batuta_search_f {
  float duration;   ///< s, >= 0; neither turns by more than 2526 rad in it
  float tolerance;  ///< a gap of so much of the query's length counts as contact, 0 ... 1; 1e-6
                    ///< suits, and is raised to what float can resolve
  uint32_t budget;  ///< most distance evaluations, up to 4096; 30 suits
} batuta_search_f;

/// The same in double.
typedef struct batuta_search_d {
  double duration;   ///< s, >= 0; neither turns by more than 2526 rad in it
  double tolerance;  ///< a gap of so much of the query's length counts as contact, 0 ... 1; 1e-6
                     ///< suits
  uint32_t budget;   ///< most distance evaluations, up to 4096; 30 suits
} batuta_search_d;

/// When two moving capsules first touch.
typedef struct batuta_contact_f {
  int32_t outcome;       ///< BATUTA_FREE | BATUTA_CONTACT | BATUTA_TOUCHING | BATUTA_BUDGET
  uint32_t evaluations;  ///< distance evaluations that it took
  float t_free;          ///< s: no contact before it, proven
  float t_hit;           ///< s: where the gap is foreseen to vanish; the duration where none is
} batuta_contact_f;

/// The same in double.
typedef struct batuta_contact_d {
  int32_t outcome;       ///< BATUTA_FREE | BATUTA_CONTACT | BATUTA_TOUCHING | BATUTA_BUDGET
  uint32_t evaluations;  ///< distance evaluations that it took
  double t_free;         ///< s: no contact before it, proven
  double t_hit;          ///< s: where the gap is foreseen to vanish; the duration where none is
} batuta_contact_d;

/// First contact of two capsules whose bodies keep their twists for the duration; none is missed
/// (search_advancement(), batuta/detection/advancement.hpp).
/// @param A, B  moving[20]
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT | BATUTA_UNAVAILABLE (arithmetic): `out` is as it
///   was. Bound: budget evaluations.
int32_t batuta_time_of_contact_f(const float* A, const float* B, const batuta_search_f* search,
                                 batuta_contact_f* out);
/// The same in double. @returns also BATUTA_UNAVAILABLE: the library is built without double
int32_t batuta_time_of_contact_d(const double* A, const double* B, const batuta_search_d* search,
                                 batuta_contact_d* out);

/// First contacts of many pairs: A[i] and B[i], each on its own.
/// @param A, B  count times moving[20]  @param out  room for `count`
/// @returns how many were answered: `count`, or the index of the first pair that is refused; it and
///   those after it are as they were. Bound: count budget evaluations.
size_t batuta_time_of_contact_many_f(const float* A, const float* B, size_t count,
                                     const batuta_search_f* search, batuta_contact_f* out);
/// The same in double; 0 where the library is built without.
size_t batuta_time_of_contact_many_d(const double* A, const double* B, size_t count,
                                     const batuta_search_d* search, batuta_contact_d* out);

/// The constant twist that carries one pose into another in `duration` on the shortest way.
/// @param from, to  pose[7]  @param duration  s, > 0  @param[out] twist  twist[6]
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT | BATUTA_UNAVAILABLE (arithmetic): `twist` is as it
///   was. Bound: no loop.
int32_t batuta_twist_between_f(const float* from, const float* to, float duration, float* twist);
/// The same in double. @returns also BATUTA_UNAVAILABLE: the library is built without double
int32_t batuta_twist_between_d(const double* from, const double* to, double duration,
                               double* twist);

/// The twists of many bodies in one duration.
/// @param from, to  count times pose[7]  @param[out] twist  room for count times twist[6]
/// @returns how many were answered, as above. Bound: count.
size_t batuta_twist_between_many_f(const float* from, const float* to, size_t count, float duration,
                                   float* twist);
/// The same in double; 0 where the library is built without.
size_t batuta_twist_between_many_d(const double* from, const double* to, size_t count,
                                   double duration, double* twist);

// --- World ------------------------------------------------------------------------------------

/// Storage of a world, to be placed anywhere and kept there: up to BATUTA_WORLD_BODIES capsules
/// that fly, fall, bounce, rub and come to rest, in float.
typedef union batuta_world {
  uint64_t alignment;                       ///< nobody's
  unsigned char bytes[BATUTA_WORLD_BYTES];  ///< the library's
} batuta_world;

/// A contact of a step.
typedef struct batuta_event {
  int32_t kind;       ///< 0 begins, 1 persists, 2 ends
  int32_t body_A;     ///< number of a body
  int32_t body_B;     ///< of the other one, larger
  float time;         ///< in the step, s
  float impulse;      ///< N s
  float point_W[3];   ///< m
  float normal_W[3];  ///< unit, out of B, towards A
} batuta_event;

/// Where a body is, and how it moves.
typedef struct batuta_body {
  float capsule_W[BATUTA_CAPSULE_NUMBERS];  ///< capsule[7], in W
  float v_W[3];                             ///< of its middle, m/s
  float w_W[3];                             ///< angular velocity, rad/s
  int32_t asleep;  ///< 1: it came to rest, and is left out until something touches it
} batuta_body;

/// What a solid capsule is made of.
typedef struct batuta_material {
  float density;      ///< kg/m^3, > 0; infinity: the body is fixed
  float restitution;  ///< 0 ... 1; of two bodies the larger one decides
  float friction;     ///< mu, >= 0; of two bodies the smaller one decides
} batuta_material;

/// Bytes that a world takes: at most BATUTA_WORLD_BYTES. For who has no C compiler at hand.
size_t batuta_world_size(void);
/// Its storage begins at a multiple of this: at most 8.
size_t batuta_world_align(void);
/// Makes an empty world, whatever was in the storage. @param bytes  of the storage
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT: null, less than batuta_world_size(), not aligned
///   | BATUTA_UNAVAILABLE (arithmetic)
int32_t batuta_world_init(batuta_world* world, size_t bytes);
/// Gravity from the next step on, m/s^2 (x y z); -9.81 along z where nothing is said. Wakes all.
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT
int32_t batuta_world_set_gravity(batuta_world* world, const float* gravity_W);
/// Puts a solid capsule into the world.
/// @param moving  moving[20]; its velocity is that of the capsule's middle
/// @param[out] number  names the body in later calls, 0 ... BATUTA_WORLD_BODIES - 1, until it is
///   removed; the lowest that is free
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT: also a speed, or a rate of turn, of which float
///   cannot hold the square, above some 1e19 | BATUTA_POOL_FULL
int32_t batuta_world_add(batuta_world* world, const float* moving, const batuta_material* material,
                         int32_t* number);
/// Takes a body out; its contacts end without an event.
/// @returns BATUTA_OK | BATUTA_STALE_HANDLE | BATUTA_INVALID_ARGUMENT
int32_t batuta_world_remove(batuta_world* world, int32_t number);
/// Moves everything. @param dt  s, > 0
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT. Bound: World::step().
int32_t batuta_world_step(batuta_world* world, float dt);
/// Whether the last step left nothing out: 1; 0 where bodies went on together from where they were
/// proven free (StepReport::complete()), or it is no world.
int32_t batuta_world_complete(const batuta_world* world);
/// A body. @returns BATUTA_OK | BATUTA_STALE_HANDLE | BATUTA_INVALID_ARGUMENT
int32_t batuta_world_body(const batuta_world* world, int32_t number, batuta_body* out);
/// How many contacts the last step had: 0 ... BATUTA_WORLD_EVENTS; 0 where it is no world.
int32_t batuta_world_event_count(const batuta_world* world);
/// One of them. @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT: there is no such event
int32_t batuta_world_event(const batuta_world* world, int32_t index, batuta_event* out);
/// Hash of all that the next step depends on: two worlds of one hash go on alike.
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT. Bound: members of the world.
int32_t batuta_world_hash(const batuta_world* world, uint64_t* out);

#ifdef __cplusplus  // deviation: names-of-c
}
#endif
// NOLINTEND(readability-identifier-naming): deviation: names-of-c
