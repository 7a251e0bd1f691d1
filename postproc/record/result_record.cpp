#include "postproc/record/result_record.h"

namespace gouge {

std::size_t ResultRecord::listed_motions() const {
  std::size_t digits = 0;
  for (const std::string& text : motions) digits += text.size();
  return digits / kListedDigits;
}

std::string_view ResultRecord::motion(std::size_t move) const {
  return std::string_view(motions[move / kMotionsOfText]).substr(move % kMotionsOfText * kListedDigits, kListedDigits);
}

std::vector<std::string_view> ResultRecord::motion_list() const {
  std::vector<std::string_view> all;
  const std::size_t count = listed_motions();
  all.reserve(count);
  for (std::size_t move = 0; move < count; ++move) all.push_back(motion(move));
  return all;
}

}  // namespace gouge
