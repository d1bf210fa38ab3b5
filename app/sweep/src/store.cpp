#include "swayaw/app/sweep/store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <limits>

#include "swayaw/core/refusal.hpp"

namespace swayaw::app {

static_assert(sizeof(double) == 8, "a number of a block is 8 bytes, least first");

// ---------------------------------------------------------------- SQLite

struct SweepStore::Database {
  sqlite3* handle = nullptr;
  std::filesystem::path file;

  ~Database() { sqlite3_close(handle); }

  [[noreturn]] void fail() const {
    throw Refusal(fmt::format("{}: {}; what was written before is kept, and the same command goes on from there",
                              file.string(), sqlite3_errmsg(handle)));
  }
  void check(int code) const {
    if (code != SQLITE_OK && code != SQLITE_DONE && code != SQLITE_ROW) fail();
  }
  void run(const char* text) const { check(sqlite3_exec(handle, text, nullptr, nullptr, nullptr)); }
};

namespace {

class Statement {
 public:
  template <class Database>
  Statement(const Database& database, const char* text) {
    database.check(sqlite3_prepare_v2(database.handle, text, -1, &handle_, nullptr));
  }
  ~Statement() { sqlite3_finalize(handle_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(int place, std::int64_t value) { return sqlite3_bind_int64(handle_, place, value), *this; }
  Statement& bind(int place, const std::string& text) {
    return sqlite3_bind_text(handle_, place, text.data(), static_cast<int>(text.size()), SQLITE_STATIC), *this;
  }
  Statement& bind(int place, std::span<const double> values) {
    return sqlite3_bind_blob64(handle_, place, values.data(), values.size_bytes(), SQLITE_STATIC), *this;
  }

  /// @return whether there is a row
  template <class Database>
  bool step(const Database& database) {
    const int code = sqlite3_step(handle_);
    database.check(code);
    return code == SQLITE_ROW;
  }
  template <class Database>
  void insert(const Database& database) {
    step(database);
    sqlite3_reset(handle_);
  }

  std::int64_t number(int column) const { return sqlite3_column_int64(handle_, column); }
  std::string text(int column) const {
    const auto* words = sqlite3_column_text(handle_, column);
    return words ? std::string(reinterpret_cast<const char*>(words)) : std::string();
  }
  std::span<const double> numbers(int column) const {
    return {static_cast<const double*>(sqlite3_column_blob(handle_, column)),
            static_cast<std::size_t>(sqlite3_column_bytes(handle_, column)) / sizeof(double)};
  }

 private:
  sqlite3_stmt* handle_ = nullptr;
};

constexpr const char* tables =
    "CREATE TABLE about (key TEXT PRIMARY KEY, value TEXT);"
    "CREATE TABLE column_ (place INTEGER PRIMARY KEY, name TEXT, unit TEXT, varied INTEGER);"
    "CREATE TABLE ship (place INTEGER PRIMARY KEY, name TEXT, file TEXT);"
    "CREATE TABLE block (place INTEGER PRIMARY KEY, first INTEGER, count INTEGER, numbers BLOB);"
    "CREATE TABLE note (item INTEGER, text TEXT);"
    "CREATE TABLE case_ (item INTEGER PRIMARY KEY, name TEXT);"
    "CREATE TABLE document (item INTEGER PRIMARY KEY, json TEXT);";

/// What the file says of a block need not be so: it may come from others.
[[noreturn]] void refuse_block(const std::filesystem::path& file) {
  throw Refusal(fmt::format("{}: holds a block that is none of this plan; give another --out", file.string()));
}

/// A folder in which no other sweep works as long as this program lives. @return its lock
int locked(const std::filesystem::path& folder) {
  std::error_code trouble;
  std::filesystem::create_directories(folder, trouble);
  const auto file = folder / "lock";
  const int lock = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock < 0) {
    const auto why = trouble ? trouble.message() : std::string(std::strerror(errno));
    throw Refusal(fmt::format("{}: cannot be written: {}; give another --out", folder.string(), why));
  }
  if (::flock(lock, LOCK_EX | LOCK_NB) == 0) return lock;
  ::close(lock);
  throw Refusal(fmt::format("{}: another sweep works in this folder; give another --out", folder.string()));
}

}  // namespace

// ---------------------------------------------------------------- store

SweepStore::SweepStore(const std::filesystem::path& folder, const SweepWork& work)
    : file_(folder / "sweep.sqlite"), work_(work), database_(std::make_unique<Database>()) {
  lock_ = locked(folder);
  auto& database = *database_;
  database.file = file_;
  if (sqlite3_open_v2(file_.c_str(), &database.handle, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr) !=
      SQLITE_OK)
    throw Refusal(fmt::format("{}: {}", file_.string(), sqlite3_errmsg(database.handle)));
  // results are appended: the journal of a commit holds a page or two of before, and is not removed each time
  database.run("PRAGMA journal_mode=TRUNCATE; PRAGMA synchronous=NORMAL; PRAGMA page_size=65536;");
  done_.assign(work.blocks(), false);
  Statement there(database, "SELECT count(*) FROM sqlite_master WHERE name = 'about'");
  if (there.step(database) && there.number(0) > 0) {
    Statement of(database, "SELECT value FROM about WHERE key = 'fingerprint'");
    if (!of.step(database) || of.text(0) != work.fingerprint())
      throw Refusal(fmt::format(
          "{}: holds the results of another plan, other ships or another version of swayaw; give another --out",
          file_.string()));
    Statement blocks(database, "SELECT place FROM block");
    while (blocks.step(database)) {
      const auto place = static_cast<std::size_t>(blocks.number(0));
      if (place >= done_.size()) refuse_block(file_);
      done_[place] = true;
    }
    return;
  }
  database.run("BEGIN IMMEDIATE");
  database.run(tables);
  Statement about(database, "INSERT INTO about VALUES (?, ?)");
  const std::pair<const char*, std::string> facts[]{{"schema", "swayaw.sweep/1"},
                                                    {"fingerprint", work.fingerprint()},
                                                    {"plan", work.plan().text},
                                                    {"items", std::to_string(work.items())},
                                                    {"points_of_a_ship", std::to_string(work.points())}};
  for (const auto& [key, value] : facts) about.bind(1, std::string(key)).bind(2, value).insert(database);
  Statement column(database, "INSERT INTO column_ VALUES (?, ?, ?, ?)");
  for (std::size_t i = 0; i < work.columns().size(); ++i) {
    const auto& c = work.columns()[i];
    column.bind(1, static_cast<std::int64_t>(i)).bind(2, c.name).bind(3, c.unit).bind(4, std::int64_t{c.varied});
    column.insert(database);
  }
  Statement named(database, "INSERT INTO case_ VALUES (?, ?)");
  for (std::size_t i = 0; i < work.plan().cases.size(); ++i)
    named.bind(1, static_cast<std::int64_t>(i)).bind(2, work.plan().cases[i].name).insert(database);
  Statement ship(database, "INSERT INTO ship VALUES (?, ?, ?)");
  for (std::size_t i = 0; i < work.plan().ships.size(); ++i) {
    ship.bind(1, static_cast<std::int64_t>(i)).bind(2, work.subjects()[i]).bind(3, work.plan().ships[i]);
    ship.insert(database);
  }
  database.run("COMMIT");
}

SweepStore::~SweepStore() {
  database_.reset();
  if (lock_ >= 0) ::close(lock_);
}

void SweepStore::write(std::span<const SweepBlock> blocks) {
  auto& database = *database_;
  database.run("BEGIN IMMEDIATE");
  try {
    Statement block(database, "INSERT INTO block VALUES (?, ?, ?, ?)");
    Statement note(database, "INSERT INTO note VALUES (?, ?)");
    Statement document(database, "INSERT INTO document VALUES (?, ?)");
    for (const auto& b : blocks) {
      block.bind(1, static_cast<std::int64_t>(b.place)).bind(2, static_cast<std::int64_t>(b.first));
      block.bind(3, static_cast<std::int64_t>(b.count)).bind(4, std::span<const double>(b.values)).insert(database);
      for (const auto& [item, text] : b.notes)
        note.bind(1, static_cast<std::int64_t>(item)).bind(2, text).insert(database);
      for (const auto& [item, json] : b.documents)
        document.bind(1, static_cast<std::int64_t>(item)).bind(2, json).insert(database);
    }
    database.run("COMMIT");
  } catch (...) {
    sqlite3_exec(database.handle, "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
  }
  for (const auto& b : blocks) done_[b.place] = true;
}

std::vector<double> SweepStore::column(std::size_t subject, std::size_t column) const {
  const auto& database = *database_;
  const auto begin = subject * work_.points();
  std::vector<double> values(work_.points(), std::numeric_limits<double>::quiet_NaN());
  Statement blocks(database, "SELECT first, count, numbers FROM block WHERE first >= ? AND first < ?");
  blocks.bind(1, static_cast<std::int64_t>(begin)).bind(2, static_cast<std::int64_t>(begin + work_.points()));
  while (blocks.step(database)) {
    const auto first = static_cast<std::size_t>(blocks.number(0)) - begin,
               count = static_cast<std::size_t>(blocks.number(1));
    const auto all = blocks.numbers(2);
    const bool fits = count <= values.size() - first && all.size() == work_.columns().size() * count;
    if (!fits) refuse_block(file_);
    const auto numbers = all.subspan(column * count, count);
    std::ranges::copy(numbers, values.begin() + static_cast<std::ptrdiff_t>(first));
  }
  return values;
}

std::vector<std::pair<std::size_t, std::string>> SweepStore::notes(std::size_t most) const {
  const auto& database = *database_;
  std::vector<std::pair<std::size_t, std::string>> notes;
  Statement all(database, "SELECT item, text FROM note ORDER BY item LIMIT ?");
  all.bind(1, static_cast<std::int64_t>(most));
  while (all.step(database)) {
    const auto item = static_cast<std::size_t>(all.number(0));
    if (item >= work_.items()) refuse_block(file_);
    notes.emplace_back(item, all.text(1));
  }
  return notes;
}

std::vector<std::pair<std::string, std::size_t>> SweepStore::counts(const std::string& path) const {
  const auto& database = *database_;
  std::vector<std::pair<std::string, std::size_t>> counts;
  Statement all(database,
                "SELECT coalesce(json_extract(json, ?), '-') AS word, count(*) FROM document GROUP BY word ORDER BY 2 "
                "DESC, 1");
  all.bind(1, path);
  while (all.step(database)) counts.emplace_back(all.text(0), static_cast<std::size_t>(all.number(1)));
  return counts;
}

std::size_t SweepStore::note_count() const {
  Statement all(*database_, "SELECT count(*) FROM note");
  return all.step(*database_) ? static_cast<std::size_t>(all.number(0)) : 0;
}

}  // namespace swayaw::app
