#include "swayaw/linear/linear_ship_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "swayaw/core/parts_reader.hpp"
#include "swayaw/core/parts_writer.hpp"
#include "swayaw/core/ship_text.hpp"

namespace swayaw::inline linear {
namespace {

// ---------------------------------------------------------------- the forms

struct PartsFile {
  LinearParticulars<double> particulars;
  LinearHull<double> hull;
  LinearRudder<double> rudder;
  SteeringGear<double> gear;

  static constexpr auto sections() {
    return std::tuple{Section<PartsFile, LinearParticulars<double>>{"particulars", &PartsFile::particulars},
                      Section<PartsFile, LinearHull<double>>{"hull", &PartsFile::hull},
                      Section<PartsFile, LinearRudder<double>>{"rudder", &PartsFile::rudder},
                      Section<PartsFile, SteeringGear<double>>{"rudder", &PartsFile::gear}};
  }

  LinearForm form() const { return LinearParts<double>{hull, rudder}; }
};

/// Indices with real time constants.
struct RealIndices {
  double T1, T2, T3b, T3w, Kb, Kw;

  static constexpr auto parameters() {
    constexpr auto index = [](std::string_view key, double RealIndices::*member, const Range& range = any_number) {
      return ParameterOf<RealIndices, double>{key, member, "-", range, Role::coefficient};
    };
    return std::array{index("T1", &RealIndices::T1, not_zero), index("T2", &RealIndices::T2, not_zero),
                      index("T3b", &RealIndices::T3b),         index("T3w", &RealIndices::T3w),
                      index("Kb", &RealIndices::Kb),           index("Kw", &RealIndices::Kw)};
  }
};

LinearForm form_of(const SwayYawCoefficients<double>& m) { return m; }
LinearForm form_of(const SteeringIndices<double>& i) { return i; }
LinearForm form_of(const RealIndices& i) {
  return SteeringIndices<double>{i.T1 * i.T2, i.T1 + i.T2, i.T3b, i.T3w, i.Kb, i.Kw};
}

/// A form that is one table of numbers.
template <class Numbers>
struct TableFile {
  LinearParticulars<double> particulars;
  Numbers numbers;
  SteeringGear<double> gear;

  static constexpr std::string_view table = std::is_same_v<Numbers, SwayYawCoefficients<double>> ? "linear" : "nomoto";

  static constexpr auto sections() {
    return std::tuple{Section<TableFile, LinearParticulars<double>>{"particulars", &TableFile::particulars},
                      Section<TableFile, Numbers>{table, &TableFile::numbers},
                      Section<TableFile, SteeringGear<double>>{"rudder", &TableFile::gear}};
  }

  LinearForm form() const { return form_of(numbers); }
};

// ---------------------------------------------------------------- reading

template <class File>
LinearShip read_as(const PartsReader& reader) {
  File file{};
  auto head = reader.read({file_parameters(file), {}, {}});
  if (file.gear.lag > 0.0)
    reader.fail("rudder", "lag_s",
                "a linear ship's rudder keeps its rate until it arrives; lag_s is not understood here");
  if (file.gear.dead_band > 0.0)
    reader.fail("rudder", "dead_band_deg", "dead_band_deg is not understood in a linear ship");
  return {std::move(head.name), file.particulars, file.gear, file.form(), std::move(head.confidence)};
}

/// "hull", "linear" or "nomoto".
std::string_view form_in(const PartsReader& reader) {
  constexpr std::array<std::string_view, 3> forms{"hull", "linear", "nomoto"};
  constexpr std::string_view rule = "a linear ship has one of [hull], [linear] and [nomoto]";
  std::vector<std::string_view> there;
  std::ranges::copy_if(forms, std::back_inserter(there), [&](auto form) { return reader.has(form); });
  if (there.empty()) reader.fail("", "", fmt::format("{}; none is there", rule));
  if (there.size() > 1) reader.fail("", there[1], fmt::format("{}; [{}] and [{}] are there", rule, there[0], there[1]));
  return there.front();
}

LinearShip read_indices(const PartsReader& reader) {
  const bool products = reader.has("nomoto", "T1T2") || reader.has("nomoto", "T1_plus_T2");
  for (const auto* key : {"T1", "T2"})
    if (products && reader.has("nomoto", key))
      reader.fail("nomoto", key,
                  fmt::format("{} in [nomoto] is one too many: T1T2 and T1_plus_T2 replace T1 and T2", key));
  return products ? read_as<TableFile<SteeringIndices<double>>>(reader) : read_as<TableFile<RealIndices>>(reader);
}

// ---------------------------------------------------------------- writing

PartsFile file_of(const LinearShip& ship, const LinearParts<double>& parts) {
  return {ship.particulars, parts.hull, parts.rudder, ship.steering_gear};
}

template <class Numbers>
TableFile<Numbers> file_of(const LinearShip& ship, const Numbers& numbers) {
  return {ship.particulars, numbers, ship.steering_gear};
}

}  // namespace

std::string ship_text(const LinearShip& ship, std::string_view remark) {
  const auto text_as = [&](const auto& form) {
    auto file = file_of(ship, form);
    return core::ship_text("linear", {ship.name, ship.confidence}, {file_parameters(file), {}, {}}, {}, remark);
  };
  return std::visit(text_as, ship.form);
}

void write_linear_ship(const std::filesystem::path& file, const LinearShip& ship, std::string_view remark) {
  const auto units = [&](const auto& form) {
    auto model = file_of(ship, form);
    return units_of({file_parameters(model), {}, {}});
  };
  write_ship_text(file, ship_text(ship, remark), std::visit(units, ship.form));
}

LinearShip parse_linear_ship(std::string_view text, const std::filesystem::path& name) {
  const PartsReader reader(text, name);
  reader.require_model("linear");
  if (reader.has("effect")) reader.fail("", "effect", "[[effect]] is not understood in a linear ship");
  const auto form = form_in(reader);
  if (form == "hull") return read_as<PartsFile>(reader);
  if (form == "linear") return read_as<TableFile<SwayYawCoefficients<double>>>(reader);
  return read_indices(reader);
}

LinearShip read_linear_ship(const std::filesystem::path& file) { return parse_linear_ship(read_ship_text(file), file); }

}  // namespace swayaw::linear
