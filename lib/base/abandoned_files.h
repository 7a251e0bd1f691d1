#pragma once

#include <string>

namespace gouge {

/// How many letters random_name adds to its prefix.
inline constexpr int kRandomLetters = 12;

/// `prefix` and kRandomLetters of 0 to 9 and a to v.
[[nodiscard]] std::string random_name(const std::string& prefix);

/// Locks the file of `handle` as long as it is open, so that no other process takes it for abandoned.
void keep_from_removal(int handle);

/// Removes from `folder` the files named by random_name(prefix) that belong to this user and that no process keeps
/// from removal: those of a program that was killed. What cannot be identified or removed stays.
/// Cost     O(entries of the folder).
void remove_abandoned(const std::string& folder, const std::string& prefix);

}  // namespace gouge
