#include "postproc/report/write_report.h"

#include <algorithm>
#include <functional>
#include <string_view>

#include "lib/base/number_text.h"
#include "postproc/record/words.h"
#include "postproc/report/assumption_report.h"
#include "postproc/report/axis_chart.h"
#include "postproc/report/axis_text.h"
#include "postproc/report/baseline_text.h"
#include "postproc/report/excess_text.h"
#include "postproc/report/findings_html.h"
#include "postproc/report/html_table.h"
#include "postproc/report/open_items.h"
#include "postproc/report/operations_html.h"
#include "postproc/report/report_sources.h"
#include "postproc/report/report_text.h"
#include "postproc/report/stickout_text.h"
#include "postproc/report/tightness.h"

namespace gouge {
namespace {

std::string figure(const NamedFile& picture) {
  const std::string id = picture.name.substr(0, picture.name.find('.'));
  return "<figure id=\"" + xml_escaped(id) + "\"><img alt=\"" + xml_escaped(picture.title) +
         "\" src=\"data:image/png;base64," + base64(picture.bytes) + "\"><figcaption>" + xml_escaped(picture.title) +
         "</figcaption></figure>\n";
}

std::string lengths_text(const Vec3& v, LengthUnit unit) { return point_text(v, unit) + " " + unit_name(unit); }

/// Returns the records, the largest first. Equal ones keep their order.
template <typename Record>
std::vector<const Record*> largest_first(const std::vector<Record>& records, double Record::*size) {
  std::vector<const Record*> sorted;
  for (const Record& record : records) sorted.push_back(&record);
  std::ranges::stable_sort(sorted, std::greater<>(), [size](const Record* record) { return record->*size; });
  return sorted;
}

class HtmlReport {
 public:
  HtmlReport(const ReportModel& model, const std::vector<NamedFile>& pictures, const HtmlParts& more)
      : model_(model),
        pictures_(pictures),
        more_(more),
        unit_(model.toolpath->unit),
        times_(measure_cycle_times(*model.toolpath)) {}

  [[nodiscard]] std::string build() const {
    const std::string title = xml_escaped(std::string(model_.has_correction ? "Gouge correction: " : "Gouge check: ") +
                                          model_.toolpath->file);
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
           "content=\"width=device-width, initial-scale=1\">\n<title>" +
           title + "</title>\n<style>" + std::string(kHtmlStyle) + "</style>\n</head>\n<body>\n<main>\n" +
           batch_links(model_.sign_off) + "<h1>" + title + "</h1>\n" + against() + sign_off_facts(model_.sign_off) +
           banner() + numbers() + sign_off_lines(model_.sign_off) + overview() + changes() + axis_section(model_) +
           operations_html(model_, times_) + findings_html(model_, pictures_, more_.review) + laws() + stickouts() +
           material_left() + open_queries() + close_ups() + tools_html(model_, more_.tool_drawings) +
           assumptions_html(*model_.result) + inputs() + options() + notes() + "<footer>" + kProgramName + " " +
           kProgramVersion + "</footer>\n</main>\n</body>\n</html>\n";
  }

 private:
  [[nodiscard]] std::string against() const {
    std::string text;
    for (const MeshFacts& mesh : model_.parts) text += (text.empty() ? "part " : ", part ") + mesh.name;
    for (const MeshFacts& mesh : model_.fixtures) {
      text += ", fixture " + mesh.name;
      if (mesh.clearance_mm > 0) text += " (clearance " + depth_text(mesh.clearance_mm, unit_) + ")";
    }
    const char* before = "; with the tool moves head ";
    for (const MeshFacts& mesh : model_.heads) {
      text += before + mesh.name;
      before = ", head ";
    }
    return "<p class=\"soft\">against " + xml_escaped(text) + "</p>\n";
  }

  [[nodiscard]] std::string banner() const {
    const OverallVerdict verdict = overall_verdict(model_);
    const std::string accepted = accepted_words(model_);
    const char* word = verdict == OverallVerdict::accepted_gouges ? accepted.c_str()
                       : verdict == OverallVerdict::clean         ? "Clean"
                       : verdict == OverallVerdict::gouges        ? "Gouges"
                       : verdict == OverallVerdict::material_left ? "Material left"
                                                                  : "Not fully checked";
    auto [headline, before] = headlines(model_);
    headline.erase(0, headline.find(": ") + 2);  // the banner has this word already
    if (!before.empty()) before = "<p class=\"soft\">Before the correction: " + xml_escaped(before) + ".</p>\n";
    const std::string guarantee = guarantee_text(model_);
    return std::string("<div class=\"banner ") + verdict_name(verdict) + "\"><strong>" + word + "</strong><div>" +
           xml_escaped(headline) + open_items_html(model_) + "</div></div>\n" + before + beside_the_verdict() +
           "<p class=\"promise\">The guarantee of this check: " + xml_escaped(guarantee) + ".</p>\n";
  }

  [[nodiscard]] std::string beside_the_verdict() const {
    std::string out;
    for (const std::string& fact : open_facts(model_))
      out += "<p class=\"but\">Not established: " + xml_escaped(fact) + ".</p>\n";
    for (const std::string& reservation : reservations(model_))
      out += "<p class=\"but\">Note: " + xml_escaped(reservation) + ".</p>\n";
    out += acceptances();
    const std::string overcut = overcut_gaps_text(model_);
    if (!overcut.empty()) out += "<p class=\"soft\">Overcut: " + xml_escaped(overcut) + ".</p>\n";
    if (const std::string any = any_turn_text(model_); !any.empty())
      out += "<p class=\"soft\">Rotary joints: " + xml_escaped(any) + ".</p>\n";
    if (const std::string stock = stock_text(model_); !stock.empty())
      out += "<p class=\"soft\">Stock: " + xml_escaped(stock) + ".</p>\n";
    if (const std::string left = stock_left_text(model_); !left.empty())
      out += "<p class=\"soft\">Stock left: " + xml_escaped(left) + ".</p>\n";
    if (const std::string excess = excess_text(model_); !excess.empty())
      out += "<p class=\"soft\">Excess: " + xml_escaped(excess) + ".</p>\n";
    const std::string closest_approach = closest_approach_text(model_);
    if (closest_approach.empty()) return out;
    return out + "<p class=\"soft\">Closest approach to the part: " + xml_escaped(closest_approach) + ".</p>\n";
  }

  [[nodiscard]] std::string acceptances() const {
    if (!model_.baseline.is_given()) return {};
    std::string out = "<p class=\"soft\">Acceptances of " + xml_escaped(model_.baseline.file) + ": " +
                      baseline_counts(model_) + ".</p>\n";
    for (const BaselineEntry& entry : model_.baseline.entries) {
      if (entry.use == BaselineEntry::Use::voided)
        out += "<p class=\"but\">Void: " + xml_escaped(entry.finding + ": " + entry.why) + ".</p>\n";
      if (entry.use == BaselineEntry::Use::partly)
        out += "<p class=\"soft\">In part: " + xml_escaped(entry.finding + ": " + entry.why) + ".</p>\n";
    }
    return out;
  }

  [[nodiscard]] std::string numbers() const {
    const StateCounts& n = model_.result->counts;
    std::string out = "<div class=\"numbers\">";
    const auto add = [&](const std::string& value, const std::string& what, const char* css) {
      out += std::string("<div class=\"") + css + "\"><b>" + xml_escaped(value) + "</b><span>" + what + "</span></div>";
    };
    add(std::to_string(model_.result->verdicts.size()), "moves", "");
    add(std::to_string(n.clean), "clean", "");
    if (n.near_miss > 0) add(std::to_string(n.near_miss), "near", "");
    add(std::to_string(n.gouge), "gouge", n.gouge > 0 ? "bad" : "");
    if (n.buried > 0) add(std::to_string(n.buried), "buried", "bad");
    if (n.not_checked > 0) add(std::to_string(n.not_checked), "not checked", n.not_checked > n.skipped ? "open" : "");
    if (n.not_certified > 0) add(std::to_string(n.not_certified), "not certified", "open");
    if (n.gouge > 0) add(depth_text(model_.result->worst_depth_mm, unit_, model_.options), "deepest gouge", "bad");
    if (const std::string time = cycle_time_text(whole_time(times_)); !time.empty())
      add(time, "cycle time at the feeds", "");
    return out + "</div>\n";
  }

  [[nodiscard]] const NamedFile* picture(std::string_view name) const {
    const auto found = std::ranges::find_if(pictures_, [&](const NamedFile& file) { return file.name == name; });
    return found == pictures_.end() ? nullptr : &*found;
  }

  [[nodiscard]] std::string overview() const {
    std::string out = more_.view;
    for (const char* name : {"before_after.png", "tilt_field.png", "heat_map.png", "depth_along_path.png"}) {
      if (const NamedFile* file = picture(name)) out += figure(*file);
    }
    return out;
  }

  [[nodiscard]] std::string close_ups() const {
    std::string out;
    for (const NamedFile& file : pictures_) {
      if (file.name.starts_with("event_")) out += figure(file);
    }
    return out.empty() ? out : "<h2>The worst findings close up</h2>\n<div class=\"figures\">\n" + out + "</div>\n";
  }

  [[nodiscard]] std::string material_left() const {
    if (!model_.result->excess || model_.result->excess->places.empty()) return {};
    HtmlTable table({{"State"},
                     {"Height", "n"},
                     {"At most", "n"},
                     {"Area", "n"},
                     {"Point", "k"},
                     {"Part"},
                     {"Facet", "n"},
                     {"Open because"}});
    for (const ExcessPlaceFacts& place : model_.result->excess->places) {
      if (!table.has_room()) {
        table.skip();
        continue;
      }
      const std::string state = place.is_proved() ? "gouge" : "not-certified";
      table.add("<td><span class=\"state " + state + "\">" + excess_kind(place) + "</span></td>" +
                html_cell(place.is_proved() ? length_text(place.height_mm, unit_) : "", "n") +
                html_cell(length_text(place.height_upper_mm, unit_), "n") +
                html_cell(area_range_text(place.area_mm2, place.area_upper_mm2, unit_), "n") +
                html_cell(point_text(place.point, unit_), "k") + html_cell(model_.parts[place.part].name) +
                html_cell(std::to_string(place.facet), "n") + html_cell(why_open_text(place)));
    }
    return "<h2>Material left on the part</h2>\n" + table.html();
  }

  [[nodiscard]] std::string open_queries() const {
    const std::vector<ReasonGroup> groups = group_reasons(*model_.result);
    const auto& words = model_.toolpath->words_not_understood;
    if (groups.empty() && words.empty()) return {};
    std::string out = "<h2>What was not checked</h2>\n";
    HtmlTable table({{"State"}, {"Reason"}, {"Moves", "n"}, {"First line", "n"}});
    for (const ReasonGroup& group : groups) {
      const std::string state = state_name(group.state);
      table.add("<td><span class=\"state " + state + "\">" + state + "</span></td>" + html_cell(group.reason) +
                html_cell(std::to_string(group.moves), "n") +
                html_cell(std::to_string(model_.toolpath->moves[group.first_move].line), "n"));
    }
    out += table.html();
    std::string list;
    for (const auto& [word, count] : words)
      list += (list.empty() ? "" : ", ") + word + " (" + std::to_string(count) + ")";
    if (!list.empty()) out += "<p>Words of the toolpath that were not understood: " + xml_escaped(list) + "</p>\n";
    return out;
  }

  [[nodiscard]] std::string changes() const {
    if (!model_.has_correction) return {};
    const CorrectionFacts& c = model_.correction;
    std::string out = "<h2>Changes</h2>\n<p>Strategy " + xml_escaped(c.strategy);
    if (c.max_shift_mm > 0) out += ", shifts up to " + length_text(c.max_shift_mm, unit_);
    out += c.output_file.empty() ? ". No toolpath was written."
                                 : ". Written to <code>" + xml_escaped(c.output_file) + "</code>.";
    if (c.curves > 0) out += " " + straightened_text(c) + ", of which those are listed that had to leave their curve.";
    out += c.changes.empty() && c.curves == 0
               ? " Nothing was changed.</p>\n"
               : " " + count_text(c.written.size(), "record") +
                     " of the file changed, added or removed; every other one is the same to the byte.</p>\n";
    if (!c.uncut.empty()) out += "<p class=\"but\">" + xml_escaped(uncut_text(c, unit_)) + ".</p>\n" + uncut_table();
    if (!c.low_rapids.empty())
      out += "<p class=\"but\">" + xml_escaped(low_rapids_text(c, unit_)) + ".</p>\n" + low_rapids_table();
    HtmlTable table({{"Line", "n"},
                     {"Move", "n"},
                     {"Strategy"},
                     {"Shift", "n"},
                     {"Shift vector"},
                     {"Tilt", "n"},
                     {"Depth before", "n"},
                     {"Depth after", "n"},
                     {"Iterations", "n"},
                     {"Cause"}});
    for (const CorrectedRecord* r : largest_first(c.changes, &CorrectedRecord::shift_length_mm))
      table.has_room() ? table.add(change_row(*r)) : table.skip();
    return out + table.html() + left_as_was();
  }

  [[nodiscard]] std::string uncut_table() const {
    HtmlTable table({{"Lines not cut", "n"}, {"Moves", "n"}, {"Positions", "n"}, {"Length", "n"}, {"Kind"}});
    const auto span = [](std::size_t first, std::size_t last) {
      return first == last ? std::to_string(first) : std::to_string(first) + "-" + std::to_string(last);
    };
    for (const Uncut* r : largest_first(model_.correction.uncut, &Uncut::length_mm)) {
      table.has_room()
          ? table.add(html_cell(span(r->first_line, r->last_line), "n") +
                      html_cell(span(r->first_move, r->last_move), "n") + html_cell(std::to_string(r->positions), "n") +
                      html_cell(length_text(r->length_mm, unit_), "n") +
                      html_cell(uncut_words().at(static_cast<std::size_t>(r->kind))))
          : table.skip();
    }
    return table.html();
  }

  [[nodiscard]] std::string low_rapids_table() const {
    HtmlTable table({{"Line", "n"}, {"Move", "n"}, {"Keeps", "n"}});
    std::vector<LowRapid> sorted = model_.correction.low_rapids;
    std::ranges::stable_sort(sorted, {}, &LowRapid::keeps_mm);
    for (const LowRapid& r : sorted) {
      table.has_room() ? table.add(html_cell(std::to_string(r.line), "n") + html_cell(std::to_string(r.move), "n") +
                                   html_cell(kept_text(r.keeps_mm, unit_), "n"))
                       : table.skip();
    }
    return table.html();
  }

  [[nodiscard]] std::string change_row(const CorrectedRecord& r) const {
    return html_cell(std::to_string(r.line), "n") + html_cell(std::to_string(r.move), "n") + html_cell(r.strategy) +
           html_cell(depth_text(r.shift_length_mm, unit_), "n") + html_cell(lengths_text(r.shift_mm, unit_), "k") +
           html_cell(r.tilt_rad > 0 ? angle_text(r.tilt_rad, DegreeSign::sign) : "", "n") +
           html_cell(depth_text(r.depth_before_mm, unit_, model_.options), "n") +
           html_cell(depth_text(r.depth_after_mm, unit_, model_.options), "n") +
           html_cell(std::to_string(r.iterations), "n") + html_cell(cause(r));
  }

  [[nodiscard]] static std::string cause(const CorrectedRecord& r) {
    if (!r.cause) return {};
    const std::string body = body_name(r.cause->body);
    if (!r.cause->against) return body + " inside a solid";
    const std::string against = body + " against " + against_name(*r.cause->against);
    return r.cause->mesh ? against + " " + *r.cause->mesh : against;
  }

  [[nodiscard]] std::string left_as_was() const {
    if (model_.correction.uncorrected.empty()) return {};
    HtmlTable table({{"Line", "n"}, {"Move", "n"}, {"Depth", "n"}, {"Reason"}});
    for (const Uncorrected* one : largest_first(model_.correction.uncorrected, &Uncorrected::depth_mm)) {
      const std::string depth = one->depth_mm > 0 ? depth_text(one->depth_mm, unit_, model_.options) : "-";
      table.has_room()
          ? table.add(html_cell(std::to_string(one->line), "n") + html_cell(std::to_string(one->move), "n") +
                      html_cell(depth, "n") + html_cell(one->reason))
          : table.skip();
    }
    return "<h2>Left as it was</h2>\n" + table.html();
  }

  [[nodiscard]] std::string inputs() const {
    HtmlTable table({{"Role"}, {"File"}, {"Bytes", "n"}, {"Checksum"}});
    for (const InputFile& input : model_.inputs) {
      table.add(html_cell(input.role) + html_cell(input.name) + html_cell(std::to_string(input.bytes), "n") +
                "<td><code>" + xml_escaped(input.checksum) + "</code></td>");
    }
    std::string out = "<h2>Inputs</h2>\n" + table.html();
    for (const std::vector<MeshFacts>* meshes : {&model_.parts, &model_.fixtures, &model_.heads}) {
      for (const MeshFacts& mesh : *meshes) {
        out += "<p>" + xml_escaped(mesh.name) + ": " + count_text(mesh.triangles, "triangle") +
               (mesh.is_closed ? ", closed" : ", not closed") +
               (mesh.dropped > 0 ? ", " + std::to_string(mesh.dropped) + " without area dropped" : "") +
               xml_escaped(mesh.meaning.empty() ? "" : "; " + mesh.meaning) + "</p>\n";
      }
    }
    return out + path_facts();
  }

  [[nodiscard]] std::string path_facts() const {
    const Toolpath& path = *model_.toolpath;
    std::size_t kinds[4] = {0, 0, 0, 0};
    for (const Move& move : path.moves) ++kinds[static_cast<std::size_t>(move.kind)];
    std::string text = path.file + ": " + path.dialect + ", " + unit_name(unit_) +
                       (path.is_unit_stated ? "" : " (not stated in the file)");
    for (const MoveKind kind : {MoveKind::feed, MoveKind::rapid, MoveKind::arc, MoveKind::cycle}) {
      const std::size_t count = kinds[static_cast<std::size_t>(kind)];
      if (count > 0) text += ", " + std::to_string(count) + " " + kind_name(kind);
    }
    return "<p>" + xml_escaped(text) + "</p>\n";
  }

  [[nodiscard]] std::string laws() const {
    if (model_.laws.empty()) return {};
    HtmlTable table({{"Law"}, {"Gouges"}});
    for (const LawRecord& law : model_.laws)
      table.add(html_cell(law_label(law), "k") + html_cell(law_text(model_, law)));
    return "<h2>Laws of motion compared</h2>\n" + table.html();
  }

  [[nodiscard]] std::string stickouts() const {
    if (model_.stickouts.empty()) return {};
    HtmlTable table({{"Tool"}, {"Operation"}, {"Stick-out", "n"}, {"To be free of shank, holder and heads"}});
    for (const StickoutFacts& tool : model_.stickouts) {
      const auto add = [&](const std::string& operation, const StickoutNeed& need) {
        table.add(html_cell(tool_label(*model_.toolpath, tool.found.tool), "k") + html_cell(operation) +
                  html_cell(length_text(tool.found.now_mm, unit_), "n") +
                  html_cell(stickout_need_text(model_, tool, need)));
      };
      add("all", tool.found.all);
      for (const OperationStickout& operation : operations_in_need(tool))
        add(stickout_operation_label(model_, operation.operation), operation.need);
    }
    return "<h2>Stick-out</h2>\n" + table.html();
  }

  [[nodiscard]] std::string options() const {
    const CheckOptions& o = model_.options;
    HtmlTable table({});
    const auto add = [&](const std::string& name, const std::string& value) {
      table.add(html_cell(name, "k") + html_cell(value));
    };
    add("tolerance", length_text(o.tolerance_mm, unit_));
    add("resolution", length_text(o.resolution_mm, unit_));
    add("stock to leave", length_text(o.stock_to_leave_mm, unit_));
    add("clearance of the shank", length_text(o.shank_clearance_mm, unit_));
    add("clearance of the holder", length_text(o.holder_clearance_mm, unit_));
    add("near miss", o.near_miss_mm > 0 ? length_text(o.near_miss_mm, unit_) : "not asked");
    add("rapid moves", rapid_word(o.law.rapid()));
    for (const OptionText& option : model_.more_options) add(option.name, option.value);
    return "<h2>Options in force</h2>\n" + table.html();
  }

  [[nodiscard]] std::string notes() const {
    if (model_.notes.empty()) return {};
    HtmlTable table({});
    for (const Diagnostic& note : model_.notes) table.add(html_cell(to_text(note)));
    return "<h2>Notes on the input</h2>\n" + table.html();
  }

  const ReportModel& model_;
  const std::vector<NamedFile>& pictures_;
  const HtmlParts& more_;
  LengthUnit unit_;
  std::vector<CycleTime> times_;
};

}  // namespace

std::string write_html(const ReportModel& model, const std::vector<NamedFile>& pictures, const HtmlParts& more) {
  return HtmlReport(model, pictures, more).build();
}

}  // namespace gouge
