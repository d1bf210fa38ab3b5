#include "linear_model_mat.hpp"

#include <string>
#include <utility>
#include <vector>

#include "swayaw/core/mat_file.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/linear/dimensional.hpp"

namespace swayaw::app {
namespace {

using Names = std::vector<std::string>;

MatValue row(std::vector<double> values) { return {MatNumbers{1, values.size(), std::move(values)}}; }

/// d(x)/dt = A x + B delta, every state an output. A column by column.
void add_state_space(MatStruct& model, const Names& states, const Names& units, std::vector<double> A,
                     std::vector<double> B) {
  const auto n = states.size();
  std::vector<double> C(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) C[i * (n + 1)] = 1.0;
  model.fields.insert(model.fields.end(), {{"A", {MatNumbers{n, n, std::move(A)}}},
                                           {"B", mat_column(std::move(B))},
                                           {"C", {MatNumbers{n, n, std::move(C)}}},
                                           {"D", mat_column(std::vector<double>(n, 0.0))},
                                           {"StateName", mat_texts(states)},
                                           {"StateUnit", mat_texts(units)},
                                           {"InputName", mat_texts({"delta"})},
                                           {"InputUnit", mat_texts({"rad"})},
                                           {"OutputName", mat_texts(states)},
                                           {"OutputUnit", mat_texts(units)}});
}

/// r/delta = (nw1/t² s + nw0/t³) / (s² + e1/t s + e0/t²), t = L/U; and first order K / (T s + 1).
MatStruct nomoto_of(const LinearShip& ship, double speed) {
  const auto h = transfer_functions(ship);
  const auto i = indices(ship);
  const auto times = time_constants(h).value_or(TimeConstants<double>{missing, missing});
  const double t = ship.particulars.L / speed, K = i.Kw / t, T = first_order_yaw(i).T * t;
  return {{{"num", row({h.nw1 / (t * t), h.nw0 / (t * t * t)})},
           {"den", row({1.0, h.e1 / t, h.e0 / (t * t)})},
           {"K", mat_number(K)},
           {"T1", mat_number(times.T1 * t)},
           {"T2", mat_number(times.T2 * t)},
           {"T3", mat_number(i.T3w * t)},
           {"T", mat_number(T)},
           {"first_order_num", row({K})},
           {"first_order_den", row({T, 1.0})}}};
}

MatStruct head_of(const std::string& name, double speed) {
  return {{{"Name", {name}}, {"TimeUnit", {std::string("seconds")}}, {"speed_m_s", mat_number(speed)}}};
}

MatStruct model_of(const LinearShip& ship, double speed) {
  auto model = head_of(ship.name, speed);
  if (has_coefficients(ship)) {
    const auto c = dimensional(coefficients(ship), prime_scale(ship, speed));
    add_state_space(model, {"v", "r"}, {"m/s", "rad/s"}, {c.v_v, c.r_v, c.v_r, c.r_r}, {c.v_delta, c.r_delta});
  }
  model.fields.push_back({"nomoto", {nomoto_of(ship, speed)}});
  return model;
}

MatStruct point_of(const OperatingPoint& point) {
  const auto& [m, c] = point;
  const bool thrust = c.by_thrust;
  return {{{"u_m_s", mat_number(m.u)},
           {"v_m_s", mat_number(m.v)},
           {"r_rad_s", mat_number(m.r)},
           {"delta_rad", mat_number(c.delta)},
           {thrust ? "thrust_N" : "rev_s", mat_number(thrust ? c.thrust.port + c.thrust.starboard : c.rev)}}};
}

MatStruct model_of(const Ship& ship, const Linearization& linear) {
  auto model = head_of(ship.name, linear.scale.U);
  const auto& d = linear.whole.d;
  std::vector<double> A, B;
  for (std::size_t column = 0; column < 3; ++column)
    for (std::size_t line = 0; line < 3; ++line) A.push_back(d[line][column]);
  for (std::size_t line = 0; line < 3; ++line) B.push_back(d[line][3]);
  add_state_space(model, {"u", "v", "r"}, {"m/s", "m/s", "rad/s"}, std::move(A), std::move(B));
  model.fields.push_back({"operating_point", {point_of(linear.point)}});
  model.fields.push_back({"nomoto", {nomoto_of(linear_ship(ship, linear), linear.scale.U)}});
  return model;
}

/// A model, with those of both sides in fields of it.
template <class Sides, class Of>
void write(const std::filesystem::path& file, const Sides& sides, Of&& of) {
  auto model = of(sides.mean);
  if (sides.port) model.fields.push_back({"port", {of(*sides.port)}});
  if (sides.starboard) model.fields.push_back({"starboard", {of(*sides.starboard)}});
  write_mat(file, model.fields);
}

}  // namespace

void write_linear_model(const std::filesystem::path& file, const SteeringSides& sides, double speed) {
  write(file, sides, [&](const LinearShip& ship) { return model_of(ship, speed); });
}

void write_linear_model(const std::filesystem::path& file, const Ship& ship, const LinearizedSides& sides) {
  write(file, sides, [&](const Linearization& linear) { return model_of(ship, linear); });
}

}  // namespace swayaw::app
