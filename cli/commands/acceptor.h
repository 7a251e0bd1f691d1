#pragma once

#include <cstddef>
#include <iosfwd>
#include <vector>

#include "lib/base/result.h"
#include "postproc/accept/accept_findings.h"
#include "postproc/accept/accepted.h"
#include "postproc/result/stored_result.h"

namespace gouge {

/// Adds findings of results to the entries of a file. The results must outlive it.
class Acceptor {
 public:
  /// `existing` are the entries that the file has before.
  Acceptor(AcceptanceNote note, std::vector<Acceptance> existing);

  /// Accepts the findings of a result with these numbers. Errors: those of accept_finding; accept-twice if one is accepted
  /// already.
  [[nodiscard]] Outcome accept_named(const std::vector<std::size_t>& numbers, const StoredResult& result);
  /// Accepts every finding that can be accepted. Those that are accepted already stay as they are.
  void accept_all(const StoredResult& result);
  /// Adds an error to `refused` for each finding that the entries do not accept, as `check --baseline` applies them.
  void test_outcome();

  [[nodiscard]] bool has_new() const { return entries_.size() > existing_.size(); }
  /// The entries of the file and the new ones.
  [[nodiscard]] const std::vector<Acceptance>& entries() const { return entries_; }
  [[nodiscard]] const Diagnostics& refused() const { return refused_; }
  /// Lists the new entries, and counts the findings that need none.
  void tell(std::ostream& out) const;

 private:
  struct Taken {
    const StoredResult* result = nullptr;
    std::vector<std::size_t> kept;  // AcceptedFindings::kept
  };

  void take(const StoredResult& result, AcceptedFindings found);

  AcceptanceNote note_;
  std::vector<Acceptance> existing_, entries_;
  std::size_t known_ = 0, same_ = 0;  // findings that an earlier entry accepts, and those that a new one accepts too
  std::vector<Taken> taken_;
  Diagnostics refused_;
};

}  // namespace gouge
