#include "nmea_quantities.hpp"

#include <algorithm>
#include <cmath>

#include "swayaw/core/detail/csv_text.hpp"

namespace swayaw::inline core::detail {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double km_per_nautical_mile = 1.852;

constexpr std::array<QuantityWords, quantity_count> words{{
    {"heading", "psi_deg", "", "", ""},
    {"rate of turn", "r_deg_min", "", "", ""},
    {"rudder angle", "delta_deg", "", "starboard", "port"},
    {"rudder order", "delta_order_deg", "", "starboard", "port"},
    {"speed through water", "stw_kn", "", "speed through water", ""},
    {"transverse speed through water", "v_kn", "", "transverse speed through water", ""},
    {"velocity over ground", "ug_kn", "vg_kn", "speed over ground", "transverse speed over ground"},
    {"course and speed over ground", "sog_kn", "cog_deg", "speed", "course"},
    {"position", "lat_deg", "lon_deg", "latitude", "longitude"},
    {"shaft speed", "rev_rpm", "", "", ""},
    {"propeller pitch", "propeller_pitch_percent", "", "", ""},
    {"true wind", "wind_speed_kn", "wind_from_deg", "speed", "direction"},
    {"true wind from the bow", "wind_speed_kn", "wind_from_deg", "speed", "direction"},
    {"apparent wind", "wind_speed_kn", "wind_from_deg", "speed", "direction"},
    {"depth", "depth_m", "", "", ""},
}};

double in_circle(double degrees) { return degrees - 360.0 * std::floor(degrees / 360.0); }

}  // namespace

const QuantityWords& words_for(NmeaQuantity quantity) { return words[index_of(quantity)]; }

// ---------------------------------------------------------------- fields

void SentenceReading::tell(Told told) {
  if (!std::isnan(told.first) || !std::isnan(told.second)) told_[count_++] = told;
}

bool SentenceReading::needs(bool condition) {
  if (!condition) result_ = Result::unreadable;
  return condition;
}

/// "A": data valid. A status that is missing says nothing against the data.
bool SentenceReading::valid(std::size_t i) {
  const auto status = sentence_->text(i);
  if (status.empty() || status == "A" || status == "D") return true;
  if (result_ == Result::told) result_ = Result::invalid;
  return false;
}

/// NaN for an empty field, and for one that holds no number of that range.
double SentenceReading::number(std::size_t i, double lowest, double highest) {
  if (sentence_->text(i).empty()) return none;
  const auto value = sentence_->number(i);
  return needs(value && *value >= lowest && *value <= highest) ? *value : none;
}

double SentenceReading::speed(std::size_t knots, std::size_t km_h) {
  const double told = number(knots, -200.0, 200.0);
  return std::isnan(told) ? number(km_h, -400.0, 400.0) / km_per_nautical_mile : told;
}

/// The number in field i, negative if the letter after it is the second of `sides`; 0 where the field is empty.
double SentenceReading::signed_by(std::size_t i, std::string_view sides) {
  const double value = number(i, 0.0, 180.0);
  if (std::isnan(value)) return 0.0;
  const auto side = sentence_->text(i + 1);
  if (!needs(side.size() == 1 && sides.find(side) != std::string_view::npos)) return none;
  return side[0] == sides[0] ? value : -value;
}

/// dddmm.mmm and the side after it, to degrees.
double SentenceReading::coordinate(std::size_t i, std::size_t degree_digits, std::string_view sides) {
  const auto text = sentence_->text(i);
  const auto side = sentence_->text(i + 1);
  if (text.empty() && side.empty()) return none;
  if (!needs(text.size() >= degree_digits + 2 && side.size() == 1 && sides.find(side) != std::string_view::npos))
    return none;
  const double whole = number(i, 0.0, degree_digits == 2 ? 9000.0 : 18000.0);
  const double whole_degrees = std::floor(whole / 100.0);
  const double minutes = whole - 100.0 * whole_degrees;
  if (!needs(minutes <= 60.0)) return none;
  const double value = whole_degrees + minutes / 60.0;
  return side[0] == sides[0] ? value : -value;
}

void SentenceReading::tell_time(std::string_view text, std::optional<long> day) {
  if (text.empty()) return;
  if (const auto seconds = nmea_time(text); needs(seconds.has_value())) time_ = ToldTime{day, *seconds};
}

void SentenceReading::tell_position(std::size_t at) {
  const double latitude = coordinate(at, 2, "NS"), longitude = coordinate(at + 2, 3, "EW");
  if (!std::isnan(latitude) && !std::isnan(longitude))
    tell({.quantity = NmeaQuantity::position, .first = latitude, .second = longitude});
}

/// Years of two digits are 1980 to 2079, as satellite time began in 1980.
std::optional<long> SentenceReading::day_of(std::string_view ddmmyy) {
  if (ddmmyy.empty()) return std::nullopt;
  const auto digits = number_in(ddmmyy);
  if (!needs(ddmmyy.size() == 6 && digits && *digits >= 0.0)) return std::nullopt;
  const int all = static_cast<int>(*digits), year = all % 100;
  const auto day = day_number(year < 80 ? 2000 + year : 1900 + year, all / 100 % 100, all / 10000);
  needs(day.has_value());
  return day;
}

// ---------------------------------------------------------------- heading and turning

void SentenceReading::tell_heading(double heading, double variation, Directness directness) {
  tell({.quantity = NmeaQuantity::heading, .directness = directness, .first = in_circle(heading + variation)});
}

/// HDT,x.x,T
void SentenceReading::heading_true() { tell_heading(number(1, 0.0, 360.0), 0.0, Directness::direct); }

/// THS,x.x,mode
void SentenceReading::heading_with_status() {
  if (sentence_->text(2) == "V") result_ = Result::invalid;
  else heading_true();
}

/// HDM,x.x,M
void SentenceReading::heading_magnetic() {
  const bool known = !std::isnan(variation_);
  tell_heading(number(1, 0.0, 360.0), known ? variation_ : 0.0, known ? Directness::corrected : Directness::magnetic);
}

/// HDG,sensor heading,deviation,E/W,variation,E/W:  true = sensor + deviation + variation, positive to the east
void SentenceReading::heading_sensor() {
  const double heading = number(1, 0.0, 360.0) + signed_by(2, "EW");
  const bool own = !sentence_->text(4).empty(), known = own || !std::isnan(variation_);
  const double variation = own ? signed_by(4, "EW") : known ? variation_ : 0.0;
  tell_heading(heading, variation, known ? Directness::corrected : Directness::magnetic);
}

/// ROT,deg/min,status: "-" the bow turns to port
void SentenceReading::yaw_rate() {
  if (valid(2)) tell({.quantity = NmeaQuantity::yaw_rate, .first = number(1, -9999.9, 9999.9)});
}

// ---------------------------------------------------------------- rudder and shaft

/// RSA and ROR: starboard or single, status, port, status; "-" the bow turns to port. One of two may be invalid.
void SentenceReading::rudder(NmeaQuantity quantity) {
  const auto angle = [&](std::size_t i) { return sentence_->text(i + 1) == "V" ? none : number(i, -90.0, 90.0); };
  const Told told{.quantity = quantity, .first = angle(1), .second = angle(3)};
  const bool said = !sentence_->text(1).empty() || !sentence_->text(3).empty();
  if (said && std::isnan(told.first) && std::isnan(told.second) && result_ == Result::told) result_ = Result::invalid;
  tell(told);
}

/// RPM,source S/E,number,rpm,pitch,status
void SentenceReading::shaft() {
  if (!valid(5)) return;
  const auto source = sentence_->text(1);
  if (!needs(source == "S" || source == "E")) return;
  const auto directness = source == "S" ? Directness::direct : Directness::corrected;
  const double which = number(2, 0.0, 99.0);
  const int shaft = std::isnan(which) ? 0 : static_cast<int>(which);
  tell({NmeaQuantity::shaft_speed, directness, shaft, number(3, -1e5, 1e5), none});
  tell({NmeaQuantity::pitch, directness, shaft, number(4, -150.0, 150.0), none});
}

// ---------------------------------------------------------------- speed

/// VHW,true heading,T,magnetic,M,knots,N,km/h,K
void SentenceReading::water_speed() {
  tell_heading(number(1, 0.0, 360.0), 0.0, Directness::corrected);
  tell({.quantity = NmeaQuantity::log_speed, .first = speed(5, 7)});
}

/// VBW,water forward,water to starboard,status,ground forward,ground to starboard,status,…  [kn]
void SentenceReading::ground_and_water_speed() {
  const double u = number(1, -200.0, 200.0), v = number(2, -200.0, 200.0);
  const double u_ground = number(4, -200.0, 200.0), v_ground = number(5, -200.0, 200.0);
  if ((!std::isnan(u) || !std::isnan(v)) && valid(3)) {
    tell({.quantity = NmeaQuantity::log_speed, .first = u});
    tell({.quantity = NmeaQuantity::log_drift, .first = v});
  }
  if ((!std::isnan(u_ground) || !std::isnan(v_ground)) && valid(6))
    tell({.quantity = NmeaQuantity::ground_motion, .first = u_ground, .second = v_ground});
}

/// VTG,course,T,magnetic,M,knots,N,km/h,K,mode
void SentenceReading::course_and_speed() {
  if (sentence_->text(9) == "N") result_ = Result::invalid;
  else if (needs(sentence_->text(2) == "T" || sentence_->text(1).empty()))
    tell({.quantity = NmeaQuantity::course, .first = speed(5, 7), .second = number(1, 0.0, 360.0)});
}

/// RMC,time,status,latitude,N/S,longitude,E/W,knots,course,ddmmyy,variation,E/W,mode
void SentenceReading::minimum_navigation() {
  if (!valid(2)) return;
  tell_time(sentence_->text(1), day_of(sentence_->text(9)));
  tell_position(3);
  tell({.quantity = NmeaQuantity::course, .first = number(7, 0.0, 200.0), .second = number(8, 0.0, 360.0)});
  if (!sentence_->text(10).empty()) variation_ = signed_by(10, "EW");
}

// ---------------------------------------------------------------- position and time

/// GGA,time,latitude,N/S,longitude,E/W,quality: 0 no fix
void SentenceReading::fix() {
  if (sentence_->text(6) == "0") result_ = Result::invalid;
  else {
    tell_time(sentence_->text(1));
    tell_position(2);
  }
}

/// GNS,time,latitude,N/S,longitude,E/W,modes: N no fix
void SentenceReading::fix_of_several() {
  if (sentence_->text(6).find_first_not_of('N') == std::string_view::npos) result_ = Result::invalid;
  else {
    tell_time(sentence_->text(1));
    tell_position(2);
  }
}

/// GLL,latitude,N/S,longitude,E/W,time,status
void SentenceReading::place() {
  if (!valid(6)) return;
  tell_position(1);
  tell_time(sentence_->text(5));
}

/// ZDA,time,day,month,year,…
void SentenceReading::date_and_time() {
  if (sentence_->text(1).empty()) return;
  const double day = number(2, 1.0, 31.0), month = number(3, 1.0, 12.0), year = number(4, 1980.0, 2999.0);
  if (std::isnan(day + month + year)) return tell_time(sentence_->text(1));
  const auto date = day_number(static_cast<int>(year), static_cast<int>(month), static_cast<int>(day));
  if (needs(date.has_value())) tell_time(sentence_->text(1), date);
}

// ---------------------------------------------------------------- wind and depth

/// MWV,angle from the bow,R/T,speed,K/M/N/S,status
void SentenceReading::wind() {
  if (!valid(5)) return;
  const auto unit = sentence_->text(4), reference = sentence_->text(2);
  if (!needs(reference == "R" || reference == "T")) return;
  const double knots = unit == "N"   ? 1.0
                       : unit == "K" ? 1.0 / km_per_nautical_mile
                       : unit == "M" ? 3.6 / km_per_nautical_mile
                       : unit == "S" ? 1.609344 / km_per_nautical_mile
                                     : none;
  if (!needs(!std::isnan(knots))) return;
  tell({.quantity = reference == "R" ? NmeaQuantity::apparent_wind : NmeaQuantity::bow_wind,
        .first = knots * number(3, 0.0, 400.0),
        .second = number(1, 0.0, 360.0)});
}

/// MWD,from,T,from,M,knots,N,m/s,M
void SentenceReading::wind_from_north() {
  const double knots = number(5, 0.0, 200.0);
  const double told = std::isnan(knots) ? number(7, 0.0, 100.0) * 3.6 / km_per_nautical_mile : knots;
  tell({.quantity = NmeaQuantity::true_wind, .first = told, .second = number(1, 0.0, 360.0)});
}

/// DPT,below the transducer,offset: positive from the transducer to the water line
void SentenceReading::depth() {
  const double offset = number(2, -100.0, 100.0);
  const bool surface = offset > 0.0;
  tell({.quantity = NmeaQuantity::depth,
        .directness = surface ? Directness::direct : Directness::corrected,
        .first = number(1, 0.0, 12000.0) + (surface ? offset : 0.0)});
}

/// DBT,feet,f,metres,M,fathoms,F
void SentenceReading::depth_below_transducer() {
  tell({.quantity = NmeaQuantity::depth, .directness = Directness::corrected, .first = number(3, 0.0, 12000.0)});
}

/// DBS, as DBT, from the water line
void SentenceReading::depth_below_surface() {
  tell({.quantity = NmeaQuantity::depth, .first = number(3, 0.0, 12000.0)});
}

// ---------------------------------------------------------------- all sentences

struct SentenceReading::Row {
  std::string_view formatter;
  void (*read)(SentenceReading&);
};

std::span<const SentenceReading::Row> SentenceReading::table() {
  using R = SentenceReading;
  static constexpr std::array rows{
      Row{"HDT", [](R& r) { r.heading_true(); }},
      Row{"THS", [](R& r) { r.heading_with_status(); }},
      Row{"HDG", [](R& r) { r.heading_sensor(); }},
      Row{"HDM", [](R& r) { r.heading_magnetic(); }},
      Row{"ROT", [](R& r) { r.yaw_rate(); }},
      Row{"RSA", [](R& r) { r.rudder(NmeaQuantity::rudder); }},
      Row{"ROR", [](R& r) { r.rudder(NmeaQuantity::rudder_order); }},
      Row{"RPM", [](R& r) { r.shaft(); }},
      Row{"VHW", [](R& r) { r.water_speed(); }},
      Row{"VBW", [](R& r) { r.ground_and_water_speed(); }},
      Row{"VTG", [](R& r) { r.course_and_speed(); }},
      Row{"RMC", [](R& r) { r.minimum_navigation(); }},
      Row{"GGA", [](R& r) { r.fix(); }},
      Row{"GNS", [](R& r) { r.fix_of_several(); }},
      Row{"GLL", [](R& r) { r.place(); }},
      Row{"ZDA", [](R& r) { r.date_and_time(); }},
      Row{"MWV", [](R& r) { r.wind(); }},
      Row{"MWD", [](R& r) { r.wind_from_north(); }},
      Row{"DPT", [](R& r) { r.depth(); }},
      Row{"DBT", [](R& r) { r.depth_below_transducer(); }},
      Row{"DBS", [](R& r) { r.depth_below_surface(); }},
  };
  return rows;
}

SentenceReading::Result SentenceReading::read(const NmeaSentence& sentence) {
  sentence_ = &sentence;
  count_ = 0;
  time_.reset();
  result_ = Result::told;
  const auto rows = table();
  const auto row = std::ranges::find(rows, sentence.formatter(), &Row::formatter);
  if (row == rows.end() || sentence.address.front() == 'P') return Result::not_used;
  row->read(*this);
  if (result_ == Result::unreadable) count_ = 0, time_.reset();
  return result_;
}

}  // namespace swayaw::core::detail
