#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Raw files as they come, made into recordings; each says what it took for what.
namespace swayaw::inline core {

/// What one column of a raw file was taken for.
struct ImportedColumn {
  std::string source;     ///< as the file names it: "Kurs [°]", "HDT", "RSA starboard"
  std::string taken_for;  ///< column of the recording, "psi_deg"; empty where it was left out or kept as it is
  std::string why;        ///< by name, unit, values: plain words
  std::size_t samples;    ///< with a value
};

/// A raw file as a recording file (`text` is the CSV that docs/formats.md describes).
struct Import {
  std::vector<ImportedColumn> columns;
  std::vector<std::string> notes;  ///< whole-file facts, one line each: encoding, clock, zone, what was dropped
  std::string text;                ///< the recording file
};

/// What the files do not say themselves.
struct ImportOptions {
  std::filesystem::path column_map;  ///< TOML of docs/import.md; empty: none
};

/// Text tables in the dialects of spreadsheets and loggers; several files with the same columns are joined by time.
///
/// Nothing is guessed silently: columns are known by name and unit and must agree with their values, and what stays
/// open is refused with the line of the column map that settles it (docs/import.md).
///
/// @throws FileError  "FILE:LINE:COLUMN: what is wrong"
Import import_table(const std::vector<std::filesystem::path>& files, const ImportOptions& options);

/// The same from text; `name` stands for the file in messages.
Import import_table_text(std::string_view text, const std::filesystem::path& name, const ImportOptions& options);

/// Logs of NMEA 0183 sentences, with a time in front of each line or with none (docs/import_nmea.md).
///
/// Sentences whose checksum is wrong, whose status is "invalid" or which are cut are dropped and counted. Where several
/// instruments tell one quantity, one is taken and the others are named. A row for each time; cells without a sentence
/// are empty. The rudder keeps its sign, positive turns to starboard, and the run key says so.
///
/// @throws FileError  if a file cannot be read, holds no sentence, or tells no time
/// @throws FileError  if no sentence tells a heading, or none a rudder angle
Import import_nmea(const std::vector<std::filesystem::path>& files, const ImportOptions& options);

/// MATLAB files, versions 4 to 7.3: variables of equal length are columns (docs/import_nmea.md).
/// @throws FileError  if the file is none, or holds no columns, or swayaw was built without libmatio
Import import_mat(const std::filesystem::path& file, const ImportOptions& options);

/// The numeric variables of a MATLAB file as a comma-separated table, variable names in its header.
/// @throws as import_mat
std::string table_of_mat(const std::filesystem::path& file);

}  // namespace swayaw::core
