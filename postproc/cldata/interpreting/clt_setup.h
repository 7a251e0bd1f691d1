#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/cldata/interpreting/uncertainties.h"

namespace gouge {

/// The setups of CAMWorks CLT: ROTABL turns the table, and TLAXIS states the Z axis of the setup in the axes of the
/// model. No word states the place of a setup in the model. So the first setup of the file is the frame of its
/// positions, and positions of other setups are not checked. Facts that are stated twice must agree. A setup that the
/// file never ends holds until its end.
class CltSetup {
 public:
  CltSetup(StatementContext& in, Uncertainties& uncertainties) : in_(in), uncertainties_(uncertainties) {}

  /// Takes ROTABL/angle,AAXIS,TABLE,CCLW. Opposite turns undo turns, the last one first. Returns false and takes
  /// nothing if the statement has other words than these four.
  [[nodiscard]] bool take_turn();
  void take_axis();
  /// Ends a feature and all turns that it left in force. Each feature states its own turns.
  void end_feature();
  /// Evaluates the setup at a position, because several statements before it make the setup.
  void settle();
  void write_note() const;

 private:
  struct TableTurn {
    std::string_view axis;
    double angle = 0;  // counter-clockwise, as the file counts it
  };
  [[nodiscard]] static std::optional<TableTurn> turn_of(std::span<const Argument> arguments);
  [[nodiscard]] Eigen::Matrix3d axes() const;
  void begin();

  StatementContext& in_;
  Uncertainties& uncertainties_;
  std::vector<TableTurn> turns_;              // turns in force
  std::optional<Vec3> axis_ = Vec3::UnitZ();  // TLAXIS, in the axes of the model; nothing: not understood
  std::optional<Eigen::Matrix3d> first_;      // axes of the setup at the first position
  std::size_t turned_line_ = 0;               // line of the first setup if its axes are not those of the model
  bool is_new_ = false;                       // changed since the last position
  std::string_view word_;
  std::size_t line_ = 0;
};

}  // namespace gouge
