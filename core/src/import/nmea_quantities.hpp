#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "nmea_sentence.hpp"

/// What sentences of NMEA 0183 tell; docs/import_nmea.md has the table. Not installed.
namespace swayaw::inline core::detail {

/// What one instrument tells at a time: a number or two that belong together.
enum class NmeaQuantity {
  heading,        ///< from true north [deg]
  yaw_rate,       ///< [deg/min]
  rudder,         ///< angle of the starboard or only rudder, angle of the port rudder [deg], positive to starboard
  rudder_order,   ///< the same, as ordered
  log_speed,      ///< forward through the water [kn]
  log_drift,      ///< to starboard through the water [kn]
  ground_motion,  ///< forward and to starboard over ground [kn]
  course,         ///< speed over ground [kn], course over ground from true north [deg]
  position,       ///< latitude, longitude [deg]
  shaft_speed,    ///< [rpm]
  pitch,          ///< [% of the largest]
  true_wind,      ///< speed [kn], direction it comes from, from true north [deg]
  bow_wind,       ///< the same, direction from the bow
  apparent_wind,  ///< relative to the ship, direction it comes from, from the bow
  depth,          ///< [m]
};

inline constexpr std::size_t quantity_count = 15;

constexpr std::size_t index_of(NmeaQuantity quantity) { return static_cast<std::size_t>(quantity); }

/// How a quantity appears in the recording: its columns, and what notes call it.
struct QuantityWords {
  std::string_view name;
  std::string_view first, second;  ///< column; empty where it has none of its own
  std::string_view parts_first, parts_second;
};

const QuantityWords& words_for(NmeaQuantity quantity);

/// How directly a sentence tells its quantity; a lower one is taken first.
enum class Directness { direct, corrected, magnetic };

/// What a sentence tells.
struct Told {
  NmeaQuantity quantity;
  Directness directness = Directness::direct;
  int which = 0;  ///< number of the shaft
  double first = std::numeric_limits<double>::quiet_NaN();
  double second = std::numeric_limits<double>::quiet_NaN();
};

/// Coordinated universal time in a sentence.
struct ToldTime {
  std::optional<long> day;  ///< since 1970
  double seconds;           ///< since midnight
};

/// Takes what sentences tell, one after the other.
class SentenceReading {
 public:
  enum class Result { told, invalid, unreadable, not_used };

  /// What was told is in `told` until the next call.
  Result read(const NmeaSentence& sentence);

  std::span<const Told> told() const { return {told_.data(), count_}; }
  const std::optional<ToldTime>& time() const { return time_; }

 private:
  struct Row;
  static std::span<const Row> table();

  void heading_true();
  void heading_with_status();
  void heading_magnetic();
  void heading_sensor();
  void yaw_rate();
  void rudder(NmeaQuantity quantity);
  void water_speed();
  void ground_and_water_speed();
  void course_and_speed();
  void minimum_navigation();
  void fix();
  void fix_of_several();
  void place();
  void shaft();
  void wind();
  void wind_from_north();
  void depth();
  void depth_below_transducer();
  void depth_below_surface();
  void date_and_time();

  void tell(Told told);
  void tell_heading(double heading, double variation, Directness directness);
  void tell_time(std::string_view text, std::optional<long> day = {});
  void tell_position(std::size_t at);
  std::optional<long> day_of(std::string_view ddmmyy);
  double number(std::size_t i, double lowest, double highest);
  double speed(std::size_t knots, std::size_t km_h);
  double coordinate(std::size_t i, std::size_t degree_digits, std::string_view sides);
  double signed_by(std::size_t i, std::string_view sides);
  bool valid(std::size_t i);
  bool needs(bool condition);

  const NmeaSentence* sentence_ = nullptr;
  std::array<Told, 4> told_{};
  std::size_t count_ = 0;
  std::optional<ToldTime> time_;
  double variation_ = std::numeric_limits<double>::quiet_NaN();  ///< of the last RMC [deg], positive to the east
  Result result_ = Result::told;
};

}  // namespace swayaw::core::detail
