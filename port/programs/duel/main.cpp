// SPDX-License-Identifier: MIT
// batuta-duel: opens the devices, runs the bout, tells the observers.

#include <unistd.h>

#include <array>
#include <cstdio>
#include <exception>
#include <memory>
#include <utility>

#include "batuta/fencing/opponent.hpp"
#include "programs/duel/beat_figure.hpp"
#include "programs/duel/bout_log.hpp"
#include "programs/duel/device/device_log.hpp"
#include "programs/duel/device/device_setup.hpp"
#include "programs/duel/interrupt.hpp"
#include "programs/duel/json_log.hpp"
#include "programs/duel/options.hpp"
#include "programs/duel/pacing.hpp"
#include "programs/duel/progress_bar.hpp"
#include "programs/duel/replay.hpp"
#include "programs/duel/run_record.hpp"
#include "programs/duel/stick_feedback.hpp"
#include "programs/duel/svg_picture.hpp"
#include "programs/duel/touch_strip.hpp"
#include "programs/duel/view/held_exit.hpp"
#include "programs/duel/view/replay_show.hpp"
#include "programs/duel/view/view.hpp"
#include "programs/files/output_file.hpp"
#include "programs/files/standard_output.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

using Observers = std::vector<std::unique_ptr<Observer>>;

int complain(int exit_code, const std::string& what) {
  std::fprintf(stderr, "batuta-duel: %s\n", what.c_str());
  return exit_code;
}

/// Below this, a replay is over before a bar could be read.
constexpr double kLongReplay = 600;  // s

/// Where a bout is drawn, recorded and seen, if it is to be, and who feels it.
struct Outputs {
  std::array<LiveForce*, 2> forces{};
  OutputFile svg;
  OutputFile figure;
  OutputFile strip;
  FileSink record;
  std::unique_ptr<View> view;
  ViewFeed feed;  ///< of the view

  /// Each path, empty where nothing is drawn, and its file.
  std::array<std::pair<const std::string*, OutputFile*>, 3> pictures(const Options& options) {
    return {{{&options.svg, &svg}, {&options.figure, &figure}, {&options.strip, &strip}}};
  }
  ViewControls* controls() const { return view ? &view->controls() : nullptr; }
  /// @param exit_code  of all the rest  @returns that of the program
  int end_view(int exit_code) const {
    const bool lost = view && view->is_lost();
    return lost ? complain(kExitFailure, "--view: the window is lost: the display is gone")
                : exit_code;
  }
};

Observers make_observers(const Options& options, double limit, Outputs& outputs) {
  Observers observers;
  auto feedback = std::make_unique<StickFeedback>(outputs.forces);
  auto force_log = std::make_unique<ForceLog>(stdout, options.json, *feedback);
  observers.push_back(std::move(feedback));  // the hand first
  if (limit >= kLongReplay && !options.realtime && isatty(STDERR_FILENO) != 0) {
    observers.push_back(std::make_unique<ProgressBar>(stderr));
  }
  if (options.json) {
    observers.push_back(std::move(force_log));  // the summary is the last line
    observers.push_back(std::make_unique<JsonLog>(stdout));
  } else {
    observers.push_back(std::make_unique<BoutLog>(stdout));
    observers.push_back(std::move(force_log));
  }
  if (outputs.view) {
    std::FILE* const out = options.json ? nullptr : stdout;
    observers.push_back(std::make_unique<ViewObserver>(*outputs.view, outputs.feed, out));
  }
  if (!options.svg.empty()) observers.push_back(std::make_unique<SvgPicture>(outputs.svg.stream()));
  if (!options.figure.empty())
    observers.push_back(std::make_unique<BeatFigure>(outputs.figure.stream()));
  if (!options.strip.empty())
    observers.push_back(std::make_unique<TouchStrip>(outputs.strip.stream()));
  if (!options.record.empty()) observers.push_back(std::make_unique<RunRecord>(outputs.record));
  return observers;
}

/// One step. @param[out] going_on  whether another one follows
/// @returns whether it was made; if not, the runner's status or the device says why
bool make_step(DuelRunner& runner, const Observers& observers, DevicePartner* device,
               bool& going_on) {
  if (device != nullptr && !device->before_step(runner)) return false;
  going_on = runner.step();
  if (runner.status() != Status::kOk) return false;
  if (device != nullptr && !device->after_step(runner)) return false;
  for (const auto& observer : observers) observer->on_step(runner);
  return true;
}

/// @returns whether the bout came to its end; if not, the runner's status or the device says why
bool run(DuelRunner& runner, const Observers& observers, const Options& options,
         const Outputs& outputs, DevicePartner* device) {
  const bool device_keeps_time = device != nullptr && device->mode() == link::Mode::kFree;
  if (outputs.view) outputs.controls()->begin(device_keeps_time);
  for (const auto& observer : observers) observer->on_start(runner);
  Pacing pacing(options.realtime && !(outputs.view && device_keeps_time), outputs.controls());
  bool going_on = !is_interrupted();
  while (going_on) {  // Bound: the steps up to runner.limit()
    if (!make_step(runner, observers, device, going_on)) return false;
    if (options.realtime) std::fflush(stdout);
    going_on = going_on && !is_output_lost() && pacing.wait();
  }
  return true;
}

/// The last words. JSON ends with the summary, the log with what the device has to say.
void conclude(const DuelRunner& runner, const Observers& observers, DevicePartner* device,
              bool json) {
  if (device != nullptr && json) print_device_json(stdout, *device);
  if (device == nullptr || device->session() == Session::kGoingOn) {
    for (const auto& observer : observers) observer->on_end(runner);
  }
  if (device != nullptr && !json) print_device(stdout, *device);
}

/// Sessions with a device that may be lost before the program gives up.
constexpr std::uint32_t kMostLost = 10;

enum class BoutEnd : std::uint8_t {
  kOver,
  kDeviceLost,  ///< another session may be tried
  kAgain,       ///< the viewer wants another bout
  kFailed,      ///< and everything has been said
};

/// What became of a bout that its device did not follow to its end.
BoutEnd give_up_on(const DevicePartner& device) {
  const bool again = device.session() == Session::kLost && device.lost_sessions() <= kMostLost &&
                     !is_interrupted();
  complain(kExitFailure, device.problem() + (again ? "; a new session begins" : ""));
  return again ? BoutEnd::kDeviceLost : BoutEnd::kFailed;
}

BoutEnd fail(const std::string& what) {
  complain(kExitFailure, what);
  return BoutEnd::kFailed;
}

/// A recording or a picture holds one bout: each begins the file anew. @returns empty | why not
std::string open_files(const Options& options, Outputs& outputs) {
  for (const auto& [path, file] : outputs.pictures(options)) {  // Bound: 2
    if (path->empty()) continue;
    const std::string problem = file->open(*path);
    if (!problem.empty()) return *path + ": cannot be written: " + problem;
  }
  return options.record.empty() ? "" : outputs.record.open(options.record);
}

/// A bout that is over stays in sight until its viewer has seen enough.
BoutEnd end_in_sight(const Outputs& outputs) {
  if (!outputs.view) return BoutEnd::kOver;
  return wait_for_wish(*outputs.controls()) == ViewWish::kRestart ? BoutEnd::kAgain
                                                                  : BoutEnd::kOver;
}

/// A firmware's fencers stand where the library puts them.
float distance_of(const Options& options, DeviceSetup& setup) {
  if (options.distance > 0) return static_cast<float>(options.distance);
  const bool sees = setup.source(Side::kLeft).sees() || setup.source(Side::kRight).sees();
  return sees && setup.partner() == nullptr ? fencing::Opponent::kOnGuard : BoutRules().distance;
}

BoutRules rules_of(const Options& options, DeviceSetup& setup) {
  const bool paper = options.search == name_of(SearchKind::kStepping);
  return {options.touches, paper ? SearchKind::kStepping : SearchKind::kAdvancement,
          distance_of(options, setup)};
}

BoutEnd play_bout(const Options& options, DeviceSetup& setup, Outputs& outputs) {
  const std::string error = open_files(options, outputs);
  if (!error.empty()) return fail(error);
  DevicePartner* device = setup.partner();
  if (device != nullptr && !device->open(options.touches)) return fail(device->problem());
  watch_interrupts();  // until here, who waits for a board or a pipe is ended by a signal
  for (const Side side : {Side::kLeft, Side::kRight}) setup.source(side).rewind();
  const auto runner =
      std::make_unique<DuelRunner>(setup.source(Side::kLeft), setup.source(Side::kRight),
                                   options.seconds, rules_of(options, setup));
  if (runner->start() != Status::kOk) return fail("the fencers are not valid");
  const Observers observers = make_observers(options, runner->limit(), outputs);
  const bool ended = run(*runner, observers, options, outputs, device);
  if (runner->status() != Status::kOk) {
    return fail("step " + std::to_string(runner->bout().steps() + 1) +
                " was not made: the bout refused it");
  }
  const BoutEnd end = ended ? BoutEnd::kOver : give_up_on(*device);
  if (end != BoutEnd::kDeviceLost) conclude(*runner, observers, device, options.json);
  std::fflush(stdout);
  if (is_output_lost()) return BoutEnd::kFailed;  // which main() tells
  return end == BoutEnd::kOver ? end_in_sight(outputs) : end;
}

/// One bout; with a device that was lost on the way, or a viewer who wants it, another one.
int play_bouts(const Options& options, DeviceSetup& setup, Outputs& outputs) {
  BoutEnd end = BoutEnd::kAgain;
  while (end == BoutEnd::kDeviceLost || end == BoutEnd::kAgain) {
    // Bound: kMostLost + 1 sessions, and the patience of who watches
    end = play_bout(options, setup, outputs);
  }
  return end == BoutEnd::kOver ? kExitOk : kExitFailure;
}

/// Opens a source and says what there is to say.
OpenedSource open(const std::string& words) {
  OpenedSource opened = open_source(words);
  if (!opened.error.empty()) complain(kExitUsage, opened.error);
  if (!opened.note.empty()) complain(kExitOk, opened.note);
  return opened;
}

/// @returns empty | why there is no window where there is to be one
std::string open_window(const Options& options, const ViewNames& names, Outputs& outputs) {
  if (!options.view) return {};
  OpenedView opened = open_view(names);
  outputs.view = std::move(opened.view);
  return opened.error;
}

/// Whether all files that were to be written are; each is brought to its end, whatever becomes of
/// the others.
int finish(const Options& options, Outputs& outputs) {
  int exit_code = kExitOk;
  const auto tell = [&exit_code](const std::string& path, const std::string& problem) {
    if (!problem.empty())
      exit_code = complain(kExitFailure, path + ": cannot be written: " + problem);
  };
  for (const auto& [path, file] : outputs.pictures(options)) {  // Bound: 3
    if (!path->empty()) tell(*path, file->commit());
  }
  if (!options.record.empty()) tell(options.record, outputs.record.close());
  return exit_code;
}

/// @returns null: there is none, for a reason that has been told unless it is the usual one
LiveForce* open_force(Source& source, const ForceOptions& effects) {
  LiveForce* const force = source.force(effects);
  if (force == nullptr || force->first_kind() != ForceKind::kNone) return force;
  const std::string& problem = force->problem();
  if (!problem.empty()) complain(kExitOk, source.description() + ": no force: " + problem);
  return nullptr;
}

/// The ways back into the hands, where there are some.
std::array<LiveForce*, 2> open_forces(const Options& options, Source& left, Source& right) {
  if (options.force == "off") return {};
  ForceOptions effects;
  effects.spring.coefficient = options.spring;
  effects.damper.coefficient = options.damper;
  return {open_force(left, effects), open_force(right, effects)};
}

/// Effects that were asked for, and that no device will compute, are worth a word.
void tell_of_effects(const Options& options, const std::array<LiveForce*, 2>& forces) {
  bool done = options.spring + options.damper <= 0;
  for (const LiveForce* force : forces) {  // Bound: 2
    done = done || (force != nullptr && force->first_kind() == ForceKind::kForce);
  }
  if (!done) complain(kExitOk, "--spring and --damper: no device here has a force to do that");
}

std::vector<NamedFile> read_by(const OpenedSource& left, const OpenedSource& right) {
  std::vector<NamedFile> files;
  for (const std::string& path : left.files) files.push_back({"--left", path});
  for (const std::string& path : right.files) files.push_back({"--right", path});
  return files;
}

std::vector<NamedFile> written_by(const Options& options) {
  std::vector<NamedFile> files;
  for (const NamedFile& file : {NamedFile{"--svg", options.svg},
                                {"--figure", options.figure},
                                {"--strip", options.strip},
                                {"--record", options.record}}) {
    if (!file.path.empty()) files.push_back(file);
  }
  return files;
}

int play(Options options) {
  const OpenedSource left = open(options.left);
  if (!left.source) return kExitUsage;
  const OpenedSource right = open(options.right);
  if (!right.source) return kExitUsage;
  std::string error = clash_of(read_by(left, right), written_by(options));
  if (!error.empty()) return complain(kExitUsage, error);
  DeviceSetup setup;
  error = setup.open(left, right, patience_of(options.patience));
  if (!error.empty()) return complain(kExitUsage, error);
  if (setup.partner() != nullptr && options.distance > 0)
    return complain(kExitUsage, "--distance: the firmware has its own; it cannot be compared");
  if (setup.partner() != nullptr && rules_of(options, setup).search != SearchKind::kAdvancement)
    return complain(kExitUsage, "--search: the firmware has advancement; it cannot be compared");
  Outputs outputs;
  error = open_window(options, {left.source->description(), right.source->description()}, outputs);
  if (!error.empty()) return complain(kExitUsage, error);
  outputs.forces = open_forces(options, *left.source, *right.source);
  tell_of_effects(options, outputs.forces);
  if (left.source->is_live() || right.source->is_live() || outputs.view) options.realtime = true;
  const int exit_code = play_bouts(options, setup, outputs);
  if (exit_code == kExitOk) return outputs.end_view(finish(options, outputs));
  // What a bout that failed has recorded may tell why.
  if (outputs.record.has_taken()) (void)outputs.record.close();
  return exit_code;
}

/// A recorded bout instead of one of two sources.
int play_again(const Options& options) {
  Outputs outputs;
  std::string error = clash_of({{"--replay", options.replay}}, {});
  if (!error.empty()) return complain(kExitUsage, error);
  error = open_window(options, {options.replay, options.replay}, outputs);
  if (!error.empty()) return complain(kExitUsage, error);
  if (outputs.view) watch_interrupts();
  const Replay result = outputs.view ? show_replay(options.replay, *outputs.view, outputs.feed)
                                     : replay(options.replay);
  const int exit_code = exit_code_for(result);
  if (exit_code != kExitOk) return complain(exit_code, words_for(result));
  std::printf("%s\n", words_for(result).c_str());
  return outputs.end_view(kExitOk);
}

int run_program(int count, char** words) {
  try {
    const auto line = read_command_line(count, words);
    if (!line.run) return line.exit_code;
    return line.options.replay.empty() ? play(line.options) : play_again(line.options);
  } catch (const std::exception& problem) {
    return complain(kExitFailure, problem.what());
  }
}

}  // namespace
}  // namespace batuta::host

int main(int count, char** words) {
  batuta::host::begin_output();
  const int exit_code = batuta::host::run_program(count, words);
  batuta::host::HeldExit::end_program(batuta::host::finish_output("batuta-duel", exit_code));
}
