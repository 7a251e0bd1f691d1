#include "postproc/cldata/nccs/nccs_sink.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

constexpr double kLongestSweep_rad = 2.5;  // clearly less than half a turn, so that the opposite arc is longer
constexpr double kShortestChord_mm = 0.01;
constexpr double kCircleKind = 5;  // the first of the five words before the numbers of a circle
constexpr std::size_t kHeaderWords = 16, kNameWords = 8, kProgramWord = 12;

struct PostCode {
  static constexpr std::uint16_t kRetrct = 7, kGohome = 14, kCutcom = 1007, kFedrat = 1009, kSpindl = 1031,
                                 kPprint = 1044, kLoadtl = 1055;
};
constexpr std::uint16_t kOn = 71, kOff = 72;

std::uint16_t minor_code(CutcomSide side) {
  constexpr std::uint16_t kLeft = 8, kRight = 24;
  constexpr std::array<std::uint16_t, 4> kCodes = {kOff, kLeft, kRight, kOn};
  return kCodes[static_cast<std::size_t>(side)];
}

// Returns `text` in whole words, filled with blanks.
std::string text_words(std::string text, std::size_t words) {
  text.resize(words * kNccsWordBytes, ' ');
  return text;
}

}  // namespace

NccsSink::NccsSink(LengthUnit unit, const std::string& name) : unit_(unit) {
  std::string header = text_words(name, kNameWords) + text_words("", kProgramWord - kNameWords);
  header += text_words("NCLCAM     2019.00", kHeaderWords - kProgramWord);
  add(NccsClass::kHeader, 0, header);
  add(NccsClass::kMode, 0, {});
}

void NccsSink::add(std::uint16_t klass, std::uint16_t subclass, const std::string& words) {
  const auto count = static_cast<std::uint16_t>(1 + words.size() / kNccsWordBytes);
  words_ += nccs_word(NccsHeader{count, klass, subclass, ++sequence_}) + words;
}

void NccsSink::begin_operation(const std::string& name) {
  add(NccsClass::kPost, PostCode::kPprint, text_words(name, (name.size() + kNccsWordBytes - 1) / kNccsWordBytes));
}

// Writes the number before the cutter, because a number that occurred before restores its old cutter.
void NccsSink::change_tool(const PathTool& tool) {
  if (tool.number) add(NccsClass::kPost, PostCode::kLoadtl, nccs_word(static_cast<double>(*tool.number)));
  if (!tool.cutter) return;
  const CutterStatement& c = *tool.cutter;
  const double factor = mm_per(unit_);
  const bool leans = std::abs(c.beta_deg) > 0;
  const double d_mm = leans ? 2 * (c.e_mm + c.r_mm) : c.d_mm;
  std::string words = nccs_word(d_mm / factor) + nccs_word(c.r_mm / factor) + nccs_word(c.h_mm / factor);
  if (leans) words += nccs_word(c.beta_deg);
  add(NccsClass::kTool, 6, words);
}

bool NccsSink::break_motion() {
  add(NccsClass::kPost, PostCode::kGohome, {});
  return true;
}

bool NccsSink::set_cutcom(CutcomSide side) {
  add(NccsClass::kPost, PostCode::kCutcom, nccs_word(NccsHeader{minor_code(side), 0, 0, 0}));
  return true;
}

void NccsSink::retract() { add(NccsClass::kPost, PostCode::kRetrct, {}); }

// Writes the feed without a unit, as NCL does. The unit is written from the first feed per revolution on.
bool NccsSink::set_feed(const Feed& feed) {
  constexpr std::uint16_t kIpm = 73, kIpr = 74, kMmpm = 315, kMmpr = 316;
  const bool is_inch = unit_ == LengthUnit::inch;
  const bool is_per_turn = feed.unit == FeedUnit::per_revolution;
  has_feed_per_turn_ = has_feed_per_turn_ || is_per_turn;
  std::string words = nccs_word(feed.mm / mm_per(unit_));
  const std::uint16_t code = is_per_turn ? (is_inch ? kIpr : kMmpr) : (is_inch ? kIpm : kMmpm);
  if (has_feed_per_turn_) words += nccs_word(NccsHeader{code, 0, 0, 0});
  add(NccsClass::kPost, PostCode::kFedrat, words);
  return true;
}

void NccsSink::stop_spindle(bool is_stopped) {
  add(NccsClass::kPost, PostCode::kSpindl, nccs_word(NccsHeader{is_stopped ? kOff : kOn, 0, 0, 0}));
}

bool NccsSink::make_rapid() {
  add(NccsClass::kPost, NccsSubclass::kRapid, {});
  return true;
}

void NccsSink::go_to(const Pose& end) {
  std::string words;
  for (Eigen::Index i = 0; i < 3; ++i) words += nccs_word(end.tip[i] / mm_per(unit_));
  for (Eigen::Index i = 0; i < 3; ++i) words += nccs_word(end.axis[i]);
  add(NccsClass::kMotion, 5, words);
}

// Writes a planar arc with one tool axis if it is the shorter of both arcs. The record does not state the sense.
bool NccsSink::go_round(const PathArc& arc, const Pose& start, const Pose& end) {
  const Vec3 radial = start.tip - arc.center;
  const bool is_planar = std::abs(radial.dot(arc.axis)) <= Tolerance::kWitness_mm &&
                         std::abs((end.tip - start.tip).dot(arc.axis)) <= Tolerance::kWitness_mm;
  const bool keeps_axis = (start.axis - end.axis).cwiseAbs().maxCoeff() <= kSameNccsAxis;
  const bool is_short =
      std::abs(arc.sweep_rad) <= kLongestSweep_rad && (end.tip - start.tip).norm() >= kShortestChord_mm;
  if (!is_planar || !keeps_axis || !is_short) return false;
  std::string words = nccs_word(kCircleKind) + std::string(4 * kNccsWordBytes, '\0');
  for (Eigen::Index i = 0; i < 3; ++i) words += nccs_word(arc.center[i] / mm_per(unit_));
  for (Eigen::Index i = 0; i < 3; ++i) words += nccs_word(arc.axis[i]);
  words += nccs_word(radial.norm() / mm_per(unit_));
  add(NccsClass::kCircle, 0, words);
  go_to(end);
  return true;
}

std::string NccsSink::finish() {
  add(NccsClass::kFini, 0, {});
  return nccs_blocks(words_);
}

std::unique_ptr<MotionSink> make_nccs_sink(const SinkOptions& options) {
  return std::make_unique<NccsSink>(options.unit, options.name);
}

}  // namespace gouge
