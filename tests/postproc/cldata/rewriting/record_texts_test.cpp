#include "postproc/cldata/rewriting/list_written.h"

#include <gtest/gtest.h>

#include "tests/postproc/cldata/corrected.h"
#include "tests/postproc/cldata/path_of.h"

namespace gouge::record_texts_test {
namespace {

struct Texts {
  Toolpath before, after;
  std::vector<PathChange> changes;
  RecordTexts texts;

  Texts(const std::string& text, std::vector<PathChange> of)
      : before(path_of(text)),
        after(path_of(written(before, of))),
        changes(std::move(of)),
        texts(before, changes, after, list_written(before, changes, after)) {}
};

using Text = std::optional<std::string_view>;

const std::string kText =
    "LOADTL/1\nFEDRAT/100,MMPM\nGOTO/0.,0.,0.\nPPRINT one\nGOTO/10.,0.,0.\nGOTO/20.,0.,0.\nFINI\n";

TEST(RecordTexts, OfAMovedPositionAreItsStatementBeforeAndAfter) {
  const Toolpath path = path_of(kText);
  const Texts moved(kText, {lift(path, 1, 2)});
  EXPECT_EQ(moved.texts.before(1), Text("GOTO/10.,0.,0.\n"));
  EXPECT_EQ(moved.texts.after(1, 0), Text("GOTO/10.,0.,2.\n"));
  EXPECT_EQ(moved.texts.after(1), Text("GOTO/10.,0.,2.\n"));
  EXPECT_EQ(moved.texts.after(2), Text("GOTO/20.,0.,0.\n"));
}

TEST(RecordTexts, OfInsertedPositionsAreTheirOwnWithWhatStandsBeforeThem) {
  const Toolpath path = path_of(kText);
  PathChange change = lift(path, 1, 2);
  change.inserted_before = {{Vec3(0, 0, 2), Vec3::UnitZ()}, {Vec3(5, 0, 2), Vec3::UnitZ()}};
  change.at_rapid = {false, true, false};
  const Texts inserted(kText, {change});
  EXPECT_EQ(inserted.texts.after(1, 0), Text("GOTO/0.,0.,2.\n")) << "PPRINT before it is as it was";
  EXPECT_EQ(inserted.texts.after(1, 1), Text("RAPID\nGOTO/5.,0.,2.\n"));
  EXPECT_EQ(inserted.texts.after(1, 2), Text("GOTO/10.,0.,2.\n"));
  EXPECT_EQ(inserted.texts.after(1), Text("GOTO/0.,0.,2.\nRAPID\nGOTO/5.,0.,2.\nGOTO/10.,0.,2.\n"));
  EXPECT_EQ(inserted.texts.before(1), Text("GOTO/10.,0.,0.\n"));
}

// MULTAX/ON and MULTAX/OFF about a position with an axis, in a file that states none.
TEST(RecordTexts, OfAPositionInAFrameHoldAllOfIt) {
  PathChange tilted;
  tilted.move = 1;
  tilted.new_end = Pose{Vec3(10, 0, 1), Vec3(0.6, 0, 0.8)};
  const Texts framed(kText, {tilted});
  const Text text = framed.texts.after(1, 0);
  ASSERT_TRUE(text);
  EXPECT_TRUE(text->starts_with("MULTAX/ON\nGOTO/10.")) << *text;
  EXPECT_TRUE(text->ends_with("MULTAX/OFF\n")) << *text;
}

}  // namespace
}  // namespace gouge::record_texts_test
