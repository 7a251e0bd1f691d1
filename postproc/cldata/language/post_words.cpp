#include "postproc/cldata/language/post_words.h"

#include <algorithm>
#include <array>
#include <span>

namespace gouge {
namespace {

struct Code {
  std::uint16_t code;
  std::string_view name;
};

constexpr bool is_below(const Code& a, const Code& b) { return a.code < b.code; }

// NCL has its own codes for END, INDEX, COPY and TRACUT (499, 810 to 812); its post-processor has those of IBM.
constexpr auto kMajors = std::to_array<Code>({
    {1, "END"},       {2, "STOP"},      {3, "OPSTOP"},    {4, "ISTOP"},     {5, "RAPID"},     {7, "RETRCT"},
    {10, "UNLOAD"},   {13, "ZERO"},     {14, "GOHOME"},   {499, "END"},     {810, "INDEX"},   {811, "COPY"},
    {812, "TRACUT"},  {1003, "MODE"},   {1004, "CLEARP"}, {1005, "TMARK"},  {1006, "SWITCH"}, {1007, "CUTCOM"},
    {1008, "REVERS"}, {1009, "FEDRAT"}, {1010, "DELAY"},  {1011, "AIR"},    {1012, "OPSKIP"}, {1013, "LEADER"},
    {1014, "GOHOME"}, {1015, "MACHIN"}, {1016, "MCHTOL"}, {1019, "SEQNO"},  {1021, "DISPLY"}, {1022, "AUXFUN"},
    {1024, "POSITN"}, {1025, "TOOLNO"}, {1026, "ROTABL"}, {1027, "ORIGIN"}, {1029, "ARCSLP"}, {1030, "COOLNT"},
    {1031, "SPINDL"}, {1033, "TURRET"}, {1035, "ROTHED"}, {1036, "THREAD"}, {1037, "TRANS"},  {1038, "TRACUT"},
    {1039, "INDEX"},  {1040, "COPY"},   {1043, "LETTER"}, {1044, "PPRINT"}, {1045, "PARTNO"}, {1046, "INSERT"},
    {1048, "PREFUN"}, {1049, "COUPLE"}, {1050, "PITCH"},  {1054, "CYCLE"},  {1055, "LOADTL"}, {1056, "SELCTL"},
    {1057, "CLRSRF"}, {1058, "DWELL"},  {1060, "CLAMP"},  {1073, "LINTOL"}, {1083, "BREAK"},  {1143, "SELECT"},
});

// NCL and its post-processor have different codes for DWELL (197, 279) and OFFSET (814, 705).
constexpr auto kMinors = std::to_array<Code>({
    {1, "ATANGL"},   {8, "LEFT"},     {24, "RIGHT"},    {33, "XYPLAN"},   {37, "YZPLAN"},  {41, "ZXPLAN"},
    {57, "START"},   {59, "CCLW"},    {60, "CLW"},      {66, "INCR"},     {71, "ON"},      {72, "OFF"},
    {73, "IPM"},     {74, "IPR"},     {75, "CIRCUL"},   {78, "RPM"},      {80, "TURN"},    {81, "FACE"},
    {82, "BORE"},    {84, "XAXIS"},   {85, "YAXIS"},    {86, "ZAXIS"},    {88, "AUTO"},    {92, "STEP"},
    {140, "AAXIS"},  {141, "BAXIS"},  {142, "CAXIS"},   {143, "TPI"},     {144, "OPTION"}, {151, "MILL"},
    {152, "THRU"},   {153, "DEEP"},   {159, "ADJUST"},  {163, "DRILL"},   {168, "TAP"},    {197, "DWELL"},
    {211, "BORE7"},  {212, "BORE8"},  {213, "BORE9"},   {249, "SHIFT"},   {262, "REAM"},   {279, "DWELL"},
    {280, "RAPTO"},  {281, "FEDTO"},  {295, "RTRCTO"},  {315, "MMPM"},    {316, "MMPR"},   {327, "AVOID"},
    {510, "DEPTH"},  {617, "TOOL"},   {664, "ENDPT"},   {705, "OFFSET"},  {732, "MODIFY"}, {814, "OFFSET"},
    {822, "INVERS"}, {934, "PARAMS"}, {1008, "REVERS"}, {1083, "REPEAT"},
});

static_assert(std::is_sorted(kMajors.begin(), kMajors.end(), is_below));
static_assert(std::is_sorted(kMinors.begin(), kMinors.end(), is_below));

std::string_view name_in(std::span<const Code> codes, std::uint16_t code) {
  const auto it = std::lower_bound(codes.begin(), codes.end(), Code{code, {}}, is_below);
  return it == codes.end() || it->code != code ? std::string_view() : it->name;
}

}  // namespace

std::string_view major_of_code(std::uint16_t subclass) { return name_in(kMajors, subclass); }

std::string_view minor_of_code(std::uint16_t code) { return name_in(kMinors, code); }

}  // namespace gouge
