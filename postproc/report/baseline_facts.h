#pragma once

#include <cstddef>
#include <string>
#include <vector>

// Effect of accepted findings on a result: plain data, made by postproc/accept.

namespace gouge {

/// An acceptance of the file of --baseline.
struct BaselineEntry {
  enum class Use { applied, unused, voided };

  std::string by, date, reason;  ///< as given when it was accepted
  std::string finding;           ///< the accepted finding, for people
  Use use = Use::unused;         ///< unused: nothing gouges any more where it was accepted
  std::string why;               ///< voided: what changed
};

/// Acceptance of one of CheckResult::events.
struct EventAcceptance {
  std::vector<std::size_t> entries;  ///< of BaselineFacts::entries, that accept its moves
  bool is_accepted = false;          ///< every move of it is accepted
  std::string why_not;               ///< where some entry is of it and it is not accepted; else empty
};

struct BaselineFacts {
  std::string file;  ///< as the user named it; empty: no --baseline
  std::vector<BaselineEntry> entries;
  std::vector<EventAcceptance> events;  ///< one of each of CheckResult::events
  std::size_t accepted_moves = 0;

  [[nodiscard]] bool is_given() const { return !file.empty(); }
  [[nodiscard]] bool is_accepted(std::size_t event) const { return event < events.size() && events[event].is_accepted; }
  [[nodiscard]] std::size_t accepted_findings() const {
    std::size_t count = 0;
    for (const EventAcceptance& event : events) count += event.is_accepted ? 1U : 0U;
    return count;
  }
};

}  // namespace gouge
