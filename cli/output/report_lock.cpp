#include "cli/output/report_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace gouge {

Result<ReportLock> ReportLock::take(const std::string& folder, bool is_for_batch) {
  ReportLock lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (lock.handle_ < 0)
    return make_error("folder-unwritable", "cannot read the folder: " + std::string(std::strerror(errno)), folder);
  // On a file system without locks, the user must avoid two reports at once.
  if (::flock(lock.handle_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return lock;
  if (is_for_batch)
    return make_error("store-busy",
                      "another gougecheck works in this folder of a batch, or watches a hot folder for it; run this "
                      "one when it has ended, or name another folder",
                      folder);
  return make_error(
      "report-busy",
      "another gougecheck is about to write its report here; expected a folder for each, or one after the other",
      folder);
}

ReportLock::~ReportLock() {
  if (handle_ >= 0) ::close(handle_);
}

}  // namespace gouge
