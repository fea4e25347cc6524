// SPDX-License-Identifier: MIT
#pragma once
// A bout of the library's two fencers for C and for bindings: its steps, the forces on both sticks,
// opponents that see, and recordings that batuta-duel makes and plays as well. As batuta/c.h says
// of storage, statuses and arrays. Threads: one at a time for each duel, with who looks at it.

#include "batuta/c.h"

// NOLINTBEGIN(readability-identifier-naming): deviation: names-of-c
#ifdef __cplusplus  // deviation: names-of-c
extern "C" {
#endif

/// Sizes.
enum {
  BATUTA_BODY_PARTS = 12,          ///< capsules of a fencer's body
  BATUTA_SHORTEST_STEP_US = 100,   ///< of a duel, us
  BATUTA_LONGEST_STEP_US = 20000,  ///< of a duel, us
  BATUTA_MOST_TOUCHES = 99,        ///< that a bout can go to
  BATUTA_DUEL_BYTES = 8192,        ///< batuta_duel_size(), rounded up
  BATUTA_OPPONENT_BYTES = 1536,    ///< batuta_opponent_size(), rounded up
  BATUTA_RECORDER_BYTES = 7680,    ///< batuta_recorder_size(), rounded up
  BATUTA_PLAYER_BYTES = 7680       ///< batuta_player_size(), rounded up
};

/// A fencer, by the side on which he begins.
enum { BATUTA_LEFT = 0, BATUTA_RIGHT = 1 };

// --- Duel -------------------------------------------------------------------------------------

/// Storage of a bout, in float; to be placed anywhere and kept there.
typedef union batuta_duel {
  uint64_t alignment;                      ///< nobody's
  unsigned char bytes[BATUTA_DUEL_BYTES];  ///< the library's
} batuta_duel;

/// Where a stick is, each axis -1 ... 1.
typedef struct batuta_stick {
  float x;       ///< left ... right
  float y;       ///< down ... up
  float feet_x;  ///< second pair of axes, left ... right; 0 where there is none
  float feet_y;  ///< back ... forward
} batuta_stick;

/// A stick as a device with a clock of its own tells it: batuta::InputSample.
typedef struct batuta_sample {
  batuta_stick stick;
  uint32_t time_us;   ///< when it was there, by a clock that runs on beyond 2^32
  uint32_t buttons;   ///< bit i: button i is pressed
  uint32_t sequence;  ///< counts the samples of this device; gaps are counted as lost
} batuta_sample;

/// A touch.
typedef struct batuta_touch {
  int32_t by;        ///< whose blade: BATUTA_LEFT | BATUTA_RIGHT
  int32_t part;      ///< where on the other: batuta::fencing::BodyPart
  uint64_t time_us;  ///< since the start of the bout
  float point_W[3];  ///< m
} batuta_touch;

/// How a bout stands. Of pairs the first is the left fencer's.
typedef struct batuta_duel_state {
  uint32_t steps;         ///< since the start
  int32_t bout;           ///< 0 fencing, 1 lockout, 2 over by a touch, 3 over by two, 4 halt
  int32_t exchange;       ///< the number of this one, from 1
  int32_t annulled;       ///< 1: the touches of this exchange do not count
  int32_t touches;        ///< of this exchange: 0 ... 2; a halt with 0 is for a corps a corps
  batuta_touch touch[2];  ///< so many of them are set; the others are zeros
  int32_t score[2];       ///< touches that count, of exchanges that are over
  float gap;              ///< of the blades, m; negative: they overlap
  float blade_W[2][BATUTA_CAPSULE_NUMBERS];  ///< capsule[7], guard to tip
  float body_W[2][BATUTA_BODY_PARTS]
              [BATUTA_CAPSULE_NUMBERS];  ///< BATUTA_BODY_PARTS times capsule[7]
  float stick[2][2];                     ///< where the sticks are taken to be, x y
  float control[2];                      ///< of the grips: 0 free ... 1 held
  float place[2];                        ///< of the feet along the strip, W's x, m
  float feet[2];                         ///< what moves them: -1 back ... 1 forward
  float force[2][2];  ///< on the sticks, x y: shares of what the device has, each
                      ///< -1 ... 1; 0 where no samples come; it begins anew where a
                      ///< recording is begun
  int32_t blows;      ///< meetings of the weapons in the last step
  float impulse;      ///< of all of them, N s
  float blow_W[3];    ///< where the last of them was, m; zeros without one
} batuta_duel_state;

/// Bytes that a duel takes: at most BATUTA_DUEL_BYTES. For who has no C compiler at hand.
size_t batuta_duel_size(void);
/// Its storage begins at a multiple of this: at most 8.
size_t batuta_duel_align(void);
/// Puts both fencers on guard, so near that their blades meet, whatever was in the storage.
/// @param bytes  of the storage
/// @param step_us  length of a step, us: BATUTA_SHORTEST_STEP_US ... BATUTA_LONGEST_STEP_US
/// @param touches  that the bout goes to, 1 ... BATUTA_MOST_TOUCHES
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT: null, less than batuta_duel_size(), not aligned,
///   or a number out of its range | BATUTA_UNAVAILABLE (arithmetic); what is in the storage goes on
int32_t batuta_duel_init(batuta_duel* duel, size_t bytes, int32_t step_us, int32_t touches);
/// Before the first step: puts them on guard elsewhere.
/// @param distance  between their frames, m, > 0 ... 1000; 4 suits an opponent, who needs time to
///   see
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT | BATUTA_UNAVAILABLE: it has made a step, a
///   recording was put into it, or arithmetic; the bout goes on
int32_t batuta_duel_set_distance(batuta_duel* duel, float distance);
/// One step. @param left, right  a new sample of the fencer's stick, taken at the beginning of the
///   step, or null where there is none
/// @returns BATUTA_OK | BATUTA_UNAVAILABLE: the bout is over | BATUTA_INVALID_ARGUMENT: an axis is
///   not within -1 ... 1, or it is no duel. Bound: Duel::step() and the forces of its events.
int32_t batuta_duel_step(batuta_duel* duel, const batuta_stick* left, const batuta_stick* right);
/// The same with samples of devices that have a clock. One bout takes samples of one clock, also
/// after a recording: those of another one are believed after a quarter of a second of silence.
int32_t batuta_duel_step_sampled(batuta_duel* duel, const batuta_sample* left,
                                 const batuta_sample* right);
/// How it stands. @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT
int32_t batuta_duel_get_state(const batuta_duel* duel, batuta_duel_state* out);
/// Hash of all that the next step depends on: two duels of one hash go on alike.
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT. Bound: members of the duel.
int32_t batuta_duel_hash(const batuta_duel* duel, uint64_t* out);

// --- Opponents --------------------------------------------------------------------------------

/// How well an opponent fences: batuta::fencing::Skill.
enum { BATUTA_NOVICE = 0, BATUTA_CLUB = 1, BATUTA_MASTER = 2 };

/// Storage of a fencer that sees (batuta/fencing/opponent.hpp), and moves a stick like everybody.
typedef union batuta_opponent {
  uint64_t alignment;                          ///< nobody's
  unsigned char bytes[BATUTA_OPPONENT_BYTES];  ///< the library's
} batuta_opponent;

/// Bytes that one takes: at most BATUTA_OPPONENT_BYTES.
size_t batuta_opponent_size(void);
/// Its storage begins at a multiple of this: at most 8.
size_t batuta_opponent_align(void);
/// Makes one, who waits on guard and has seen nothing: once a bout.
/// @param skill  BATUTA_NOVICE | BATUTA_CLUB | BATUTA_MASTER
/// @param seed  any number: another one, another fencer
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT: null, too small, not aligned, no such skill
///   | BATUTA_UNAVAILABLE (arithmetic)
int32_t batuta_opponent_init(batuta_opponent* opponent, size_t bytes, int32_t skill, uint32_t seed);
/// Once a step, before it: looks at the duel, and moves the stick.
/// @param side  on which it fences: BATUTA_LEFT | BATUTA_RIGHT
/// @param[out] out  the fencer's stick, for batuta_duel_step()
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT. Bound: Opponent::step().
int32_t batuta_opponent_look(batuta_opponent* opponent, const batuta_duel* duel, int32_t side,
                             batuta_stick* out);

// --- Recordings -------------------------------------------------------------------------------

/// Storage of a recorder of one bout: a file that batuta-duel --replay plays. It keeps what it has
/// until that is taken: the start of a bout, or some fifty steps. Take often.
typedef union batuta_recorder {
  uint64_t alignment;                          ///< nobody's
  unsigned char bytes[BATUTA_RECORDER_BYTES];  ///< the library's
} batuta_recorder;

/// Bytes that one takes: at most BATUTA_RECORDER_BYTES.
size_t batuta_recorder_size(void);
/// Its storage begins at a multiple of this: at most 8.
size_t batuta_recorder_align(void);
/// Begins a recording with the duel as it is.
/// @param hash_every  steps between two hashes, which say where a replay parts; 0: one at the end
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT: null, too small, not aligned, no duel
int32_t batuta_recorder_init(batuta_recorder* recorder, size_t bytes, const batuta_duel* duel,
                             uint32_t hash_every);
/// After each step of the duel, made by batuta_duel_step() or batuta_duel_step_sampled().
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT: also where the duel has not made just one step
///   since the last call | BATUTA_UNAVAILABLE: it has ended | BATUTA_POOL_FULL: there was no room,
///   and the recording ends before this step; its end says how many are missing
int32_t batuta_recorder_step(batuta_recorder* recorder, const batuta_duel* duel);
/// The end mark; then take until nothing is left.
/// @param duel  as it is after the last step that was recorded
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT: also where the duel has made a step that was not
///   recorded | BATUTA_POOL_FULL: take, then again | BATUTA_UNAVAILABLE: it has ended
int32_t batuta_recorder_end(batuta_recorder* recorder, const batuta_duel* duel);
/// Hands out what was recorded, from the first byte on, each once.
/// @param[out] out  room for `capacity` bytes
/// @returns how many there were, and are in `out`; 0: none, or no recorder
size_t batuta_recorder_take(batuta_recorder* recorder, uint8_t* out, size_t capacity);

/// How playing goes on, or ended: batuta::Playback.
enum {
  BATUTA_PLAYBACK_READY = 0,          ///< begun: the duel is that of the start
  BATUTA_PLAYBACK_STEP = 1,           ///< a step was made
  BATUTA_PLAYBACK_END = 2,            ///< all steps are made, and every hash agreed
  BATUTA_PLAYBACK_WAITING = 3,        ///< give more bytes, then again
  BATUTA_PLAYBACK_PARTED = 4,         ///< the duel is another than the recorded one
  BATUTA_PLAYBACK_GAP = 5,            ///< steps are missing from here on
  BATUTA_PLAYBACK_CUT = 6,            ///< the bytes end before the end mark
  BATUTA_PLAYBACK_DAMAGED = 7,        ///< a check sum, a number or an order is wrong
  BATUTA_PLAYBACK_FOREIGN = 8,        ///< no recording
  BATUTA_PLAYBACK_OTHER_VERSION = 9,  ///< of the format
  BATUTA_PLAYBACK_OTHER_SCALAR = 10,  ///< of double
  BATUTA_PLAYBACK_OTHER_SCENE = 11,   ///< of something else than this duel
  BATUTA_PLAYBACK_TOO_LARGE = 12      ///< no recording of this duel has such a record
};

/// Storage of a player of one recording. Nothing of the bytes is believed.
typedef union batuta_player {
  uint64_t alignment;                        ///< nobody's
  unsigned char bytes[BATUTA_PLAYER_BYTES];  ///< the library's
} batuta_player;

/// Bytes that one takes: at most BATUTA_PLAYER_BYTES.
size_t batuta_player_size(void);
/// Its storage begins at a multiple of this: at most 8.
size_t batuta_player_align(void);
/// Makes one that waits for the first bytes of a recording.
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT: null, too small, not aligned | BATUTA_UNAVAILABLE
///   (arithmetic)
int32_t batuta_player_init(batuta_player* player, size_t bytes);
/// The next bytes of the recording. They stay the caller's, and where they are until all of them
/// are read: what is unread of those before is forgotten.
/// @param bytes  not null, also where count is 0  @param is_all  1: none will follow
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT
int32_t batuta_player_give(batuta_player* player, const uint8_t* bytes, size_t count,
                           int32_t is_all);
/// Bytes that were given and are unread; behind an end mark there should be none.
size_t batuta_player_unread(const batuta_player* player);
/// Hashes that agreed so far.
uint32_t batuta_player_agreed(const batuta_player* player);
/// Puts the start of the recorded bout into a duel: call it until it is READY, or an end.
/// @param duel  one that batuta_duel_init() has made, the same in each call. What it was may be
///   gone after any answer but FOREIGN.
/// @param[out] playback  BATUTA_PLAYBACK_READY | _WAITING: give more bytes | one of the ends
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT: also where it was READY before
int32_t batuta_player_begin(batuta_player* player, batuta_duel* duel, int32_t* playback);
/// Makes the recording's next step; where a hash was recorded before it, after a look whether the
/// duel is the recorded one so far.
/// @param duel  as this player left it
/// @param[out] playback  BATUTA_PLAYBACK_STEP | _END | _WAITING | one of the other ends
/// @returns BATUTA_OK | BATUTA_INVALID_ARGUMENT: also before it is READY, and for a duel that has
///   made another number of steps; it is then as it was. Bound: two records and batuta_duel_step().
int32_t batuta_player_next(batuta_player* player, batuta_duel* duel, int32_t* playback);

#ifdef __cplusplus  // deviation: names-of-c
}
#endif
// NOLINTEND(readability-identifier-naming): deviation: names-of-c
