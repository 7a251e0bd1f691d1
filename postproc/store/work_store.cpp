#include "postproc/store/work_store.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "lib/base/files.h"
#include "lib/base/sha256.h"
#include "postproc/store/database.h"

namespace gouge {

namespace fs = std::filesystem;

namespace {

// Returns the digest of a checkpoint. A disk may return other bytes than were written, which would become wrong
// verdicts.
std::string digest_of(std::string_view stage, std::size_t stretch, std::string_view bytes) {
  Sha256 digest;
  digest.add(stage);
  digest.add(" " + std::to_string(stretch) + "\n");
  digest.add(bytes);
  return digest.finish();
}

}  // namespace

std::optional<std::string> WorkStore::find(std::string_view stage, std::size_t stretch) {
  open();
  if (!database_) return std::nullopt;
  std::optional<std::string> bytes;
  database_->each("SELECT bytes, digest FROM stretches WHERE stage = ? AND stretch = ?",
                  {stage, static_cast<std::int64_t>(stretch)}, [&](const Row& row) {
                    std::string kept = row.text(0);
                    if (row.text(1) == digest_of(stage, stretch, kept)) bytes = std::move(kept);
                  });
  return database_->error() ? std::nullopt : bytes;
}

void WorkStore::keep(std::string_view stage, std::size_t stretch, std::string_view bytes) {
  open();
  if (!database_) return;
  const Outcome kept = database_->change([&] {
    const std::string digest = digest_of(stage, stretch, bytes);
    database_->run("INSERT OR REPLACE INTO stretches VALUES(?, ?, ?, ?)",
                   {stage, static_cast<std::int64_t>(stretch), bytes, std::string_view(digest)});
  });
  static_cast<void>(kept);  // without it the job still runs
}

void WorkStore::open() {
  if (is_opened_) return;
  is_opened_ = true;
  if (open_once() || !database_) return;
  const bool is_damaged = database_->error() && database_->error()->code == "store-unreadable";
  database_.reset();
  if (!is_damaged) return;
  remove_work_store(path_);
  if (!open_once()) database_.reset();
}

bool WorkStore::open_once() {
  const fs::path folder = fs::path(path_).parent_path();
  if (!folder.empty() && !make_folder(folder.string())) return false;
  Result<Database> opened = Database::open(path_);
  if (!opened) return false;
  database_.emplace(std::move(*opened));
  return prepare();
}

bool WorkStore::prepare() {
  database_->begin_writing();
  const Outcome made = database_->change([&] {
    database_->run("PRAGMA application_id = " + std::to_string(kStoreApplication));
    database_->run("PRAGMA user_version = " + std::to_string(kStoreVersion));
    database_->run(
        "CREATE TABLE IF NOT EXISTS stretches(stage TEXT NOT NULL, stretch INTEGER NOT NULL, bytes BLOB NOT NULL, "
        "digest TEXT NOT NULL, PRIMARY KEY(stage, stretch))");
  });
  return made.has_value();
}

void remove_work_store(const std::string& path) {
  std::error_code ignored;
  for (const char* end : {"", "-wal", "-shm", "-journal"}) fs::remove(path + end, ignored);
}

}  // namespace gouge
