#include <mpi.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <thread>

#include "cli/batch/job_dealer.h"
#include "cli/batch/ranks.h"

// The only file that uses MPI; it is built as a shared module.

namespace gouge {
namespace {

constexpr int kAsk = 1, kAnswer = 2;  // tags of messages
constexpr std::int64_t kNoMore = -1;  // in place of a list number: this process requests no more jobs
// A process that requests again within this time has short jobs, and receives more at once. One process serves many
// (docs/method/scaling.md).
constexpr std::chrono::milliseconds kSoon{4};
constexpr std::chrono::microseconds kPause{200}, kLongestPause{1000};
// approximate number of pauses between two requests; each costs some 10 us of processor time
constexpr int kPausesBetween = 16;

/// A thread of rank 0 distributes the positions. It serves requests while the other threads of that process work. A
/// process that waits sleeps in between, because MPI itself would keep a core busy.
class MpiRanks : public Ranks {
 public:
  MpiRanks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_MULTIPLE, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    is_dealt_ = largest(provided < MPI_THREAD_MULTIPLE ? 1 : 0) != 0;
    if (!is_dealt_ && rank_ == 0) server_ = std::thread([this] { answer(); });
  }
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;
  ~MpiRanks() override {
    const Question no_more{kNoMore, 0};
    if (!is_dealt_ && rank_ != 0) MPI_Send(no_more.data(), 2, MPI_INT64_T, 0, kAsk, MPI_COMM_WORLD);
    if (server_.joinable()) server_.join();
    MPI_Finalize();
  }

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int count() const override { return count_; }

  void deal(int list, const std::vector<std::size_t>& group_ends, const std::vector<std::uint64_t>& work) override {
    Given& given = given_.at(static_cast<std::size_t>(list));
    if (is_dealt_) {
      given.next = rank_;
      given.end = group_ends.empty() ? 0 : static_cast<std::int64_t>(group_ends.back());
      return;
    }
    if (rank_ == 0) {
      const std::scoped_lock lock(dealing_);
      dealers_.at(static_cast<std::size_t>(list)) = JobDealer(group_ends, work, static_cast<std::size_t>(count_));
    }
    static_cast<void>(largest(0));  // no rank sends a request before rank 0 is ready
  }

  [[nodiscard]] std::optional<std::size_t> take(int list, std::size_t most) override {
    const std::scoped_lock lock(guard_);
    Given& given = given_.at(static_cast<std::size_t>(list));
    if (!is_dealt_ && given.next == given.end) ask(list, given, static_cast<std::int64_t>(most));
    if (given.next >= given.end) return std::nullopt;
    const std::int64_t taken = given.next;
    given.next += is_dealt_ ? count_ : 1;
    return static_cast<std::size_t>(taken);
  }

  void share(std::vector<std::size_t>& numbers) override {
    std::uint64_t count = numbers.size();
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibcast(&count, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD, &request);
    wait(request);
    std::vector<std::uint64_t> sent(numbers.begin(), numbers.end());
    sent.resize(count);
    MPI_Ibcast(sent.data(), static_cast<int>(count), MPI_UINT64_T, 0, MPI_COMM_WORLD, &request);
    wait(request);
    numbers.assign(sent.begin(), sent.end());
  }

  [[nodiscard]] int largest(int value) override {
    int most = value;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallreduce(&value, &most, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD, &request);
    wait(request);
    return most;
  }

 private:
  /// Positions of a list that this process has received but not yet taken.
  struct Given {
    std::int64_t next = 0, end = 0, at_once = 1;
    std::chrono::steady_clock::time_point asked;
  };
  using Question = std::array<std::int64_t, 2>;  // a list, and the number of positions requested
  using Answer = std::array<std::int64_t, 2>;    // the first position, and the number of positions

  void ask(int list, Given& given, std::int64_t most) {
    if (rank_ == 0) {
      const Answer answer = next(0, {list, 1});
      given.next = answer[0];
      given.end = answer[0] + answer[1];
      return;
    }
    const auto now = std::chrono::steady_clock::now();
    given.at_once =
        now - given.asked < kSoon ? std::min(2 * given.at_once, most) : std::max<std::int64_t>(given.at_once / 2, 1);
    given.asked = now;
    const Question question{list, given.at_once};
    MPI_Send(question.data(), 2, MPI_INT64_T, 0, kAsk, MPI_COMM_WORLD);
    MPI_Request request = MPI_REQUEST_NULL;
    Answer answer{};
    MPI_Irecv(answer.data(), 2, MPI_INT64_T, 0, kAnswer, MPI_COMM_WORLD, &request);
    wait(request);
    given.next = answer[0];
    given.end = answer[0] + answer[1];
  }

  static void wait(MPI_Request& request) {
    for (int is_done = 0;;) {
      MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
      if (is_done != 0) return;
      std::this_thread::sleep_for(kPause);
    }
  }

  Answer next(int rank, const Question& question) {
    const std::scoped_lock lock(dealing_);
    const JobDealer::Block block = dealers_.at(static_cast<std::size_t>(question[0]))
                                       .take(static_cast<std::size_t>(rank), static_cast<std::size_t>(question[1]));
    return {static_cast<std::int64_t>(block.first), static_cast<std::int64_t>(block.count)};
  }

  void answer() {
    auto asked = std::chrono::steady_clock::now();
    for (int asking = count_ - 1; asking > 0;) {
      int is_there = 0;
      MPI_Status status;
      MPI_Iprobe(MPI_ANY_SOURCE, kAsk, MPI_COMM_WORLD, &is_there, &status);
      const auto now = std::chrono::steady_clock::now();
      if (is_there == 0) {
        std::this_thread::sleep_for(
            std::clamp<std::chrono::nanoseconds>((now - asked) / kPausesBetween, kPause, kLongestPause));
        continue;
      }
      asked = now;
      Question question{kNoMore, 0};
      MPI_Recv(question.data(), 2, MPI_INT64_T, status.MPI_SOURCE, kAsk, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      if (question[0] == kNoMore) {
        --asking;
        continue;
      }
      const Answer answer = next(status.MPI_SOURCE, question);
      MPI_Send(answer.data(), 2, MPI_INT64_T, status.MPI_SOURCE, kAnswer, MPI_COMM_WORLD);
    }
  }

  int rank_ = 0, count_ = 1;
  bool is_dealt_ = false;  // positions are fixed because this MPI allows no threads: rank 0 has 0, n, 2n, ...
  std::array<Given, 2> given_;
  std::mutex guard_;    // guards given_
  std::mutex dealing_;  // guards dealers_
  std::array<JobDealer, 2> dealers_;
  std::thread server_;
};

}  // namespace
}  // namespace gouge

/// Returns the processes of MPI_COMM_WORLD; the caller deletes them. Must be called only once in a process.
extern "C" __attribute__((visibility("default"))) gouge::Ranks* gougecheck_mpi_ranks() { return new gouge::MpiRanks; }
