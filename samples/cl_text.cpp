#include "samples/cl_text.h"

#include "lib/base/number_text.h"

namespace gouge::samples {
namespace {

std::string joined(const Vec3& v, int decimals, std::string_view separator) {
  std::string out = fixed_text(v.x(), decimals);
  out.append(separator).append(fixed_text(v.y(), decimals));
  out.append(separator).append(fixed_text(v.z(), decimals));
  return out;
}

}  // namespace

void ClText::line(std::string_view text) {
  text_.append(text).push_back('\n');
  ++lines_;
}

std::size_t ClText::feed(const Pose& pose) {
  const Pose local = to_block_.pose(pose);
  std::string goto_line;
  if (form_ == Form::nx) {
    goto_line = "GOTO/" + joined(local.tip, 4, ",");
    const std::string axis = joined(local.axis, 7, ",");
    if (axis != last_axis_) goto_line += "," + axis;
    last_axis_ = axis;
  } else {
    goto_line = "GOTO/ " + joined(local.tip, 5, ", ");
    if (form_ == Form::apt) goto_line += ", " + joined(local.axis, 7, ", ");
  }
  line(goto_line);
  ++positions_;
  return lines_;
}

std::size_t ClText::rapid(const Pose& pose) {
  line("RAPID");
  return feed(pose);
}

}  // namespace gouge::samples
