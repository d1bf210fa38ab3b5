#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "page_writing.hpp"
#include "plot.hpp"
#include "swayaw/app/page.hpp"
#include "swayaw/linear/linear_ship.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/manoeuvres/imo_criteria.hpp"
#include "user_units.hpp"

/// Pages of `swayaw simulate`: what all manoeuvres share, and those that MSC.137(76) judges.
namespace swayaw::app {

/// A ship and how she was sailed.
struct Sailed {
  std::string ship;
  double L;      ///< [m]
  double speed;  ///< of the approach [m/s]
  UserUnits units;
  std::string how;                   ///< "15.5 kn, shaft 107 rpm held; draught 21.0 m"
  std::vector<std::string> assumed;  ///< sentences
  bool calm = true;                  ///< deep water without wind, waves or current
};

Sailed sailed(const Ship& ship, double speed, const Controls<double>& propulsion, const SimulateArguments& arguments);
Sailed sailed(const LinearShip& ship, double speed, const SimulateArguments& arguments);

/// Writes the page that was asked for. @param page  makes it of how she was sailed
template <class MakePage>
void write_page_of(const Ship& ship, double speed, const Controls<double>& propulsion, const SimulateArguments& a,
                   MakePage&& page) {
  if (a.report.wanted()) write_page(a.report.file, html(page(sailed(ship, speed, propulsion, a))));
}

/// Adds to a page what it has in common with those of the other manoeuvres.
Page completed(Page page, const Sailed& s);

/// A number in the table of a manoeuvre that has no limit.
struct Measure {
  std::string name, value;
};

/// "953 m (2.98 L)"; "not reached" where there is nothing.
std::string length_of(const std::optional<double>& metres, const UserUnits& units);
std::string time_of(const std::optional<double>& seconds, const UserUnits& units);

/// Criteria with limit and margin first, then the other measures.
PageTable table_of(const std::vector<Criterion>& criteria, const std::vector<Measure>& others, const Sailed& s);

/// A track to be drawn.
struct DrawnTrack {
  const Recording* run;
  std::string name;
  const char* colour;
};

/// Tracks with the outlines of the ship along them, and other lines.
PagePicture track_picture(const std::vector<DrawnTrack>& tracks, std::vector<Curve> others, const Sailed& s,
                          std::string words, std::string caption);

/// The part of a curve up to an abscissa.
Curve up_to(Curve curve, double x);

Page zigzag_page(const Zigzag& zigzag, const ZigzagOrder& order, const Sailed& s);
Page circle_page(const Ship& ship, const TurningCircle& circle, const TurnOrder& order, const Sailed& s);

/// Sails the manoeuvres once more for the pictures.
Page imo_page(const Ship& ship, const ImoCriteria& result, const ManoeuvreOptions& options, const Sailed& s);

}  // namespace swayaw::app
