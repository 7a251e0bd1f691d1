#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/base/result.h"

struct sqlite3_stmt;

namespace gouge {

/// A value of a row. Text need not be UTF-8.
using Cell = std::variant<std::nullptr_t, std::int64_t, double, std::string_view>;

/// One row of a query. Columns count from 0; NULL is read as 0 or empty.
class Row {
 public:
  explicit Row(sqlite3_stmt* statement) : statement_(statement) {}
  [[nodiscard]] bool is_null(int column) const;
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double number(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::optional<double> optional_number(int column) const;

 private:
  sqlite3_stmt* statement_;
};

/// An SQLite file that only this process uses. A change is on the disk as soon as its transaction is committed. A kill
/// at any instant leaves the last committed state. After the first error all functions do nothing.
class Database {
 public:
  /// Opens the file, or makes it. Errors: store-busy (another process has it open), store-unreadable, store-unwritable.
  [[nodiscard]] static Result<Database> open(const std::string& path);
  Database(Database&&) noexcept;
  Database& operator=(Database&&) = delete;
  ~Database();

  /// Prepares the file for changes. Must be called once, before the first change. A file that is only read stays
  /// unchanged.
  void begin_writing();
  void run(std::string_view sql, const std::vector<Cell>& values = {});
  void each(std::string_view sql, const std::vector<Cell>& values, const std::function<void(const Row&)>& use);
  /// Runs `changes` in one transaction: all of them are made, or none. Errors: those of open.
  [[nodiscard]] Outcome change(const std::function<void()>& changes);
  [[nodiscard]] const std::optional<Diagnostic>& error() const;

 private:
  struct State;
  explicit Database(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// The PRAGMA user_version of a store. Stores with other tables have another number.
inline constexpr int kStoreVersion = 5;
/// The PRAGMA application_id of a store: "goug".
inline constexpr int kStoreApplication = 0x676f7567;

/// The tables other than `jobs` that have rows of a job, each with a column `job`.
inline constexpr std::string_view kTablesOfJob[] = {"counts", "findings", "cases", "warnings",
                                                    "inputs", "searches", "found", "outputs"};

/// The statements that create the tables. docs/formats/batch_store.md states the meaning of each column.
inline constexpr std::string_view kCreateTables[] = {
    "CREATE TABLE runs(run INTEGER PRIMARY KEY, version TEXT NOT NULL, build TEXT NOT NULL, list TEXT NOT NULL, "
    "jobs INTEGER NOT NULL, is_ended INTEGER NOT NULL, project TEXT NOT NULL, reviewer TEXT NOT NULL, date TEXT NOT "
    "NULL, command TEXT NOT NULL)",
    "CREATE TABLE names(job INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE)",
    "CREATE TABLE jobs(job INTEGER PRIMARY KEY, name TEXT NOT NULL, command TEXT NOT NULL, path TEXT NOT NULL, "
    "status INTEGER NOT NULL, verdict TEXT NOT NULL, unit TEXT NOT NULL, moves INTEGER NOT NULL, findings INTEGER NOT "
    "NULL, deepest REAL, deepest_mm REAL NOT NULL, deepest_line INTEGER NOT NULL, report TEXT NOT NULL, key TEXT NOT "
    "NULL, beside TEXT NOT NULL, messages TEXT NOT NULL, seconds REAL NOT NULL, memory_mb REAL NOT NULL, host TEXT NOT "
    "NULL, rank INTEGER NOT NULL, digest TEXT NOT NULL)",
    "CREATE TABLE counts(job INTEGER NOT NULL, state TEXT NOT NULL, moves INTEGER NOT NULL, PRIMARY KEY(job, state)) "
    "WITHOUT ROWID",
    "CREATE TABLE findings(job INTEGER NOT NULL, finding INTEGER NOT NULL, state TEXT NOT NULL, line INTEGER NOT NULL, "
    "move INTEGER NOT NULL, moves INTEGER NOT NULL, tool TEXT NOT NULL, body TEXT NOT NULL, against TEXT NOT NULL, "
    "depth REAL, depth_upper REAL, t REAL, x REAL, y REAL, z REAL, message TEXT NOT NULL, fingerprint TEXT NOT NULL, "
    "baseline_state TEXT NOT NULL, justification TEXT NOT NULL, PRIMARY KEY(job, finding)) WITHOUT ROWID",
    "CREATE TABLE cases(job INTEGER NOT NULL, number INTEGER NOT NULL, name TEXT NOT NULL, moves INTEGER NOT NULL, "
    "failure_type TEXT NOT NULL, failure_message TEXT NOT NULL, failure_text TEXT NOT NULL, skipped_message TEXT NOT "
    "NULL, error_message TEXT NOT NULL, PRIMARY KEY(job, number)) WITHOUT ROWID",
    "CREATE TABLE warnings(job INTEGER NOT NULL, number INTEGER NOT NULL, severity INTEGER NOT NULL, code TEXT NOT "
    "NULL, file TEXT NOT NULL, line INTEGER NOT NULL, message TEXT NOT NULL, PRIMARY KEY(job, number)) WITHOUT ROWID",
    "CREATE TABLE inputs(job INTEGER NOT NULL, number INTEGER NOT NULL, role TEXT NOT NULL, file TEXT NOT NULL, bytes "
    "INTEGER NOT NULL, checksum TEXT NOT NULL, PRIMARY KEY(job, number)) WITHOUT ROWID",
    "CREATE TABLE searches(job INTEGER NOT NULL, number INTEGER NOT NULL, role TEXT NOT NULL, folder TEXT NOT NULL, name "
    "TEXT NOT NULL, PRIMARY KEY(job, number)) WITHOUT ROWID",
    "CREATE TABLE found(job INTEGER NOT NULL, search INTEGER NOT NULL, number INTEGER NOT NULL, file TEXT NOT NULL, "
    "PRIMARY KEY(job, search, number)) WITHOUT ROWID",
    "CREATE TABLE outputs(job INTEGER NOT NULL, number INTEGER NOT NULL, file TEXT NOT NULL, bytes INTEGER NOT NULL, "
    "sha256 TEXT NOT NULL, PRIMARY KEY(job, number)) WITHOUT ROWID"};

}  // namespace gouge
