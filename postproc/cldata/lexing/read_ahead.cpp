#include "postproc/cldata/lexing/read_ahead.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "postproc/cldata/language/arguments.h"

namespace gouge {
namespace {

// Few enough that the statements stay in the cache of a core until they are taken.
constexpr std::size_t kBatches = 8;
// A batch ends after a statement that fills it with so much text, and a statement keeps only the memory of a usual one.
// So statements of many lines take little more memory than without reading ahead.
constexpr std::size_t kMaxBytes = 65536, kUsualArguments = 64, kUsualBytes = 1024;

bool keeps_much_memory(const Statement& statement) {
  return std::max({statement.pieces.capacity(), statement.decoded.capacity(), statement.arguments.capacity()}) >
         kUsualArguments;
}

std::size_t bytes_of(const Statement& statement) { return statement.last_byte - statement.first_byte; }

/// Statements that pass to the caller together. Their memory is reused.
struct Batch {
  std::vector<Statement> statements;
  std::size_t count = 0;
};

class StatementsAhead final : public StatementSource {
 public:
  StatementsAhead(std::unique_ptr<StatementSource> source, std::size_t at_once) : source_(std::move(source)) {
    for (Batch& batch : batches_) batch.statements.resize(at_once);
    try {
      reader_ = std::thread([this] { read_all(); });
    } catch (const std::exception&) {
      // Without the thread, next() reads.
    }
  }
  StatementsAhead(const StatementsAhead&) = delete;
  StatementsAhead& operator=(const StatementsAhead&) = delete;
  ~StatementsAhead() override {
    {
      const std::scoped_lock lock(guard_);
      is_closed_ = true;
    }
    news_.notify_all();
    if (reader_.joinable()) reader_.join();
  }

  bool next(Statement& statement) override {
    if (!reader_.joinable()) return source_->next(statement);
    if (at_ == count_ && !take_batch()) return false;
    if (keeps_much_memory(statement)) statement = {};
    std::swap(statement, batch(taken_ - 1).statements[at_++]);
    return true;
  }

 private:
  // The reader uses only batch `read_`, and the caller only the last one that it took.
  Batch& batch(std::size_t number) { return batches_[number % kBatches]; }

  // Gives the last batch back, and waits for the next one. Returns false after the last statement.
  bool take_batch() {
    std::unique_lock lock(guard_);
    is_taking_ = false;
    news_.notify_all();
    news_.wait(lock, [this] { return read_ > taken_ || is_at_end_; });
    if (read_ == taken_) {
      if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
      return false;
    }
    is_taking_ = true;
    count_ = batch(taken_++).count;
    at_ = 0;
    return true;
  }

  void read_all() noexcept {
    try {
      while (wait_for_room() && read_batch()) {
      }
    } catch (...) {
      thrown_ = std::current_exception();
    }
    const std::scoped_lock lock(guard_);
    is_at_end_ = true;
    news_.notify_all();
  }

  // Returns false if the caller needs no more statements.
  bool wait_for_room() {
    std::unique_lock lock(guard_);
    news_.wait(lock, [this] { return is_closed_ || read_ + (is_taking_ ? 1 : 0) < taken_ + kBatches; });
    return !is_closed_;
  }

  // Reads one batch. Returns false if the source has no more.
  bool read_batch() {
    Batch& next = batch(read_);
    bool has_more = true;
    std::size_t bytes = 0;
    for (next.count = 0; next.count < next.statements.size() && bytes < kMaxBytes; ++next.count) {
      Statement& statement = next.statements[next.count];
      has_more = source_->next(statement);
      if (!has_more) break;
      split_ahead(statement);
      bytes += bytes_of(statement);
    }
    const std::scoped_lock lock(guard_);
    if (next.count > 0) ++read_;
    news_.notify_all();
    return has_more;
  }

  // Most statements of a file are positions, and their numbers are most of its text.
  static void split_ahead(Statement& statement) {
    if (statement.word != Word::go_to || statement.is_decoded || bytes_of(statement) > kUsualBytes) return;
    split_arguments(statement, statement.arguments);
    statement.is_split = true;
  }

  std::unique_ptr<StatementSource> source_;
  std::array<Batch, kBatches> batches_;
  std::size_t at_ = 0, count_ = 0;  // the next statement of the batch that the caller took, and their number
  std::mutex guard_;                // protects all members that follow
  std::condition_variable news_;
  std::size_t read_ = 0, taken_ = 0;  // numbers of batches
  bool is_taking_ = false;            // the caller uses the last batch that it took
  bool is_closed_ = false, is_at_end_ = false;
  std::exception_ptr thrown_;
  std::thread reader_;
};

}  // namespace

std::unique_ptr<StatementSource> read_ahead(std::unique_ptr<StatementSource> source, std::size_t at_once) {
  return std::make_unique<StatementsAhead>(std::move(source), at_once);
}

}  // namespace gouge
