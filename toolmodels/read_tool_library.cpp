#include <algorithm>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/base/similar_name.h"
#include "lib/base/tolerance.h"
#include "lib/json/json_file.h"
#include "toolmodels/cutter_fields.h"
#include "toolmodels/cutter_shapes.h"
#include "toolmodels/json_words.h"
#include "toolmodels/tool_library.h"

namespace gouge {
namespace {

using Json = nlohmann::json;

using detail::keys_text;
using detail::type_word;

// A reader of values that knows where each stands in the file. It keeps the first error, and then returns empty values,
// so the functions below need no test after each step.
class Reader {
 public:
  Reader(std::string file, JsonLines lines) : lines_(std::move(lines)) { library_.file = std::move(file); }

  Result<ToolLibrary> read(const Json& root) {
    read_root(root);
    if (error_) return *error_;
    return std::move(library_);
  }

 private:
  void fail(const std::string& code, const std::string& message, const std::string& pointer) {
    if (!error_) error_ = make_error(code, message, library_.file, lines_.at(pointer));
  }

  void warn_unknown_keys(const Json& object, const std::string& pointer, const std::string& who,
                         const std::vector<std::string_view>& known) {
    for (const auto& [key, value] : object.items())
      if (std::find(known.begin(), known.end(), key) == known.end())
        library_.notes.push_back(make_warning(
            "library-unknown-key", who + " has a key \"" + key + "\" that is not understood and was left out",
            library_.file, lines_.at(pointer + "/" + key)));
  }

  // Returns the message without its beginning "tool T1", because the doubt is printed after the name of the tool.
  static std::string without_owner(const std::string& message) {
    return message.substr(std::min(message.find(" has a key "), message.size()));
  }

  // Returns the first unknown key, because a mistyped key may have described a body.
  [[nodiscard]] std::string first_unknown_key(std::size_t notes_before) const {
    for (std::size_t i = notes_before; i < library_.notes.size(); ++i)
      if (library_.notes[i].code == "library-unknown-key")
        return "its entry" + without_owner(library_.notes[i].message);
    return {};
  }

  bool is_object(const Json& value, const std::string& pointer, const std::string& who) {
    if (value.is_object()) return true;
    fail("library-field", who + " is " + type_word(value) + "; expected an object", pointer);
    return false;
  }

  bool is_list(const Json& value, const std::string& pointer, const std::string& who) {
    if (value.is_array()) return true;
    fail("library-field", who + " is " + type_word(value) + "; expected a list", pointer);
    return false;
  }

  double number(const Json& object, const char* key, const std::string& pointer, const std::string& who,
                std::optional<double> otherwise = std::nullopt) {
    const auto found = object.find(key);
    if (found == object.end()) {
      if (!otherwise) fail("library-field", who + " has no \"" + key + "\"; it needs one" + keys_text(object), pointer);
      return otherwise.value_or(0);
    }
    if (!found->is_number()) {
      fail("library-field", who + ": \"" + key + "\" is " + type_word(*found) + "; expected a number",
           pointer + "/" + key);
      return 0;
    }
    return found->get<double>();
  }

  double length(const Json& object, const char* key, const std::string& pointer, const std::string& who,
                std::optional<double> otherwise = std::nullopt) {
    return number(object, key, pointer, who, otherwise) * mm_per(library_.unit);
  }

  std::string text(const Json& object, const char* key, const std::string& pointer, const std::string& who) {
    const auto found = object.find(key);
    if (found == object.end()) return {};
    if (!found->is_string()) {
      fail("library-field", who + ": \"" + key + "\" is " + type_word(*found) + "; expected a text",
           pointer + "/" + key);
      return {};
    }
    return found->get<std::string>();
  }

  void read_root(const Json& root) {
    if (!is_object(root, "", "the library")) return;
    warn_unknown_keys(root, "", "the library", {"units", "tools", "holders", "$schema", "comment"});
    if (!library_.notes.empty()) unknown_key_ = library_.notes.front().message;
    const std::string units = text(root, "units", "", "the library");
    if (units == "inch")
      library_.unit = LengthUnit::inch;
    else if (units != "mm")
      fail("library-field",
           root.contains("units") ? "units is \"" + units + "\"; expected \"mm\" or \"inch\""
                                  : "the library does not say its unit; add \"units\": \"mm\" or \"inch\"",
           "/units");
    if (error_) return;
    read_holders(root);
    read_tools(root);
    if (!unknown_key_.empty()) mark_all_uncertain();
  }

  // A key of the whole library may have described any of its tools.
  void mark_all_uncertain() {
    for (ToolAssembly& tool : library_.tools)
      if (tool.uncertainty.empty()) tool.uncertainty = unknown_key_;
    for (NamedHolder& holder : library_.holders)
      if (holder.uncertainty.empty()) holder.uncertainty = unknown_key_;
  }

  void read_holders(const Json& root) {
    const auto found = root.find("holders");
    if (found == root.end() || !is_list(*found, "/holders", "holders")) return;
    for (std::size_t i = 0; i < found->size() && !error_; ++i) {
      const std::string pointer = "/holders/" + std::to_string(i);
      const Json& entry = (*found)[i];
      const std::string who = "holder " + std::to_string(i + 1);
      if (!is_object(entry, pointer, who)) return;
      const std::size_t notes_before = library_.notes.size();
      warn_unknown_keys(entry, pointer, who, {"name", "segments", "uncertain", "comment"});
      NamedHolder holder{text(entry, "name", pointer, who), {}};
      if (holder.name.empty()) fail("library-field", who + " has no \"name\"; it needs one", pointer);
      if (!entry.contains("segments"))
        fail("library-field", who + " has no \"segments\"; it needs them", pointer);
      else
        holder.segments = read_segments(entry["segments"], pointer + "/segments", who + ": segment");
      check_holder(holder, pointer, who);
      holder.uncertainty = read_uncertainty(entry, pointer, who, notes_before);
      if (holder.uncertainty.empty() && holder.segments.empty()) holder.uncertainty = "it has no segments";
      if (!holders_.try_emplace(holder.name, library_.holders.size()).second)
        fail("library-duplicate-name", who + " has the name of an earlier one; give every holder a name of its own",
             pointer + "/name");
      library_.holders.push_back(std::move(holder));
    }
  }

  // Checks a holder alone, on a cutter that is certainly valid.
  void check_holder(const NamedHolder& holder, const std::string& pointer, const std::string& who) {
    const ToolAssembly probe{std::nullopt, holder.name, FlatCutter{1, 1}, {}, holder.segments};
    const Result<BodyProfiles> bodies = make_body_profiles(probe);
    if (!bodies) fail(bodies.error().code, who + ": " + bodies.error().message, pointer);
  }

  std::vector<ToolSegment> read_segments(const Json& list, const std::string& pointer, const std::string& who) {
    std::vector<ToolSegment> segments;
    if (!is_list(list, pointer, who)) return segments;
    for (std::size_t i = 0; i < list.size() && !error_; ++i) {
      const std::string here = pointer + "/" + std::to_string(i);
      const std::string which = who + " " + std::to_string(i + 1);
      if (!is_object(list[i], here, which)) break;
      warn_unknown_keys(list[i], here, which, {"lower_diameter", "upper_diameter", "length", "comment"});
      segments.push_back({length(list[i], "lower_diameter", here, which),
                          length(list[i], "upper_diameter", here, which), length(list[i], "length", here, which)});
    }
    return segments;
  }

  void read_tools(const Json& root) {
    const auto found = root.find("tools");
    if (found == root.end()) return fail("library-empty", "the library has no \"tools\"; expected a list of them", "");
    if (!is_list(*found, "/tools", "tools")) return;
    if (found->empty() && library_.holders.empty())
      return fail("library-empty", "the list of tools is empty; it needs at least one", "/tools");
    for (std::size_t i = 0; i < found->size() && !error_; ++i)
      read_tool((*found)[i], "/tools/" + std::to_string(i), i + 1);
  }

  void read_tool(const Json& entry, const std::string& pointer, std::size_t position) {
    std::string who = "tool at position " + std::to_string(position);
    if (!is_object(entry, pointer, who)) return;
    ToolAssembly tool;
    tool.name = text(entry, "name", pointer, who);
    read_number(entry, pointer, who, tool);
    if (error_) return;
    who = "tool " + label(tool);
    const std::size_t notes_before = library_.notes.size();
    warn_unknown_keys(entry, pointer, who,
                      {"number", "name", "cutter", "shank", "extensions", "holder", "stickout", "gauge_length", "cuts",
                       "uncertain", "comment"});
    if (!entry.contains("cutter"))
      return fail("library-field", who + " has no \"cutter\"; it needs one" + keys_text(entry), pointer);
    read_cutter(entry["cutter"], pointer + "/cutter", who, tool);
    if (entry.contains("shank")) tool.shank = read_segments(entry["shank"], pointer + "/shank", who + ": shank");
    if (entry.contains("extensions")) read_extensions(entry["extensions"], pointer + "/extensions", who, tool);
    tool.stickout_mm = length(entry, "stickout", pointer, who, 0);
    tool.gauge_length_mm = length(entry, "gauge_length", pointer, who, 0);
    if (entry.contains("holder")) read_tool_holder(entry["holder"], pointer + "/holder", who, tool);
    if (entry.contains("cuts")) read_cuts(entry["cuts"], pointer + "/cuts", who, tool);
    const std::string own = read_uncertainty(entry, pointer, who, notes_before);
    if (!own.empty()) tool.uncertainty = own;  // else it is that of the holder
    if (!error_) add_tool(std::move(tool), pointer, who);
  }

  // Returns the reason in "uncertain", or else the first unknown key of the entry, or nothing.
  std::string read_uncertainty(const Json& entry, const std::string& pointer, const std::string& who,
                               std::size_t notes_before) {
    const std::string stated = text(entry, "uncertain", pointer, who);
    if (stated.empty()) return first_unknown_key(notes_before);
    library_.notes.push_back(make_note("library-uncertain", who + " is not certain: " + stated, library_.file,
                                       lines_.at(pointer + "/uncertain")));
    return stated;
  }

  void read_number(const Json& entry, const std::string& pointer, const std::string& who, ToolAssembly& tool) {
    if (const auto found = entry.find("number"); found != entry.end()) {
      constexpr std::int64_t kLargest = 999'999'999;
      if (!found->is_number_integer() || found->get<std::int64_t>() < 0 || found->get<std::int64_t>() > kLargest)
        fail("library-field", who + ": \"number\" is not a whole number from 0 to 999999999", pointer + "/number");
      else
        tool.number = static_cast<int>(found->get<std::int64_t>());
    }
    if (!tool.number && tool.name.empty())
      fail("library-field", who + " has neither \"number\" nor \"name\"; it needs one to be found by", pointer);
  }

  void read_cuts(const Json& value, const std::string& pointer, const std::string& who, ToolAssembly& tool) {
    if (!value.is_boolean()) return fail("library-field", who + ": \"cuts\" is neither true nor false", pointer);
    tool.cuts = value.get<bool>();
  }

  void read_tool_holder(const Json& value, const std::string& pointer, const std::string& who, ToolAssembly& tool) {
    if (!value.is_string()) {
      tool.holder = read_segments(value, pointer, who + ": holder");
      if (tool.holder.empty()) tool.missing_holder = "its holder has no segments";
      return;
    }
    const std::string name = value.get<std::string>();
    const std::optional<NamedHolder> holder = holder_called(name);
    if (!holder)
      return fail("library-field",
                  who + ": holder \"" + name + "\" is neither among \"holders\" nor an earlier tool with a holder",
                  pointer);
    tool.holder = holder->segments;
    (tool.holder.empty() ? tool.missing_holder : tool.uncertainty) = uncertainty_of_owner(*holder);
  }

  // Returns the holder that ToolLibrary::holder_called finds; that function searches the tools one by one.
  [[nodiscard]] std::optional<NamedHolder> holder_called(const std::string& name) const {
    if (const auto holder = holders_.find(name); holder != holders_.end()) return library_.holders[holder->second];
    const auto found = by_name_.find(name);
    if (found == by_name_.end()) return std::nullopt;
    const ToolAssembly& tool = library_.tools[found->second];
    if (tool.holder.empty()) return std::nullopt;
    return NamedHolder{name, tool.holder, tool.uncertainty};
  }

  void read_cutter(const Json& value, const std::string& pointer, const std::string& tool_name, ToolAssembly& tool) {
    const std::string who = tool_name + ": cutter";
    if (!is_object(value, pointer, who)) return;
    const std::string shape = text(value, "shape", pointer, who);
    std::string names;
    for (const Cutter& known : every_shape()) {
      names += (names.empty() ? "" : ", ") + std::string(shape_name(known));
      if (shape != shape_name(known)) continue;
      tool.cutter = known;
      return read_fields(value, pointer, who, tool.cutter);
    }
    std::vector<std::string> shapes;
    for (const Cutter& known : every_shape()) shapes.emplace_back(shape_name(known));
    const std::string similar = find_similar_name(shape, shapes);
    if (!error_)
      fail("library-field",
           who + ": shape is " + (shape.empty() ? "missing" : "\"" + shape + "\"") + "; expected one of " + names +
               (similar.empty() ? "" : "; did you mean " + similar + "?"),
           pointer + "/shape");
  }

  void read_fields(const Json& value, const std::string& pointer, const std::string& who, Cutter& cutter) {
    std::vector<std::string_view> known{"shape", "comment"};
    detail::visit_fields(cutter, [&](const detail::CutterField& field) {
      known.push_back(field.key);
      const bool is_length = field.kind == detail::FieldKind::length;
      *field.value = is_length ? length(value, field.key, pointer, who, field.otherwise)
                               : number(value, field.key, pointer, who, field.otherwise);
    });
    if (auto* profile = std::get_if<ProfileCutter>(&cutter)) {
      known.push_back("points");
      if (!value.contains("points")) return fail("library-field", who + " has no \"points\"; it needs them", pointer);
      profile->points = read_points(value["points"], pointer + "/points", who);
    }
    warn_unknown_keys(value, pointer, who, known);
  }

  std::vector<ProfilePoint> read_points(const Json& list, const std::string& pointer, const std::string& who) {
    std::vector<ProfilePoint> points;
    if (!is_list(list, pointer, who + ": points")) return points;
    for (std::size_t i = 0; i < list.size() && !error_; ++i) {
      const std::string here = pointer + "/" + std::to_string(i);
      const std::string which = who + ": point " + std::to_string(i + 1);
      if (!is_object(list[i], here, which)) break;
      warn_unknown_keys(list[i], here, which, {"r", "z", "arc", "radius", "comment"});
      ProfilePoint point;
      point.r_mm = length(list[i], "r", here, which);
      point.z_mm = length(list[i], "z", here, which);
      const std::string arc = text(list[i], "arc", here, which);
      if (!arc.empty()) point.radius_mm = length(list[i], "radius", here, which);
      if (arc == "convex")
        point.shape = ProfilePoint::SegmentShape::convex;
      else if (arc == "concave")
        point.shape = ProfilePoint::SegmentShape::concave;
      else if (!arc.empty())
        fail("library-field", which + ": arc is \"" + arc + "\"; expected \"convex\" or \"concave\"", here + "/arc");
      else if (list[i].contains("radius"))
        fail("library-field", which + " has a radius but no \"arc\"; add \"arc\": \"convex\" or \"concave\"", here);
      points.push_back(point);
    }
    return points;
  }

  void read_extensions(const Json& list, const std::string& pointer, const std::string& who, ToolAssembly& tool) {
    if (!is_list(list, pointer, who + ": extensions")) return;
    for (std::size_t i = 0; i < list.size() && !error_; ++i) {
      const std::string here = pointer + "/" + std::to_string(i);
      const std::string which = who + ": extension " + std::to_string(i + 1);
      if (!is_object(list[i], here, which)) return;
      warn_unknown_keys(list[i], here, which, {"name", "counts_as", "segments", "comment"});
      ToolExtension extension{text(list[i], "name", here, which), Body::holder, {}};
      const std::string body = text(list[i], "counts_as", here, which);
      if (body == "shank")
        extension.counts_as = Body::shank;
      else if (!body.empty() && body != "holder")
        fail("library-field", which + ": counts_as is \"" + body + "\"; expected \"shank\" or \"holder\"",
             here + "/counts_as");
      if (!list[i].contains("segments") || list[i]["segments"].empty())
        return fail("library-field", which + " has no \"segments\"; it needs at least one", here);
      extension.segments = read_segments(list[i]["segments"], here + "/segments", which);
      tool.extensions.push_back(std::move(extension));
    }
  }

  void add_tool(ToolAssembly&& tool, const std::string& pointer, const std::string& who) {
    if (const Result<BodyProfiles> bodies = make_body_profiles(tool); !bodies)
      return fail(bodies.error().code, bodies.error().message, pointer);
    if (tool.number && !numbers_.insert(*tool.number).second)
      return fail(
          "library-duplicate-number",
          who + ": number " + std::to_string(*tool.number) + " is already taken; give every tool a number of its own",
          pointer + "/number");
    if (!tool.name.empty() && !by_name_.try_emplace(tool.name, library_.tools.size()).second) {
      library_.shared_names.push_back(tool.name);
      library_.notes.push_back(make_warning(
          "library-duplicate-name", who + " has the name of an earlier tool; asked for by name, the first is taken",
          library_.file, lines_.at(pointer + "/name")));
    }
    if (const double height = height_mm(tool);
        tool.gauge_length_mm > height * (1 + Tolerance::kRounding) && !tool.holder.empty())
      library_.notes.push_back(make_warning("tool-gauge-length",
                                            who + ": gauge_length " + detail::mm(tool.gauge_length_mm) +
                                                " is more than the assembly, which ends at " + detail::mm(height) +
                                                "; what is between is not in the file and not checked",
                                            library_.file, lines_.at(pointer + "/gauge_length")));
    if (const auto* apt = std::get_if<AptCutter>(&tool.cutter))
      if (const std::string reported = apt_contradiction(*apt); !reported.empty())
        library_.notes.push_back(
            make_warning("cutter-contradiction", who + ": " + reported, library_.file, lines_.at(pointer + "/cutter")));
    library_.tools.push_back(std::move(tool));
  }

  JsonLines lines_;
  ToolLibrary library_;
  std::string unknown_key_;                               // the first unknown key of the whole library; empty: none
  std::unordered_set<int> numbers_;                       // tool numbers already in use
  std::unordered_map<std::string, std::size_t> by_name_;  // the first tool of each name
  std::unordered_map<std::string, std::size_t> holders_;  // the first holder of each name
  std::optional<Diagnostic> error_;
};

}  // namespace

Result<ToolLibrary> read_tool_library(const std::string& file, std::string_view bytes) {
  Result<JsonFile> json = parse_json(file, bytes, {"library-syntax", "library-duplicate-key", "a tool library"});
  if (!json) return json.error();
  return Reader(file, std::move(json->lines)).read(json->root);
}

}  // namespace gouge
