#include "postproc/program/edits.h"

namespace gouge {

std::string apply_edits(std::string_view source, const Edits& edits) {
  std::size_t size = source.size();
  for (const Edit& edit : edits) size += edit.text.size();
  std::string result;
  result.reserve(size);
  std::size_t copied = 0;
  for (const Edit& edit : edits) {
    result += source.substr(copied, edit.first_byte - copied);
    result += edit.text;
    copied = edit.last_byte;
  }
  result += source.substr(copied);
  return result;
}

}  // namespace gouge
