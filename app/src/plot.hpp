#pragma once

#include <string>
#include <vector>

/// Plots of curves as SVG. gnuplot draws them.
namespace swayaw::app {

/// Colours of the quantities, the same as on the HTML pages.
namespace ink {
inline constexpr const char *drift = "#0072b2", *yaw = "#e07b00", *rudder = "#5a6470", *heading = "#2b2b2b",
                            *line = "#009e73", *faint = "#b9c0c8";
}

struct Stroke {
  const char* colour = ink::heading;  ///< "#rrggbb"
  double width = 2.0;                 ///< [px]
  bool dashed = false;
  bool filled = false;  ///< what the line encloses, without the line
};

/// Points joined by straight lines. One that is not finite interrupts them.
struct Curve {
  std::string name;  ///< in the key
  std::vector<double> x, y;
  Stroke stroke;
};

struct Axis {
  std::string quantity;
  std::string unit;  ///< "deg"; empty for a bare number
  bool logarithmic = false;
  double tick = 0.0;  ///< distance of the marks; 0: what suits
};

/// A text whose middle is at a point.
struct Label {
  std::string text;
  double x, y;
};

/// One pair of axes with its curves.
struct Panel {
  Axis x, y;
  std::vector<Curve> curves;
  bool same_scale = false;  ///< a unit of x is as long as a unit of y
  std::vector<Label> labels{};
  double bare_to = 0.0;  ///< if more than 0: no axes are drawn; both go as far to either side
};

/// Panels one below the other.
struct Plot {
  std::string title;
  std::vector<Panel> panels;
  int width = 800, height_of_panel = 350, height_of_rest = 250;  ///< [px]
};

/// The plot as an SVG document.
///
/// gnuplot is started without a shell and without the user's settings. Texts may hold anything: they are drawn as they
/// are, line ends as blanks, and what would act written out. Parameters reach gnuplot with all their digits.
///
/// @throws Refusal  if gnuplot is not installed, which says what to install, or if it fails
std::string svg_of(const Plot& plot);

}  // namespace swayaw::app
