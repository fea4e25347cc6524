// SPDX-License-Identifier: MIT

#include "programs/duel/options.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <vector>

#include "batuta/fencing/bout.hpp"

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
                           a simple opponent: a pattern that sees nothing
  script:novice, script:club, script:master
                           an opponent that sees and decides; with @SEED behind it, another one
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
The bout goes to --touches: after each touch a halt of 1 s, then both are on guard again; the same
where both have stood body to body for 2 s (corps a corps). Two touches within 40 ms count for both;
where one is missing to either, they are annulled, but in a bout to one touch, which they end. The
bout ends sooner when the recordings are at their end; without any, after 180 s. Who has more
touches then wins.
After one of two recordings has ended, its fencer stays where it is.

The stick: centre is the guard, up are the lunges, from left to right high inside, low inside, low
outside, high outside; left and right are the parries quarte and sixte, below them septime and
octave; half way up the middle is the beat, down is the retreat. Up is where a mouse moves away from
you.

A live device is real time: --realtime goes without saying. While it is unplugged its fencer
stays where it is and has no force; plugged in again, it goes on.
Ctrl-C ends a bout, whose result is then "open"; a second one does not wait for its summary.
--figure shows its blades before, at and after the blow between them that had the largest impulse,
with their velocities; --strip shows both fencers in the third of a second before its last touch.

Where a live device has force feedback, or at least rumbles, its fencer feels the blows, unless
--force off. --spring and --damper add effects that the device computes by itself.

With --view a window shows the bout: the salle from the side and from above, the score, the sticks
and the force on them. Its steps are then made as they happen. Keys: Space pauses and goes on; a
point (.) makes one step; 1, 2 and 3 are the whole speed, a quarter and a twentieth; R begins the
bout again; Q, Escape or closing the window ends it. What is over stays in sight. A device that
makes its steps by itself (serial:LINE without SOURCE) waits for nobody: R and Q work.

On guard the fencers stand 2.25 m apart, where a lunge just arrives; with an opponent that sees they
stand 4 m apart, each 2 m from the middle, and walk: --distance. A firmware has the former.

With --search stepping the bout is found by the paper's own search, which may miss a touch that is
shallower than 1 mm and takes more time. A firmware has the other one: not with serial:. A recording
is gone through again with the search that it was made with.

With --json each line of the output is an object; "type" is start, contact, touch, halt or, in the
last line, summary. SI units. Contacts that only persist are counted in the summary, not listed.

A serial device that has not answered a step for the --patience is given up; what has just been
switched on is given 5 s. An emulator on a busy machine takes longer than a board.

With a serial device, a line of the type "link" before the summary tells what the cable did; with
a force, a line of the type "force" how well it came through.

With --replay no source is opened: the samples come from the file, and after every step the state
of the duel is compared with the recorded one. A recording made on another machine must agree.

Exit codes: 0 the bout ran; 1 something failed on the way, such as writing the picture or the
            log, a device that does not answer, or one that computes other bits, or a replay that
            parts from its recording, or a recording that goes on behind its end; 2 wrong usage,
            or a source or recording that cannot be read)";

/// The length of a bout, whose steps of 1 ms are counted in 32 bits.
std::string seconds_of_a_bout(const std::string& words) {
  constexpr double kMost = 4e6;
  double value = 0;
  const bool number = CLI::detail::lexical_cast(words, value);
  return number && value > 0 && value <= kMost
             ? ""
             : words + " is not a number above 0 and at most 4000000";
}

/// In decimal: 010 and 0x5 would be numbers of other bases.
std::string number_of_touches(const std::string& words) {
  int value = 0;
  const bool is_decimal =
      words.find_first_not_of("0123456789") == std::string::npos && words.find_first_of('0') != 0;
  const bool number = is_decimal && CLI::detail::lexical_cast(words, value);
  return number && value >= 1 && value <= fencing::kMostTouches
             ? ""
             : words + " is not a whole number from 1 to 99";
}

/// No nearer than the feet may come, and with room behind on the strip.
std::string metres_apart(const std::string& words) {
  double value = 0;
  const bool number = CLI::detail::lexical_cast(words, value);
  return number && value >= 1.5 && value <= 10 ? "" : words + " is not a number from 1.5 to 10";
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

/// @returns those that ask for a file
std::vector<CLI::Option*> declare_pictures(CLI::App& app, Options& options) {
  CLI::Option* const svg = app.add_option("--svg", options.svg, "draw the bout into this file");
  CLI::Option* const figure = app.add_option("--figure", options.figure,
                                             "draw the hardest beat of the bout into this file");
  CLI::Option* const strip =
      app.add_option("--strip", options.strip, "draw how the last touch came about into this file");
  for (CLI::Option* picture : {svg, figure, strip}) picture->type_name("FILE")->check(file_name);
  app.add_flag("--view", options.view, "show the bout in a window, as it happens");
  return {svg, figure, strip};
}

void declare(CLI::App& app, Options& options) {
  CLI::Option* const left = app.add_option("--left", options.left, "who fences on the left");
  left->type_name("SOURCE")->capture_default_str();
  CLI::Option* const right = app.add_option("--right", options.right, "who fences on the right");
  right->type_name("SOURCE")->capture_default_str();
  CLI::Option* const json =
      app.add_flag("--json", options.json, "print one JSON object a line instead of the log");
  const std::vector<CLI::Option*> pictures = declare_pictures(app, options);
  CLI::Option* const realtime = app.add_flag("--realtime", options.realtime,
                                             "as fast as it happens, not as fast as possible");
  CLI::Option* const seconds = app.add_option(
      "--seconds", options.seconds, "end the bout after so many seconds, at most 4000000");
  seconds->type_name("LIMIT")->check(seconds_of_a_bout);
  CLI::Option* const touches =
      app.add_option("--touches", options.touches, "the bout goes to so many touches, 1 to 99");
  touches->type_name("N")->check(number_of_touches)->capture_default_str();
  CLI::Option* const distance =
      app.add_option("--distance", options.distance,
                     "between the fencers on guard, 1.5 to 10 (2.25; 4 if one of them sees)");
  distance->type_name("METRES")->check(metres_apart);
  CLI::Option* const search = app.add_option(
      "--search", options.search, "how contacts are found: surely, or as the paper does it");
  search->check(CLI::IsMember({"advancement", "stepping"}))->capture_default_str();
  CLI::Option* const record =
      app.add_option("--record", options.record, "record the bout into this file");
  record->type_name("FILE")->check(file_name);
  CLI::Option* const replay = app.add_option(
      "--replay", options.replay,
      "go through a recorded bout again and compare every step; goes with --view only");
  replay->type_name("FILE")->check(file_name);
  CLI::Option* const patience =
      app.add_option("--patience", options.patience, "wait so long for a silent serial device");
  patience->type_name("SECONDS")->check(seconds_of_silence)->capture_default_str();
  std::vector<CLI::Option*> others = declare_force(app, options);
  others.insert(others.end(), pictures.begin(), pictures.end());
  others.insert(others.end(), {left, right, json, realtime, seconds, touches, distance, search,
                               record, patience});
  // CLI11's own excludes() would fill the help with what excludes what.
  app.final_callback([replay, others] {
    for (const CLI::Option* other : others) {
      if (replay->count() > 0 && other->count() > 0) {
        throw CLI::ExcludesError(replay->get_name(), other->get_name());
      }
    }
  });
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
