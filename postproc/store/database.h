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

/// One row of an answer. Columns count from 0; what is NULL is 0 or empty.
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

/// An SQLite file of this process alone, in which a change stands on the disk once its transaction is committed, and
/// of which a kill at any instant leaves the last committed state. The first error sticks: after it nothing is done.
class Database {
 public:
  /// Makes the file where there is none. Errors: store-busy (another process has it), store-unreadable,
  /// store-unwritable.
  [[nodiscard]] static Result<Database> open(const std::string& path);
  Database(Database&&) noexcept;
  Database& operator=(Database&&) = delete;
  ~Database();

  /// To be called once, before the first change: an open file that is only read stays as it is.
  void begin_writing();
  void run(std::string_view sql, const std::vector<Cell>& values = {});
  void each(std::string_view sql, const std::vector<Cell>& values, const std::function<void(const Row&)>& use);
  /// Runs `changes` in one transaction: all of them, or none. Errors: those of open.
  [[nodiscard]] Outcome change(const std::function<void()>& changes);
  [[nodiscard]] const std::optional<Diagnostic>& error() const;

 private:
  struct State;
  explicit Database(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace gouge
