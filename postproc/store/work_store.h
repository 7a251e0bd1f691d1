#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lib/base/checkpoints.h"
#include "postproc/store/database.h"

namespace gouge {

/// Checkpoints of one long job, stretch by stretch, in a separate database. Each stretch is committed and synchronised
/// as soon as it is complete. The first query of the job opens or makes the file, so short jobs make none. If that
/// fails, nothing is kept. A damaged file is begun anew.
class WorkStore : public CheckpointStore {
 public:
  /// `path` is a name that identifies the work, including the contents of its inputs. Its folder is made if necessary.
  WorkStore(std::string path, std::size_t items) : path_(std::move(path)), items_(items) {}

  [[nodiscard]] std::size_t items() const override { return items_; }
  [[nodiscard]] std::optional<std::string> find(std::string_view stage, std::size_t stretch) override;
  void keep(std::string_view stage, std::size_t stretch, std::string_view bytes) override;

  /// Returns whether checkpoints were read or kept, so that there may be a file.
  [[nodiscard]] bool is_used() const { return is_opened_; }

 private:
  void open();
  [[nodiscard]] bool open_once();
  [[nodiscard]] bool prepare();

  std::string path_;
  std::size_t items_;
  std::optional<Database> database_;  // none: nothing is kept
  bool is_opened_ = false;
};

/// Removes the file of a closed WorkStore, and the files of SQLite beside it.
void remove_work_store(const std::string& path);

}  // namespace gouge
