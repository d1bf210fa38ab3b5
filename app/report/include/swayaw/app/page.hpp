#pragma once

#include <optional>
#include <string>
#include <vector>

/// What a page says before anything else, as values: a sentence that a person can decide from, answers to what users
/// ask, a table, the picture that carries the proof, what was assumed. It becomes static HTML, which is read without
/// scripts, in the preview of a mail and in print. Texts may hold anything; they are escaped.
namespace swayaw {

/// What a statement means to the reader: well, worth a look, wrong; or just a number.
enum class Tone { neutral, good, look, bad };

struct PageCell {
  std::string text;
  Tone tone = Tone::neutral;

  PageCell(std::string words, Tone meaning = Tone::neutral) : text(std::move(words)), tone(meaning) {}  // NOLINT
  PageCell(const char* words) : text(words) {}                                                          // NOLINT
};

/// The first cell of a row is its heading.
struct PageTable {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::vector<PageCell>> rows;
};

struct PagePicture {
  std::string words;                   ///< what is to be seen, for who cannot see it
  std::string svg;                     ///< empty: no picture, its table only
  std::string caption;                 ///< below
  std::optional<PageTable> numbers{};  ///< what is drawn, opened on demand
};

/// A question that users ask, and its answer.
struct PageAnswer {
  std::string question, answer;
};

/// Further down.
struct PageSection {
  std::string title;
  std::vector<std::string> words{};
  std::vector<PageTable> tables{};
  std::vector<PagePicture> pictures{};
};

struct Page {
  std::string kicker;    ///< what was done: "Diagnosis"
  std::string title;     ///< the ship, or the file
  std::string headline;  ///< one or two sentences
  Tone tone = Tone::neutral;
  std::vector<PageAnswer> answers{};
  std::optional<PagePicture> picture{};
  std::optional<PageTable> table{};
  std::vector<std::string> assumed{};
  std::vector<PageSection> sections{};
  std::vector<std::string> footnotes{};
};

/// The page by itself, without scripts.
std::string html(const Page& page);

/// The first screen and the static sections as HTML, to be put into a page.
std::string first_screen_html(const Page& page);
std::string sections_html(const Page& page);

/// A text in which nothing is markup, within quotes or without, and nothing moves what stands beside it.
std::string escaped(const std::string& text);

}  // namespace swayaw
