#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "toolmodels/tool_library.h"

namespace gouge {
namespace {

using nlohmann::json;

/// Reads the document and keeps the first error; what follows it is not looked at.
class LibraryReader {
 public:
  LibraryReader(const std::string& file, ToolLibrary& library) : file_(file), library_(library) {}

  std::optional<Diagnostic> read(const json& document) {
    if (!document.is_object()) fail("the file", "expected an object with \"units\" and \"tools\"");
    if (error_) return error_;
    read_unit(document);
    know(document, "the file", {"units", "tools", "holders", "$schema", "comment"});
    const json& tools = member(document, "the file", "tools", &json::is_array, "a list");
    for (std::size_t i = 0; i < tools.size() && !error_; ++i) read_tool(tools[i], i);
    if (document.contains("holders") && !error_) read_holders(document["holders"]);
    if (!error_ && library_.tools.empty() && library_.holders.empty()) {
      error_ = make_error("library-empty", "\"tools\" is empty; expected at least one tool", file_);
    }
    return error_;
  }

 private:
  void fail(const std::string& where, const std::string& what) {
    if (!error_) error_ = make_error("library-field", where + ": " + what, file_);
  }

  const json& member(const json& object, const std::string& where, const char* key,
                     bool (json::*is)() const noexcept, const char* expected) {
    static const json kNothing = json::array();
    if (!object.contains(key)) {
      fail(where, std::string("\"") + key + "\" is missing; expected " + expected);
    } else if (!(object[key].*is)()) {
      fail(where,
           std::string("\"") + key + "\" is " + object[key].dump().substr(0, 40) + "; expected " + expected);
    } else {
      return object[key];
    }
    return kNothing;
  }

  double number(const json& object, const std::string& where, const char* key) {
    const json& value = member(object, where, key, &json::is_number, "a number");
    return error_ ? 0.0 : value.get<double>();
  }

  double length(const json& object, const std::string& where, const char* key) {
    return number(object, where, key) * mm_per(library_.unit);
  }

  double optional_length(const json& object, const std::string& where, const char* key) {
    return object.contains(key) ? length(object, where, key) : 0.0;
  }

  double optional_number(const json& object, const std::string& where, const char* key) {
    return object.contains(key) ? number(object, where, key) : 0.0;
  }

  void know(const json& object, const std::string& where, const std::vector<std::string_view>& keys) {
    for (const auto& [key, value] : object.items()) {
      if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
      library_.notes.push_back(make_warning(
          "library-unknown-key", where + ": \"" + key + "\" is not known and has no effect", file_));
    }
  }

  void read_unit(const json& document) {
    const json& unit = member(document, "the file", "units", &json::is_string, "\"mm\" or \"inch\"");
    if (error_) return;
    if (unit == "mm") {
      library_.unit = LengthUnit::mm;
    } else if (unit == "inch") {
      library_.unit = LengthUnit::inch;
    } else {
      fail("the file", "\"units\" is " + unit.dump() + "; expected \"mm\" or \"inch\"");
    }
  }

  void read_tool(const json& entry, std::size_t index) {
    ToolAssembly tool;
    std::string where = "tool " + std::to_string(index + 1);
    if (!entry.is_object()) return fail(where, "expected an object");
    if (entry.contains("name")) tool.name = text(entry, where, "name");
    if (entry.contains("number")) tool.number = static_cast<int>(whole(entry, where, "number"));
    if (error_) return;
    if (!tool.number && tool.name.empty())
      return fail(where, "has neither \"number\" nor \"name\"; give at least one");
    where = label(tool);
    know(entry, where, {"number", "name", "cutter", "shank", "holder", "comment"});
    read_cutter(member(entry, where, "cutter", &json::is_object, "an object"), where + ": cutter",
                tool.cutter);
    if (entry.contains("shank")) tool.shank = segments(entry["shank"], where + ": shank");
    if (entry.contains("holder")) tool.holder = segments(entry["holder"], where + ": holder");
    if (error_) return;
    if (tool.number && library_.with_number(*tool.number) != nullptr) {
      error_ = make_error("library-duplicate-number",
                          where + ": number " + std::to_string(*tool.number) +
                              " is given to an earlier tool too; numbers must differ",
                          file_);
      return;
    }
    const Result<Profile> profile = make_profile(tool);
    if (!profile) {
      error_ = profile.error();
      error_->file = file_;
      return;
    }
    library_.tools.push_back(std::move(tool));
  }

  std::string text(const json& object, const std::string& where, const char* key) {
    const json& value = member(object, where, key, &json::is_string, "a text");
    return error_ ? std::string() : value.get<std::string>();
  }

  long long whole(const json& object, const std::string& where, const char* key) {
    const json& value = member(object, where, key, &json::is_number_integer, "a whole number");
    if (error_) return 0;
    const long long n = value.get<long long>();
    if (n < 0 || n > 1'000'000'000)
      fail(where, std::string("\"") + key + "\" is out of range; expected 0 to 1000000000");
    return n;
  }

  void read_cutter(const json& c, const std::string& where, Cutter& cutter) {
    if (error_) return;
    const std::string shape = text(c, where, "shape");
    if (error_) return;
    if (shape == "flat") {
      cutter = FlatCutter{length(c, where, "diameter"), length(c, where, "length")};
      know(c, where, {"shape", "diameter", "length"});
    } else if (shape == "ball") {
      cutter = BallCutter{length(c, where, "diameter"), length(c, where, "length")};
      know(c, where, {"shape", "diameter", "length"});
    } else if (shape == "bull_nose") {
      cutter = BullNoseCutter{length(c, where, "diameter"), length(c, where, "corner_radius"),
                              length(c, where, "length")};
      know(c, where, {"shape", "diameter", "corner_radius", "length"});
    } else if (shape == "tapered") {
      cutter = TaperedCutter{length(c, where, "diameter"), optional_length(c, where, "corner_radius"),
                             number(c, where, "taper_angle"), length(c, where, "length")};
      know(c, where, {"shape", "diameter", "corner_radius", "taper_angle", "length"});
    } else if (shape == "apt") {
      cutter = AptCutter{length(c, where, "d"),
                         optional_length(c, where, "r"),
                         optional_length(c, where, "e"),
                         optional_length(c, where, "f"),
                         optional_number(c, where, "alpha"),
                         optional_number(c, where, "beta"),
                         length(c, where, "h")};
      know(c, where, {"shape", "d", "r", "e", "f", "alpha", "beta", "h"});
    } else {
      fail(where, "shape \"" + shape + "\" is not known; expected flat, ball, bull_nose, tapered or apt");
    }
  }

  std::vector<ToolSegment> segments(const json& list, const std::string& where) {
    std::vector<ToolSegment> result;
    if (!list.is_array()) fail(where, "expected a list of segments");
    for (std::size_t i = 0; i < list.size() && !error_; ++i) {
      const std::string here = where + " " + std::to_string(i + 1);
      if (!list[i].is_object()) fail(here, "expected an object");
      if (error_) break;
      know(list[i], here, {"lower_diameter", "upper_diameter", "length"});
      result.push_back({length(list[i], here, "lower_diameter"), length(list[i], here, "upper_diameter"),
                        length(list[i], here, "length")});
    }
    return result;
  }

  void read_holders(const json& list) {
    if (!list.is_array()) return fail("\"holders\"", "expected a list");
    for (std::size_t i = 0; i < list.size() && !error_; ++i) {
      const std::string where = "holder " + std::to_string(i + 1);
      if (!list[i].is_object()) return fail(where, "expected an object");
      NamedHolder holder;
      holder.name = text(list[i], where, "name");
      know(list[i], where, {"name", "segments", "comment"});
      holder.segments = segments(member(list[i], where, "segments", &json::is_array, "a list"), where);
      if (!error_) library_.holders.push_back(std::move(holder));
    }
  }

  const std::string& file_;
  ToolLibrary& library_;
  std::optional<Diagnostic> error_;
};

std::size_t line_of(std::string_view bytes, std::size_t at) {
  const std::string_view before = bytes.substr(0, std::min(at, bytes.size()));
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

}  // namespace

Result<ToolLibrary> read_tool_library(const std::string& file, std::string_view bytes) {
  ToolLibrary library;
  library.file = file;
  try {
    const json document = json::parse(bytes);
    if (auto error = LibraryReader(file, library).read(document)) return *error;
  } catch (const json::parse_error& error) {
    return make_error("library-syntax",
                      "is not valid JSON here; expected a tool library (docs/formats/tool_library.md)", file,
                      line_of(bytes, error.byte));
  } catch (const json::exception& error) {
    return make_error("library-field", std::string("cannot be understood: ") + error.what(), file);
  }
  return library;
}

}  // namespace gouge
