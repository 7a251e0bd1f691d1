#include "postproc/report/write_html.h"

#include <algorithm>
#include <string_view>

#include "lib/base/number_text.h"
#include "postproc/report/findings_text.h"
#include "postproc/report/html_style.h"
#include "postproc/report/report_text.h"
#include "postproc/report/tightness.h"

namespace gouge {
namespace {

constexpr std::size_t kMostRows = 200;

std::string cell(const std::string& text, const char* css = "") {
  return std::string("<td") + (*css != '\0' ? std::string(" class=\"") + css + "\"" : std::string()) + ">" +
         xml_escaped(text) + "</td>";
}

std::string more_rows(std::size_t all, const char* columns) {
  if (all <= kMostRows) return {};
  return std::string("<tr><td class=\"soft\" colspan=\"") + columns + "\">and " + std::to_string(all - kMostRows) +
         " more; the CSV and JSON files have them all</td></tr>\n";
}

std::string figure(const NamedFile& picture) {
  const std::string id = picture.name.substr(0, picture.name.find('.'));
  return "<figure id=\"" + xml_escaped(id) + "\"><img alt=\"" + xml_escaped(picture.title) +
         "\" src=\"data:image/png;base64," + base64(picture.bytes) + "\"><figcaption>" + xml_escaped(picture.title) +
         "</figcaption></figure>\n";
}

std::string lengths_text(const Vec3& v, LengthUnit unit) { return point_text(v, unit) + " " + unit_name(unit); }

class HtmlReport {
 public:
  HtmlReport(const ReportModel& model, const std::vector<NamedFile>& pictures)
      : model_(model), pictures_(pictures), unit_(model.toolpath->unit) {}

  [[nodiscard]] std::string build() const {
    const std::string title = xml_escaped(std::string(model_.has_correction ? "Gouge correction: " : "Gouge check: ") +
                                          model_.toolpath->file);
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
           "content=\"width=device-width, initial-scale=1\">\n<title>" +
           title + "</title>\n<style>" + kHtmlStyle + "</style>\n</head>\n<body>\n<main>\n<h1>" + title + "</h1>\n" +
           against() + banner() + numbers() + overview() + changes() + findings() + open_queries() + close_ups() +
           inputs() + tools() + options() + notes() + "<footer>" + kProgramName + " " + kProgramVersion +
           "</footer>\n</main>\n</body>\n</html>\n";
  }

 private:
  [[nodiscard]] std::string against() const {
    std::string text;
    for (const MeshFacts& mesh : model_.parts) text += (text.empty() ? "part " : ", part ") + mesh.name;
    for (const MeshFacts& mesh : model_.fixtures) text += ", fixture " + mesh.name;
    const char* before = "; with the tool moves head ";
    for (const MeshFacts& mesh : model_.heads) {
      text += before + mesh.name;
      before = ", head ";
    }
    return "<p class=\"soft\">against " + xml_escaped(text) + "</p>\n";
  }

  [[nodiscard]] std::string banner() const {
    const OverallVerdict verdict = overall_verdict(*model_.result);
    const char* word = verdict == OverallVerdict::clean    ? "Clean"
                       : verdict == OverallVerdict::gouges ? "Gouges"
                                                           : "Not fully checked";
    // The second line of the summary is the headline; its first word is what the banner says already.
    const std::string summary = summary_text(model_);
    const std::size_t first = summary.find('\n') + 1;
    std::string headline = summary.substr(first, summary.find('\n', first) - first);
    headline.erase(0, headline.find(": ") + 2);
    const std::string guarantee = guarantee_text(model_);
    return std::string("<div class=\"banner ") + verdict_name(verdict) + "\"><strong>" + word + "</strong><div>" +
           xml_escaped(headline) + "</div></div>\n" + beside_the_verdict() +
           "<p class=\"promise\">The guarantee of this check: " + xml_escaped(guarantee) + ".</p>\n";
  }

  [[nodiscard]] std::string beside_the_verdict() const {
    std::string out;
    for (const std::string& reservation : reservations(model_))
      out += "<p class=\"but\">Note: " + xml_escaped(reservation) + ".</p>\n";
    const std::string overcut = overcut_gaps_text(model_);
    if (!overcut.empty()) out += "<p class=\"soft\">Overcut: " + xml_escaped(overcut) + ".</p>\n";
    const std::string closeness = closeness_text(model_);
    if (closeness.empty()) return out;
    return out + "<p class=\"soft\">Closest approach to the part: " + xml_escaped(closeness) + ".</p>\n";
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
    if (n.gouge > 0) add(depth_text(model_.result->worst_depth_mm, unit_), "deepest gouge", "bad");
    return out + "</div>\n";
  }

  [[nodiscard]] const NamedFile* picture(std::string_view name) const {
    const auto found =
        std::find_if(pictures_.begin(), pictures_.end(), [&](const NamedFile& file) { return file.name == name; });
    return found == pictures_.end() ? nullptr : &*found;
  }

  [[nodiscard]] std::string overview() const {
    std::string out;
    for (const char* name : {"before_after.png", "heat_map.png", "depth_along_path.png"}) {
      if (const NamedFile* file = picture(name)) out += figure(*file);
    }
    return out;
  }

  [[nodiscard]] std::string close_ups() const {
    std::string out;
    for (const NamedFile& file : pictures_) {
      if (file.name.starts_with("event_")) out += figure(file);
    }
    return out.empty() ? out : "<h2>The worst findings close up</h2>\n" + out;
  }

  [[nodiscard]] std::string link(const Event& event) const {
    for (const NamedFile& file : pictures_) {
      if (file.name.starts_with("event_") && file.move == event.worst_move) {
        const std::string id = file.name.substr(0, file.name.find('.'));
        return "<a href=\"#" + xml_escaped(id) + "\">picture " + xml_escaped(id.substr(6)) + "</a>";
      }
    }
    return {};
  }

  [[nodiscard]] std::string finding_row(const Event& event) const {
    const MoveVerdict& verdict = model_.result->verdicts[event.worst_move];
    const Move& move = model_.toolpath->moves[event.worst_move];
    const std::string state = state_name(event.state);
    std::string depth = "-";
    if (event.state == MoveState::gouge) depth = depth_text(verdict.depth_mm, unit_);
    if (has_wide_depth(model_, verdict)) depth += " to " + depth_text(verdict.depth_upper_mm, unit_);
    if (event.state == MoveState::near_miss) depth = depth_text(verdict.clearance_mm.value_or(0), unit_) + " left";
    std::string against = against_name(event.against);
    if (verdict.witness) against += " " + mesh_name(model_, *verdict.witness);
    const std::string span = event.moves < 2 ? std::to_string(event.worst_move)
                                             : std::to_string(event.first_move) + "-" + std::to_string(event.last_move);
    return "<tr><td><span class=\"state " + state + "\">" + state + "</span></td>" +
           cell(std::to_string(move.line), "n") + cell(depth, "n") +
           cell(std::string(body_name(event.body)) + " " + tool_label(*model_.toolpath, event.tool)) + cell(against) +
           cell(verdict.witness ? point_text(verdict.witness->point, unit_) : std::string(), "k") + cell(span, "n") +
           cell(operation_name(*model_.toolpath, move.operation)) + "<td class=\"k\">" + link(event) + "</td></tr>\n";
  }

  [[nodiscard]] std::string findings() const {
    std::vector<const Event*> events;
    for (const Event& event : model_.result->events) {
      if (event.state != MoveState::not_checked && event.state != MoveState::not_certified) events.push_back(&event);
    }
    if (events.empty()) return {};
    std::string out =
        "<h2>Findings</h2>\n<p class=\"soft\">Neighbouring moves of one tool and body are one finding, in the order of "
        "the path. Line, depth and position are those of its deepest move.</p>\n<div "
        "class=\"wide\"><table><thead><tr><th>State</th><th class=\"n\">Line</th><th "
        "class=\"n\">Depth</th><th>Body</th><th>Against</th><th>At, in ";
    out += std::string(unit_words(unit_)) +
           "</th><th class=\"n\">Moves</th><th>Operation</th><th></th></tr></thead><tbody>\n";
    if (events.size() > kMostRows) keep_worst(events);
    for (std::size_t i = 0; i < events.size() && i < kMostRows; ++i) out += finding_row(*events[i]);
    std::size_t all = 0;
    for (const Event& event : model_.result->events) {
      all += event.state != MoveState::not_checked && event.state != MoveState::not_certified ? 1 : 0;
    }
    return out + more_rows(all, "9") + "</tbody></table></div>\n";
  }

  void keep_worst(std::vector<const Event*>& events) const {
    const auto depth = [&](const Event* event) {
      return event->state == MoveState::buried ? 1e300 : model_.result->verdicts[event->worst_move].depth_mm;
    };
    std::stable_sort(events.begin(), events.end(), [&](const Event* a, const Event* b) { return depth(a) > depth(b); });
    events.resize(kMostRows);
    std::stable_sort(events.begin(), events.end(),
                     [](const Event* a, const Event* b) { return a->first_move < b->first_move; });
  }

  [[nodiscard]] std::string open_queries() const {
    const std::vector<ReasonGroup> groups = group_reasons(*model_.result);
    const auto& words = model_.toolpath->words_not_understood;
    if (groups.empty() && words.empty()) return {};
    std::string out = "<h2>What was not checked</h2>\n";
    if (!groups.empty()) {
      out +=
          "<div class=\"wide\"><table><thead><tr><th>State</th><th>Reason</th><th class=\"n\">Moves</th><th "
          "class=\"n\">First line</th></tr></thead><tbody>\n";
      for (const ReasonGroup& group : groups) {
        const std::string state = state_name(group.state);
        out += "<tr><td><span class=\"state " + state + "\">" + state + "</span></td>" + cell(group.reason) +
               cell(std::to_string(group.moves), "n") +
               cell(std::to_string(model_.toolpath->moves[group.first_move].line), "n") + "</tr>\n";
      }
      out += "</tbody></table></div>\n";
    }
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
    if (!c.changes.empty()) {
      out +=
          "<div class=\"wide\"><table><thead><tr><th class=\"n\">Line</th><th "
          "class=\"n\">Move</th><th>Strategy</th><th class=\"n\">Shift</th><th>Shift vector</th><th class=\"n\">Depth "
          "before</th><th class=\"n\">Depth after</th><th class=\"n\">Iterations</th></tr></thead><tbody>\n";
      for (std::size_t i = 0; i < c.changes.size() && i < kMostRows; ++i) {
        const CorrectedRecord& r = c.changes[i];
        out += "<tr>" + cell(std::to_string(r.line), "n") + cell(std::to_string(r.move), "n") + cell(r.strategy) +
               cell(depth_text(r.shift_length_mm, unit_), "n") + cell(lengths_text(r.shift_mm, unit_), "k") +
               cell(depth_text(r.depth_before_mm, unit_), "n") + cell(depth_text(r.depth_after_mm, unit_), "n") +
               cell(std::to_string(r.iterations), "n") + "</tr>\n";
      }
      out += more_rows(c.changes.size(), "8") + "</tbody></table></div>\n";
    }
    return out + left_as_was();
  }

  [[nodiscard]] std::string left_as_was() const {
    const std::vector<UncorrectedRecord>& left = model_.correction.uncorrected;
    if (left.empty()) return {};
    std::string out =
        "<h2>Left as it was</h2>\n<div class=\"wide\"><table><thead><tr><th class=\"n\">Line</th><th "
        "class=\"n\">Move</th><th class=\"n\">Depth</th><th>Reason</th></tr></thead><tbody>\n";
    for (std::size_t i = 0; i < left.size() && i < kMostRows; ++i) {
      out += "<tr>" + cell(std::to_string(left[i].line), "n") + cell(std::to_string(left[i].move), "n") +
             cell(left[i].depth_mm > 0 ? depth_text(left[i].depth_mm, unit_) : "-", "n") + cell(left[i].reason) +
             "</tr>\n";
    }
    return out + more_rows(left.size(), "4") + "</tbody></table></div>\n";
  }

  [[nodiscard]] std::string inputs() const {
    std::string out =
        "<h2>Inputs</h2>\n<div class=\"wide\"><table><thead><tr><th>Role</th><th>File</th><th "
        "class=\"n\">Bytes</th><th>Checksum</th></tr></thead><tbody>\n";
    for (const InputFile& input : model_.inputs) {
      out += "<tr>" + cell(input.role) + cell(input.name) + cell(std::to_string(input.bytes), "n") + "<td><code>" +
             xml_escaped(input.checksum) + "</code></td></tr>\n";
    }
    out += "</tbody></table></div>\n";
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

  [[nodiscard]] std::string tools() const {
    if (model_.tools.empty()) return {};
    std::string out =
        "<h2>Tools</h2>\n<div class=\"wide\"><table><thead><tr><th>Tool</th><th>Name</th><th>Shape</th><th>Defined "
        "in</th></tr></thead><tbody>\n";
    for (std::size_t i = 0; i < model_.tools.size(); ++i) {
      const ToolFacts& tool = model_.tools[i];
      out += "<tr>" + cell(tool_label(*model_.toolpath, i), "k") + cell(tool.name) + cell(tool.description) +
             cell(tool.defined_in.empty() ? "nowhere: its moves are not checked" : tool.defined_in) + "</tr>\n";
    }
    return out + "</tbody></table></div>\n";
  }

  [[nodiscard]] std::string options() const {
    static constexpr const char* kRapid[] = {"straight", "dogleg", "skip"};
    const CheckOptions& o = model_.options;
    std::string out = "<h2>Options in force</h2>\n<div class=\"wide\"><table><tbody>\n";
    const auto add = [&](const std::string& name, const std::string& value) {
      out += "<tr>" + cell(name, "k") + cell(value) + "</tr>\n";
    };
    add("tolerance", length_text(o.tolerance_mm, unit_));
    add("resolution", length_text(o.resolution_mm, unit_));
    add("stock to leave", length_text(o.stock_to_leave_mm, unit_));
    add("clearance of the shank", length_text(o.shank_clearance_mm, unit_));
    add("clearance of the holder", length_text(o.holder_clearance_mm, unit_));
    add("near miss", o.near_miss_mm > 0 ? length_text(o.near_miss_mm, unit_) : "not asked");
    add("rapid moves", kRapid[static_cast<std::size_t>(o.rapid)]);
    for (const OptionText& option : model_.more_options) add(option.name, option.value);
    return out + "</tbody></table></div>\n";
  }

  [[nodiscard]] std::string notes() const {
    if (model_.notes.empty()) return {};
    std::string out = "<h2>Notes on the input</h2>\n<div class=\"wide\"><table><tbody>\n";
    for (const Diagnostic& note : model_.notes) out += "<tr>" + cell(to_text(note)) + "</tr>\n";
    return out + "</tbody></table></div>\n";
  }

  const ReportModel& model_;
  const std::vector<NamedFile>& pictures_;
  LengthUnit unit_;
};

}  // namespace

std::string write_html(const ReportModel& model, const std::vector<NamedFile>& pictures) {
  return HtmlReport(model, pictures).build();
}

}  // namespace gouge
