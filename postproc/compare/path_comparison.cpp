#include "postproc/compare/path_comparison.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "lib/base/units.h"
#include "postproc/report/report_model.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDecimals = 6;

std::size_t line_of(const Toolpath& path, std::size_t move) { return path.moves[move].line; }

std::string row(const std::string& name, const std::string& value) {
  constexpr std::size_t kValueAt = 34;
  return padded(name, kValueAt) + printable(value) + "\n";
}

std::string places_text(const Toolpath& path, std::size_t move, const Toolpath& other, std::size_t other_move) {
  const auto place = [](const Toolpath& of, std::size_t at) { return of.file + ":" + std::to_string(line_of(of, at)); };
  return " at " + place(path, move) + ", nearest " + place(other, other_move);
}

std::string feed_row(const PathDifference& of, const Toolpath& path, const Toolpath& other) {
  if (of.other_feeds == 0) return {};
  const auto rate = [](const Toolpath& in, std::size_t move) { return feed_text(in.moves[move].feed(), in.unit); };
  return row("  other feed rates", std::to_string(of.other_feeds) + ", first " + rate(path, of.feed_move) +
                                       places_text(path, of.feed_move, other, of.feed_other) + ": " +
                                       rate(other, of.feed_other));
}

/// Names the feed rates that were not compared, and how the user states that of a program.
std::string unknown_feed_row(const PathDifference& of, const Toolpath& path, const Toolpath& other) {
  if (of.unknown_feeds == 0) return {};
  const auto rate = [](const Toolpath& in, std::size_t move) {
    const Feed feed = in.moves[move].feed();
    return feed.is_number() && feed.mm > 0 ? feed_text(feed, in.unit) : std::string("not known");
  };
  return row("  feed rates not compared", std::to_string(of.unknown_feeds) + ", first " + rate(path, of.unknown_move) +
                                              places_text(path, of.unknown_move, other, of.unknown_other) + ": " +
                                              rate(other, of.unknown_other));
}

/// The two paths in the text, the one that is measured first.
struct Names {
  const char *path, *other;
};
constexpr Names kForward{"OLD", "NEW"}, kBackward{"NEW", "OLD"};

/// Names the feeds that are rapids in the other path, by the first of them.
std::string rapid_row(const PathDifference& of, const Names& names, const Toolpath& path, const Toolpath& other) {
  if (of.rapids == 0) return {};
  const auto at_line = [](const Toolpath& in, std::size_t move) {
    return " at line " + std::to_string(line_of(in, move));
  };
  std::string text = std::to_string(of.rapids) + ", first: a feed in " + names.path + at_line(path, of.rapid_move) +
                     " is a rapid in " + names.other + at_line(other, of.rapid_other);
  if (of.retracts > 0)
    text += "; " +
            (of.retracts == of.rapids ? std::string(of.rapids == 1 ? "it is a retract" : "all are retracts")
                                      : count_text(of.retracts, "retract")) +
            " along the tool axis";
  return row(std::string("  feeds that are rapids in ") + names.other, text);
}

/// Names the moves of a path that are not compared, with the first of each kind.
std::string left_out_rows(const MovesLeftOut& out, const Names& names, const Toolpath& path) {
  const auto first = [&](std::size_t count, std::size_t move) {
    return std::to_string(count) + ", first " + path.file + ":" + std::to_string(line_of(path, move));
  };
  std::string text;
  if (out.unchecked > 0)
    text += row(std::string("moves not checked in ") + names.path,
                first(out.unchecked, out.first_unchecked) + ": " +
                    std::string(path.moves[out.first_unchecked].not_checked_reason));
  if (out.rapids > 0)
    text +=
        row(std::string("rapids in ") + names.path, first(out.rapids, out.first_rapid) + ": only feeds are compared");
  return text;
}

std::string difference_text(const PathDifference& of, const Names& names, const Toolpath& path, const Toolpath& other) {
  return row(std::string(names.path) + " against " + names.other, count_text(of.positions, "feed")) +
         row("  largest distance of a tip", display_text(of.tip_mm, kDecimals) +
                                                (of.is_tip_inside ? " mm on the way to the position" : " mm") +
                                                places_text(path, of.tip_move, other, of.tip_other)) +
         row("  largest angle of an axis", display_text(of.axis_rad / kDegree_rad, kDecimals) + " deg" +
                                               places_text(path, of.axis_move, other, of.axis_other)) +
         rapid_row(of, names, path, other) + feed_row(of, path, other) + unknown_feed_row(of, path, other);
}

Json difference_json(const PathDifference& of, const Toolpath& path, const Toolpath& other) {
  const auto lines = [&](Json value, std::size_t move, std::size_t other_move) {
    value["line"] = line_of(path, move);
    value["nearest_line"] = line_of(other, other_move);
    return value;
  };
  Json feeds = {{"count", of.other_feeds}};
  if (of.other_feeds > 0) feeds = lines(std::move(feeds), of.feed_move, of.feed_other);
  Json unknown = {{"count", of.unknown_feeds}};
  if (of.unknown_feeds > 0) unknown = lines(std::move(unknown), of.unknown_move, of.unknown_other);
  Json rapids = {{"count", of.rapids}, {"retracts", of.retracts}};
  if (of.rapids > 0) rapids = lines(std::move(rapids), of.rapid_move, of.rapid_other);
  return {{"positions", of.positions},
          {"tip", lines({{"mm", of.tip_mm}, {"is_inside", of.is_tip_inside}}, of.tip_move, of.tip_other)},
          {"axis", lines({{"degrees", of.axis_rad / kDegree_rad}}, of.axis_move, of.axis_other)},
          {"rapids_in_other", std::move(rapids)},
          {"other_feed_rates", std::move(feeds)},
          {"feed_rates_not_compared", std::move(unknown)}};
}

Json left_out_json(const MovesLeftOut& out, const Toolpath& path) {
  Json unchecked = {{"count", out.unchecked}}, rapids = {{"count", out.rapids}};
  if (out.unchecked > 0) {
    unchecked["line"] = line_of(path, out.first_unchecked);
    unchecked["reason"] = valid_utf8(std::string(path.moves[out.first_unchecked].not_checked_reason));
  }
  if (out.rapids > 0) rapids["line"] = line_of(path, out.first_rapid);
  return {{"not_checked", std::move(unchecked)}, {"rapids", std::move(rapids)}};
}

constexpr std::size_t kMinOrdered = 2;  // positions that can have an order

std::string order_row(const PathComparison& c) {
  if (!c.order.is_same())
    return row("order", "differs from line " + std::to_string(line_of(*c.before, c.order.move)) + " of OLD and line " +
                            std::to_string(line_of(*c.after, c.order.other)) + " of NEW on");
  const std::string where = count_text(c.order.positions, "position") + " that each file reaches once";
  return row("order", (c.order.positions < kMinOrdered ? "not known: " : "the same at ") + where);
}

Json order_json(const PathComparison& c) {
  Json order = {{"positions", c.order.positions}, {"is_same", nullptr}};
  if (!c.order.is_same() || c.order.positions >= kMinOrdered) order["is_same"] = c.order.is_same();
  if (c.order.is_same()) return order;
  order["line"] = line_of(*c.before, c.order.move);
  order["nearest_line"] = line_of(*c.after, c.order.other);
  return order;
}

/// Returns how a file states its unit, such as "a.nc:3 states inches (G20)"; empty if it states none.
std::string unit_statement(const Toolpath& path) {
  const auto fact = std::ranges::find(path.assumptions, Subject::path_unit, &Assumption::subject);
  const bool is_stated = fact != path.assumptions.end() && fact->basis == Basis::stated && fact->line > 0;
  if (!is_stated) return {};
  return path.file + ":" + std::to_string(fact->line) + " states " + (path.unit == LengthUnit::inch ? "inches" : "mm") +
         " (" + fact->evidence + ")";
}

/// Explains a factor between two paths. A unit on the command line is no remedy for a file that states its own.
std::string factor_text(const PathComparison& c) {
  const std::string found = c.relation->factor > 1 ? "NEW is OLD times 25.4: " : "OLD is NEW times 25.4: ";
  const std::string before = unit_statement(*c.before), after = unit_statement(*c.after);
  if (!before.empty() && !after.empty())
    return found + before + ", " + after + "; one of the files was written in a wrong unit";
  if (before.empty() && after.empty()) return found + "one is read in a wrong unit (--path-units, --new-path-units)";
  return found + (before.empty() ? after : before) + ", and " + (before.empty() ? "OLD" : "NEW") + " states no unit (" +
         (before.empty() ? "--path-units" : "--new-path-units") + ")";
}

std::string relation_text(const PathComparison& c) {
  const PathRelation& relation = *c.relation;
  if (std::abs(relation.factor - 1) > 0) return row("relation", factor_text(c));
  std::string shift;
  for (int k = 0; k < 3; ++k) shift += (k > 0 ? ", " : "") + display_text(relation.shift_mm[k], kDecimals);
  return row("relation", "NEW is OLD shifted by (" + shift + ") mm: compare offsets, tool lengths and origins");
}

Json relation_json(const std::optional<PathRelation>& relation) {
  if (!relation) return nullptr;
  const Vec3& shift = relation->shift_mm;
  return {{"factor", relation->factor}, {"shift_mm", Json::array({shift.x(), shift.y(), shift.z()})}};
}

/// Returns "; 3 feed rates differ", which does not affect the exit status; empty if none does.
std::string other_feeds_text(const PathComparison& c) {
  const std::size_t count = std::max(c.forward.other_feeds, c.backward.other_feeds);
  return count == 0 ? "" : "; " + count_text(count, "feed rate differs", "feed rates differ");
}

std::string difference_words(const PathComparison& c) {
  const std::string limit = display_text(c.same_within_mm, kDecimals) + " mm";
  if (c.exit_status() == kExitClean) return "same: no tip or axis differs by more than " + limit;
  if (c.exit_status() == kExitNotChecked) return "same as far as it was compared, within " + limit;
  const bool is_of_tip = c.tip_mm() > c.same_within_mm;
  if (!is_of_tip && c.axis_mm() <= c.same_within_mm) {
    const std::string found = c.rapids() == 0 ? std::string("the order of positions")
                                              : count_text(c.rapids(), "feed") + " of one toolpath " +
                                                    (c.rapids() == 1 ? "is a rapid" : "are rapids") + " in the other";
    return "differs: " + found + "; no tip or axis differs by more than " + limit;
  }
  return std::string("differs: ") +
         (is_of_tip ? "a tip by " + display_text(c.tip_mm(), kDecimals) + " mm"
                    : "an axis by " + display_text(c.axis_mm(), kDecimals) + " mm at " +
                          display_text(PathComparison::kHeight_mm, 0) + " mm above the tip") +
         ", more than " + limit + " (--same-within)";
}

std::string verdict_text(const PathComparison& c) { return difference_words(c) + other_feeds_text(c) + "\n"; }

}  // namespace

double PathComparison::tip_mm() const { return std::max(forward.tip_mm, backward.tip_mm); }

double PathComparison::axis_mm() const { return std::max(forward.axis_rad, backward.axis_rad) * kHeight_mm; }

ExitCode PathComparison::exit_status() const {
  if (std::max(tip_mm(), axis_mm()) > same_within_mm || rapids() > 0 || !order.is_same()) return kExitGouges;
  return unchecked() > 0 ? kExitNotChecked : kExitClean;
}

std::string comparison_text(const PathComparison& c) {
  return difference_text(c.forward, kForward, *c.before, *c.after) +
         difference_text(c.backward, kBackward, *c.after, *c.before) +
         left_out_rows(c.out_of_before, kForward, *c.before) + left_out_rows(c.out_of_after, kBackward, *c.after) +
         order_row(c) + (c.relation ? relation_text(c) : std::string()) + verdict_text(c);
}

std::string comparison_json(const PathComparison& c) {
  const Json json = {{"format", "gougecheck-path-comparison"},
                     {"format_version", 1},
                     {"program", {{"name", kProgramName}, {"version", kProgramVersion}}},
                     {"exit_status", static_cast<int>(c.exit_status())},
                     {"before", valid_utf8(c.before->file)},
                     {"after", valid_utf8(c.after->file)},
                     {"same_within_mm", c.same_within_mm},
                     {"height_mm", PathComparison::kHeight_mm},
                     {"not_compared", c.unchecked()},
                     {"left_out_before", left_out_json(c.out_of_before, *c.before)},
                     {"left_out_after", left_out_json(c.out_of_after, *c.after)},
                     {"order", order_json(c)},
                     {"relation", relation_json(c.relation)},
                     {"before_against_after", difference_json(c.forward, *c.before, *c.after)},
                     {"after_against_before", difference_json(c.backward, *c.after, *c.before)}};
  return json.dump(1) + "\n";
}

}  // namespace gouge
