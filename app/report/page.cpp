#include "swayaw/app/page.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string_view>

#include "base64.hpp"
#include "swayaw/core/detail/printable.hpp"

namespace swayaw {
namespace {

std::string_view class_of(Tone tone) {
  switch (tone) {
    case Tone::good: return "good";
    case Tone::look: return "look";
    case Tone::bad: return "bad";
    case Tone::neutral: break;
  }
  return "neutral";
}

std::string paragraphs(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& sentence : words) text += fmt::format("<p>{}</p>\n", escaped(sentence));
  return text;
}

std::string html_of(const PageTable& table) {
  std::string text = "<div class=\"scroll\" tabindex=\"0\"><table class=\"facts-table\">";
  if (!table.caption.empty()) text += fmt::format("<caption>{}</caption>", escaped(table.caption));
  text += "<thead><tr>";
  for (const auto& column : table.columns)
    text += column.empty() ? "<td></td>" : fmt::format("<th scope=\"col\">{}</th>", escaped(column));
  text += "</tr></thead>\n<tbody>";
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto mark = row[i].tone == Tone::neutral ? "" : fmt::format(" class=\"{}\"", class_of(row[i].tone));
      text += i == 0 ? fmt::format("<th scope=\"row\"{}>{}</th>", mark, escaped(row[i].text))
                     : fmt::format("<td{}>{}</td>", mark, escaped(row[i].text));
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string html_of(const PagePicture& picture) {
  std::string text = "<figure>\n";
  if (!picture.svg.empty())
    text += fmt::format("<img alt=\"{}\" src=\"data:image/svg+xml;base64,{}\">\n", escaped(picture.words),
                        base64(picture.svg));
  if (!picture.caption.empty()) text += fmt::format("<figcaption>{}</figcaption>\n", escaped(picture.caption));
  if (picture.numbers)
    text +=
        fmt::format("<details><summary>The numbers of this picture</summary>{}</details>\n", html_of(*picture.numbers));
  return text + "</figure>\n";
}

std::string answers_html(const std::vector<PageAnswer>& answers) {
  if (answers.empty()) return {};
  std::string text = "<dl class=\"answers\">\n";
  for (const auto& [question, answer] : answers)
    text += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(question), escaped(answer));
  return text + "</dl>\n";
}

std::string assumed_html(const std::vector<std::string>& assumed) {
  if (assumed.empty()) return {};
  std::string text = "<details class=\"assumed\" open><summary>What was assumed</summary>\n<ul>\n";
  for (const auto& line : assumed) text += fmt::format("<li>{}</li>\n", escaped(line));
  return text + "</ul>\n</details>\n";
}

}  // namespace

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : core::detail::printable(text, core::detail::Lines::many)) {
    switch (c) {
      case '&': safe += "&amp;"; break;
      case '<': safe += "&lt;"; break;
      case '>': safe += "&gt;"; break;
      case '"': safe += "&quot;"; break;
      case '\'': safe += "&#39;"; break;
      default: safe += c;
    }
  }
  return safe;
}

std::string first_screen_html(const Page& page) {
  std::string text = fmt::format(
      "<div class=\"first\">\n<div class=\"said\">\n<p class=\"kicker\">{}</p>\n<h1>{}</h1>\n<p class=\"verdict "
      "{}\">{}</p>\n",
      escaped(page.kicker), escaped(page.title), class_of(page.tone), escaped(page.headline));
  text += answers_html(page.answers) + "</div>\n<div class=\"shown\">\n";
  if (page.picture) text += html_of(*page.picture);
  if (page.table) text += html_of(*page.table);
  return text + "</div>\n</div>\n" + assumed_html(page.assumed);
}

std::string sections_html(const Page& page) {
  std::string text;
  for (const auto& section : page.sections) {
    text += fmt::format("<section class=\"part\">\n<h2>{}</h2>\n{}", escaped(section.title), paragraphs(section.words));
    for (const auto& picture : section.pictures) text += html_of(picture);
    for (const auto& table : section.tables) text += html_of(table);
    text += "</section>\n";
  }
  if (!page.footnotes.empty()) text += "<footer>\n" + paragraphs(page.footnotes) + "</footer>\n";
  return text;
}

}  // namespace swayaw
