#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "swayaw/core/refusal.hpp"
#include "swayaw/core/side.hpp"

/// The plan of a sweep, as its file says (docs/sweep.md).
namespace swayaw::app {

/// What is done with every ship of a sweep, or with recordings.
enum class SweepTask { zigzag, turn, indices, trial, identify, diagnose };

/// Recordings that are worked on together; of a trial one, without a ship unless the plan has one.
struct SweepCase {
  std::string name;
  std::string ship;
  std::vector<std::string> runs, reference, holdout;
};

/// Which points are taken where parameters vary.
enum class SweepDesign {
  grid,   ///< every combination of the values of each parameter
  draws,  ///< independent draws from the laws of the parameters
  sobol,  ///< pairs of draws that have all but one parameter in common, for sensitivity indices
};

/// How a parameter varies, in the unit of the ship file. One of the four is given.
struct Variation {
  std::string name;                     ///< "N_v", "rudder.area_m2", "steady_wind.wind_speed_m_s", "speed_m_s"
  std::optional<double> relative_sd{};  ///< normal about the value of the ship, standard deviation over it
  std::optional<double> sd{};           ///< the same in the unit of the ship file
  std::optional<double> from{}, to{};   ///< uniform
  std::size_t steps = 0;                ///< values from `from` to `to` of a grid
  std::vector<double> values{};         ///< those of a grid
  FilePlace place{};
};

struct SweepPlan {
  std::filesystem::path file;
  std::string text;  ///< of the file
  SweepTask task;
  double rudder = 0.0;             ///< D of a zigzag, rudder of a turn [rad]
  double heading = 0.0;            ///< H of a zigzag [rad]
  Side first = Side::starboard;    ///< side turned to first
  std::size_t overshoots = 2;      ///< of a zigzag
  double tolerance = 1e-7;         ///< error of an integration step, relative to ship length and speed
  std::optional<double> speed{};   ///< approach speed [m/s]; the service speed unless given
  std::vector<std::string> ships;  ///< files as seen from the working folder, or names of published ships
  FilePlace ships_place{};
  std::vector<SweepCase> cases{};   ///< of trial, identify and diagnose
  std::string model{};              ///< of identify: mmg, pi or pu
  std::vector<std::string> find{};  ///< of identify: keys of the coefficients
  bool prior = false;               ///< of identify: numbers of the ship file count as measurements
  SweepDesign design = SweepDesign::draws;
  std::size_t size = 1;     ///< draws, or pairs of them, for each ship
  std::uint64_t seed = 1;   ///< of the draws
  bool confidence = false;  ///< every coefficient varies as far as the ship file trusts it
  std::vector<Variation> variations{};
};

/// @throws FileError  "FILE:LINE:COLUMN: what is wrong"
SweepPlan read_sweep_plan(const std::filesystem::path& file);

/// Whether the items are recordings rather than points of ships.
inline bool of_recordings(SweepTask task) { return task >= SweepTask::trial; }

/// The same from text; `name` stands for the file in messages, and ships are sought beside it.
SweepPlan parse_sweep_plan(const std::string& text, const std::filesystem::path& name);

}  // namespace swayaw::app
