#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "tests/laws/loose_statements.h"
#include "tests/laws/motion_expander.h"

// Mastercam NCI for the mutation law's own reader, written from docs/formats/mastercam_nci.md.

namespace gouge::laws {
namespace {

class NciExpander {
 public:
  explicit NciExpander(Expansion& expansion) : out_(expansion) {}

  void pair(std::size_t line, int code, std::string_view text) {
    line_ = line;
    std::vector<double> v;  // those before the first that is no number
    for (const LooseArgument& argument : loose_arguments(text)) {
      if (!argument.number) break;
      v.push_back(*argument.number);
    }
    if (code == 0 || code == 1)
      line_to(v);
    else if (code == 2 || code == 3)
      arc_to(code, v);
    else if (code == 11)
      turn_to(v);
    else if (code >= 1000 && code <= 1002)
      tool(v);
    else if (code == 1014 || code == 1027)
      frame(code, v);
    else if (code == 1018 || code == 1019 || (code < 1000 && code != 4 && code != 80))
      uncertainty("a code that may move or shift");
    else if (code == 1004)
      is_compensated_ = false;
  }

  void uncertainty(const char* why) { out_.uncertainties.push_back({line_, why}); }

 private:
  bool compensate(double value) {
    const int code = static_cast<int>(std::lround(value));
    if (code != 0) is_compensated_ = code != 40 && code != 140;
    if (is_compensated_) uncertainty("a compensated position");
    return !is_compensated_;
  }

  void move_to(const Pose& to, std::optional<CurvePoints> curve = std::nullopt) {
    out_.motions.push_back({line_, at_, to, curve, tool_, std::nullopt});
    at_ = to;
  }

  void line_to(const std::vector<double>& v) {
    if (v.size() < 5) return uncertainty("a line without its fields");
    if (compensate(v[0])) move_to({Vec3(v[1], v[2], v[3]), Vec3::UnitZ()});
  }

  void turn_to(const std::vector<double>& v) {
    if (v.size() < 7) return uncertainty("a five-axis line without its fields");
    const Vec3 tip(v[0], v[1], v[2]), axis = Vec3(v[3], v[4], v[5]) - tip;
    if (axis.norm() < 1e-3 || (v.size() > 8 && v[8] >= 100))
      return uncertainty("an axis or flags that are not understood");
    if (compensate(0)) move_to({tip, axis.normalized()});
  }

  void arc_to(int code, const std::vector<double>& v) {
    if (v.size() < 8 || !at_) return uncertainty("an arc without its fields or its start");
    const double plane = v[0] < 40 && std::abs(v[0]) > 0 ? v[0] : v[1] < 40 ? v[1] : v[0] < 40 ? v[0] : -1;
    const double compensation = v[0] >= 40 ? v[0] : v[1] >= 40 ? v[1] : 0;
    const bool is_yz = std::abs(plane - 1) < 0.5;
    if (plane < 0 || plane > 1 || (v[0] < 40 && v[1] < 40 && std::abs(v[0] * v[1]) > 0))
      return uncertainty("a plane that is not stated");
    if (!compensate(compensation)) return;
    const auto place = [&](double a, double b, double across) {
      return is_yz ? Vec3(across, a, b) : Vec3(a, b, across);
    };
    StatedArc arc;
    arc.center = place(v[4], v[5], v[6]);
    arc.normal = (code == 3 ? 1 : -1) * (is_yz ? Vec3::UnitX() : Vec3::UnitZ());
    const Pose to{place(v[2], v[3], v[6]), Vec3::UnitZ()};
    std::string why;
    const std::optional<CurvePoints> curve = arc_points(arc, at_->tip, to.tip, why);
    if (!curve) return out_.uncertainties.push_back({line_, why});
    const bool is_closed = (at_->tip - to.tip - (at_->tip - to.tip).dot(arc.normal) * arc.normal).norm() < 1e-6;
    if (v.size() > 9 && v[9] > 0 && !is_closed) return uncertainty("a full circle that ends elsewhere");
    move_to(to, curve);
  }

  void tool(const std::vector<double>& v) {
    if (v.size() < 4) return uncertainty("a tool without its number");
    const int number = static_cast<int>(std::lround(v[3]));
    if (tool_ && *tool_ != number) at_.reset();
    tool_ = number;
  }

  void frame(int code, const std::vector<double>& v) {
    constexpr std::array<double, 12> kIdentity{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    bool is_identity = v.size() == (code == 1014 ? 9U : 12U);
    for (std::size_t i = 0; i < v.size() && is_identity; ++i) is_identity = std::abs(v[i] - kIdentity[i]) < 1e-9;
    if (!is_identity) uncertainty("a plane or a system of its own");
  }

  Expansion& out_;
  std::optional<Pose> at_;
  std::optional<int> tool_;
  bool is_compensated_ = false;
  std::size_t line_ = 0;
};

}  // namespace

Expansion expand_nci(std::string_view bytes) {
  Expansion expansion;
  NciExpander expander(expansion);
  int code = -1;  // below 0: a code must come
  const std::vector<std::string_view> lines = physical_lines(bytes);
  for (std::size_t i = 0; i < lines.size() && expansion.uncertainties.empty(); ++i) {
    if (code >= 0) {
      expander.pair(i, code, lines[i]);  // the line of its code
      code = -1;
    } else if (!lines[i].empty()) {
      const std::optional<double> number = loose_number(lines[i]);
      if (!number || lines[i].find_first_not_of("0123456789") != std::string_view::npos)
        expansion.uncertainties.push_back({i + 1, "a line that is no code"});
      else
        code = static_cast<int>(std::lround(*number));
    }
  }
  if (code >= 0) expansion.uncertainties.push_back({lines.size(), "a code without its line"});
  return expansion;
}

}  // namespace gouge::laws
