#pragma once

#include <cstddef>
#include <string>
#include <vector>

// Effect of accepted findings on a result, as plain data made by postproc/accept.

namespace gouge {

/// An acceptance in the file of --baseline.
struct BaselineEntry {
  enum class Use {
    applied,
    unused,     ///< the accepted motions no longer gouge
    voided,     ///< `why` states the change
    elsewhere,  ///< made for another program, and no finding of this one has its motions
    partly      ///< made for another program, and accepts only some moves of a finding of this one, as `why` states
  };

  std::string by{}, date{}, reason{};  ///< as given at the acceptance
  std::string finding{};               ///< description of the accepted finding
  std::string toolpath{};              ///< file whose finding was accepted
  std::size_t line = 0;                ///< its line there
  std::string text{};                  ///< the entry with its seal, as JSON
  Use use = Use::unused;
  std::string why{};  ///< if voided: the change that voids it; if partly: the moves that it accepts
};

/// The acceptance of one of CheckResult::events.
struct EventAcceptance {
  std::vector<std::size_t> entries;  ///< indices into BaselineFacts::entries of those that accept its moves
  bool is_accepted = false;          ///< every one of its moves is accepted
  std::string why_not;               ///< reason if an entry concerns it but it is not accepted; else empty
};

struct BaselineFacts {
  std::string file;  ///< as the user named it; empty: no --baseline
  std::vector<BaselineEntry> entries;
  std::vector<EventAcceptance> events;  ///< one for each of CheckResult::events
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
