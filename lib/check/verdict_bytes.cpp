#include "lib/check/verdict_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

namespace gouge {
namespace {

// Bits of the first byte: the state, and a flag for each part of the verdict that follows.
constexpr std::uint8_t kState = 7, kDepth = 8, kWitness = 16, kClearance = 32, kOvercut = 64, kReason = 128;

template <class Value>
void append(const Value& value, std::string& bytes) {
  static_assert(std::is_trivially_copyable_v<Value>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Value>
bool take(std::string_view& bytes, Value& value) {
  static_assert(std::is_trivially_copyable_v<Value>);
  if (bytes.size() < sizeof value) return false;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return true;
}

void append(const Vec3& v, std::string& bytes) {
  for (int k = 0; k < 3; ++k) append(v[k], bytes);
}

bool take(std::string_view& bytes, Vec3& v) { return take(bytes, v[0]) && take(bytes, v[1]) && take(bytes, v[2]); }

void append(const Witness& w, std::string& bytes) {
  append(w.t, bytes);
  append(w.point, bytes);
  append(w.normal, bytes);
  append(w.body, bytes);
  append(w.against, bytes);
  append(w.mesh, bytes);
  append(w.triangle, bytes);
  append(std::uint8_t{w.turn.has_value()}, bytes);
  if (w.turn) append(*w.turn, bytes);
}

bool take(std::string_view& bytes, Witness& w) {
  std::uint8_t has_turn = 0;
  return take(bytes, w.t) && take(bytes, w.point) && take(bytes, w.normal) && take(bytes, w.body) &&
         take(bytes, w.against) && take(bytes, w.mesh) && take(bytes, w.triangle) && take(bytes, has_turn) &&
         (has_turn == 0 || take(bytes, w.turn.emplace()));
}

void append(const Reason& reason, std::string& bytes) {
  append(reason.kind, bytes);
  append(reason.body, bytes);
  append(reason.amount(), bytes);
  append(static_cast<std::uint64_t>(reason.detail().size()), bytes);
  bytes += reason.detail();
}

bool take(std::string_view& bytes, Reason& reason) {
  Reason::Kind kind{};
  Body body{};
  double amount = 0;
  std::uint64_t length = 0;
  if (!take(bytes, kind) || !take(bytes, body) || !take(bytes, amount) || !take(bytes, length) || bytes.size() < length)
    return false;
  reason = {kind, body, amount, std::string(bytes.substr(0, length))};
  bytes.remove_prefix(length);
  return true;
}

// Returns whether the value is possible. The bytes may have been damaged, or written by another program; an impossible
// value would later be an index out of range.
bool is_possible(Body body) { return body <= Body::head; }

bool is_possible(const Witness& w) {
  const auto is_share = [](double share) { return share >= 0 && share <= 1; };
  if (w.turn && !std::ranges::all_of(*w.turn, is_share)) return false;
  return w.t >= 0 && w.t <= 1 && w.point.allFinite() && w.normal.allFinite() && is_possible(w.body) &&
         w.against <= Against::fixture;  // the stock is checked anew
}

bool is_possible(const Reason& reason) {
  using enum Reason::Kind;
  constexpr double kMaxCounted = 9e15;
  const bool is_counted = reason.is(link_gouges) || reason.is(out_of_budget) || reason.is(head_out_of_budget);
  if (is_counted && !(reason.amount() >= 0 && reason.amount() <= kMaxCounted)) return false;
  return reason.kind <= mesh_tolerance_exceeded && is_possible(reason.body) && !std::isnan(reason.amount());
}

bool is_possible(const MoveVerdict& v) {
  const auto is_length = [](double length_mm) { return length_mm >= 0 && std::isfinite(length_mm); };
  return is_length(v.depth_mm) && v.depth_upper_mm >= 0 && (!v.witness || is_possible(*v.witness)) &&
         (!v.clearance_mm || is_length(*v.clearance_mm)) &&
         (!v.overcut || (is_length(v.overcut->lower_mm) && v.overcut->upper_mm >= 0)) && is_possible(v.reason);
}

bool is_zero(double number) { return std::fpclassify(number) == FP_ZERO && !std::signbit(number); }

}  // namespace

void append_bytes(double number, std::string& bytes) { append(number, bytes); }
void append_bytes(std::uint64_t count, std::string& bytes) { append(count, bytes); }
bool take_bytes(std::string_view& bytes, double& number) { return take(bytes, number); }
bool take_bytes(std::string_view& bytes, std::uint64_t& count) { return take(bytes, count); }

void append_bytes(const MoveVerdict& v, std::string& bytes) {
  const bool has_reason = !v.reason.is_same({});
  const auto flag = [](bool is_there, std::uint8_t bit) { return is_there ? bit : std::uint8_t{0}; };
  const auto head = static_cast<std::uint8_t>(
      static_cast<std::uint8_t>(v.state) | flag(!is_zero(v.depth_mm), kDepth) | flag(v.witness.has_value(), kWitness) |
      flag(v.clearance_mm.has_value(), kClearance) | flag(v.overcut.has_value(), kOvercut) | flag(has_reason, kReason));
  append(head, bytes);
  append(v.depth_upper_mm, bytes);
  if ((head & kDepth) != 0) append(v.depth_mm, bytes);
  if (v.witness) append(*v.witness, bytes);
  if (v.clearance_mm) append(*v.clearance_mm, bytes);
  if (v.overcut) {
    append(v.overcut->lower_mm, bytes);
    append(v.overcut->upper_mm, bytes);
  }
  if (has_reason) append(v.reason, bytes);
}

bool take_bytes(std::string_view& bytes, MoveVerdict& verdict) {
  std::uint8_t head = 0;
  MoveVerdict v;
  if (!take(bytes, head) || (head & kState) > static_cast<std::uint8_t>(MoveState::not_certified)) return false;
  v.state = static_cast<MoveState>(head & kState);
  bool is_whole = take(bytes, v.depth_upper_mm);
  const auto taken = [&](std::uint8_t bit, auto& value) {
    if ((head & bit) != 0) is_whole = is_whole && take(bytes, value);
  };
  taken(kDepth, v.depth_mm);
  if ((head & kWitness) != 0) taken(kWitness, v.witness.emplace());
  if ((head & kClearance) != 0) taken(kClearance, v.clearance_mm.emplace());
  if ((head & kOvercut) != 0) {
    taken(kOvercut, v.overcut.emplace().lower_mm);
    taken(kOvercut, v.overcut->upper_mm);
  }
  taken(kReason, v.reason);
  verdict = std::move(v);
  return is_whole && is_possible(verdict);
}

bool is_of_meshes(const MoveVerdict& verdict, const Scene& scene) {
  if (!verdict.witness) return true;
  return verdict.witness->mesh < obstacles_of(scene)[static_cast<std::size_t>(verdict.witness->against)].meshes.size();
}

}  // namespace gouge
