// SPDX-License-Identifier: MIT
#pragma once
// A world of capsules as every engine is asked: plain numbers, so that no engine's headers meet
// another's. SI units; a capsule lies along z of its body, about its centre of mass.

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace batuta::worlds {

using Triple = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  ///< w, x, y, z

struct BodyState {
  Triple place{};
  Quaternion turn{1, 0, 0, 0};
  Triple v{};
  Triple w{};
};

struct BodyPlan {
  double half_length = 0;
  double radius = 0;
  double mass = 0;           ///< 0: fixed
  double moment_across = 0;  ///< of inertia
  double moment_along = 0;
  BodyState start;
};

struct Plan {
  std::vector<BodyPlan> bodies;
  Triple gravity{};
  double restitution = 0;  ///< of all pairs
  double friction = 0;     ///< of all pairs
  bool may_sleep = false;
};

class Engine {
 public:
  virtual ~Engine() = default;
  virtual std::string name() const = 0;
  virtual std::string setting() const = 0;
  virtual void load(const Plan& plan) = 0;
  /// Steps once at its pace.
  virtual void step() = 0;
  virtual int steps_per_second() const = 0;
  virtual BodyState state(int body) const = 0;
  /// Turns a body's velocity along an axis of the world round.
  virtual void mirror(int body, int axis) = 0;
  /// Of memory, where it is known.
  virtual std::size_t bytes() const { return 0; }
  /// Steps so far in which the engine says that something did not fit.
  virtual int incomplete() const { return 0; }
};
using EnginePtr = std::unique_ptr<Engine>;

/// Most bodies of a plan.
inline constexpr int kMostBodies = 160;

std::vector<EnginePtr> batuta_engines();
std::vector<EnginePtr> bullet_engines();

/// Bars that rub, in a world with room for no more than so many (a power of two, 32 to 128).
EnginePtr batuta_bars(int bodies, int hz);
/// A sparse crowd, in a world with room for no more than so many (a power of two, 32 to 4,096).
EnginePtr batuta_crowd(int bodies, int hz);
/// With its defaults.
EnginePtr bullet_engine(int hz);

}  // namespace batuta::worlds
