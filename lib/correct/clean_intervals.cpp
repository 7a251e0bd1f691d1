#include "lib/correct/clean_intervals.h"

#include <algorithm>

namespace gouge {
namespace {

constexpr int kBorderHalvings = 5;
constexpr double kPiece = 1.0 / (1 << kBorderHalvings);  // length of the shortest piece that is searched between
                                                         // gouges,
constexpr double kPiece_mm = 0.25;                       // unless this length is longer
constexpr int kBisections = 14;                          // number of halvings that find the end of a clean interval
constexpr double kExact_mm = 0.01;                       // accuracy of that end
constexpr double kArm_mm = 10;                           // lever at which a turn of the axis counts as a distance

class IntervalSearch {
 public:
  IntervalSearch(const Motion& motion, const IsCleanBetween& is_clean) : motion_(motion), is_clean_(is_clean) {}

  std::vector<TimeInterval> run() {
    collect(0, 1);
    // An end of the motion that is itself clean begins an interval, even a very short one.
    if ((found_.empty() || found_.front().first > 0) && is_clean_(0, 0)) found_.insert(found_.begin(), {0, 0});
    if ((found_.empty() || found_.back().last < 1) && is_clean_(1, 1)) found_.push_back({1, 1});
    for (std::size_t k = 0; k < found_.size(); ++k) {
      TimeInterval& interval = found_[k];
      const double low = k > 0 ? found_[k - 1].last : 0.0;
      const double high = k + 1 < found_.size() ? found_[k + 1].first : 1.0;
      interval = {last_clean(interval.first, low), last_clean(interval.last, high)};
    }
    return std::move(found_);
  }

 private:
  void collect(double first, double last) {
    if (is_clean_(first, last)) {
      if (!found_.empty() && found_.back().last >= first) {
        found_.back().last = last;
      } else {
        found_.push_back({first, last});
      }
      return;
    }
    if (last - first <= kPiece || travel_mm(first, last) <= kPiece_mm) return;
    const double middle = 0.5 * (first + last);
    collect(first, middle);
    collect(middle, last);
  }

  [[nodiscard]] double travel_mm(double first, double last) const {
    const Pose a = motion_.at(first), b = motion_.at(last);
    return (b.tip - a.tip).norm() + kArm_mm * (b.axis - a.axis).norm();
  }

  [[nodiscard]] double last_clean(double from, double towards) const {
    double good = from, bad = towards;
    for (int k = 0; k < kBisections; ++k) {
      if (travel_mm(good, bad) < kExact_mm) break;
      const double t = 0.5 * (good + bad);
      (is_clean_(std::min(good, t), std::max(good, t)) ? good : bad) = t;
    }
    return good;
  }

  const Motion& motion_;
  const IsCleanBetween& is_clean_;
  std::vector<TimeInterval> found_;
};

}  // namespace

std::vector<TimeInterval> find_clean_intervals(const Motion& motion, const IsCleanBetween& is_clean) {
  return IntervalSearch(motion, is_clean).run();
}

}  // namespace gouge
