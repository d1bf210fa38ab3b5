#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch.hpp>
#include <filesystem>
#include <sstream>

#include "files.hpp"
#include "program.hpp"

/// What every command says at a terminal of eighty columns.
namespace swayaw::app {
namespace {

constexpr std::size_t columns = 80;

/// What a command of the shell prints to a terminal; what goes to stderr is left out.
std::string at_terminal(const std::string& command) {
  winsize size{.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
  int terminal = -1;
  const auto child = ::forkpty(&terminal, nullptr, nullptr, &size);
  REQUIRE(child >= 0);
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", (command + " 2>/dev/null").c_str(), nullptr);
    ::_exit(127);
  }
  std::string text;
  char piece[4096];
  for (ssize_t read = 0; (read = ::read(terminal, piece, sizeof piece)) > 0;)
    text.append(piece, static_cast<std::size_t>(read));
  ::close(terminal);
  int status = 0;
  ::waitpid(child, &status, 0);
  std::erase(text, '\r');
  return text;
}

std::size_t width_of(std::string_view line) {
  return static_cast<std::size_t>(
      std::ranges::count_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Lines that are wider than the terminal, unless by one word that cannot be folded, or end with blanks.
std::vector<std::string> unfit_lines(const std::string& text) {
  std::vector<std::string> unfit;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const bool words = line.find(' ', line.find_first_not_of(' ')) != std::string::npos;
    if ((width_of(line) > columns && words) || line.ends_with(' ')) unfit.push_back(line);
  }
  return unfit;
}

std::string example(const char* name) { return (test::example_recordings / name).string(); }

/// Every command with words to a person, in a folder of its own.
std::vector<std::string> commands_in(const test::Scratch& folder) {
  const auto zigzag = example("weak_rudder_zz10_10.csv"), turn = example("weak_rudder_turn35.csv"),
             both = zigzag + " " + turn, model = test::ship_file("kvlcc2_l7.toml"),
             out = " --out " + (folder / "out").string();
  std::vector<std::string> commands;
  for (const auto& ship : std::filesystem::directory_iterator(test::ships)) {
    const auto file = ship.path().string();
    for (const char* words : {"indices", "invert", "linearize"}) commands.push_back(words + (" " + file));
    commands.push_back("loop " + file + " --zigzag 10/10");
    commands.push_back("forces " + file + " --state u=1,v=0.05,r=-0.01,delta=0.1");
    for (const char* manoeuvre : {"--zigzag 10/10", "--turn 35 --first port", "--spiral", "--reverse-spiral",
                                  "--pullout 15", "--williamson", "--imo", "--straight 30"})
      commands.push_back("simulate " + file + " " + manoeuvre);
  }
  for (const std::string& words :
       {"invert " + test::ship_file("tanker97_nomoto.toml") + " --parts " + test::ship_file("tanker97.toml"),
        "compare " + model + " " + both, "replay " + model + " " + zigzag + out, "trial " + both + " --ship " + model,
        "trial " + zigzag, "check " + both, "import " + zigzag + out + " --split",
        "identify " + zigzag + " --ship " + model + " --model linear" + out,
        "identify " + both + " --ship " + model + " --model mmg --find Y_v,N_v,N_r --resample" + out,
        "estimate --length 230 --beam 32.2 --draught 10.8 --block 0.651 --trim 0.5 --depth 19" + out,
        "tune " + test::ship_file("nawigator_ym.toml") + " --indices " +
            (test::example_recordings / "../indices/nawigator.toml").string() + " --prior 1 --bound 1 --turns 20" + out,
        "diagnose " + model + " " + zigzag + " --holdout " + turn})
    commands.push_back(words);
  for (const char* command : {"", "check", "compare", "diagnose", "estimate", "forces", "identify", "import", "indices",
                              "invert", "linearize", "loop", "replay", "simulate", "trial", "tune"})
    commands.push_back(std::string(command) + " --help");
  return commands;
}

TEST_CASE("no command says anything wider than a terminal of eighty columns", "[app][limit]") {
  const test::Scratch folder;
  for (const auto& command : commands_in(folder)) {
    INFO(command);
    const auto text = at_terminal(std::string(SWAYAW_PROGRAM) + " " + command);
    CHECK(unfit_lines(text) == std::vector<std::string>{});
  }
}

TEST_CASE("words to a file are not folded, and their lines do not end with blanks", "[app][limit]") {
  const test::Scratch folder;
  const auto trial = test::run(folder, "trial " + example("weak_rudder_turn35.csv"));
  CHECK_THAT(trial.out, Catch::Contains("the drift by current and wind cannot be told: the turn ends after 496 deg"));
  CHECK(trial.out.find(" \n") == std::string::npos);
}

}  // namespace
}  // namespace swayaw::app
