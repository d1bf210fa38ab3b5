#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What each command of the program was asked, and the functions that do it.
/// Results go to stdout, messages to stderr. @throws Refusal, std::domain_error
namespace swayaw::app {

/// What was measured around the ship and is not to act on her.
struct Ignored {
  bool wind = false;
  bool depth = false;
};

/// How recordings are read before they are worked with.
struct Reading {
  std::string rudder_positive;  ///< "port" or "starboard", whatever the files say; empty: as they say
  bool no_check = false;        ///< instruments are not checked first
  Ignored ignored{};
};

/// The page that is written besides the answer.
struct ReportArguments {
  std::filesystem::path file{};  ///< empty: no page
  bool si = false;               ///< its first screen in metres, seconds and radians

  bool wanted() const { return !file.empty(); }
};

struct SimulateArguments {
  std::filesystem::path ship;
  std::string zigzag;          ///< "D/H" in degrees, or empty
  std::optional<double> turn;  ///< [deg]
  bool spiral = false;
  bool reverse_spiral = false;
  std::optional<double> pullout;  ///< [deg]
  bool williamson = false;
  bool imo = false;
  std::optional<double> rudder;     ///< of spirals and the Williamson turn [deg]
  double rudder_step = 5.0;         ///< of the spiral [deg]
  std::optional<double> straight;   ///< course over ground to be kept in the wind of the ship file [deg]
  std::string first = "starboard";  ///< side turned to first
  std::optional<double> speed;      ///< [m/s]
  std::optional<double> rev;        ///< [1/s]
  std::optional<double> thrust;     ///< [N]
  std::optional<double> duration;   ///< [s]
  std::optional<double> step;       ///< [s]
  double tolerance = 1e-9;
  std::filesystem::path out;  ///< empty: no time series
  bool forces = false;        ///< forces by part in the time series
  std::filesystem::path svg;  ///< empty: no plot
  ReportArguments report{};
  bool json = false;
};
void simulate(const SimulateArguments& arguments);

struct ReplayArguments {
  std::filesystem::path ship;
  std::filesystem::path run;
  std::string shaft = "recorded";
  std::filesystem::path out;
  bool forces = false;  ///< forces by part in the time series
  bool json = false;
  std::string rudder_positive;  ///< of all recordings, whatever they say; empty: as they say
  Ignored ignored{};
};
void replay(const ReplayArguments& arguments);

struct CheckArguments {
  std::vector<std::filesystem::path> runs;
  std::string rudder_positive;  ///< "port" or "starboard", whatever the files say; empty: as they say
  ReportArguments report{};
  std::filesystem::path out;  ///< repaired recording; empty: none
  bool json = false;
};
void check(const CheckArguments& arguments);

struct CompareArguments {
  std::filesystem::path ship;
  std::vector<std::filesystem::path> runs;
  std::string shaft = "recorded";
  double window_lengths = 2.0;
  ReportArguments report{};
  bool json = false;
  bool markdown = false;
  Reading reading{};
};
void compare(const CompareArguments& arguments);

struct ForcesArguments {
  std::filesystem::path ship;
  std::string state;  ///< "u=0.96,v=0.05,…"
  bool json = false;
};
void forces(const ForcesArguments& arguments);

struct LinearizeArguments {
  std::filesystem::path ship;
  std::optional<double> speed;   ///< [m/s]
  std::optional<double> rev;     ///< [1/s]
  std::optional<double> thrust;  ///< [N]
  std::optional<double> rudder;  ///< [deg], positive to port; nothing: straight ahead
  std::string side;              ///< turned to, where the forces have a kink; empty: mean and both
  std::filesystem::path out;     ///< linear model; empty: none
  bool json = false;
};
void linearize(const LinearizeArguments& arguments);

struct IndicesArguments {
  std::filesystem::path ship;
  std::optional<double> speed;  ///< [m/s]
  std::filesystem::path svg;    ///< empty: no plot
  ReportArguments report{};
  std::filesystem::path out;  ///< linear model; empty: none
  bool json = false;
};
void indices(const IndicesArguments& arguments);

struct ShipArguments {
  std::filesystem::path ship;
  std::filesystem::path out;  ///< ship file; empty: none
  bool json = false;
};
void describe_ship(const ShipArguments& arguments);

struct InvertArguments {
  std::filesystem::path ship;
  std::string known;            ///< the number known beforehand; empty: c_Ry
  std::filesystem::path parts;  ///< ship whose hull and rudder give all other parameters; empty: the ship itself
  bool json = false;
};
void invert(const InvertArguments& arguments);

struct LoopArguments {
  std::filesystem::path ship;
  std::string zigzag;               ///< "D/H" in degrees
  std::string first = "starboard";  ///< side turned to first
  std::optional<double> speed;      ///< [m/s]
  std::filesystem::path out;        ///< empty: no time series
  ReportArguments report{};
  std::filesystem::path svg;  ///< empty: no plot
  bool json = false;
};
void loop(const LoopArguments& arguments);

struct TrialArguments {
  std::vector<std::filesystem::path> runs;
  std::filesystem::path ship;    ///< simulated beside the recording, and her length; empty: none
  std::optional<double> speed;   ///< approach speed in place of the recorded one [m/s]
  std::optional<double> length;  ///< [m]
  ReportArguments report{};
  bool json = false;
  std::string rudder_positive;  ///< of all recordings, whatever they say; empty: as they say
};
void trial(const TrialArguments& arguments);

struct TuneArguments {
  std::filesystem::path ship;
  std::filesystem::path indices;
  std::vector<std::string> parameters;  ///< that may change; empty: those of the hull but for its resistance
  std::optional<double> prior;          ///< relative standard deviation of each
  std::optional<double> most_change;    ///< largest relative change of each
  int most_turns = 300;                 ///< turning circles to be sailed at most
  std::filesystem::path out;
  ReportArguments report{};
  bool json = false;
};
void tune(const TuneArguments& arguments);

struct SweepArguments {
  std::filesystem::path plan;
  std::filesystem::path out;  ///< folder of the results
  std::filesystem::path csv;  ///< every item; empty: none
  unsigned threads = 0;       ///< 0: one on each core
  ReportArguments report{};
  bool json = false;
};
void sweep(const SweepArguments& arguments);

struct EstimateArguments {
  std::optional<double> length, beam, draught;  ///< between perpendiculars, moulded, mean [m]
  std::optional<double> block;                  ///< block coefficient
  std::optional<double> speed;                  ///< service speed [m/s]; nothing: by Froude number
  double trim = 0.0;                            ///< draught aft less forward [m]
  double x_g = 0.0;                             ///< centre of gravity forward of midship [m]
  std::optional<double> yaw_radius;             ///< radius of gyration [m]
  std::optional<double> rudder_area;            ///< of all rudders together [m^2]
  std::optional<double> rudder_height;          ///< span of each [m]
  std::optional<double> propeller_diameter;     ///< of each [m]
  std::optional<double> wake, thrust_deduction;
  std::optional<double> resistance;  ///< at the service speed [N]
  double density = 1025.0;           ///< [kg/m^3]
  int screws = 1, rudders = 1;
  bool azimuth = false;
  std::string ship_type;                                               ///< empty: not told
  std::optional<double> frontal_area, lateral_area;                    ///< above water [m^2]
  std::optional<double> length_over_all;                               ///< [m]
  std::optional<double> depth;                                         ///< keel to deck [m]
  std::optional<double> superstructure_length, superstructure_height;  ///< of what stands on the deck [m]
  std::optional<double> superstructure_x;                              ///< its middle forward of midship [m]
  std::string name = "estimated ship";
  std::filesystem::path out;
  bool json = false;
};
void estimate(const EstimateArguments& arguments);

struct ImportArguments {
  std::vector<std::filesystem::path> files;
  std::filesystem::path columns;  ///< column map; empty: none
  std::filesystem::path out;
  bool split = false;  ///< a file for each manoeuvre
  bool json = false;
};
void import_run(const ImportArguments& arguments);

struct IdentifyArguments {
  std::vector<std::filesystem::path> runs;
  std::vector<std::filesystem::path> holdout;  ///< not used in the fit
  std::filesystem::path ship;
  std::string model;                  ///< mmg, pi, pu, linear
  std::vector<std::string> find;      ///< coefficients to find; empty: the usual ones
  std::vector<std::string> also;      ///< and these
  std::vector<std::string> keep;      ///< but not these
  std::vector<std::string> channels;  ///< to be used; empty: all
  std::string fit = "auto";           ///< forces, trajectories, auto
  bool prior = false;                 ///< the ship's own parameters, with her confidence, count as measurements
  double ridge = 0.0;
  bool resample = false;
  std::filesystem::path out;
  ReportArguments report{};
  bool json = false;
  Reading reading{};
};
void identify(const IdentifyArguments& arguments);

struct DiagnoseArguments {
  std::filesystem::path ship;
  std::vector<std::filesystem::path> runs;
  std::vector<std::filesystem::path> reference;  ///< in which nothing is hidden
  std::vector<std::filesystem::path> holdout;    ///< not used
  std::filesystem::path save_model;              ///< empty: none
  ReportArguments report{};
  bool json = false;
  Reading reading{};
};
void diagnose(const DiagnoseArguments& arguments);

struct FleetArguments {
  std::filesystem::path ship;  ///< of the class
  std::vector<std::filesystem::path> runs;
  std::filesystem::path save_models;  ///< folder; empty: none
  ReportArguments report{};
  bool json = false;
  Reading reading{};
};
void fleet(const FleetArguments& arguments);

}  // namespace swayaw::app
