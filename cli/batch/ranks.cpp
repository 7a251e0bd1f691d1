#include "cli/batch/ranks.h"

#include <array>
#include <cstdlib>
#include <mutex>

#include "cli/batch/job_dealer.h"
#include "lib/base/number_text.h"
#include "lib/base/shared_module.h"

namespace gouge {
namespace {

class OneProcess : public Ranks {
 public:
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int count() const override { return 1; }
  void deal(int list, const std::vector<std::size_t>& group_ends, const std::vector<std::uint64_t>& work) override {
    dealers_.at(static_cast<std::size_t>(list)) = JobDealer(group_ends, work, 1);
  }
  [[nodiscard]] std::optional<std::size_t> take(int list, std::size_t) override {
    const std::scoped_lock lock(guard_);
    const JobDealer::Block block = dealers_.at(static_cast<std::size_t>(list)).take(0, 1);
    if (block.count == 0) return std::nullopt;
    return block.first;
  }
  void share(std::vector<std::size_t>&) override {}
  [[nodiscard]] int largest(int value) override { return value; }

 private:
  std::mutex guard_;
  std::array<JobDealer, 2> dealers_;
};

#ifdef GOUGE_MPI
Result<std::unique_ptr<Ranks>> make_mpi_ranks(long long) {
  const Result<void*> make = find_function("gougecheck_mpi.so", "gougecheck_mpi_ranks");
  if (!make) return make.error();
  return std::unique_ptr<Ranks>(reinterpret_cast<Ranks* (*)()>(*make)());
}
#else
Result<std::unique_ptr<Ranks>> make_mpi_ranks(long long processes) {
  return make_error("usage",
                    "mpirun started " + std::to_string(processes) +
                        " processes of a program that was built without MPI; expected a build with -DGOUGE_MPI=ON, "
                        "or one process: --shard divides the jobs as well");
}
#endif

}  // namespace

// The environment variables are those of Open MPI and MPICH.
long long processes_of_mpirun() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    if (const char* size = std::getenv(name)) return parse_integer(size).value_or(0);
  }
  return 0;
}

Result<std::unique_ptr<Ranks>> make_ranks() {
  const long long processes = processes_of_mpirun();
  if (processes > 1) return make_mpi_ranks(processes);
  return std::unique_ptr<Ranks>(std::make_unique<OneProcess>());
}

}  // namespace gouge
