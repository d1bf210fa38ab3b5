#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "swayaw/core/confidence.hpp"
#include "swayaw/core/parameter.hpp"

/// How ship files are read: one set of rules for every model. A model lists its parts in `sections()` and each part its
/// numbers in `parameters()`; every key of the lists must be there, no other may be, and every number must lie in its
/// range.
namespace swayaw::inline core {

/// Models of the ship files that this version understands.
inline constexpr std::array<std::string_view, 5> ship_models{"linear", "mmg", "pi", "pu", "abkowitz"};

/// A parameter of a ship file and where it goes.
struct FileParameter {
  std::string_view table;
  std::string_view key;  ///< "kt[0]" is the first of the list kt
  std::string_view unit;
  Range range;  ///< in the unit of the file
  Role role;
  double si;  ///< SI value of one unit
  bool required;
  double fallback;  ///< where an optional number is not given, in SI
  double* value;    ///< to be set, in SI
};

/// A word of a ship file that selects a form of the physics.
struct FileChoice {
  std::string_view table;
  std::string_view key;
  std::span<const std::string_view> names;
  Selection* value;  ///< to be set
};

/// A list of numbers of a ship file, as long as the file likes; empty where it is not given.
struct FileList {
  std::string_view table;
  std::string_view key;
  double si;                   ///< SI value of one unit
  std::vector<double>* value;  ///< to be set, in SI
};

/// What a ship file may hold besides its head.
struct FileKeys {
  std::vector<FileParameter> parameters;
  std::vector<FileChoice> choices;
  std::vector<FileList> lists;
};

/// An [[effect]] of a ship file.
struct FileEffect {
  struct Place {
    std::string key;
    std::size_t line, column;
  };

  std::string kind;
  std::vector<std::pair<std::string, double>> numbers;
  std::size_t line;
  std::size_t column;
  std::string channel{};        ///< name of a channel, where one is given
  std::vector<Place> values{};  ///< where the value of each key stands
};

/// The parameters of a part that stands in that table.
template <class Part>
void add_parameters(std::vector<FileParameter>& parameters, std::string_view table, Part& part) {
  for (const auto& p : part.parameters())
    parameters.push_back({table, p.key, p.unit, p.range, p.role, p.si, p.required, p.fallback, &(part.*p.member)});
}

/// All parameters of a model, in the order of its lists.
template <class Model>
std::vector<FileParameter> file_parameters(Model& model) {
  std::vector<FileParameter> parameters;
  std::apply([&](const auto&... section) { (add_parameters(parameters, section.table, model.*section.part), ...); },
             Model::sections());
  return parameters;
}

/// All choices of a model.
template <class Model>
std::vector<FileChoice> file_choices(Model& model) {
  std::vector<FileChoice> choices;
  const auto add_part = [&]<class Part>(const Section<Model, Part>& section) {
    static constexpr auto list = choices_of<Part>();
    for (const auto& c : list) choices.push_back({section.table, c.key, c.names, &(model.*section.part.*c.member)});
  };
  std::apply([&](const auto&... section) { (add_part(section), ...); }, Model::sections());
  return choices;
}

/// Parameters and choices of a model.
template <class Model>
FileKeys file_keys(Model& model) {
  return {file_parameters(model), file_choices(model), {}};
}

/// What every ship file says besides its numbers.
struct ShipFileHead {
  std::string name;
  Confidence confidence;
};

/// The TOML of a ship file.
class PartsReader {
 public:
  /// @param name  stands for the file in messages
  /// @throws FileError  if the text is not TOML
  PartsReader(std::string_view text, const std::filesystem::path& name);
  ~PartsReader();

  /// The model named in the file; empty if none is named.
  /// @throws FileError  if it is not a text
  std::string model() const;

  /// Refuses other models. A file without a model passes.
  /// @throws FileError
  void require_model(std::string_view model) const;

  /// Whether the file has that key or table.
  bool has(std::string_view key) const;

  /// Whether the table has that key.
  bool has(std::string_view table, std::string_view key) const;

  /// Sets parameters, choices and lists. A table of which no number is required may be missing.
  /// @throws FileError  naming the key that is missing, not known or out of range
  ShipFileHead read(const FileKeys& keys) const;

  /// The [[effect]] tables in their order, each a kind and numbers, and a channel where one is given.
  /// @throws FileError  if one has no kind, or holds anything else
  std::vector<FileEffect> effects() const;

  /// @throws FileError  at the place of the effect
  [[noreturn]] void fail(const FileEffect& effect, std::string_view what) const;

  /// @throws FileError  at the value of that key of the effect, which it has
  [[noreturn]] void fail(const FileEffect& effect, std::string_view key, std::string_view what) const;

  /// @throws FileError  with the place of the value; of the table where the key is not there, of the file where neither
  /// is
  [[noreturn]] void fail(std::string_view table, std::string_view key, std::string_view what) const;

 private:
  struct Document;
  std::unique_ptr<Document> document_;
};

/// The model named in the text of a ship file; empty if none is named.
/// @throws FileError
std::string model_of(std::string_view text, const std::filesystem::path& name);

}  // namespace swayaw::core
