#include "toolmodels/import/catalogue_tool.h"

#include <algorithm>
#include <cmath>

namespace gouge {
namespace {

using enum Dimension;

// Lengths that differ by less than this are one length, rounded differently.
constexpr double kSameShape_mm = 1e-4;

Diagnostic guess(const std::string& message) { return make_note("import-guess", message); }

Diagnostic field(const std::string& message) { return make_error("import-field", message); }

// The height above the tip at which the holder begins.
struct Stickout {
  double length_mm = 0;
  std::string text;  ///< "LB 40 mm"
};

Result<Stickout> find_stickout(const CatalogueTool& tool, const ImportOptions& options, bool has_holder,
                               Diagnostics& notes) {
  const Dimensions& d = tool.dimensions;
  if (d.value_or(body_length, 0) > 0) {
    const bool differs = options.stickout_mm && std::abs(*options.stickout_mm - d[body_length]->value) > kSameShape_mm;
    if (differs) notes.push_back(guess("--stickout has no effect: the file states " + d.text(body_length)));
    return Stickout{d[body_length]->value, d.text(body_length)};
  }
  if (options.stickout_mm) return Stickout{*options.stickout_mm, "--stickout " + mm_text(*options.stickout_mm)};
  if (has_holder)
    return make_error("import-stickout",
                      "has a holder, but the file does not say how far the tool stands out of it; give --stickout");
  const Dimension known = d.value_or(overall_length, 0) > 0 ? overall_length : flute_length;
  if (!d[known]) return field("the file gives no length of the tool; it needs one");
  notes.push_back(guess("no length below the holder is given; drawn up to " + d.text(known) + ", without a holder"));
  return Stickout{d[known]->value, d.text(known)};
}

Outcome check_lengths(const Dimensions& d, const Stickout& stickout) {
  const double overall = d.value_or(overall_length, 0), flutes = d.value_or(flute_length, 0);
  if (overall > 0 && flutes > overall + kSameShape_mm)
    return field(d.text(flute_length) + " is greater than " + d.text(overall_length) +
                 "; the flutes cannot be longer than the tool");
  if (overall > 0 && stickout.length_mm > overall + kSameShape_mm)
    return field(stickout.text + " is greater than " + d.text(overall_length) +
                 "; the tool would not reach its holder");
  if (flutes > stickout.length_mm + kSameShape_mm)
    return field(d.text(flute_length) + " is greater than " + stickout.text +
                 "; the holder would swallow a part of the flutes");
  return Done{};
}

double diameter_at(const ToolSegment& s, double height_mm) {
  return s.lower_diameter_mm + (s.upper_diameter_mm - s.lower_diameter_mm) * (height_mm / s.length_mm);
}

// Adds the taper angle that follows from an entering angle, which is measured from the tip plane instead of the axis.
Dimensions with_taper(Dimensions d) {
  const double entering = d.value_or(entering_angle, 0);
  if (entering > 0 && entering < 90 && !(d.value_or(taper_angle, 0) > 0))
    d.set(taper_angle, 90 - entering, "90 - " + d[entering_angle]->key);
  return d;
}

// Adds the flute length of a drill whose format has none: up to the end of the tool, or to the holder. The result is
// the largest tool that it can be, unless a wider body stands on the flutes.
Dimensions with_flutes(const CatalogueTool& tool, bool has_holder, const ImportOptions& options, Diagnostics& notes) {
  Dimensions d = tool.dimensions;
  const bool is_open = tool.shape == CatalogueShape::drill && !d[flute_length] && tool.shaft.empty();
  const double width = d.value_or(diameter, 0) + kSameShape_mm;
  if (!is_open || d.value_or(shank_diameter, 0) > width || d.value_or(shoulder_diameter, 0) > width) return d;
  Diagnostics ignored;
  const Result<Stickout> stickout = find_stickout(tool, options, has_holder, ignored);
  if (!stickout || !(stickout->length_mm > 0)) return d;
  d.set(flute_length, stickout->length_mm, "assumed flute length");
  notes.push_back(make_warning("import-guess", "no flute length is given; the flutes are taken to reach up to " +
                                                   stickout->text + ", the whole length of the drill"));
  return d;
}

class ShankBuilder {
 public:
  ShankBuilder(const CatalogueTool& tool, const CatalogueCutter& cutter, Diagnostics& notes)
      : tool_(tool), notes_(notes), z_(length_mm(cutter.cutter)), diameter_(cutter.top_diameter_mm) {}

  [[nodiscard]] double z() const { return z_; }

  Result<std::vector<ToolSegment>> build(const Stickout& stickout) {
    add_shoulder(stickout.length_mm);
    if (Outcome good = add_shaft(stickout); !good) return good.error();
    add_rest(stickout);
    return std::move(segments_);
  }

 private:
  void push(const ToolSegment& s) {
    segments_.push_back(s);
    z_ += s.length_mm;
    diameter_ = s.upper_diameter_mm;
  }

  void add_shoulder(double top_mm) {
    const Dimensions& d = tool_.dimensions;
    const double end = std::min(d.value_or(shoulder_length, 0), top_mm);
    if (end <= z_ + kSameShape_mm) return;
    const double given = d.value_or(shoulder_diameter, 0);
    const double width = given > 0 ? given : diameter_;
    push({width, width, end - z_});
  }

  Outcome add_shaft(const Stickout& stickout) {
    for (std::size_t i = 0; i < tool_.shaft.size(); ++i) {
      const ToolSegment& s = tool_.shaft[i];
      if (!(s.length_mm > 0 && s.lower_diameter_mm > 0 && s.upper_diameter_mm > 0))
        return field("shaft segment " + std::to_string(i + 1) + " has a length or a diameter that is not above 0");
      const double room = stickout.length_mm - z_;
      if (room <= kSameShape_mm) {
        notes_.push_back(
            guess("its shaft goes on above " + stickout.text + "; that part is in the holder and left out"));
        break;
      }
      if (s.length_mm > room + kSameShape_mm)
        push({s.lower_diameter_mm, diameter_at(s, room), room});
      else
        push(s);
    }
    return Done{};
  }

  void add_rest(const Stickout& stickout) {
    const double room = stickout.length_mm - z_;
    if (room <= kSameShape_mm) return;
    double width = tool_.dimensions.value_or(shank_diameter, 0);
    if (!(width > 0)) {
      width = diameter_;
      notes_.push_back(guess("no shank diameter is given; taken as " + mm_text(width) + ", as wide as below"));
    }
    push({width, width, room});
  }

  const CatalogueTool& tool_;
  Diagnostics& notes_;
  double z_;
  double diameter_;
  std::vector<ToolSegment> segments_;
};

}  // namespace

Result<ToolAssembly> make_catalogue_tool(const CatalogueTool& given, const ImportOptions& options, Diagnostics& notes) {
  CatalogueTool tool = given;
  tool.dimensions = with_flutes(given, !given.holder.empty() || !options.holder.empty(), options, notes);
  ToolAssembly made;
  made.number = tool.number;
  made.name = tool.name;
  made.holder = tool.holder.empty() ? options.holder : tool.holder;
  const Result<CatalogueCutter> cutter = make_catalogue_cutter(tool.shape, with_taper(tool.dimensions), notes);
  if (!cutter) return cutter.error();
  made.cutter = cutter->cutter;
  made.cuts = tool.shape != CatalogueShape::probe;
  if (!made.cuts) notes.push_back(guess("a probe; it removes no stock"));
  const Result<Stickout> stickout = find_stickout(tool, options, !made.holder.empty(), notes);
  if (!stickout) return stickout.error();
  if (Outcome good = check_lengths(tool.dimensions, *stickout); !good) return good.error();
  ShankBuilder builder(tool, *cutter, notes);
  if (builder.z() > stickout->length_mm + kSameShape_mm)
    return field("the flutes reach up to " + mm_text(builder.z()) + ", more than " + stickout->text +
                 "; the holder would swallow a part of them");
  Result<std::vector<ToolSegment>> shank = builder.build(*stickout);
  if (!shank) return shank.error();
  made.shank = std::move(*shank);
  if (const Result<BodyProfiles> bodies = make_body_profiles(made); !bodies) return bodies.error();
  return made;
}

}  // namespace gouge
