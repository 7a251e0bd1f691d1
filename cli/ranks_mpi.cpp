#include "cli/ranks_mpi.h"

#ifdef GOUGE_MPI
#include <mpi.h>

#include <array>
#include <cstdint>
#include <mutex>
#endif

// The only file that knows MPI.

namespace gouge {

#ifdef GOUGE_MPI
namespace {

// Numbers are handed out by a counter at rank 0 that every process adds to by itself: no process has to answer.
class MpiRanks : public Ranks {
 public:
  MpiRanks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    MPI_Win_create(counters_.data(), static_cast<MPI_Aint>(sizeof counters_), sizeof(std::int64_t), MPI_INFO_NULL,
                   MPI_COMM_WORLD, &window_);
    MPI_Win_lock_all(0, window_);
  }
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;
  ~MpiRanks() override {
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
    MPI_Finalize();
  }

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int count() const override { return count_; }

  [[nodiscard]] std::size_t take(int list) override {
    const std::scoped_lock lock(guard_);
    const std::int64_t one = 1;
    std::int64_t taken = 0;
    MPI_Fetch_and_op(&one, &taken, MPI_INT64_T, 0, list, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
    return static_cast<std::size_t>(taken);
  }

  void share(std::vector<std::size_t>& numbers) override {
    std::uint64_t count = numbers.size();
    MPI_Bcast(&count, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    std::vector<std::uint64_t> sent(numbers.begin(), numbers.end());
    sent.resize(count);
    MPI_Bcast(sent.data(), static_cast<int>(count), MPI_UINT64_T, 0, MPI_COMM_WORLD);
    numbers.assign(sent.begin(), sent.end());
  }

  [[nodiscard]] int largest(int value) override {
    int most = value;
    MPI_Allreduce(&value, &most, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return most;
  }

 private:
  int rank_ = 0, count_ = 1;
  std::array<std::int64_t, 2> counters_{};
  MPI_Win window_ = MPI_WIN_NULL;
  std::mutex guard_;
};

}  // namespace

std::unique_ptr<Ranks> make_mpi_ranks() { return std::make_unique<MpiRanks>(); }
#else
std::unique_ptr<Ranks> make_mpi_ranks() { return nullptr; }
#endif

}  // namespace gouge
