#include "postproc/store/result_store.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "postproc/store/database.h"
#include "postproc/store/job_rows.h"

namespace gouge {
namespace {

std::int64_t number_of(Database& database, std::string_view sql) {
  std::int64_t number = 0;
  database.each(sql, {}, [&](const Row& row) { number = row.integer(0); });
  return number;
}

Diagnostic too_new(const std::string& path) {
  return make_error("store-newer",
                    "was written by another version of gougecheck; expected one of this version: use that program, or "
                    "name another folder",
                    path);
}

Diagnostic foreign(const std::string& path) {
  return make_error("store-foreign", "is a database, but no store of a batch; move it away, or name another folder",
                    path);
}

}  // namespace

Result<ResultStore> ResultStore::open(const std::string& path) {
  Result<Database> database = Database::open(path);
  if (!database) return database.error();
  ResultStore store(std::move(*database));
  if (Outcome prepared = store.prepare(path); !prepared) return prepared.error();
  return store;
}

Outcome ResultStore::prepare(const std::string& path) {
  const std::int64_t application = number_of(database_, "PRAGMA application_id");
  const std::int64_t version = number_of(database_, "PRAGMA user_version");
  const std::int64_t tables = number_of(database_, "SELECT count(*) FROM sqlite_master");
  if (database_.error()) return *database_.error();
  has_tables_ = tables > 0;
  if (!has_tables_) return Done{};
  if (application != kStoreApplication) return foreign(path);
  if (version != kStoreVersion) return too_new(path);
  is_interrupted_ = number_of(database_, "SELECT count(*) FROM runs WHERE is_ended = 0") > 0;
  read_done();
  if (database_.error()) return *database_.error();
  return Done{};
}

void ResultStore::make_tables() {
  database_.run("PRAGMA application_id = " + std::to_string(kStoreApplication));
  database_.run("PRAGMA user_version = " + std::to_string(kStoreVersion));
  for (const std::string_view sql : kCreateTables) database_.run(sql);
  has_tables_ = true;
}

void ResultStore::read_done() {
  done_.clear();
  std::map<std::int64_t, std::size_t> places;
  std::vector<JobResult> jobs;
  database_.each("SELECT job, name FROM jobs ORDER BY job", {}, [&](const Row& row) {
    places[row.integer(0)] = jobs.size();
    jobs.emplace_back();
    jobs.back().name = row.text(1);
  });
  read_jobs(database_, places, jobs);
  for (JobResult& job : jobs)
    done_.push_back({job.name, job.is_altered ? "" : job.key, job.status.value_or(0), std::move(job.outputs),
                     std::move(job.searches)});
}

Outcome ResultStore::begin(const BatchIdentity& batch) {
  database_.begin_writing();
  const Outcome begun = database_.change([&] {
    if (!has_tables_) make_tables();
    renumber(batch);
    database_.run("DELETE FROM runs");
    const SignOff& sign_off = batch.sign_off;
    database_.run("INSERT INTO runs VALUES(1, ?, ?, ?, ?, 0, ?, ?, ?, ?)",
                  {batch.version, batch.build, batch.list, static_cast<std::int64_t>(batch.jobs), sign_off.project,
                   sign_off.reviewer, sign_off.date, sign_off.command});
  });
  return begun ? refresh() : begun;
}

// Renumbers jobs by their names. It uses negative numbers in between, so that two jobs never have the same number.
void ResultStore::renumber(const BatchIdentity& batch) {
  std::map<std::string, std::int64_t> now;
  for (std::size_t k = 0; k < batch.names.size(); ++k)
    now[batch.names[k]] = static_cast<std::int64_t>(batch.numbers[k]);
  std::vector<std::pair<std::int64_t, std::string>> before;
  database_.each("SELECT job, name FROM jobs", {},
                 [&](const Row& row) { before.emplace_back(row.integer(0), row.text(1)); });
  bool is_moved = false;
  const auto move = [&](std::int64_t from, std::int64_t to) {
    database_.run("UPDATE jobs SET job = ? WHERE job = ?", {to, from});
    for (const std::string_view table : kTablesOfJob)
      database_.run("UPDATE " + std::string(table) + " SET job = ? WHERE job = ?", {to, from});
  };
  for (const auto& [job, name] : before) {
    const auto place = now.find(name);
    if (place == now.end()) {
      remove(job);
    } else if (place->second != job) {
      move(job, -1 - place->second);
      is_moved = true;
    }
  }
  if (is_moved) {
    for (const auto& [name, job] : now) move(-1 - job, job);
  }
  database_.run("DELETE FROM names");
  for (const auto& [name, job] : now) database_.run("INSERT INTO names VALUES(?, ?)", {job, name});
}

void ResultStore::remove(std::int64_t job) {
  database_.run("DELETE FROM jobs WHERE job = ?", {job});
  for (const std::string_view table : kTablesOfJob)
    database_.run("DELETE FROM " + std::string(table) + " WHERE job = ?", {job});
}

Outcome ResultStore::put(const std::vector<Numbered>& results) {
  return database_.change([&] {
    for (const auto& [job, result] : results) {
      remove(static_cast<std::int64_t>(job));
      insert_job(database_, static_cast<std::int64_t>(job), result);
    }
  });
}

Outcome ResultStore::refresh() {
  read_done();
  if (database_.error()) return *database_.error();
  return Done{};
}

Result<std::vector<JobResult>> ResultStore::all() {
  std::vector<JobResult> jobs;
  std::map<std::int64_t, std::size_t> places;
  database_.each("SELECT job, name FROM names ORDER BY job", {}, [&](const Row& row) {
    places[row.integer(0)] = jobs.size();
    jobs.emplace_back();
    jobs.back().name = row.text(1);
  });
  read_jobs(database_, places, jobs);
  if (database_.error()) return *database_.error();
  for (JobResult& job : jobs) {
    if (!job.is_altered) continue;
    JobResult unknown;
    unknown.name = job.name;
    unknown.is_altered = true;
    job = unknown;
  }
  return jobs;
}

Result<BatchIdentity> ResultStore::identity() {
  BatchIdentity batch;
  if (!has_tables_) return batch;
  database_.each("SELECT version, build, list, jobs, project, reviewer, date, command FROM runs", {},
                 [&](const Row& row) {
                   batch.version = row.text(0);
                   batch.build = row.text(1);
                   batch.list = row.text(2);
                   batch.jobs = static_cast<std::size_t>(row.integer(3));
                   batch.sign_off.project = row.text(4);
                   batch.sign_off.reviewer = row.text(5);
                   batch.sign_off.date = row.text(6);
                   batch.sign_off.command = row.text(7);
                 });
  database_.each("SELECT job, name FROM names ORDER BY job", {}, [&](const Row& row) {
    batch.numbers.push_back(static_cast<std::size_t>(row.integer(0)));
    batch.names.push_back(row.text(1));
  });
  if (database_.error()) return *database_.error();
  return batch;
}

Outcome ResultStore::end() {
  const Outcome ended = database_.change([&] { database_.run("UPDATE runs SET is_ended = 1"); });
  // The store becomes a single file, which programs without write access to its folder can read.
  if (ended) database_.run("PRAGMA journal_mode=DELETE");
  return ended;
}

}  // namespace gouge
