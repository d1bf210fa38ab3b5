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
#include "swayaw/core/manoeuvres_in.hpp"
#include "swayaw/core/mat_file.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/version.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

namespace fs = std::filesystem;

enum class FileKind { table, nmea, matlab };

std::string beginning_of(const fs::path& file) {
  require_regular_file(file);  // it is read twice
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

const fs::path& only(const std::vector<fs::path>& files) {
  if (files.size() > 1) throw FileError({files[1]}, "MATLAB files are imported one by one");
  return files.front();
}

Import imported(const ImportArguments& a) {
  const ImportOptions options{.column_map = a.columns};
  switch (kind_of(a.files)) {
    case FileKind::nmea: return import_nmea(a.files, options);
    case FileKind::matlab: return import_mat(only(a.files), options);
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

void write_import(const fs::path& file, const Import& import) {
  if (is_mat(file)) write_recording(parse_recording(import.text, file).recording, file);
  else write_text(file, import.text);
}

// ---------------------------------------------------------------- manoeuvres

/// A manoeuvre with the file it was written to.
struct WrittenPiece {
  ManoeuvrePiece piece;
  fs::path file;
};

std::vector<WrittenPiece> write_pieces(const ImportArguments& a, const Import& import) {
  if (!a.split) return {};
  const auto log = parse_recording(import.text, a.out).recording;
  std::vector<WrittenPiece> pieces;
  for (const auto& piece : manoeuvres_in(log)) {
    const auto file = file_of_piece(a.out, pieces.size() + 1, piece);
    write_recording(piece_of(log, piece), file);
    pieces.push_back({piece, file});
  }
  return pieces;
}

Json piece_json(const WrittenPiece& p) {
  return {{"file", p.file.string()},
          {"manoeuvre", p.piece.manoeuvre},
          {"from_s", p.piece.begin},
          {"to_s", p.piece.end},
          {"execute_s", p.piece.execute ? Json(*p.piece.execute) : Json(nullptr)},
          {"why", p.piece.why}};
}

void print_pieces(const ImportArguments& a, const std::vector<WrittenPiece>& pieces) {
  if (a.split && pieces.empty()) say("no manoeuvre was found in it\n");
  for (const auto& p : pieces)
    say("{}: {} from {:.6g} to {:.6g} s, {}\n", p.file.string(), p.piece.manoeuvre, p.piece.begin, p.piece.end,
        p.piece.why);
}

// ---------------------------------------------------------------- answers

Json document_of(const ImportArguments& a, const Import& import, const std::vector<WrittenPiece>& pieces) {
  Json columns = Json::array();
  for (const auto& c : import.columns)
    columns.push_back({{"source", c.source},
                       {"taken_for", c.taken_for.empty() ? Json(nullptr) : Json(c.taken_for)},
                       {"why", c.why},
                       {"samples", c.samples}});
  Json files = Json::array();
  for (const auto& file : a.files) files.push_back(file.string());
  Json manoeuvres = Json::array();
  for (const auto& p : pieces) manoeuvres.push_back(piece_json(p));
  return {{"schema", "swayaw.import/1"},        {"version", version()},
          {"files", std::move(files)},          {"out", a.out.string()},
          {"columns", std::move(columns)},      {"notes", import.notes},
          {"manoeuvres", std::move(manoeuvres)}};
}

void print_text(const ImportArguments& a, const Import& import) {
  for (const auto& c : import.columns) {
    const auto samples =
        c.samples > 0 ? fmt::format(", {} sample{}", grouped(c.samples), c.samples == 1 ? "" : "s") : "";
    if (c.taken_for.empty()) say("{}: {}{}\n", c.source, c.why, samples);
    else say("{} -> {}: {}{}\n", c.source, c.taken_for, c.why, samples);
  }
  for (const auto& note : import.notes) say("{}\n", note);
  say_aside("swayaw: recording written to {}\n", a.out.string());
}

}  // namespace

void import_run(const ImportArguments& a) {
  require_other_file(a);
  const auto import = imported(a);
  write_import(a.out, import);
  const auto pieces = write_pieces(a, import);
  if (a.json) {
    print_document(document_of(a, import, pieces));
    return;
  }
  print_text(a, import);
  print_pieces(a, pieces);
}

}  // namespace swayaw::app
