#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/cldata/interpreting/uncertainties.h"

namespace gouge {

/// The setups of CAMWorks CLT: ROTABL turns the table, TLAXIS names the setup's Z in model axes. No word states where a
/// setup lies in the model. So the first setup of the file is the frame of its positions, and those of other setups are
/// not checked. Facts that the words state twice must agree. A setup that the file never ends holds to its end.
class CltSetup {
 public:
  CltSetup(StatementContext& in, Uncertainties& uncertainties) : in_(in), uncertainties_(uncertainties) {}

  /// Takes ROTABL/angle,AAXIS,TABLE,CCLW. Turns are undone by the opposite ones, the last one first. Returns false
  /// where another word stands beside its four: then nothing was taken.
  [[nodiscard]] bool take_turn();
  void take_axis();
  /// A feature states its turns itself. Turns that another one has left in force end with it.
  void end_feature();
  /// At a position: several statements before it make the setup.
  void choose_decimals();
  void write_note() const;

 private:
  struct TableTurn {
    std::string_view axis;
    double angle = 0;  // counter-clockwise, as its file counts
  };
  [[nodiscard]] static std::optional<TableTurn> turn_of(std::span<const Argument> arguments);
  [[nodiscard]] Eigen::Matrix3d axes() const;
  void begin();

  StatementContext& in_;
  Uncertainties& uncertainties_;
  std::vector<TableTurn> turns_;              // those in force
  std::optional<Vec3> axis_ = Vec3::UnitZ();  // TLAXIS, in model axes; nothing: not understood
  std::optional<Eigen::Matrix3d> first_;      // of the first position
  std::size_t turned_line_ = 0;               // where that is not the model's
  bool is_new_ = false;                       // since the last position
  std::string_view word_;
  std::size_t line_ = 0;
};

}  // namespace gouge
