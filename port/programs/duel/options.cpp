// SPDX-License-Identifier: MIT

#include "programs/duel/options.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <vector>

namespace batuta::host {
namespace {

constexpr const char* kAbout =
    "A fencing bout between two input devices: motion moves blades, blades meet, somebody is "
    "touched.";

constexpr const char* kFooter = R"(SOURCE is one of
  FILE.events, FILE.evemu  a recording in the evemu format; its device description is taken from
                           the file or from FILE.desc beside it
  default                  the synthetic recording that is built into the program
  script:guard, script:parry, script:attack
                           a simple opponent
  device:/dev/input/eventN a live stick, pad or mouse of the Linux input stack; a path below
                           /dev/input/by-id is that of the same device after it was unplugged
  device:sdl, device:sdl:INDEX, device:sdl:NAME
                           a live stick or pad as SDL finds it: the first, the one at this place
                           of its list, or the one with this in its name
  serial:LINE[@BAUD]       the fencing firmware at the other end of a serial line, with its own stick;
                           3000000 baud unless the words say otherwise
  serial:LINE[@BAUD],SOURCE
                           the same, with a recording, a script or a live device in place of its
                           stick
                           (here and there the bout is the same, to the last bit; this is checked
                           after every step)
The bout ends with a touch, or when the recordings are at their end; without any, after 180 s.
After one of two recordings has ended, its fencer stays where it is.

The stick: centre is the guard, up is the lunge, left and right at the centre or below are the
parries, down is the retreat. Up is where a mouse moves away from you.

A live device is real time: --realtime goes without saying. While it is unplugged its fencer
stays where it is and has no force; plugged in again, it goes on.
Ctrl-C ends a bout, whose result is then "open"; a second one does not wait for its summary.
Where a live device has force feedback, or at least rumbles, its fencer feels the blows, unless
--force off. --spring and --damper add effects that the device computes by itself.

With --json each line of the output is an object; "type" is start, contact, touch or, in the last
line, summary. SI units. Contacts that only persist are counted in the summary, not listed.

A serial device that has not answered a step for the --patience is given up; what has just been
switched on is given 5 s. An emulator on a busy machine takes longer than a board.

With a serial device, a line of the type "link" before the summary tells what the cable did; with
a force, a line of the type "force" how well it came through.

With --replay no source is opened: the samples come from the file, and after every step the state
of the duel is compared with the recorded one. A recording made on another machine must agree.

Exit codes: 0 the bout ran; 1 something failed on the way, such as writing the picture, a device
            that does not answer, or one that computes other bits, or a replay that parts from
            its recording, or a recording that goes on behind its end; 2 wrong usage, or a source
            or recording that cannot be read)";

/// The length of a bout, whose steps of 1 ms are counted in 32 bits.
std::string seconds_of_a_bout(const std::string& words) {
  constexpr double kMost = 4e6;
  double value = 0;
  const bool number = CLI::detail::lexical_cast(words, value);
  return number && value > 0 && value <= kMost
             ? ""
             : words + " is not a number above 0 and at most 4000000";
}

/// CLI::Range lets what is not a number pass.
std::string share_of_range(const std::string& words) {
  double value = 0;
  const bool number = CLI::detail::lexical_cast(words, value);
  return number && value >= 0 && value <= 1 ? "" : words + " is not a number from 0 to 1";
}

/// A silence that the line's clock, of 32 bits in us, can measure with room to spare.
std::string seconds_of_silence(const std::string& words) {
  double value = 0;
  const bool number = CLI::detail::lexical_cast(words, value);
  return number && value >= 0.1 && value <= 1000 ? "" : words + " is not a number from 0.1 to 1000";
}

std::string file_name(const std::string& words) {
  return words.empty() ? "a file has a name" : "";
}

/// @returns those that ask for a force
std::vector<CLI::Option*> declare_force(CLI::App& app, Options& options) {
  CLI::Option* const force =
      app.add_option("--force", options.force, "let the hands at live devices feel the bout");
  force->check(CLI::IsMember({"on", "off"}))->capture_default_str();
  CLI::Option* const spring = app.add_option("--spring", options.spring,
                                             "the stick pulls to its centre, 0 to 1 of its range");
  CLI::Option* const damper =
      app.add_option("--damper", options.damper, "the stick resists movement, 0 to 1 of its range");
  for (CLI::Option* share : {spring, damper}) {
    share->type_name("SHARE")->check(share_of_range)->capture_default_str();
  }
  return {force, spring, damper};
}

void declare(CLI::App& app, Options& options) {
  CLI::Option* const left = app.add_option("--left", options.left, "who fences on the left");
  left->type_name("SOURCE")->capture_default_str();
  CLI::Option* const right = app.add_option("--right", options.right, "who fences on the right");
  right->type_name("SOURCE")->capture_default_str();
  CLI::Option* const json =
      app.add_flag("--json", options.json, "print one JSON object a line instead of the log");
  CLI::Option* const svg = app.add_option("--svg", options.svg, "draw the bout into this file");
  svg->type_name("FILE")->check(file_name);
  CLI::Option* const realtime = app.add_flag("--realtime", options.realtime,
                                             "as fast as it happens, not as fast as possible");
  CLI::Option* const seconds = app.add_option(
      "--seconds", options.seconds, "end the bout after so many seconds, at most 4000000");
  seconds->type_name("LIMIT")->check(seconds_of_a_bout);
  CLI::Option* const record =
      app.add_option("--record", options.record, "record the bout into this file");
  record->type_name("FILE")->check(file_name);
  CLI::Option* const replay = app.add_option(
      "--replay", options.replay, "go through a recorded bout again and compare every step");
  replay->type_name("FILE")->check(file_name);
  CLI::Option* const patience =
      app.add_option("--patience", options.patience, "wait so long for a silent serial device");
  patience->type_name("SECONDS")->check(seconds_of_silence)->capture_default_str();
  std::vector<CLI::Option*> others = declare_force(app, options);
  others.insert(others.end(), {left, right, json, svg, realtime, seconds, record, patience});
  for (CLI::Option* other : others) replay->excludes(other);
  app.set_version_flag("--version", "batuta-duel " BATUTA_VERSION);
  app.footer(kFooter);
}

}  // namespace

CommandLine read_command_line(int count, char** words) {
  CommandLine line;
  CLI::App app(kAbout, "batuta-duel");
  declare(app, line.options);
  try {
    app.parse(count, words);
    line.run = true;
  } catch (const CLI::ParseError& stop) {
    if (stop.get_exit_code() == 0) {
      line.exit_code = app.exit(stop);  // --help, --version
    } else {
      std::fprintf(stderr, "batuta-duel: %s (--help tells more)\n", stop.what());
      line.exit_code = kExitUsage;
    }
  }
  return line;
}

}  // namespace batuta::host
