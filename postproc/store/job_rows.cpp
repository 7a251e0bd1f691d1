#include "postproc/store/job_rows.h"

#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/base/sha256.h"

namespace gouge {
namespace {

std::int64_t whole(std::size_t number) { return static_cast<std::int64_t>(number); }
std::size_t size(std::int64_t number) { return static_cast<std::size_t>(number); }
Cell cell(const std::optional<double>& number) { return number ? Cell(*number) : Cell(nullptr); }

constexpr std::pair<MoveState, std::size_t StateCounts::*> kCounts[] = {
    {MoveState::clean, &StateCounts::clean},
    {MoveState::near_miss, &StateCounts::near_miss},
    {MoveState::gouge, &StateCounts::gouge},
    {MoveState::buried, &StateCounts::buried},
    {MoveState::not_checked, &StateCounts::not_checked},
    {MoveState::not_certified, &StateCounts::not_certified}};
constexpr std::string_view kSkipped = "skipped";

/// A function that takes a statement and its values, the first of which is the number of the job.
using PutRow = std::function<void(std::string_view sql, const std::vector<Cell>& values)>;

void put_findings(const PutRow& put, std::int64_t job, const std::vector<Finding>& findings) {
  for (std::size_t k = 0; k < findings.size(); ++k) {
    const Finding& f = findings[k];
    const auto at = [&](int axis) { return f.point ? Cell((*f.point)[axis]) : Cell(nullptr); };
    put("INSERT INTO findings VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)",
        {job, whole(k), state_name(f.state), whole(f.line), whole(f.move), whole(f.moves), f.tool, f.body, f.against,
         cell(f.depth), cell(f.depth_upper), cell(f.t), at(0), at(1), at(2), f.message, f.fingerprint, f.baseline_state,
         f.justification});
  }
}

void put_lists(const PutRow& put, std::int64_t job, const JobResult& result) {
  for (std::size_t k = 0; k < result.cases.size(); ++k) {
    const JunitCase& one = result.cases[k];
    put("INSERT INTO cases VALUES(?,?,?,?,?,?,?,?,?)",
        {job, whole(k), one.name, whole(one.moves), one.failure_type, one.failure_message, one.failure_text,
         one.skipped_message, one.error_message});
  }
  for (std::size_t k = 0; k < result.notes.size(); ++k) {
    const Diagnostic& one = result.notes[k];
    put("INSERT INTO warnings VALUES(?,?,?,?,?,?,?)", {job, whole(k), std::int64_t{static_cast<int>(one.severity)},
                                                       one.code, one.file, whole(one.line), one.message});
  }
  for (std::size_t k = 0; k < result.inputs.size(); ++k) {
    const InputFile& one = result.inputs[k];
    put("INSERT INTO inputs VALUES(?,?,?,?,?,?)", {job, whole(k), one.role, one.name, whole(one.bytes), one.checksum});
  }
  for (std::size_t k = 0; k < result.searches.size(); ++k) {
    const auto& [search, found] = result.searches[k];
    put("INSERT INTO searches VALUES(?,?,?,?,?)", {job, whole(k), rule_name(search.rule), search.folder, search.name});
    for (std::size_t n = 0; n < found.size(); ++n)
      put("INSERT INTO found VALUES(?,?,?,?)", {job, whole(k), whole(n), found[n]});
  }
  for (std::size_t k = 0; k < result.outputs.size(); ++k) {
    const JobOutput& one = result.outputs[k];
    put("INSERT INTO outputs VALUES(?,?,?,?,?)", {job, whole(k), one.file, whole(one.bytes), one.sha256});
  }
}

std::optional<MoveState> state_called(const std::string& name) {
  for (const auto& [state, count] : kCounts) {
    if (name == state_name(state)) return state;
  }
  return std::nullopt;
}

Finding finding_of(const Row& row) {
  Finding f;
  f.state = state_called(row.text(2)).value_or(MoveState::not_checked);
  f.line = size(row.integer(3));
  f.move = size(row.integer(4));
  f.moves = size(row.integer(5));
  f.tool = row.text(6);
  f.body = row.text(7);
  f.against = row.text(8);
  f.depth = row.optional_number(9);
  f.depth_upper = row.optional_number(10);
  f.t = row.optional_number(11);
  if (!row.is_null(12)) f.point = Vec3(row.number(12), row.number(13), row.number(14));
  f.message = row.text(15);
  f.fingerprint = row.text(16);
  f.baseline_state = row.text(17);
  f.justification = row.text(18);
  return f;
}

void read_job(const Row& row, JobResult& job) {
  job.command = row.text(2);
  job.toolpath = row.text(3);
  job.status = static_cast<int>(row.integer(4));
  job.unit = row.text(6);
  job.deepest = row.optional_number(9);
  job.deepest_mm = row.number(10);
  job.deepest_line = size(row.integer(11));
  job.report = row.text(12);
  job.key = row.text(13);
  job.beside = row.text(14);
  job.messages = row.text(15);
  job.seconds = row.number(16);
  job.memory_mb = row.number(17);
  job.host = row.text(18);
  job.rank = static_cast<int>(row.integer(19));
}

void read_count(const Row& row, JobResult& job) {
  const std::string state = row.text(1);
  if (state == kSkipped) job.counts.skipped = size(row.integer(2));
  for (const auto& [known, count] : kCounts) {
    if (state == state_name(known)) job.counts.*count = size(row.integer(2));
  }
}

// Returns the cells of a job's row without the columns that may differ between two runs.
std::vector<Cell> job_cells(std::int64_t job, const JobResult& r) {
  return {job,
          r.name,
          r.command,
          r.toolpath,
          std::int64_t{r.status.value_or(0)},
          r.verdict(),
          r.unit,
          whole(r.moves()),
          whole(r.gouge_findings()),
          cell(r.deepest),
          r.deepest_mm,
          whole(r.deepest_line),
          r.report,
          r.key,
          r.beside,
          r.messages};
}

void put_rows_beside(const PutRow& put, std::int64_t job, const JobResult& result) {
  for (const auto& [state, count] : kCounts)
    put("INSERT INTO counts VALUES(?,?,?)", {job, state_name(state), whole(result.counts.*count)});
  put("INSERT INTO counts VALUES(?,?,?)", {job, kSkipped, whole(result.counts.skipped)});
  put_findings(put, job, result.findings);
  put_lists(put, job, result);
}

// Returns a cell as text, as SQLite returns the value: -0 as 0, and a value that is not a number as NULL.
std::string text_of(const Cell& cell) {
  if (const auto* number = std::get_if<std::int64_t>(&cell)) return "i" + std::to_string(*number);
  if (const auto* number = std::get_if<double>(&cell); number != nullptr && !std::isnan(*number))
    return "d" + (std::isfinite(*number) ? exact_text(*number) : std::to_string(*number));
  if (const auto* text = std::get_if<std::string_view>(&cell))
    return "t" + std::to_string(text->size()) + ":" + std::string(*text);
  return "n";
}

// Returns the digest of all rows of a job; the job's number in the list does not enter.
std::string digest_of(const JobResult& result) {
  Sha256 digest;
  const PutRow add = [&](std::string_view sql, const std::vector<Cell>& values) {
    digest.add(sql);
    for (std::size_t k = 1; k < values.size(); ++k) digest.add(text_of(values[k]) + '\n');
  };
  add("jobs", job_cells(0, result));
  put_rows_beside(add, 0, result);
  return digest.finish();
}

/// Columns of a job's row whose data its other rows have too; only queries use them.
struct StatedAgain {
  std::string name, verdict;
  std::int64_t moves = 0, findings = 0;
  std::string digest;
  bool operator==(const StatedAgain&) const = default;
};

StatedAgain stated_again(const JobResult& job) {
  return {job.name, std::string(job.verdict()), whole(job.moves()), whole(job.gouge_findings()), digest_of(job)};
}

}  // namespace

void insert_job(Database& database, std::int64_t job, const JobResult& result) {
  std::vector<Cell> cells = job_cells(job, result);
  const std::string digest = digest_of(result);
  cells.insert(cells.end(),
               {result.seconds, result.memory_mb, result.host, std::int64_t{result.rank}, std::string_view(digest)});
  database.run("INSERT INTO jobs VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)", cells);
  put_rows_beside([&](std::string_view sql, const std::vector<Cell>& values) { database.run(sql, values); }, job,
                  result);
}

void read_jobs(Database& database, const std::map<std::int64_t, std::size_t>& places, std::vector<JobResult>& jobs) {
  const auto each = [&](std::string_view sql, const std::function<void(const Row&, JobResult&)>& use) {
    database.each(sql, {}, [&](const Row& row) {
      if (const auto place = places.find(row.integer(0)); place != places.end()) use(row, jobs[place->second]);
    });
  };
  std::map<const JobResult*, StatedAgain> stated;
  each("SELECT * FROM jobs ORDER BY job", [&](const Row& row, JobResult& job) {
    read_job(row, job);
    stated[&job] = {row.text(1), row.text(5), row.integer(7), row.integer(8), row.text(20)};
  });
  each("SELECT * FROM counts", read_count);
  each("SELECT * FROM findings ORDER BY job, finding",
       [](const Row& row, JobResult& job) { job.findings.push_back(finding_of(row)); });
  each("SELECT * FROM cases ORDER BY job, number", [](const Row& row, JobResult& job) {
    job.cases.push_back(
        {row.text(2), size(row.integer(3)), row.text(4), row.text(5), row.text(6), row.text(7), row.text(8)});
  });
  each("SELECT * FROM warnings ORDER BY job, number", [](const Row& row, JobResult& job) {
    job.notes.push_back(
        {static_cast<Severity>(row.integer(2)), row.text(3), row.text(4), size(row.integer(5)), row.text(6)});
  });
  each("SELECT * FROM inputs ORDER BY job, number", [](const Row& row, JobResult& job) {
    job.inputs.push_back({row.text(2), row.text(3), static_cast<std::uint64_t>(row.integer(4)), row.text(5)});
  });
  each("SELECT * FROM searches ORDER BY job, number", [](const Row& row, JobResult& job) {
    const SearchRule rule = search_rule_called(row.text(2)).value_or(SearchRule::program_beside);
    job.searches.push_back({{rule, row.text(3), row.text(4)}, {}});
  });
  each("SELECT * FROM found ORDER BY job, search, number", [](const Row& row, JobResult& job) {
    const std::size_t search = size(row.integer(1));
    if (search < job.searches.size()) job.searches[search].found.push_back(row.text(3));
  });
  each("SELECT * FROM outputs ORDER BY job, number", [](const Row& row, JobResult& job) {
    job.outputs.push_back({row.text(2), static_cast<std::uint64_t>(row.integer(3)), row.text(4)});
  });
  for (JobResult& job : jobs) {
    const auto known = stated.find(&job);
    job.is_altered = known != stated.end() && !(known->second == stated_again(job));
  }
}

}  // namespace gouge
