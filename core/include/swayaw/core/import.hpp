#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace swayaw::inline core {

/// What one column of a raw file was taken for.
struct ImportedColumn {
  std::string source;     ///< as the file names it: "Kurs [°]", "HDT", "RSA starboard"
  std::string taken_for;  ///< column of the recording, "psi_deg"; empty where it was left out or kept as it is
  std::string why;        ///< by name, unit, values: plain words
  std::size_t samples;    ///< with a value
};

/// A raw file as a recording file (not yet SI: `text` is the CSV that formats.md describes).
struct Import {
  std::vector<ImportedColumn> columns;
  std::vector<std::string> notes;  ///< whole-file facts, one line each: encoding, separator, clock, what was dropped
  std::string text;                ///< the recording file
};

/// What the files do not say themselves.
struct ImportOptions {
  std::filesystem::path column_map;  ///< TOML of docs/import.md; empty: none
};

/// Text tables in the dialects of spreadsheets and loggers; several files with the same columns are joined by time.
///
/// Nothing is guessed silently: columns are known by name and unit and must agree with their values, and what stays
/// open is refused with the line of the column map that settles it.
///
/// @throws FileError  "FILE:LINE:COLUMN: what is wrong"
Import import_table(const std::vector<std::filesystem::path>& files, const ImportOptions& options);

/// Logs of NMEA 0183 sentences.
Import import_nmea(const std::vector<std::filesystem::path>& files, const ImportOptions& options);

/// MATLAB files.
Import import_mat(const std::filesystem::path& file, const ImportOptions& options);

}  // namespace swayaw::core
