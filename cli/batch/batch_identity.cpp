#include "cli/batch/batch_identity.h"

#include "cli/batch/batch_sign_off.h"
#include "lib/base/sha256.h"

namespace gouge {

BatchIdentity identify_batch(const BatchArguments& arguments, const std::vector<BatchJob>& jobs, const Shard& shard,
                             std::vector<std::string>& texts) {
  FileHashes hashes;
  const std::string build = hashes.of("/proc/self/exe");
  BatchIdentity identity = {kProgramVersion, build, {}, jobs.size(), {}, {}, batch_sign_off(arguments, jobs)};
  Sha256 list;
  for (std::size_t number = 0; number < jobs.size(); ++number) {
    texts.push_back(job_text(jobs[number], std::string(kProgramVersion) + ' ' + build));
    list.add(texts.back());
    if (!shard.has(number)) continue;
    identity.numbers.push_back(number);
    identity.names.push_back(jobs[number].name);
  }
  identity.list = list.finish();
  return identity;
}

}  // namespace gouge
