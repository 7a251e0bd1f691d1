#pragma once

#include <concepts>
#include <type_traits>

namespace gouge {

/// R is Of or constant Of; the writer visits constant records.
template <typename R, typename Of>
concept RecordOf = std::same_as<std::remove_const_t<R>, Of>;

/// Lower limit of a number.
enum class Sign { any, non_negative };

}  // namespace gouge
