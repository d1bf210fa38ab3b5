#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "swayaw/core/parts_reader.hpp"

/// The text of a ship file, whether it stands in a TOML file or, with the same keys, in the structs of a MATLAB file.
namespace swayaw::inline core {

/// The unit of a number of a ship file.
struct ShipFileUnit {
  std::string_view table;
  std::string_view key;
  std::string_view unit;  ///< "-" for none
};

std::vector<ShipFileUnit> units_of(const FileKeys& keys);

/// TOML of a ship file. A file that ends in .mat holds a variable for each key and a struct for each table, or one
/// struct of these.
/// @throws FileError  if it cannot be read, or holds what no ship file can
std::string read_ship_text(const std::filesystem::path& file);

/// Writes the text, or the variables that stand for it if the file ends in .mat; these with a struct `units` of
/// those that the text gives.
/// @throws FileError  if the file cannot be written
void write_ship_text(const std::filesystem::path& file, std::string_view text,
                     const std::vector<ShipFileUnit>& units = {});

}  // namespace swayaw::core
