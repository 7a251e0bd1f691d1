#include "postproc/program/path_builder.h"

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr double kShareThatDecides = 0.02;  // share of a file after which its rest is expected to be similar
constexpr double kFirstGrowth = 4, kMinGrowth = 1.125, kMargin = 1.01;

}  // namespace

void PathBuilder::add_statement(const SourceStatement& statement) {
  read_bytes_ = statement.last_byte;
  make_room(path.statements);
  path.statements.push_back(statement);
}

std::size_t PathBuilder::expected_count(std::size_t until_here) const {
  const double share = static_cast<double>(read_bytes_) / static_cast<double>(path.source.size());
  const double growth = share < kShareThatDecides ? kFirstGrowth : std::max(kMargin / share, kMinGrowth);
  return static_cast<std::size_t>(std::ceil(static_cast<double>(until_here) * growth));
}

void PathBuilder::report(Severity severity, const char* code, const Tally& seen, std::string_view noun,
                         std::string_view rest) {
  if (seen.count == 0) return;
  path.notes.push_back({severity, code, path.file, seen.first_line, count_text(seen.count, noun) + std::string(rest)});
}

}  // namespace gouge
