#include <catch.hpp>
#include <string>

#include "files.hpp"
#include "swayaw/core/mat_file.hpp"
#include "swayaw/core/parts_reader.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/linear/linear_ship_file.hpp"
#include "swayaw/nonlinear/published_ships.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

/// A ship is the same in a MATLAB file: a struct for each table, with the keys of her file.
namespace swayaw {
namespace {

bool is_linear(const PublishedShip& ship) { return PartsReader(ship.text, std::string(ship.name)).model() == "linear"; }

MatStruct& struct_in(std::vector<MatVariable>& variables, std::string_view name) {
  return std::get<MatStruct>(std::ranges::find(variables, name, &MatVariable::name)->value.is);
}

std::string refusal_of(const std::filesystem::path& file) {
  try {
    read_ship(file);
    return {};
  } catch (const FileError& error) {
    const std::string what = error.what();
    return what.substr(what.rfind("ship.mat"));
  }
}

TEST_CASE("every published ship comes back from a MATLAB file to the last bit", "[nonlinear][round-trip]") {
  const test::Scratch scratch;
  for (const auto& published : published_ships()) {
    INFO(published.name);
    if (is_linear(published)) {
      const auto ship = parse_linear_ship(published.text, std::string(published.name));
      write_linear_ship(scratch / "ship.mat", ship);
      CHECK(ship_text(read_linear_ship(scratch / "ship.mat")) == ship_text(ship));
    } else {
      const auto ship = published_ship(published.name);
      write_ship(scratch / "ship.mat", ship);
      CHECK(ship_text(read_ship(scratch / "ship.mat")) == ship_text(ship));
    }
  }
}

TEST_CASE("effects, confidence and lists come back too, as a struct or as variables", "[nonlinear][round-trip]") {
  const std::string more =
      "\n[confidence]\ncoefficients = 0.02\nN_v = 0.05\n"
      "\n[[effect]]\nkind = \"steady_current\"\ncurrent_speed_m_s = 0.5\ncurrent_to_rad = 1.5\n"
      "\n[[effect]]\nkind = \"channel_delay\"\nchannel = \"r\"\ndelay_s = 0.4\n";
  const auto ship = parse_ship(ship_text(published_ship("kvlcc2")) + more, "ship.toml");
  const test::Scratch scratch;
  write_ship(scratch / "ship.mat", ship);
  CHECK(ship_text(read_ship(scratch / "ship.mat")) == ship_text(ship));
  const auto variables = read_mat(scratch / "ship.mat");
  write_mat(scratch / "ship.mat", {{"s", {MatStruct{variables}}}});
  CHECK(ship_text(read_ship(scratch / "ship.mat")) == ship_text(ship));
}

TEST_CASE("units stand beside the numbers of a ship", "[nonlinear]") {
  const test::Scratch scratch;
  write_ship(scratch / "ship.mat", published_ship("kvlcc2"));
  auto variables = read_mat(scratch / "ship.mat");
  auto& particulars = struct_in(struct_in(variables, "units").fields, "particulars").fields;
  const auto length = std::ranges::find(particulars, "length_m", &MatVariable::name);
  REQUIRE(length != particulars.end());
  CHECK(std::get<std::string>(length->value.is) == "m");
}

TEST_CASE("a ship that is none is refused, naming the key", "[nonlinear][refusal]") {
  const test::Scratch scratch;
  const auto file = scratch / "ship.mat";
  write_ship(file, published_ship("kvlcc2"));
  const auto variables = read_mat(file);

  auto changed = variables;
  struct_in(changed, "hull").fields.push_back({"N_w", mat_number(1.0)});
  write_mat(file, changed);
  CHECK(refusal_of(file).starts_with("ship.mat:1:1: N_w"));

  changed = variables;
  struct_in(changed, "particulars").fields.front().value = {std::string("long")};
  write_mat(file, changed);
  CHECK(refusal_of(file).find("must be a number") != std::string::npos);

  changed = variables;
  struct_in(changed, "particulars").fields.front().value = {MatNumbers{2, 2, {1, 2, 3, 4}}};
  write_mat(file, changed);
  CHECK(refusal_of(file).find("a number, a row of numbers or a text in '...' is needed") != std::string::npos);
}

}  // namespace
}  // namespace swayaw
