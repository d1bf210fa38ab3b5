#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "plot.hpp"
#include "swayaw/app/page.hpp"
#include "swayaw/core/recording.hpp"
#include "user_units.hpp"

/// What all commands need to write a page.
namespace swayaw::app {

/// A plot as a picture of a page, with the numbers that it draws; without the drawing where gnuplot is not installed,
/// which is said on stderr once.
///
/// @param plot    with angles and yaw rates in degrees; units of the page may make radians of them
/// @param words   what is to be seen, for who cannot see it
/// @param height  of each panel [px]
PagePicture picture_of(Plot plot, std::string words, std::string caption, const UserUnits& units, int height = 240);

/// Tracks seen from above, north up; every track with the outline of the ship along it.
///
/// @param wind_from  arrow of the wind [rad]; not finite: none
Panel track_panel(std::vector<Curve> tracks, double wind_from);

/// A track, east and north, of a recording; empty where it has no position.
Curve track_of(const Recording& run, std::string name, Stroke stroke);

/// Outlines of the ship along a recorded track, every few lengths.
std::vector<Curve> hulls_along(const Recording& run, double L, const char* colour);

/// A channel over time, in degrees where it is an angle or a rate of one.
Curve over_time(const Recording& run, Channel channel, std::string name, Stroke stroke);

/// Writes the page and says so on stderr.
void write_page(const std::filesystem::path& file, const std::string& html);

/// "Made by swayaw 0.1.0."
std::string made_by();

}  // namespace swayaw::app
