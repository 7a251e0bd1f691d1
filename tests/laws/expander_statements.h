#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tests/laws/loose_statements.h"
#include "tests/laws/motion_reading.h"

// One statement after the other, for motion_expander.

namespace gouge::laws {

class StatementExpander {
 public:
  StatementExpander(std::string_view dialect, Expansion& expansion) : dialect_(dialect), out_(expansion) {}

  [[nodiscard]] MotionReading& reading() { return now_; }
  void step(const LooseStatement& statement);
  /// `$$*CATIA0`: the statement behind it is the fourth or fifth; index of the last one that was read.
  [[nodiscard]] static bool is_matrix_begun(const LooseStatement& statement);
  [[nodiscard]] std::size_t matrix(const std::vector<LooseStatement>& statements, std::size_t begin);
  void end_of_file();

 private:
  using Arguments = std::vector<LooseArgument>;

  // expander_statements.cpp
  bool is(std::string_view dialect) const { return dialect_ == dialect; }
  void uncertainty(const std::string& why) { out_.uncertainties.push_back({line_, why}); }
  bool numbers(const Arguments& arguments, std::vector<double>& values);
  void word(const LooseStatement& statement);
  void wordless(const LooseStatement& statement);
  void comment(const LooseStatement& statement);
  void interrupt(std::string_view word);
  void contradict_cycle(std::string_view by);
  void begin_section(std::string_view by, bool is_swept_into);

  // expander_states.cpp
  void unit(const Arguments& arguments);
  void multax(const Arguments& arguments);
  void cycle(const Arguments& arguments);
  void cutcom(const Arguments& arguments);
  void tool_number(std::string_view word, const Arguments& arguments);
  void cutter(const std::vector<double>& values, double diameter);
  void tool_data(const LooseStatement& statement);
  void set_frame(const std::vector<double>& v, bool is_third_said);
  void mori_frame(const Arguments& arguments);
  void zeros(const Arguments& arguments, std::size_t words);

  // expander_motions.cpp
  void positions(const std::vector<double>& v);
  void arc(const LooseStatement& statement);
  void chained_line(const LooseStatement& statement);
  void step_by(const std::vector<double>& v);
  void from(const std::vector<double>& v, bool is_home);
  void end_spline();
  bool axis_of_three(Vec3& axis);
  bool pose_of(const double* v, std::size_t count, Pose& pose);
  void move_to(const Pose& to);
  void hole(const Pose& at);
  void emit(const std::optional<Pose>& start, const Pose& to, std::optional<CurvePoints> curve = std::nullopt);

  std::string_view dialect_;
  Expansion& out_;
  MotionReading now_;
  std::size_t line_ = 0;
};

}  // namespace gouge::laws
