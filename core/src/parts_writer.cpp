#include "swayaw/core/parts_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "swayaw/core/detail/printable.hpp"

namespace swayaw::inline core {
namespace {

/// The shortest number that, times `si`, is that value again.
double in_unit(double value, double si) {
  const double near = value / si;
  for (const double candidate : {near, std::nextafter(near, HUGE_VAL), std::nextafter(near, -HUGE_VAL)})
    if (candidate * si == value) return candidate;
  return near;
}

std::string text_of(double number) {
  auto text = fmt::format("{}", number);
  return text.find_first_of(".e") == std::string::npos && std::abs(number) < 1e15 ? text + ".0" : text;
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7F) result += fmt::format("\\u{:04x}", static_cast<unsigned>(code));
    else result += c;
  }
  return result + '"';
}

double checked(const FileParameter& n) {
  const double number = in_unit(*n.value, n.si);
  if (std::isfinite(number) && n.range.contains(number)) return number;
  throw std::domain_error(fmt::format("{} in [{}] cannot be {}", n.key, n.table, number));
}

bool is_written(const FileParameter& n) { return n.required || *n.value != n.fallback; }

/// "kt[0]" is the first number of the list kt.
std::string_view list_of(std::string_view key) { return key.substr(0, key.find('[')); }

/// One `key = value`, or one `key = [value, …]` where the numbers from i on make a list. @return how many numbers it
/// took
std::size_t write_number(std::string& text, const std::vector<FileParameter>& numbers, std::size_t i) {
  const auto& n = numbers[i];
  const auto list = list_of(n.key);
  if (list == n.key) {
    if (is_written(n)) text += fmt::format("{} = {}\n", n.key, text_of(checked(n)));
    return 1;
  }
  const auto in_list = [&](const FileParameter& other) { return other.table == n.table && list_of(other.key) == list; };
  const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(i);
  const auto end = std::find_if_not(begin, numbers.end(), in_list);
  std::vector<std::string> elements;
  std::transform(begin, end, std::back_inserter(elements),
                 [](const FileParameter& e) { return text_of(*e.value / e.si); });
  if (std::any_of(begin, end, is_written)) text += fmt::format("{} = [{}]\n", list, fmt::join(elements, ", "));
  return static_cast<std::size_t>(end - begin);
}

/// Tables in the order in which they first occur.
std::vector<std::string_view> tables_of(const FileKeys& keys) {
  std::vector<std::string_view> tables;
  const auto add = [&](std::string_view table) {
    if (std::ranges::find(tables, table) == tables.end()) tables.push_back(table);
  };
  for (const auto& n : keys.parameters) add(n.table);
  for (const auto& c : keys.choices) add(c.table);
  for (const auto& l : keys.lists) add(l.table);
  return tables;
}

std::string table_text(std::string_view table, const FileKeys& keys) {
  std::string text;
  for (const auto& c : keys.choices)
    if (c.table == table && c.value->index > 0)
      text += fmt::format("{} = {}\n", c.key, in_quotes(c.names[static_cast<std::size_t>(c.value->index)]));
  for (std::size_t i = 0; i < keys.parameters.size();)
    i += keys.parameters[i].table == table ? write_number(text, keys.parameters, i) : 1;
  for (const auto& l : keys.lists) {
    if (l.table != table || l.value->empty()) continue;
    std::vector<std::string> elements;
    std::ranges::transform(*l.value, std::back_inserter(elements),
                           [&](double value) { return text_of(in_unit(value, l.si)); });
    text += fmt::format("{} = [{}]\n", l.key, fmt::join(elements, ", "));
  }
  return text.empty() ? text : fmt::format("\n[{}]\n{}", table, text);
}

std::string confidence_text(const Confidence& confidence) {
  if (confidence.named.empty() && confidence.coefficients == Confidence{}.coefficients) return {};
  auto text = fmt::format("\n[confidence]\ncoefficients = {}\n", text_of(confidence.coefficients));
  for (const auto& [key, deviation] : confidence.named) text += fmt::format("{} = {}\n", key, text_of(deviation));
  return text;
}

std::string effect_text(const FileEffect& effect) {
  auto text = fmt::format("\n[[effect]]\nkind = {}\n", in_quotes(effect.kind));
  if (!effect.channel.empty()) text += fmt::format("channel = {}\n", in_quotes(effect.channel));
  for (const auto& [key, value] : effect.numbers) text += fmt::format("{} = {}\n", key, text_of(value));
  return text;
}

std::string remark_text(std::string_view remark) {
  std::string text;
  while (!remark.empty()) {
    const auto line = remark.substr(0, remark.find('\n'));
    text += line.empty() ? "#\n" : fmt::format("# {}\n", detail::printable(line));
    remark.remove_prefix(std::min(remark.size(), line.size() + 1));
  }
  return text.empty() ? text : text + '\n';
}

}  // namespace

std::string ship_text(std::string_view model, const ShipFileHead& head, const FileKeys& keys,
                      const std::vector<FileEffect>& effects, std::string_view remark) {
  auto text = fmt::format("{}name = {}\nmodel = {}\n", remark_text(remark), in_quotes(head.name), in_quotes(model));
  for (const auto table : tables_of(keys)) text += table_text(table, keys);
  text += confidence_text(head.confidence);
  for (const auto& effect : effects) text += effect_text(effect);
  return text;
}

}  // namespace swayaw::core
