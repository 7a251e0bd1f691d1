#include "postproc/report/correction_json.h"

#include <cmath>
#include <utility>

#include "postproc/report/report_text.h"
#include "postproc/report/stickout_text.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

class CorrectionReport {
 public:
  explicit CorrectionReport(const ReportModel& model) : model_(model), unit_(model.toolpath->unit) {}

  [[nodiscard]] Json build() const {
    const CorrectionFacts& c = model_.correction;
    Json changes = Json::array();
    for (const CorrectedRecord& r : c.changes) {
      changes.push_back({{"move", r.move},
                         {"line", r.line},
                         {"strategy", text(r.strategy)},
                         {"is_inserted", r.is_inserted},
                         {"shift", lengths(r.shift_mm)},
                         {"shift_length", length(r.shift_length_mm)},
                         {"tilt_rad", r.tilt_rad},
                         {"depth_before", length(r.depth_before_mm)},
                         {"depth_after", length(r.depth_after_mm)},
                         {"iterations", r.iterations},
                         {"cause", cause(c, r)},
                         {"old_record", r.old_record ? text(*r.old_record) : Json(nullptr)},
                         {"new_record", r.new_record ? text(*r.new_record) : Json(nullptr)}});
    }
    Json left = Json::array();
    for (const UncorrectedRecord& r : c.uncorrected) {
      left.push_back({{"move", r.move},
                      {"line", r.line},
                      {"depth", length(r.depth_mm)},
                      {"reason", text(r.reason)},
                      {"is_changed", r.is_changed}});
    }
    Json written = Json::array();
    for (const WrittenRecord& r : c.written) written.push_back({{"kind", r.kind}, {"line", r.line}});
    return {{"output_file", text(c.output_file)},
            {"strategy", text(c.strategy)},
            {"max_shift", c.max_shift_mm > 0 ? length(c.max_shift_mm) : Json(nullptr)},
            {"max_side_shift", c.max_side_shift_mm ? length(*c.max_side_shift_mm) : Json(nullptr)},
            {"rapid_clearance", length(c.rapid_clearance_mm)},
            {"quality", quality(c)},
            {"straightened", {{"curves", c.curves}, {"straight_moves", c.straight_moves}}},
            {"uncut", uncut(c)},
            {"stock", stock(c)},
            {"low_rapids", low_rapids(c)},
            {"changes", changes},
            {"uncorrected", left},
            {"written", written}};
  }

 private:
  [[nodiscard]] static Json text(std::string_view value) { return valid_utf8(value); }
  [[nodiscard]] Json length(double length_mm) const { return length_json(length_mm, unit_); }
  [[nodiscard]] Json lengths(const Vec3& v) const { return Json::array({length(v.x()), length(v.y()), length(v.z())}); }

  // Per length to the power given, in the toolpath's unit.
  [[nodiscard]] Json per_length(double value, int power) const { return value * std::pow(mm_per(unit_), power) + 0.0; }

  // A feed of next to nothing takes no time that a number states.
  [[nodiscard]] static Json seconds(const std::optional<double>& time) {
    return time && std::isfinite(*time) ? Json(*time) : Json(nullptr);
  }

  [[nodiscard]] static Json move_of(const LargestOfMoves& largest) {
    return largest.move == kNone ? Json(nullptr) : Json(largest.move);
  }
  [[nodiscard]] static Json line_of(const LargestOfMoves& largest, const Toolpath& path) {
    return largest.move < path.moves.size() ? Json(std::size_t{path.moves[largest.move].line}) : Json(nullptr);
  }

  [[nodiscard]] Json axis_quality(const AxisQuality& q, const Toolpath& path) const {
    const auto turn = [&](const LargestOfMoves& largest, int power) -> Json {
      return {{"rad", per_length(largest.value, power)}, {"move", move_of(largest)}, {"line", line_of(largest, path)}};
    };
    return {{"largest_turn_per_length", turn(q.turn_rad_per_mm, 1)},
            {"largest_turn", turn(q.turn_rad, 0)},
            {"turns_on_the_spot", q.turns_on_the_spot},
            {"largest_turn_on_the_spot", turn(q.turn_on_the_spot_rad, 0)},
            {"bending", per_length(q.bending, 3)},
            {"feed_seconds", seconds(q.feed_seconds)},
            {"feed_seconds_with_max_rotary_speed", seconds(q.limited_feed_seconds)},
            {"moves_without_feed", q.moves_without_feed}};
  }

  [[nodiscard]] Json quality(const CorrectionFacts& c) const {
    if (!c.axes) return nullptr;
    const AxisTilts& tilts = c.axes->tilts;
    const std::size_t inserted = inserted_positions(c);
    const Toolpath& before = c.toolpath_before ? *c.toolpath_before : *model_.toolpath;
    return {{"before", axis_quality(c.axes->before, before)},
            {"after", axis_quality(c.axes->after, *model_.toolpath)},
            {"max_rotary_speed_deg_per_min",
             c.axes->max_rotary_deg_per_min ? Json(*c.axes->max_rotary_deg_per_min) : Json(nullptr)},
            {"largest_tilt",
             {{"rad", tilts.tilt_rad.value},
              {"move", move_of(tilts.tilt_rad)},
              {"line", line_of(tilts.tilt_rad, *model_.toolpath)}}},
            {"positions", {{"moved", moved_positions(c)}, {"inserted", inserted}, {"tilted", tilts.positions}}},
            {"tilted_runs", tilts.runs.size() + tilts.runs_left_out}};
  }

  // The finding that the change cures: for a buried move no surface is named.
  [[nodiscard]] Json cause(const CorrectionFacts& c, const CorrectedRecord& r) const {
    if (!r.cause || c.result_before == nullptr) return nullptr;
    const MoveVerdict& verdict = c.result_before->verdicts[*r.cause];
    const Toolpath& before = c.toolpath_before ? *c.toolpath_before : *model_.toolpath;
    const bool has_witness = verdict.witness.has_value();
    return {{"move", *r.cause},
            {"line", std::size_t{before.moves[*r.cause].line}},
            {"state", state_name(verdict.state)},
            {"depth", length(verdict.depth_mm)},
            {"body", body_name(has_witness ? verdict.witness->body : verdict.reason.body)},
            {"against", has_witness ? Json(against_name(verdict.witness->against)) : Json(nullptr)},
            {"mesh", has_witness ? text(mesh_name(model_, *verdict.witness)) : Json(nullptr)}};
  }

  template <typename Record>
  [[nodiscard]] static Json lines_of_stretch(const Record& r) {
    return {{"first_move", r.first_move},
            {"last_move", r.last_move},
            {"first_line", r.first_line},
            {"last_line", r.last_line}};
  }

  [[nodiscard]] Json uncut(const CorrectionFacts& c) const {
    Json stretches = Json::array();
    for (const UncutRecord& r : c.uncut) {
      Json stretch = lines_of_stretch(r);
      stretch["positions"] = r.positions;
      stretch["length"] = length(r.length_mm);
      stretch["kind"] = uncut_kind_name(r.kind);
      stretches.push_back(std::move(stretch));
    }
    const UncutTotal total = uncut_total(c);
    return {{"positions", total.positions},
            {"length", length(total.length_mm)},
            {"holes", total.holes},
            {"stretches", stretches}};
  }

  [[nodiscard]] Json stock(const CorrectionFacts& c) const {
    Json stretches = Json::array();
    for (const StockRecord& r : c.stock) {
      Json stretch = lines_of_stretch(r);
      stretch["thickness"] = length(r.thickness_mm);
      stretch["is_more"] = r.is_more;
      stretch["is_proved"] = !r.is_undecided;
      stretch["point"] = lengths(r.point);
      stretches.push_back(std::move(stretch));
    }
    return stretches;
  }

  [[nodiscard]] Json low_rapids(const CorrectionFacts& c) const {
    Json all = Json::array();
    for (const LowRapidRecord& r : c.low_rapids)
      all.push_back({{"move", r.move}, {"line", r.line}, {"keeps", length(r.keeps_mm)}});
    return all;
  }

  const ReportModel& model_;
  LengthUnit unit_;
};

}  // namespace

Json correction_json(const ReportModel& model) {
  return model.has_correction ? CorrectionReport(model).build() : Json(nullptr);
}

}  // namespace gouge
