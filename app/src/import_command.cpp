#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>

#include "commands.hpp"
#include "json.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/import.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/version.hpp"

namespace swayaw::app {
namespace {

namespace fs = std::filesystem;

enum class FileKind { table, nmea, matlab };

std::string beginning_of(const fs::path& file) {
  std::string bytes(4096, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

/// Whether more lines are sentences, "$HEHDT,…" or "!AIVDM,…", perhaps behind a time stamp, than are not.
bool holds_sentences(std::string_view text) {
  std::ptrdiff_t sentences = 0, others = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const auto end = std::min(text.find('\n', begin), text.size());
    const auto line = text.substr(begin, end - begin);
    const auto mark = line.find_first_of("$!");
    const bool is_sentence = mark != std::string_view::npos && line.find(',', mark) - mark == 6;
    if (line.size() > 1) ++(is_sentence ? sentences : others);
    begin = end + 1;
  }
  return sentences > others;
}

FileKind kind_of(const fs::path& file) {
  const auto bytes = beginning_of(file);
  if (bytes.starts_with("MATLAB ") || bytes.starts_with("\x89HDF") || file.extension() == ".mat")
    return FileKind::matlab;
  return holds_sentences(bytes) ? FileKind::nmea : FileKind::table;
}

FileKind kind_of(const std::vector<fs::path>& files) {
  const auto kind = kind_of(files.front());
  for (const auto& file : files)
    if (kind_of(file) != kind) throw FileError({file}, fmt::format("is not of the kind of {}", files.front().string()));
  return kind;
}

Import imported(const ImportArguments& a) {
  const ImportOptions options{.column_map = a.columns};
  switch (kind_of(a.files)) {
    case FileKind::nmea: throw FileError({a.files.front(), 1, 1}, "NMEA 0183 sentences cannot be imported yet");
    case FileKind::matlab: throw FileError({a.files.front(), 1, 1}, "MATLAB files cannot be imported yet");
    case FileKind::table: break;
  }
  return import_table(a.files, options);
}

void require_other_file(const ImportArguments& a) {
  auto inputs = a.files;
  if (!a.columns.empty()) inputs.push_back(a.columns);
  std::error_code ignored;
  for (const auto& file : inputs)
    if (fs::equivalent(file, a.out, ignored))
      throw FileError({a.out}, "is read by this import and would be overwritten");
}

/// "36,000"
std::string grouped(std::size_t count) {
  return count < 1000 ? std::to_string(count) : fmt::format("{},{:03}", grouped(count / 1000), count % 1000);
}

Json document_of(const ImportArguments& a, const Import& import) {
  Json columns = Json::array();
  for (const auto& c : import.columns)
    columns.push_back({{"source", c.source},
                       {"taken_for", c.taken_for.empty() ? Json(nullptr) : Json(c.taken_for)},
                       {"why", c.why},
                       {"samples", c.samples}});
  Json files = Json::array();
  for (const auto& file : a.files) files.push_back(file.string());
  return {{"schema", "swayaw.import/1"}, {"version", version()},          {"files", std::move(files)},
          {"out", a.out.string()},       {"columns", std::move(columns)}, {"notes", import.notes}};
}

void print_text(const ImportArguments& a, const Import& import) {
  for (const auto& c : import.columns) {
    const auto samples =
        c.samples > 0 ? fmt::format(", {} sample{}", grouped(c.samples), c.samples == 1 ? "" : "s") : "";
    if (c.taken_for.empty()) fmt::print("{}: {}{}\n", c.source, c.why, samples);
    else fmt::print("{} -> {}: {}{}\n", c.source, c.taken_for, c.why, samples);
  }
  for (const auto& note : import.notes) fmt::print("{}\n", note);
  fmt::print(stderr, "swayaw: recording written to {}\n", a.out.string());
}

}  // namespace

void import_run(const ImportArguments& a) {
  require_other_file(a);
  const auto import = imported(a);
  write_text(a.out, import.text);
  if (a.json) fmt::print("{}\n", document_of(a, import).dump(2));
  else print_text(a, import);
}

}  // namespace swayaw::app
