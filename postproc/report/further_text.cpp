#include "postproc/report/further_text.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "lib/base/number_text.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

/// Returns whether a contact is stated before another one of the same body and obstacle.
bool is_worse(const FurtherContact& a, const FurtherContact& b) {
  return a.depth_mm > b.depth_mm || (!(b.depth_mm > 0) && !(a.depth_mm > 0) && a.depth_upper_mm > b.depth_upper_mm);
}

std::string contact_text(const ReportModel& model, const Event& event, const FurtherContact& contact) {
  const LengthUnit unit = model.toolpath->unit;
  const std::string body = body_name(contact.body);
  const std::string at_most =
      std::isfinite(contact.depth_upper_mm) ? "at most " + depth_text(contact.depth_upper_mm, unit, model.options) : "";
  const std::string move = event.moves == 1 ? "" : ", move " + std::to_string(contact.move);
  if (!contact.witness) {
    const std::string with = contact.against == Against::part ? "the part" : "a fixture";
    return "it is open whether the " + body + " gouges " + with + " too" + (at_most.empty() ? "" : ": " + at_most) +
           move;
  }
  const bool is_wide = contact.depth_upper_mm > contact.depth_mm + model.options.resolution_mm;
  return body + " too: " + depth_text(contact.depth_mm, unit, model.options) +
         (is_wide && !at_most.empty() ? " (" + at_most + ")" : "") + counterpart_text(model, *contact.witness) +
         " at " + point_text(contact.witness->point, unit) + move + " t=" + instant_text(contact.witness->t);
}

}  // namespace

std::vector<FurtherContact> further_of(const CheckResult& result, const Event& event) {
  std::vector<FurtherContact> worst;
  if (event.state != MoveState::gouge) return worst;
  const auto first = std::ranges::lower_bound(result.further, event.first_move, {}, &FurtherContact::move);
  const auto last = std::ranges::upper_bound(result.further, event.last_move, {}, &FurtherContact::move);
  for (const FurtherContact& contact : std::span(first, last)) {
    const auto same =
        std::ranges::find_if(worst, [&](const FurtherContact& one) { return one.is_of_same_pair(contact); });
    if (same == worst.end()) {
      worst.push_back(contact);
    } else if (is_worse(contact, *same)) {
      *same = contact;
    }
  }
  std::ranges::stable_sort(worst, is_worse);
  return worst;
}

std::vector<std::string> further_texts(const ReportModel& model, const Event& event) {
  std::vector<std::string> texts;
  for (const FurtherContact& contact : further_of(*model.result, event))
    texts.push_back(contact_text(model, event, contact));
  return texts;
}

std::string further_text(const ReportModel& model, const Event& event) {
  std::string text;
  for (const std::string& one : further_texts(model, event)) text += "; " + one;
  return text;
}

std::string other_bodies_text(const CheckResult& result, const Event& event) {
  std::set<Body> bodies;
  for (const FurtherContact& contact : further_of(result, event))
    if (contact.witness && contact.body != event.body) bodies.insert(contact.body);
  std::string text;
  for (const Body body : bodies) text += (text.empty() ? " (and " : ", ") + std::string(body_name(body));
  return text.empty() ? text : text + ")";
}

std::string other_obstacle_text(const CheckResult& result, const Event& event) {
  for (const FurtherContact& contact : further_of(result, event))
    if (contact.witness && contact.against != event.against)
      return " (and " + std::string(against_name(contact.against)) + ")";
  return {};
}

std::string stock_too_text(const CheckResult& result, const Event& event) {
  if (event.state != MoveState::gouge) return {};
  const Reason* worst = nullptr;
  std::size_t moves = 0, of = 0;
  for (std::size_t move = event.first_move; move <= event.last_move; ++move) {
    const Reason& reason = result.verdicts[move].reason;
    if (!reason.is_stock_too()) continue;
    ++moves;
    if (worst != nullptr && reason.amount() <= worst->amount()) continue;
    worst = &reason;
    of = move;
  }
  if (worst == nullptr) return {};
  const std::string where =
      event.moves == 1 ? "" : count_text(moves, "move") + ", the worst is move " + std::to_string(of) + ": ";
  return "; " + where + reason_text(*worst);
}

}  // namespace gouge
