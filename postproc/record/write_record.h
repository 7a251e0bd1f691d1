#pragma once

#include <string>

#include "postproc/record/result_record.h"

namespace gouge {

/// Returns the text of a result file: the fields of result_fields.h, indented by one blank for each level, and the
/// digest. Lengths are in the unit of the toolpath, and numbers read back exactly. Bytes that are not UTF-8 become
/// U+FFFD. Cost: linear in the text.
[[nodiscard]] std::string write_record(const ResultRecord& record);

}  // namespace gouge
