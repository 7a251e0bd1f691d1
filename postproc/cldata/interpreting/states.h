#pragma once

#include "lib/base/units.h"
#include "postproc/cldata/interpreting/arc_senses.h"
#include "postproc/cldata/interpreting/axis_state.h"
#include "postproc/cldata/interpreting/block_state.h"
#include "postproc/cldata/interpreting/catia_matrix.h"
#include "postproc/cldata/interpreting/clt_setup.h"
#include "postproc/cldata/interpreting/cutter_compensation.h"
#include "postproc/cldata/interpreting/cycle_state.h"
#include "postproc/cldata/interpreting/described_curve.h"
#include "postproc/cldata/interpreting/doubts.h"
#include "postproc/cldata/interpreting/feed_state.h"
#include "postproc/cldata/interpreting/frame_state.h"
#include "postproc/cldata/interpreting/motion_chain.h"
#include "postproc/cldata/interpreting/nurbs_state.h"
#include "postproc/cldata/interpreting/operation_state.h"
#include "postproc/cldata/interpreting/part_program.h"
#include "postproc/cldata/interpreting/tool_state.h"

namespace gouge {

/// All that a statement may look at or change. Each state says in its own file what holds where the file never ends it.
struct States {
  /// `motion_records` may be null; else it gets one entry for each move.
  States(Toolpath& path, const Dialect& dialect, LengthUnit unit, MotionRecords* motion_records)
      : in(path, dialect), records(motion_records), frame(in, mm_per(unit)) {}
  States(const States&) = delete;
  States& operator=(const States&) = delete;

  StatementContext in;
  MotionRecords* records;
  Doubts doubts;
  AxisState axes{in, doubts};
  FeedState feed{in};
  FrameState frame;
  BlockState blocks;
  CatiaMatrix matrix{in, frame};
  CltSetup setup{in, doubts};
  CutterCompensation cutcom{in};
  DescribedCurve curve{in};
  NurbsState nurbs{in, frame, axes};
  ArcSenses senses{in};
  CycleState cycle{in};
  ToolState tool{in, doubts};
  OperationState operation{in};
  MotionChain chain{in};
  PartProgram program{in};
  Tally offsets_chosen;                    ///< by text for the machine's control
  bool has_end = false;                    ///< END or FINI
  std::size_t run_begin = 0;               ///< the first move since the last tool or operation
  Word previous_word = Word::comment;      ///< of the statement before, but for comments
  std::size_t previous_statement = kNone;  ///< that word's
};

}  // namespace gouge
