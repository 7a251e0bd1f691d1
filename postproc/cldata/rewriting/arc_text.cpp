#include "postproc/cldata/rewriting/arc_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "lib/base/tolerance.h"
#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/lexing/lexer.h"
#include "postproc/cldata/lexing/statement_at.h"
#include "postproc/cldata/parsing/arc_statement.h"

namespace gouge {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kArcStatementsLearned = 5000;
constexpr int kMinDirectionDecimals = 6, kUsualDirectionDecimals = 9;
constexpr int kMinAngleDecimals = 4, kUsualAngleDecimals = 6;
constexpr int kUsualArcDecimals = 6;
constexpr double kMoreThanOneTurn_rad = 2 * kPi + 1e-6;
constexpr double kSameNumber_mm = 3e-4;  // half a digit of a file with the fewest decimals, in each direction
constexpr double kSameAngle_rad = 1e-3;
constexpr double kHalfTurn_rad = 0.01;  // within this of half a turn both words are right

std::optional<std::size_t> index_of(const std::vector<Argument>& arguments, std::string_view word) {
  const auto found = std::find_if(arguments.begin(), arguments.end(),
                                  [&](const Argument& a) { return equals_ignoring_case(a.text, word); });
  if (found == arguments.end()) return std::nullopt;
  return static_cast<std::size_t>(found - arguments.begin());
}

bool are_numbers(const std::vector<Argument>& arguments, std::size_t first, std::size_t count) {
  if (first + count > arguments.size()) return false;
  return std::all_of(arguments.begin() + static_cast<std::ptrdiff_t>(first),
                     arguments.begin() + static_cast<std::ptrdiff_t>(first + count),
                     [](const Argument& a) { return a.number.has_value(); });
}

std::vector<Argument> arguments_of(const Statement& statement) {
  std::vector<Argument> arguments;
  split_arguments(statement, arguments);
  return arguments;
}

double radius_of(const WrittenArc& arc) {
  const auto from_axis = [&](const Vec3& point) {
    const Vec3 away = point - arc.arc.center;
    return (away - away.dot(arc.arc.axis) * arc.arc.axis).norm();
  };
  return 0.5 * (from_axis(arc.start) + from_axis(arc.end));
}

Vec3 start_direction(const WrittenArc& arc) {
  return ((arc.arc.sweep_rad < 0 ? -1.0 : 1.0) * arc.arc.axis).cross(arc.start - arc.arc.center).normalized();
}

// Returns whether a written statement is read as the arc that is meant.
bool reads_as(ArcStatement read, const WrittenArc& meant) {
  if (read.sense == ArcSense::unknown) {
    read.sense = meant.arc.sweep_rad < 0 ? ArcSense::left_handed : ArcSense::right_handed;
  }
  const ArcFit fit = fit_arc(read, meant.start, meant.end);
  return fit.problem.empty() &&
         std::abs(fit.arc.sweep_rad - meant.arc.sweep_rad) <= kSameAngle_rad + kSameNumber_mm / radius_of(meant) &&
         (fit.arc.center - meant.arc.center).norm() <= kSameNumber_mm &&
         (fit.arc.axis - meant.arc.axis).cwiseAbs().maxCoeff() <= Tolerance::kFileAxis;
}

Statement lexed(std::string_view text) {
  Lexer lexer(text);
  Statement statement;
  if (!lexer.next(statement)) statement.clear();
  return statement;
}

}  // namespace

ArcText::ArcText(const Toolpath& path, const MotionRecords& records)
    : path_(path),
      records_(records.of_move),
      dialect_(dialect_or_apt(path.dialect)),
      arcs_of_statement_(path.statements.size(), SmallIndex(0)) {
  std::size_t learned = 0;
  const bool is_text = dialect_.has_apt_words;
  for (std::size_t i = 0; is_text && i < records_.size(); ++i) {
    const MotionRecord& record = records_[i];
    if (record.curve_statement == kNone) continue;
    SmallIndex& count = arcs_of_statement_[record.curve_statement];
    count = count + 1;
    if (count > 1 || path_.moves[i].curve_kind != CurveKind::arc || learned >= kArcStatementsLearned) continue;
    learn(statement_at(path_, record.curve_statement));
    if (record.form == PositionForm::curve) learn(statement_at(path_, record.statement));
    ++learned;
  }
  lengths_.choose_decimals(min_coordinate_decimals(path.unit), kUsualArcDecimals);
  directions_.choose_decimals(kMinDirectionDecimals, kUsualDirectionDecimals);
  angles_.choose_decimals(kMinAngleDecimals, kUsualAngleDecimals);
}

void ArcText::learn(const Statement& statement) {
  const std::vector<Argument> arguments = arguments_of(statement);
  const auto learn_from = [&](NumberStyle& style, std::size_t first, std::size_t count) {
    if (!are_numbers(arguments, first, count)) return;
    for (std::size_t i = first; i < first + count; ++i) {
      const auto at = static_cast<std::size_t>(arguments[i].text.data() - path_.source.data());
      style.learn(arguments[i].text, arguments[i].text.size() + blanks_before(path_.source, at));
    }
  };
  if (statement.word == Word::indirv) return learn_from(directions_, 0, 3);
  if (statement.word == Word::tlon) {
    if (const auto circle = index_of(arguments, "CIRCLE")) learn_from(lengths_, *circle + 1, 4);
    return;
  }
  const std::optional<ArgumentIndices> indices = indices_of(statement, arguments);
  if (!indices) return;
  learn_from(lengths_, indices->center, 3);
  learn_from(directions_, indices->axis, 3);
  if (indices->radius) learn_from(lengths_, *indices->radius, 1);
  if (indices->angle) learn_from(angles_, *indices->angle, 1);
}

// Returns the indices of the arguments as read_arc uses them. Every written statement is read back as a test.
std::optional<ArcText::ArgumentIndices> ArcText::indices_of(const Statement& statement,
                                                            const std::vector<Argument>& arguments) const {
  if (statement.word != Word::circle && statement.word != Word::movarc) return std::nullopt;
  ArgumentIndices indices;
  if (const auto center = index_of(arguments, "CENTER")) {
    const auto axis = index_of(arguments, "AXIS");
    if (!axis) return std::nullopt;
    indices.center = *center + 1;
    indices.axis = *axis + 1;
    if (const auto radius = index_of(arguments, "RADIUS")) indices.radius = *radius + 1;
  } else if (are_numbers(arguments, 6, 1)) {
    indices.radius = 6;
  }
  if (const auto angle = index_of(arguments, "ANGLE")) indices.angle = *angle + 1;
  if (dialect_.arc_form == ArcForm::with_sweep && are_numbers(arguments, 7, 1)) indices.angle = 7;
  if (indices.angle && are_numbers(arguments, *indices.angle, 1) && *arguments[*indices.angle].number <= 0)
    indices.angle.reset();  // an angle of 0 or less states none
  const bool is_whole = are_numbers(arguments, indices.center, 3) && are_numbers(arguments, indices.axis, 3) &&
                        (!indices.radius || are_numbers(arguments, *indices.radius, 1)) &&
                        (!indices.angle || are_numbers(arguments, *indices.angle, 1));
  return is_whole ? std::optional(indices) : std::nullopt;
}

// Returns whether no statement between those of one arc would change its meaning after an inserted position.
bool ArcText::is_quiet_between(std::size_t first, std::size_t last) const {
  static constexpr WordSet kQuiet = {Word::comment, Word::harmless, Word::free_text, Word::pprint, Word::fedrat};
  for (std::size_t s = first + 1; s < last; ++s) {
    if (!kQuiet.has(statement_at(path_, s).word)) return false;
  }
  return true;
}

bool ArcText::is_writable(std::size_t move) const {
  const Move& m = path_.moves[move];
  const MotionRecord& record = records_[move];
  if (m.kind != MoveKind::arc || m.curve_kind != CurveKind::arc || !m.has_start || !m.not_checked_reason.empty())
    return false;
  if (record.curve_statement == kNone || arcs_of_statement_[record.curve_statement] != 1 || record.is_rapid ||
      record.points != 1 || std::abs(path_.arcs[m.curve].sweep_rad) > kMoreThanOneTurn_rad)
    return false;
  if (!is_quiet_between(record.curve_statement, record.statement)) return false;
  const Statement statement = statement_at(path_, record.curve_statement);
  const std::vector<Argument> arguments = arguments_of(statement);
  if (record.form == PositionForm::curve) return statement.word == Word::indirv;
  if (record.form != PositionForm::go_to || has_argument(arguments, "TIMES")) return false;
  return indices_of(statement, arguments).has_value();
}

void ArcText::add_point(std::vector<Field>& fields, std::size_t first, const NumberStyle& style,
                        const Vec3& point) const {
  for (Eigen::Index i = 0; i < 3; ++i) fields.push_back({first + static_cast<std::size_t>(i), &style, point[i]});
}

std::string ArcText::replaced(const Statement& statement, const std::vector<Argument>& arguments,
                              const std::vector<Field>& fields) const {
  std::string text;
  std::size_t copied = statement.first_byte;
  for (const Field& field : fields) {
    append_changed_number(text, copied, path_.source, arguments[field.argument], *field.style, field.value);
  }
  return text += std::string_view(path_.source).substr(copied, statement.last_byte - copied);
}

WrittenArc ArcText::as_read(std::size_t move) const {
  const RigidTransform to_local = records_[move].frame->to_part.inverse();
  const PathArc& arc = path_.arcs[path_.moves[move].curve];
  return {{to_local.point(arc.center), to_local.direction(arc.axis), arc.sweep_rad},
          to_local.point(path_.start_of(move).tip),
          to_local.point(path_.moves[move].end.tip)};
}

// Returns the first statement of an arc. CATIA finds the plane of an arc by AUTOPS, from the position of the tool.
std::size_t ArcText::first_statement(std::size_t move) const {
  const std::size_t described = records_[move].curve_statement;
  if (described == 0) return described;
  const Statement before = statement_at(path_, described - 1);
  return equals_ignoring_case(before.major, "AUTOPS") ? described - 1 : described;
}

Diagnostic ArcText::refuse(std::size_t move, std::string_view why) const {
  return make_error("write-arc",
                    "move " + std::to_string(move) + " cannot become the arc asked for: " + std::string(why) +
                        "; straighten it instead",
                    path_.file, path_.moves[move].line);
}

Result<std::string> ArcText::description(std::size_t move, const WrittenArc& arc) const {
  const double mm = records_[move].frame->mm_per_unit;
  const Statement statement = statement_at(path_, records_[move].curve_statement);
  const std::vector<Argument> arguments = arguments_of(statement);
  std::vector<Field> fields;
  if (statement.word == Word::indirv) {
    add_point(fields, 0, directions_, start_direction(arc));
    return replaced(statement, arguments, fields);
  }
  const ArgumentIndices indices = indices_of(statement, arguments).value_or(ArgumentIndices{});
  add_point(fields, indices.center, lengths_, arc.arc.center / mm);
  add_point(fields, indices.axis, directions_, arc.arc.axis);
  // The numbers change by the difference of both arcs, because those in the file may not agree to the last digit.
  const WrittenArc old = as_read(move);
  if (dialect_.has_z_alone && (arc.arc.axis - old.arc.axis).norm() > Tolerance::kSameDirection)
    return refuse(move, "the vector of a CLT arc is an axis of the part");
  if (indices.radius) {
    const double stated = *arguments[*indices.radius].number;
    fields.push_back({*indices.radius, &lengths_, stated + (radius_of(arc) - radius_of(old)) / mm});
  }
  if (indices.angle) {
    const double more = std::abs(arc.arc.sweep_rad) - std::abs(old.arc.sweep_rad);
    fields.push_back({*indices.angle, &angles_, *arguments[*indices.angle].number + more * 180 / kPi});
  }
  std::sort(fields.begin(), fields.end(), [](const Field& a, const Field& b) { return a.argument < b.argument; });
  std::string text = replaced(statement, arguments, fields);
  const Statement written = lexed(text);
  const ArcStatement read = read_arc(dialect_, arguments_of(written), mm);
  if (!read.problem.empty()) return refuse(move, read.problem);
  if (!reads_as(read, arc)) return refuse(move, "its start and end do not lie on it, or its sense would change");
  return text;
}

Result<std::string> ArcText::tlon(std::size_t move, const WrittenArc& arc) const {
  const double mm = records_[move].frame->mm_per_unit;
  const Statement statement = statement_at(path_, records_[move].statement);
  const std::vector<Argument> arguments = arguments_of(statement);
  const auto circle = index_of(arguments, "CIRCLE"), line = index_of(arguments, "LINE");
  if (!circle || !line || !are_numbers(arguments, *circle + 1, 4) || !are_numbers(arguments, *line + 1, 6))
    return refuse(move, "a TLON of another form");
  std::vector<Field> fields;
  add_point(fields, *circle + 1, lengths_, arc.arc.center / mm);
  const double stated = *arguments[*circle + 4].number;
  fields.push_back({*circle + 4, &lengths_, stated + (radius_of(arc) - radius_of(as_read(move))) / mm});
  add_point(fields, *line + 1, lengths_, arc.arc.center / mm);
  add_point(fields, *line + 4, lengths_, arc.end / mm);
  std::string text = replaced(statement, arguments, fields);
  const bool is_beyond_half = std::abs(arc.arc.sweep_rad) > kPi;
  const std::optional<TlonStatement> read = read_tlon(arguments_of(lexed(text)), mm);
  if (!read) return refuse(move, "a TLON of another form");
  if (read->is_beyond_half != is_beyond_half && std::abs(std::abs(arc.arc.sweep_rad) - kPi) > kHalfTurn_rad)
    return refuse(move, "it crosses half a turn, which a TLON says in other words");
  WrittenArc meant = arc;
  if (meant.arc.sweep_rad < 0) meant.arc = {meant.arc.center, Vec3(-meant.arc.axis), -meant.arc.sweep_rad};
  // The reader computes the plane from the written start, so the tangent, with all its digits, determines it.
  if (!reads_as(arc_of_tlon(*read, arc.start, start_direction(arc)), meant))
    return refuse(move, "its start and end do not lie on it");
  return text;
}

}  // namespace gouge
