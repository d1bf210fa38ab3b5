#include <catch.hpp>
#include <chrono>
#include <cmath>
#include <map>

#include "files.hpp"
#include "random_manoeuvres.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/import.hpp"
#include "swayaw/core/manoeuvres_in.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "trial_logs.hpp"

/// What was sailed is found: its kind, its angles, its side, its execution within a sample; and nothing else is.
namespace swayaw {
namespace {

using test::Sailed;
using test::TrialFaults;
using test::TrialLog;

/// Manoeuvres without steady runs.
std::vector<ManoeuvrePiece> sailed_in(const Recording& run) {
  auto pieces = manoeuvres_in(run);
  std::erase_if(pieces, [](const auto& piece) { return !piece.execute.has_value(); });
  return pieces;
}

std::string words(const std::vector<ManoeuvrePiece>& pieces) {
  std::string text;
  for (const auto& p : pieces)
    text += fmt::format("{} at {:.1f} from {:.0f} to {:.0f}: {}\n", p.manoeuvre, p.execute.value_or(-1.0), p.begin,
                        p.end, p.why);
  return text;
}

std::string words(const std::vector<Sailed>& sailed) {
  std::string text;
  for (const auto& s : sailed) text += fmt::format("{} at {:.1f} to {}\n", s.name, s.execute, name_of(s.side));
  return text;
}

/// What is wrong with what was found; empty if nothing is.
std::string fault(const TrialLog& log, int& beyond_a_sample) {
  const auto found = sailed_in(log.run());
  const auto& sailed = log.sailed();
  std::string wrong = found.size() == sailed.size() ? "" : "number; ";
  for (std::size_t k = 0; k < std::min(found.size(), sailed.size()); ++k) {
    if (found[k].manoeuvre != sailed[k].name) wrong += sailed[k].name + " is named " + found[k].manoeuvre + "; ";
    const double late = std::abs(*found[k].execute - sailed[k].execute) / log.moment();
    if (late > 1.5) wrong += sailed[k].name + " executed; ";
    beyond_a_sample += late > 1.01 ? 1 : 0;
    if (found[k].why.find("to " + std::string(name_of(sailed[k].side))) == std::string::npos) wrong += "side; ";
    if (found[k].begin > *found[k].execute - 20.0 || found[k].end < *found[k].execute + 20.0) wrong += "margins; ";
  }
  return wrong.empty() ? wrong : wrong + "\nfound\n" + words(found) + "sailed\n" + words(sailed);
}

std::string fault(const TrialLog& log) {
  int ignored = 0;
  return fault(log, ignored);
}

/// A tanker-like ship of the size of a ship or of a model.
struct TestShip {
  Ship ship;
  double length, speed;
};

TestShip random_ship(unsigned seed) {
  test::RandomShips random(seed);
  auto model = random.ship();
  model.steering_gear.max_angle = radians(35.0);
  if (seed % 3 != 0) model = test::mmg(test::kvlcc2());
  return {test::with_model(model), model.particulars.L, model.particulars.U_0};
}

TrialFaults random_faults(unsigned seed) {
  test::RandomShips random(1000 + seed);
  TrialFaults faults;
  faults.rudder_rounding = radians(std::array{0.0, 0.1, 0.5, 1.0}[seed % 4]);
  faults.rudder_zero = radians(random.uniform(-1.0, 1.0));
  faults.missing_share = seed % 2 == 0 ? 0.0 : 0.05;
  faults.helm_noise = radians(random.uniform(0.2, 2.0));
  return faults;
}

Side random_side(TrialLog& log) { return log.uniform(0.0, 1.0) < 0.5 ? Side::port : Side::starboard; }

void sail_one(TrialLog& log) {
  const auto pick = static_cast<int>(log.uniform(0.0, 8.0));
  const auto side = random_side(log);
  const auto reversals = static_cast<int>(log.uniform(2.0, 6.0));
  switch (pick) {
    case 0: return log.zigzag(10, 10, side, reversals);
    case 1: return log.zigzag(20, 20, side, reversals);
    case 2: return log.zigzag(10, 5, side, reversals);
    case 3: return log.zigzag(20, 10, side, reversals);
    case 4: return log.zigzag(15, 15, side, reversals);
    case 5: return log.turn(35, side, radians(log.uniform(220.0, 560.0)));
    case 6: return log.turn(20, side, radians(log.uniform(220.0, 400.0)));
    default: return log.turn(15, side, radians(log.uniform(220.0, 400.0)));
  }
}

TEST_CASE("every manoeuvre of a long log is found, and none is invented", "[nonlinear][manoeuvres_in]") {
  int wrong = 0, sailed = 0, beyond_a_sample = 0;
  for (unsigned seed = 0; sailed < 200; ++seed) {
    const auto ship = random_ship(seed);
    TrialLog log(ship.ship, ship.length, ship.speed, seed, random_faults(seed));
    log.steam(200.0);
    for (int k = 0; k < 3; ++k) {
      if (log.uniform(0.0, 1.0) < 0.5) log.change_course(log.uniform(-radians(60.0), radians(60.0)));
      log.steam(log.uniform(150.0, 500.0));
      sail_one(log);
    }
    log.steam(200.0);
    if (!log.keeps_course()) continue;  // unstable beyond what rudder and autopilot can do
    ++sailed;
    const auto what = fault(log, beyond_a_sample);
    if (!what.empty()) UNSCOPED_INFO("seed " << seed << ": " << what);
    wrong += what.empty() ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(beyond_a_sample <= 6);  // of 600: noise of the rudder on its way
}

TEST_CASE("straight courses and an autopilot's changes of course are no manoeuvres", "[nonlinear][manoeuvres_in]") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const auto ship = random_ship(seed);
    TrialLog log(ship.ship, ship.length, ship.speed, 500 + seed, random_faults(seed));
    for (int k = 0; k < 12; ++k) {
      log.steam(log.uniform(60.0, 900.0));
      log.change_course(log.uniform(-radians(120.0), radians(120.0)));
    }
    INFO("seed " << seed << "\n" << words(sailed_in(log.run())));
    CHECK(sailed_in(log.run()).empty());
  }
}

TEST_CASE("a hand that steers by steps of 5 deg in waves sails no manoeuvres", "[nonlinear][manoeuvres_in]") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const auto ship = random_ship(seed);
    auto faults = random_faults(seed);
    faults.helm_steps = radians(seed % 2 == 0 ? 5.0 : 2.5);
    faults.helm_noise = radians(1.0 + 0.1 * seed);
    TrialLog log(ship.ship, ship.length, ship.speed, 700 + seed, faults);
    for (int k = 0; k < 6; ++k) {
      log.steam(log.uniform(60.0, 1500.0));
      log.change_course(log.uniform(-radians(60.0), radians(60.0)));
    }
    INFO("seed " << seed << "\n" << words(sailed_in(log.run())));
    CHECK(sailed_in(log.run()).empty());
  }
}

// ---------------------------------------------------------------- spirals, pull-outs, speed runs

TEST_CASE("spirals are found", "[nonlinear][manoeuvres_in]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto ship = random_ship(seed);
    TrialLog log(ship.ship, ship.length, ship.speed, seed, random_faults(seed));
    log.steam(200.0);
    log.spiral(seed % 2 == 0 ? 25 : 20, 5, random_side(log), 8.0 * ship.length / ship.speed);
    log.steam(300.0);
    INFO("seed " << seed);
    CHECK(fault(log) == "");
  }
}

TEST_CASE("a pull-out follows a turn where the rudder stays amidships", "[nonlinear][manoeuvres_in]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto ship = random_ship(seed);
    auto faults = random_faults(seed);
    faults.rudder_zero = 0.0;
    TrialLog log(ship.ship, ship.length, ship.speed, seed, faults);
    log.steam(200.0);
    log.pull_out(20, random_side(log), radians(270.0), 20.0 * ship.length / ship.speed);
    log.steam(200.0);
    const auto found = sailed_in(log.run());
    INFO("seed " << seed << "\n" << words(found));
    REQUIRE(found.size() == 2);
    CHECK(found[0].manoeuvre == "turn 20");
    CHECK(found[1].manoeuvre == "pull-out 20");
    CHECK(std::abs(*found[1].execute - log.sailed()[1].execute) <= 2.0 * log.step());
    CHECK(found[1].begin < *found[1].execute - 20.0);
    CHECK(found[0].end <= *found[1].execute + 2.0 * log.step());
  }
}

TEST_CASE("two steady runs on opposite headings are speed runs", "[nonlinear][manoeuvres_in]") {
  TestShip ship = random_ship(1);
  TrialLog log(ship.ship, ship.length, ship.speed, 7);
  log.steam(900.0);
  log.change_course(pi);
  log.steam(1500.0);
  log.change_course(radians(40.0));
  log.steam(900.0);
  std::vector<std::string> names;
  INFO(words(manoeuvres_in(log.run())));
  for (const auto& piece : manoeuvres_in(log.run())) names.push_back(piece.manoeuvre);
  CHECK(names == std::vector<std::string>{"speed run", "steady run", "speed run", "steady run", "steady run"});
}

// ---------------------------------------------------------------- laws

TEST_CASE("sign of the rudder, turns of the heading and the order in place of the angle do not matter",
          "[nonlinear][manoeuvres_in][symmetry]") {
  const auto ship = random_ship(1);
  auto faults = random_faults(1);
  TrialLog log(ship.ship, ship.length, ship.speed, 11, faults);
  log.steam(300.0);
  log.zigzag(10, 10, Side::port, 4);
  log.steam(300.0);
  log.turn(35, Side::starboard, radians(400.0));
  log.steam(300.0);
  REQUIRE(fault(log) == "");
  const auto expected = words(manoeuvres_in(log.run()));
  Recording other = log.run();
  for (double& delta : other.fill(Channel::delta)) delta = -delta;
  CHECK(words(manoeuvres_in(other)) == expected);
  for (double& psi : other.fill(Channel::psi)) psi += 2.0 * pi * std::round(3.0 * std::sin(psi));
  CHECK(words(manoeuvres_in(other)) == expected);
  std::swap(other.channels[index_of(Channel::delta)], other.channels[index_of(Channel::delta_order)]);
  CHECK(words(manoeuvres_in(other)) == expected);
}

TEST_CASE("a piece is a recording that holds its manoeuvre alone", "[nonlinear][manoeuvres_in][round-trip]") {
  const auto ship = random_ship(1);
  TrialLog log(ship.ship, ship.length, ship.speed, 12, random_faults(2));
  log.steam(900.0);
  log.zigzag(20, 20, Side::starboard, 4);
  log.steam(900.0);
  log.turn(20, Side::port, radians(380.0));
  log.steam(900.0);
  auto run = log.run();
  run.facts.remarks = {{"start_utc", "\"2020-09-14T23:59:00.000Z\""}, {"ship", "\"KVLCC2\""}};
  run.extra.push_back({"row", {}});
  for (std::size_t i = 0; i < run.samples(); ++i) run.extra.front().cells.push_back(std::to_string(i));
  for (const auto& piece : sailed_in(run)) {
    const auto part = parse_recording(recording_text(piece_of(run, piece)), "part.csv").recording;
    CHECK(part.time.front() == 0.0);
    CHECK(part.facts.manoeuvre == piece.manoeuvre);
    const auto first = std::stoul(part.extra.front().cells.front());
    CHECK(run.time[first] + *part.facts.execute == Approx(*piece.execute).margin(1e-9));
    CHECK(part.facts.remarks.size() == 2);
    const auto again = manoeuvres_in(part);
    INFO(words(again));
    REQUIRE(again.size() == 1);
    CHECK(again.front().manoeuvre == piece.manoeuvre);
    CHECK(std::abs(*again.front().execute - *part.facts.execute) <= log.moment());
  }
  const auto late =
      piece_of(run, {.begin = 3600.0, .end = 3700.0, .manoeuvre = "steady run", .execute = {}, .why = {}});
  CHECK(late.facts.remarks.front().value == "\"2020-09-15T00:59:00.000Z\"");
  CHECK_THROWS_AS(piece_of(run, {.begin = -20.0, .end = -10.0, .manoeuvre = {}, .execute = {}, .why = {}}),
                  std::domain_error);
}

TEST_CASE("a day at 1 Hz is searched in well under a second", "[nonlinear][manoeuvres_in][speed]") {
  Recording day;
  std::mt19937_64 random(1);
  std::normal_distribution noise(0.0, 1.0);
  for (int i = 0; i < 86400; ++i) {
    day.time.push_back(i);
    day.channels[index_of(Channel::psi)].push_back(radians(40.0 * std::sin(i / 3000.0) + noise(random)));
    day.channels[index_of(Channel::delta)].push_back(radians(4.0 * std::sin(i / 9.0) + noise(random)));
  }
  const auto begin = std::chrono::steady_clock::now();
  CHECK(sailed_in(day).empty());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  CHECK(taken.count() < 1.0);
}

// ---------------------------------------------------------------- recordings

/// $body*hh
std::string sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  return fmt::format("${}*{:02X}\r\n", body, sum);
}

TEST_CASE("the manoeuvres of a log of sentences are found, rudder to starboard", "[nonlinear][manoeuvres_in]") {
  const auto ship = random_ship(1);
  TrialFaults exact{.rudder_noise = 0.0, .rudder_rounding = 0.0, .missing_share = 0.0};
  TrialLog log(ship.ship, ship.length, ship.speed, 14, exact);
  log.steam(300.0);
  log.zigzag(10, 10, Side::starboard, 4);
  log.steam(300.0);
  log.turn(35, Side::port, radians(400.0));
  log.steam(300.0);
  std::string text;
  for (std::size_t i = 0; i < log.run().samples(); ++i) {
    const double psi = std::fmod(degrees(log.run()[Channel::psi][i]) + 720.0, 360.0);
    for (const auto& body :
         {fmt::format("HEHDT,{:.1f},T", psi), fmt::format("RIRSA,{:.1f},A,,V", -degrees(log.run()[Channel::delta][i]))})
      text += fmt::format("{:.2f} ", 1.6e9 + log.run().time[i]) + sentence(body);
  }
  const test::Scratch scratch;
  write_text(scratch / "trial.nmea", text);
  const auto run = parse_recording(import_nmea({scratch / "trial.nmea"}, {}).text, "trial.csv").recording;
  const auto found = sailed_in(run);
  INFO(words(found) << words(log.sailed()));
  REQUIRE(found.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(found[k].manoeuvre == log.sailed()[k].name);
    CHECK(std::abs(*found[k].execute - log.sailed()[k].execute) <= log.step());
  }
}

TEST_CASE("a recorded run that is one manoeuvre comes back as one piece", "[nonlinear][manoeuvres_in][published]") {
  struct Known {
    const char *folder, *file, *name;
  };
  const Known known[] = {
      {"kvlcc2", "hsva_zz05_01_stbd.csv", "zigzag 5/1"},    {"kvlcc2", "hsva_zz10_01_stbd.csv", "zigzag 10/1"},
      {"kvlcc2", "hsva_zz10_10_port.csv", "zigzag 10/10"},  {"kvlcc2", "hsva_zz10_10_stbd.csv", "zigzag 10/10"},
      {"kvlcc2", "hsva_zz15_05_stbd.csv", "zigzag 15/5"},   {"kvlcc2", "hsva_zz20_10_port.csv", "zigzag 20/10"},
      {"kvlcc2", "hsva_zz20_10_stbd.csv", "zigzag 20/10"},  {"kvlcc2", "hsva_zz30_05_stbd.csv", "zigzag 30/5"},
      {"kvlcc2", "marin_zz10_10_port.csv", "zigzag 10/10"}, {"kvlcc2", "marin_zz20_20_stbd.csv", "zigzag 20/20"},
      {"kcs", "kcs_turning_port_35.csv", "turn 35"},        {"kcs", "kcs_zigzag_port_10.csv", "zigzag 10/10"},
      {"kcs", "kcs_zigzag_port_20.csv", "zigzag 20/20"},
  };
  for (const auto& [folder, file, name] : known) {
    const auto recordings = test::benchmark_recordings(folder);
    if (!recordings) continue;
    const auto found = manoeuvres_in(read_recording(*recordings / file).recording);
    INFO(file << "\n" << words(found));
    REQUIRE(found.size() == 1);
    CHECK(found.front().manoeuvre == name);
  }
}

/// Adds a run to a log, after a straight stretch on the heading where the log ends; only what is looked at.
void join(Recording& log, const Recording& run, double straight, std::mt19937_64& random) {
  std::normal_distribution noise(0.0, 1.0);
  const double step = (run.time.back() - run.time.front()) / static_cast<double>(run.samples() - 1);
  const auto add = [&](double psi, double delta) {
    log.time.push_back(log.time.empty() ? 0.0 : log.time.back() + step);
    log.channels[index_of(Channel::psi)].push_back(wrapped(psi));
    log.channels[index_of(Channel::delta)].push_back(delta);
  };
  const double heading = log.time.empty() ? 0.0 : log[Channel::psi].back();
  for (double t = 0.0; t < straight; t += step)
    add(heading + radians(0.1) * noise(random), radians(0.3) * noise(random));
  const auto psi = run[Channel::psi];
  const auto delta = run.has(Channel::delta) ? run[Channel::delta] : run[Channel::delta_order];
  for (std::size_t i = 0; i < run.samples(); ++i) add(heading + psi[i] - psi[0], delta[i]);
}

TEST_CASE("simulated manoeuvres, which begin with the order, are what they are called", "[nonlinear][manoeuvres_in]") {
  const auto ship = random_ship(1).ship;
  for (const double step : {0.5, 1.0, 2.0}) {
    for (const auto& run : {zigzag(ship, {.rudder = radians(10.0), .heading = radians(10.0)}, {.step = step}).run,
                            zigzag(ship, {.rudder = radians(20.0), .heading = radians(20.0)}, {.step = step}).run,
                            turning_circle(ship, {.rudder = radians(35.0)}, {.step = step}).run}) {
      const auto found = manoeuvres_in(run);
      INFO(run.facts.manoeuvre << "\n" << words(found));
      REQUIRE(found.size() == 1);
      CHECK(run.facts.manoeuvre.starts_with(found.front().manoeuvre));
      CHECK(std::abs(*found.front().execute) <= 0.5 * step);
      CHECK(found.front().begin == run.time.front());
    }
  }
}

TEST_CASE("recorded zigzags and turns of a model in wind come back as one piece each",
          "[nonlinear][manoeuvres_in][published]") {
  const auto recordings = test::benchmark_recordings("esso_osaka");
  if (!recordings) return;
  for (const auto& entry : std::filesystem::directory_iterator(*recordings)) {
    const auto file = entry.path().filename().string();
    if (entry.path().extension() != ".csv") continue;
    const auto found = sailed_in(read_recording(entry.path()).recording);
    INFO(file << "\n" << words(found));
    REQUIRE(found.size() == (file.starts_with("random") ? 0 : 1));
    if (!found.empty()) CHECK(found.front().manoeuvre.substr(0, 4) == file.substr(0, 4));
  }
}

TEST_CASE("the manoeuvres of a morning of full-scale trials are found in one log",
          "[nonlinear][manoeuvres_in][published]") {
  const auto recordings = test::benchmark_recordings("gunnerus");
  if (!recordings) return;
  std::map<double, std::pair<double, double>> samples;  // the files overlap
  for (const auto& entry : std::filesystem::directory_iterator(*recordings)) {
    if (entry.path().extension() != ".csv") continue;
    const auto run = read_recording(entry.path()).recording;
    for (std::size_t i = 0; i < run.samples(); ++i)
      samples[run.time[i]] = {run[Channel::psi][i], run[Channel::delta_order][i]};
  }
  Recording log;
  for (const auto& [time, both] : samples) {
    log.time.push_back(time);
    log.channels[index_of(Channel::psi)].push_back(both.first);
    log.channels[index_of(Channel::delta_order)].push_back(both.second);
  }
  const auto found = sailed_in(log);
  INFO(words(found));
  auto next = found.begin();
  for (const std::string noted : {"turn 30", "turn 30", "zigzag 10/10", "zigzag 10/20", "turn 10", "zigzag 5/10",
                                  "turn 10", "zigzag 10/20", "zigzag 5/10"}) {
    next = std::find_if(next, found.end(), [&](const auto& piece) { return piece.manoeuvre == noted; });
    INFO(noted);
    REQUIRE(next != found.end());
    CHECK(next->begin <= *next->execute - 20.0);
    ++next;
  }
}

TEST_CASE("an order that the rudder does not follow is not looked at", "[nonlinear][manoeuvres_in]") {
  const auto ship = random_ship(1);
  TrialLog log(ship.ship, ship.length, ship.speed, 13);
  log.steam(200.0);
  log.zigzag(20, 20, Side::port, 3);
  log.steam(200.0);
  auto run = log.run();
  for (double& order : run.fill(Channel::delta_order)) order = 0.0;  // of the autopilot, while a hand steered
  CHECK(words(manoeuvres_in(run)) == words(manoeuvres_in(log.run())));
}

TEST_CASE("a piece has a file beside the log's", "[nonlinear][manoeuvres_in]") {
  const ManoeuvrePiece piece{.begin = 0.0, .end = 1.0, .manoeuvre = "zigzag 10/10", .execute = {}, .why = {}};
  CHECK(file_of_piece("trials/run.csv", 2, piece) == "trials/run_2_zigzag_10_10.csv");
}

TEST_CASE("recorded manoeuvres joined to a long log are found again", "[nonlinear][manoeuvres_in][published]") {
  std::mt19937_64 random(4);
  for (const std::string folder : {"kvlcc2", "kcs", "esso_osaka"}) {
    const auto recordings = test::benchmark_recordings(folder);
    if (!recordings) continue;
    Recording log;
    std::vector<std::string> names, again;
    for (const auto& entry : std::filesystem::directory_iterator(*recordings)) {
      if (entry.path().extension() != ".csv") continue;
      const auto run = read_recording(entry.path()).recording;
      for (const auto& piece : sailed_in(run)) names.push_back(piece.manoeuvre);
      join(log, run, 150.0, random);
    }
    join(log, Recording(log), 150.0, random);
    for (const auto& piece : sailed_in(log))  // a turn that ends in a straight stretch looks like a pull-out
      if (!piece.manoeuvre.starts_with("pull-out")) again.push_back(piece.manoeuvre);
    const auto once = names;
    names.insert(names.end(), once.begin(), once.end());
    CHECK(names.size() >= 6);
    CHECK(again == names);
  }
}

}  // namespace
}  // namespace swayaw
