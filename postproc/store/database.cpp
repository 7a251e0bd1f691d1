#include "postproc/store/database.h"

#include <sqlite3.h>

#include <unordered_map>
#include <utility>

namespace gouge {
namespace {

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

const char* code_of(int result) {
  const int kind = result & 0xff;
  if (kind == SQLITE_BUSY || kind == SQLITE_LOCKED) return "store-busy";
  return kind == SQLITE_NOTADB || kind == SQLITE_CORRUPT ? "store-unreadable" : "store-unwritable";
}

std::string message_of(int result, const std::string& said) {
  const int kind = result & 0xff;
  if (kind == SQLITE_BUSY || kind == SQLITE_LOCKED)
    return "another program has it open: a gougecheck at work in this folder, or a query; expected one at a time";
  if (kind == SQLITE_NOTADB) return "is no store of a batch; move it away, or name another folder";
  if (kind == SQLITE_CORRUPT) return "is damaged (" + said + "); move it away, and the batch begins anew";
  if (kind == SQLITE_FULL) return "the disk is full; what was committed is kept, and --resume goes on from there";
  return "cannot be written: " + said;
}

}  // namespace

struct Database::State {
  std::string path;
  std::unique_ptr<sqlite3, Close> database;
  std::unordered_map<std::string, std::unique_ptr<sqlite3_stmt, Close>> statements;
  std::optional<Diagnostic> error;

  void fail(int result) {
    if (!error) error = make_error(code_of(result), message_of(result, sqlite3_errmsg(database.get())), path);
  }

  sqlite3_stmt* prepared(std::string_view sql) {
    auto& statement = statements[std::string(sql)];
    if (!statement) {
      sqlite3_stmt* made = nullptr;
      const int result = sqlite3_prepare_v2(database.get(), sql.data(), static_cast<int>(sql.size()), &made, nullptr);
      statement.reset(made);
      if (result != SQLITE_OK) fail(result);
    }
    return statement.get();
  }

  static int bind(sqlite3_stmt* statement, int at, const Cell& cell) {
    if (const auto* whole = std::get_if<std::int64_t>(&cell)) return sqlite3_bind_int64(statement, at, *whole);
    if (const auto* number = std::get_if<double>(&cell)) return sqlite3_bind_double(statement, at, *number);
    // SQLITE_STATIC is possible, because bound data outlives the call.
    if (const auto* text = std::get_if<std::string_view>(&cell))
      return sqlite3_bind_text64(statement, at, text->data() == nullptr ? "" : text->data(), text->size(), nullptr,
                                 SQLITE_UTF8);
    return sqlite3_bind_null(statement, at);
  }
};

bool Row::is_null(int column) const { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }
std::int64_t Row::integer(int column) const { return sqlite3_column_int64(statement_, column); }
double Row::number(int column) const { return sqlite3_column_double(statement_, column); }

std::string Row::text(int column) const {
  const void* const bytes = sqlite3_column_blob(statement_, column);
  if (bytes == nullptr) return {};
  return {static_cast<const char*>(bytes), static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

std::optional<double> Row::optional_number(int column) const {
  return is_null(column) ? std::nullopt : std::optional(number(column));
}

Database::Database(std::unique_ptr<State> state) : state_(std::move(state)) {}
Database::Database(Database&&) noexcept = default;
Database::~Database() = default;

Result<Database> Database::open(const std::string& path) {
  auto state = std::make_unique<State>();
  state->path = path;
  sqlite3* opened = nullptr;
  const int result = sqlite3_open_v2(path.c_str(), &opened,
                                     SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOFOLLOW, nullptr);
  state->database.reset(opened);
  Database database(std::move(state));
  if (result != SQLITE_OK) {
    database.state_->fail(result);
    return *database.error();
  }
  constexpr int kPatience_ms = 2000;  // time to wait for another program that reads the store
  sqlite3_busy_timeout(opened, kPatience_ms);
  database.run("PRAGMA locking_mode=EXCLUSIVE");
  if (database.error()) return *database.error();
  return database;
}

void Database::begin_writing() {
  // Only one process uses the file, so a write-ahead log needs no shared memory and works on network drives too. With
  // synchronous=FULL, committed data survives a power failure.
  for (const char* setting : {"PRAGMA journal_mode=WAL", "PRAGMA synchronous=FULL", "BEGIN EXCLUSIVE", "COMMIT"})
    run(setting);
}

void Database::run(std::string_view sql, const std::vector<Cell>& values) {
  each(sql, values, [](const Row&) {});
}

void Database::each(std::string_view sql, const std::vector<Cell>& values, const std::function<void(const Row&)>& use) {
  if (state_->error) return;
  sqlite3_stmt* const statement = state_->prepared(sql);
  if (state_->error) return;
  int result = SQLITE_OK;
  for (std::size_t i = 0; i < values.size() && result == SQLITE_OK; ++i)
    result = State::bind(statement, static_cast<int>(i) + 1, values[i]);
  if (result == SQLITE_OK) {
    while ((result = sqlite3_step(statement)) == SQLITE_ROW) use(Row(statement));
  }
  if (result != SQLITE_DONE) state_->fail(result);
  sqlite3_reset(statement);
  sqlite3_clear_bindings(statement);
}

Outcome Database::change(const std::function<void()>& changes) {
  run("BEGIN IMMEDIATE");
  if (!state_->error) changes();
  run("COMMIT");
  if (!state_->error) return Done{};
  if (sqlite3_get_autocommit(state_->database.get()) == 0)
    sqlite3_exec(state_->database.get(), "ROLLBACK", nullptr, nullptr, nullptr);
  return *state_->error;
}

const std::optional<Diagnostic>& Database::error() const { return state_->error; }

}  // namespace gouge
