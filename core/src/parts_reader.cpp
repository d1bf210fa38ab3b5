#include "swayaw/core/parts_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "swayaw/core/detail/spelling.hpp"
#include "swayaw/core/detail/toml_text.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/steered_thrust.hpp"

namespace swayaw::inline core {
namespace {

/// "kt[0]" is the first number of the list kt.
struct KeyPlace {
  std::string_view key;
  std::optional<std::size_t> index;
};

KeyPlace place_of(std::string_view key) {
  const auto bracket = key.find('[');
  if (bracket == std::string_view::npos) return {key, std::nullopt};
  return {key.substr(0, bracket), static_cast<std::size_t>(key[bracket + 1] - '0')};
}

enum class Holds { text, table, effects, number, choice, list };

/// A key that a table may have.
struct KnownKey {
  std::string table;  ///< "" for the keys and tables of the file itself
  std::string key;
  Holds holds;
  bool required = true;
  bool coefficient = false;
  std::size_t numbers = 1;  ///< length of the list

  std::string name() const { return holds == Holds::table ? fmt::format("[{}]", key) : key; }
};

/// All keys of a ship file, without those of [confidence].
std::vector<KnownKey> known_keys(const FileKeys& file) {
  std::vector<KnownKey> keys{{"", "name", Holds::text},
                             {"", "model", Holds::text},
                             {"", "confidence", Holds::table, false},
                             {"", "effect", Holds::effects, false}};
  const auto require_table = [&](std::string_view table, bool required) {
    const auto same = [&](const KnownKey& k) { return k.holds == Holds::table && k.key == table; };
    const auto known = std::ranges::find_if(keys, same);
    if (known == keys.end()) keys.push_back({"", std::string(table), Holds::table, required});
    else known->required = known->required || required;
  };
  for (const auto& n : file.parameters) {
    require_table(n.table, n.required);
    const auto [key, index] = place_of(n.key);
    if (index.value_or(0) > 0) ++keys.back().numbers;
    else
      keys.push_back({std::string(n.table), std::string(key), Holds::number, n.required, n.role == Role::coefficient});
  }
  const auto add_optional = [&](std::string_view table, std::string_view key, Holds holds) {
    require_table(table, false);
    keys.push_back({std::string(table), std::string(key), holds, false});
  };
  for (const auto& c : file.choices) add_optional(c.table, c.key, Holds::choice);
  for (const auto& l : file.lists) add_optional(l.table, l.key, Holds::list);
  return keys;
}

/// Where things are in a ship file.
class ShipText : public detail::TomlText {
 public:
  using TomlText::text;
  using TomlText::TomlText;

  std::string text(std::string_view key) const { return text(*root().get(key), key); }

  const toml::table& table(std::string_view name) const {
    const auto& node = *root().get(name);
    if (const auto* table = node.as_table()) return *table;
    fail(node, fmt::format("{} must be a table", name));
  }
};

/// Fills what was asked for.
class KeysReader {
 public:
  KeysReader(const ShipText& file, const FileKeys& wanted) : file_(file), wanted_(wanted), keys_(known_keys(wanted)) {}

  ShipFileHead read() const {
    require_keys(file_.root(), "");
    ShipFileHead head{.name = file_.text("name"), .confidence = {}};
    for (const auto& k : keys_)
      if (k.holds == Holds::table && k.key != "confidence" && file_.root().contains(k.key))
        require_keys(file_.table(k.key), k.key);
    for (const auto& n : wanted_.parameters) read_number(n);
    for (const auto& c : wanted_.choices) read_choice(c);
    for (const auto& l : wanted_.lists) read_list(l);
    read_confidence(head.confidence);
    return head;
  }

 private:
  // -------------------------------------------------------------- every key, and no other

  /// The first required key that the table lacks.
  const KnownKey* missing_key(const toml::table& table, std::string_view name) const {
    const auto lacks = [&](const KnownKey& k) { return k.table == name && k.required && !table.contains(k.key); };
    const auto found = std::ranges::find_if(keys_, lacks);
    return found == keys_.end() ? nullptr : &*found;
  }

  std::vector<std::string_view> keys_of(std::string_view table) const {
    std::vector<std::string_view> keys;
    for (const auto& k : keys_)
      if (k.table == table) keys.push_back(k.key);
    return keys;
  }

  void require_keys(const toml::table& table, std::string_view name) const {
    const auto* missing = missing_key(table, name);
    const auto where = name.empty() ? std::string{} : fmt::format(" in [{}]", name);
    for (auto&& entry : table) {
      const toml::key& key = entry.first;
      const auto is_key = [&](const KnownKey& k) { return k.table == name && k.key == key.str(); };
      if (std::ranges::any_of(keys_, is_key)) continue;
      const auto hint = missing ? fmt::format("; {} is missing", missing->name())
                                : core::detail::did_you_mean(key.str(), keys_of(name));
      file_.fail(key.source().begin, fmt::format("{}{} is not known{}", key.str(), where, hint));
    }
    if (missing) file_.fail(table, fmt::format("{} is missing{}", missing->name(), where));
  }

  // -------------------------------------------------------------- numbers

  void read_number(const FileParameter& n) const {
    const auto place = place_of(n.key);
    const auto* node = node_of(n.table, place.key);
    *n.value = node ? in_si(*node, place, n) : n.fallback;
  }

  /// A denormal number of degrees is no angle any more in radians, a huge one of kilonewtons infinite in newtons.
  double in_si(const toml::node& node, const KeyPlace& place, const FileParameter& n) const {
    const double written = number(node, place, n.table, n.range), value = written * n.si;
    if (std::isfinite(value) && n.range.contains(value / n.si) && (value != 0.0 || written == 0.0)) return value;
    file_.fail(node, fmt::format("{} in [{}] is too {}, {}", place.key, n.table,
                                 std::abs(written) < 1.0 ? "small" : "large", written));
  }

  const toml::node* node_of(std::string_view table, std::string_view key) const {
    return file_.root().contains(table) ? file_.table(table).get(key) : nullptr;
  }

  void read_choice(const FileChoice& c) const {
    const auto* node = node_of(c.table, c.key);
    if (!node) return;
    const auto word = node->value_exact<std::string>();
    const auto found = std::ranges::find(c.names, word.value_or(""));
    const auto names = c.names.first(static_cast<std::size_t>(std::ranges::find(c.names, "") - c.names.begin()));
    if (!word || word->empty() || found == c.names.end())
      file_.fail(*node, fmt::format("{} in [{}] must be one of \"{}\"", c.key, c.table, fmt::join(names, "\", \"")));
    c.value->index = static_cast<int>(found - c.names.begin());
  }

  void read_list(const FileList& l) const {
    const auto* node = node_of(l.table, l.key);
    if (!node) return;
    const auto* list = node->as_array();
    if (!list) file_.fail(*node, fmt::format("{} in [{}] must be a list of numbers", l.key, l.table));
    for (const auto& element : *list)
      l.value->push_back(number(element, {l.key, std::nullopt}, l.table, any_number) * l.si);
  }

  double number(const toml::node& node, const KeyPlace& place, std::string_view table, const Range& range) const {
    const auto& element = place.index ? list_element(node, place, table) : node;
    return file_.number(element, fmt::format("{} in [{}]", place.key, table), range);
  }

  const toml::node& list_element(const toml::node& node, const KeyPlace& place, std::string_view table) const {
    const auto same = [&](const KnownKey& k) { return k.table == table && k.key == place.key; };
    const auto numbers = std::ranges::find_if(keys_, same)->numbers;
    const auto* list = node.as_array();
    if (!list) file_.fail(node, fmt::format("{} in [{}] must be a list of {} numbers", place.key, table, numbers));
    if (list->size() != numbers)
      file_.fail(node, fmt::format("{} in [{}] must be a list of {} numbers, got {}", place.key, table, numbers,
                                   list->size()));
    return *list->get(*place.index);
  }

  // -------------------------------------------------------------- trust

  void read_confidence(Confidence& confidence) const {
    if (!file_.root().contains("confidence")) return;
    for (auto&& [key, value] : file_.table("confidence")) {
      if (key != "coefficients" && !is_coefficient(key.str()))
        file_.fail(key.source().begin, fmt::format("{} in [confidence] is not a coefficient of this model", key.str()));
      const double deviation = number(value, {key.str(), std::nullopt}, "confidence", non_negative);
      if (key == "coefficients") confidence.coefficients = deviation;
      else confidence.named.emplace_back(key.str(), deviation);
    }
  }

  bool is_coefficient(std::string_view key) const {
    return std::ranges::any_of(keys_, [&](const KnownKey& k) { return k.coefficient && k.key == key; });
  }

  const ShipText& file_;
  const FileKeys& wanted_;
  std::vector<KnownKey> keys_;
};

/// A key, or a text that is not a name, with the name of a drive that no model here has, refuses the ship.
void refuse_steered_thrust(const ShipText& file, const toml::table& table) {
  const auto refuse = [&](const toml::source_region& where, std::string_view words) {
    file.fail(where.begin, fmt::format("\"{}\" {}", words, no_steered_thrust));
  };
  for (auto&& [key, node] : table) {
    if (names_steered_thrust(key.str())) refuse(key.source(), key.str());
    const auto word = node.value<std::string>();
    if (word && key != "name" && names_steered_thrust(*word)) refuse(node.source(), *word);
    if (const auto* inner = node.as_table()) refuse_steered_thrust(file, *inner);
  }
}

FileEffect effect_of(const ShipText& text, const toml::table& table) {
  const auto place = table.source().begin;
  if (!table.contains("kind")) text.fail(table, "kind is missing in [[effect]]");
  FileEffect effect{.kind = {}, .numbers = {}, .line = place.line, .column = place.column, .channel = {}};
  for (auto&& [key, node] : table) {
    const auto where = node.source().begin;
    effect.values.push_back({std::string(key.str()), where.line, where.column});
    const auto word = node.value_exact<std::string>();
    const auto number = node.is_number() ? node.value<double>() : std::nullopt;
    if (key == "kind" && word) effect.kind = *word;
    else if (key == "channel" && word) effect.channel = *word;
    else if (number && std::isfinite(*number)) effect.numbers.emplace_back(key.str(), *number);
    else
      text.fail(node, fmt::format("{} in [[effect]] must be a {}", key.str(),
                                  key == "kind" || key == "channel" ? "text in quotes" : "number"));
  }
  return effect;
}

}  // namespace

struct PartsReader::Document {
  toml::table root;
  std::filesystem::path file;

  ShipText text() const { return {root, file}; }
};

PartsReader::PartsReader(std::string_view text, const std::filesystem::path& name)
    : document_(std::make_unique<Document>(Document{detail::parsed_toml(text, name), name})) {
  refuse_steered_thrust(document_->text(), document_->root);
}

PartsReader::~PartsReader() = default;

std::string PartsReader::model() const { return has("model") ? document_->text().text("model") : std::string{}; }

void PartsReader::require_model(std::string_view wanted) const {
  const auto named = model();
  if (has("model") && std::ranges::count(ship_models, named) == 0)
    fail("", "model",
         fmt::format("model \"{}\" is not known to this version (known: {})", named, fmt::join(ship_models, ", ")));
  if (has("model") && named != wanted)
    fail("", "model", fmt::format("a ship of model \"{}\" is needed here, got \"{}\"", wanted, named));
}

bool PartsReader::has(std::string_view key) const { return document_->root.contains(key); }

bool PartsReader::has(std::string_view table, std::string_view key) const {
  const auto* found = document_->root.get_as<toml::table>(table);
  return found && found->contains(key);
}

ShipFileHead PartsReader::read(const FileKeys& keys) const {
  const auto text = document_->text();
  return KeysReader(text, keys).read();
}

std::vector<FileEffect> PartsReader::effects() const {
  const auto text = document_->text();
  std::vector<FileEffect> effects;
  if (!has("effect")) return effects;
  const auto* list = document_->root.get("effect")->as_array();
  if (!list || !list->is_homogeneous<toml::table>()) fail("", "effect", "effects are written as [[effect]] tables");
  for (const auto& node : *list) effects.push_back(effect_of(text, *node.as_table()));
  return effects;
}

void PartsReader::fail(const FileEffect& effect, std::string_view what) const {
  throw FileError({document_->file, effect.line, effect.column}, what);
}

void PartsReader::fail(const FileEffect& effect, std::string_view key, std::string_view what) const {
  const auto value = std::ranges::find(effect.values, key, &FileEffect::Place::key);
  throw FileError({document_->file, value->line, value->column}, what);
}

void PartsReader::fail(std::string_view table, std::string_view key, std::string_view what) const {
  const auto text = document_->text();
  const auto* in_table = table.empty() ? &document_->root : document_->root.get_as<toml::table>(table);
  if (!in_table) text.fail(document_->root, what);
  const auto* node = in_table->get(key);
  text.fail(node ? *node : *in_table, what);
}

std::string model_of(std::string_view text, const std::filesystem::path& name) {
  return PartsReader(text, name).model();
}

}  // namespace swayaw::core
