#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "postproc/cldata/nccs/nccs_records.h"

namespace gouge {

/// A minor word by its code, as an argument of a post-processor record.
struct Minor {
  std::uint16_t code = 0;
};

/// Writes the bytes of binary NCCS files record by record, independent of the sink that converts paths to them.
class NccsFile {
 public:
  using Argument = std::variant<double, Minor>;

  NccsFile() { record(7400, 0, std::string(128, ' ')); }

  NccsFile& record(std::uint16_t klass, std::uint16_t subclass, const std::string& data = {}) {
    words_ +=
        nccs_word(NccsHeader{static_cast<std::uint16_t>(1 + data.size() / 8), klass, subclass, ++sequence_}) + data;
    return *this;
  }

  NccsFile& numbers(std::uint16_t klass, std::uint16_t subclass, const std::vector<double>& values) {
    std::string data;
    for (const double value : values) data += nccs_word(value);
    return record(klass, subclass, data);
  }

  /// A word's two halves in the middle are not set: here they hold what would be letters.
  NccsFile& post(std::uint16_t subclass, const std::vector<Argument>& arguments = {}) {
    std::string data;
    for (const Argument& argument : arguments) {
      const Minor* word = std::get_if<Minor>(&argument);
      data += word != nullptr ? nccs_word(NccsHeader{word->code, 0x4141, 0x5a5a, 0})
                              : nccs_word(std::get<double>(argument));
    }
    return record(2000, subclass, data);
  }

  NccsFile& multax(bool is_on) { return record(9000, is_on ? 0 : 1); }

  /// Records of at most `most` numbers each: the first GOTO, the others its continuations.
  NccsFile& points(const std::vector<double>& values, std::size_t most = 120) {
    for (std::size_t at = 0; at < values.size(); at += most) {
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(at);
      numbers(5000, at == 0 ? 5 : 6, {begin, begin + static_cast<std::ptrdiff_t>(std::min(most, values.size() - at))});
    }
    return *this;
  }

  NccsFile& circle(const std::vector<double>& seven) {
    std::vector<double> values = {5, 0, 0, 0, 0};
    values.insert(values.end(), seven.begin(), seven.end());
    return numbers(3000, 0, values);
  }

  /// `sixes`: position and axis of each point; the other vectors are distinguished from them.
  NccsFile& expanded(const std::vector<double>& sixes, std::uint16_t subclass = 5) {
    std::vector<double> values;
    for (std::size_t at = 0; at < sixes.size(); at += 6) {
      values.insert(values.end(), sixes.begin() + static_cast<std::ptrdiff_t>(at),
                    sixes.begin() + static_cast<std::ptrdiff_t>(at + 6));
      for (int i = 0; i < 15; ++i) values.push_back(90 + i);
    }
    return numbers(5200, subclass, values);
  }

  [[nodiscard]] std::string bytes() const {
    NccsFile whole = *this;
    whole.record(14000, 0);
    return nccs_blocks(whole.words_);
  }

 private:
  std::string words_;
  std::uint16_t sequence_ = 0;
};

}  // namespace gouge
