#include "plot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string_view>

#include "child_process.hpp"
#include "swayaw/core/detail/printable.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::app {
namespace {

using Script = std::back_insert_iterator<std::string>;

bool is_plain(unsigned char code) {
  return (code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z') || code == ' ' || code >= 0x80;
}

/// A text in gnuplot's double quotes, every byte but letters, blanks and UTF-8 by its octal number: nothing is left
/// that could end the text or be taken for a command. (In single quotes gnuplot 5.4 takes the second of two doubled
/// quotes in a row for the end.) Digits are parameters too, since gnuplot reads more than three of them as one.
std::string literal(std::string_view text) {
  std::string result = "\"";
  for (const char c : core::detail::printable(text, core::detail::Lines::many)) {
    const auto code = static_cast<unsigned char>(c);
    if (is_plain(code)) result += c;
    else result += code < 0x20 || code == 0x7f ? " " : fmt::format("\\{:03o}", code);
  }
  return result + "\"";
}

std::string label_of(const Axis& axis) {
  return literal(axis.unit.empty() ? axis.quantity : axis.quantity + ", " + axis.unit);
}

/// Shortest digits that give the number back, with a point in every locale.
std::string number_of(double x) { return std::isfinite(x) ? fmt::format("{}", x) : "NaN"; }

std::string block_name(std::size_t panel, std::size_t curve) { return fmt::format("$curve_{}_{}", panel, curve); }

void put_points(Script to, const std::string& block, const Curve& curve) {
  fmt::format_to(to, "{} << END\n", block);
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    fmt::format_to(to, "{} {}\n", number_of(curve.x[i]), number_of(curve.y[i]));
  fmt::format_to(to, "END\n");
}

void put_axis(Script to, char name, const Axis& axis) {
  fmt::format_to(to, "set {}label {}\n{} logscale {}\n", name, label_of(axis), axis.logarithmic ? "set" : "unset",
                 name);
  if (axis.tick > 0.0) fmt::format_to(to, "set {}tics {}\n", name, number_of(axis.tick));
  else fmt::format_to(to, "set {}tics autofreq\n", name);
}

std::string drawn(const std::string& block, const Curve& curve) {
  if (curve.stroke.filled)
    return fmt::format("{} using 1:2 with filledcurves closed fillcolor rgb '{}' fillstyle solid 1 noborder title {}",
                       block, curve.stroke.colour, literal(curve.name));
  return fmt::format("{} using 1:2 with lines linecolor rgb '{}' linewidth {} dashtype {} title {}", block,
                     curve.stroke.colour, number_of(curve.stroke.width), curve.stroke.dashed ? "(12,6)" : "solid",
                     literal(curve.name));
}

/// Axes, or none, and labels.
void put_frame(Script to, const Panel& panel) {
  if (panel.bare_to > 0.0)
    fmt::format_to(to,
                   "unset xlabel\nunset ylabel\nunset xtics\nunset ytics\nunset border\nunset grid\n"
                   "set xrange [-{0}:{0}]\nset yrange [-{0}:{0}]\n",
                   number_of(panel.bare_to));
  for (std::size_t i = 0; i < panel.labels.size(); ++i)
    fmt::format_to(to, "set label {} {} at {},{} center\n", i + 1, literal(panel.labels[i].text),
                   number_of(panel.labels[i].x), number_of(panel.labels[i].y));
}

void put_panel(Script to, std::size_t index, const Panel& panel) {
  for (std::size_t k = 0; k < panel.curves.size(); ++k) put_points(to, block_name(index, k), panel.curves[k]);
  put_axis(to, 'x', panel.x);
  put_axis(to, 'y', panel.y);
  // a track fills its frame, whatever the distance of the marks
  if (panel.same_scale)
    fmt::format_to(to, "set autoscale fix\nset offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\n");
  else
    fmt::format_to(to, "set autoscale x\nset autoscale y\nunset offsets\n{}",
                   panel.x.logarithmic ? "set autoscale xfix\n" : "");
  fmt::format_to(to, "set size {}\n", panel.same_scale ? "ratio -1" : "noratio");
  put_frame(to, panel);
  fmt::format_to(to, "plot ");
  for (std::size_t k = 0; k < panel.curves.size(); ++k)
    fmt::format_to(to, "{}{}", k > 0 ? ", " : "", drawn(block_name(index, k), panel.curves[k]));
  fmt::format_to(to, "\n");
}

std::string script_of(const Plot& plot) {
  const auto panels = static_cast<int>(plot.panels.size());
  std::string script;
  const Script to(script);
  fmt::format_to(
      to, "set encoding utf8\nset terminal svg size {},{} fixed noenhanced font 'sans-serif,14' background '#ffffff'\n",
      plot.width, plot.height_of_rest + plot.height_of_panel * panels);
  fmt::format_to(to,
                 "set lmargin 10\nset rmargin 3\nset grid linecolor rgb '#e8ebee' linewidth 1\nset border linecolor "
                 "rgb '#5a6470'\n");
  fmt::format_to(
      to, "set key tmargin horizontal center Left reverse samplen 2.5 width -1\nset multiplot layout {},1 title {}\n",
      panels, literal(plot.title));
  for (std::size_t i = 0; i < plot.panels.size(); ++i) put_panel(to, i, plot.panels[i]);
  fmt::format_to(to, "unset multiplot\n");
  return script;
}

/// The last line that says anything: there gnuplot tells what is wrong.
std::string_view last_line(std::string_view text) {
  const auto end = text.find_last_not_of(" \n");
  if (end == std::string_view::npos) return "no reason given";
  text = text.substr(0, end + 1);
  text.remove_prefix(text.rfind('\n') + 1);
  return text.substr(text.find_first_not_of(' '));
}

}  // namespace

std::string svg_of(const Plot& plot) {
  auto end = run_program({"gnuplot", "--default-settings", "-"}, script_of(plot));
  if (!end) throw Refusal("plots are drawn by gnuplot, which is not installed: install the Debian package gnuplot-nox");
  if (end->code != 0) throw Refusal(fmt::format("gnuplot ended with code {}: {}", end->code, last_line(end->err)));
  return std::move(end->out);
}

}  // namespace swayaw::app
