#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gouge {

struct HtmlColumn {
  std::string title;
  const char* css = "";  ///< "n": right-aligned numbers; "k": no line breaks
};

/// Returns a cell with escaped text.
[[nodiscard]] std::string html_cell(const std::string& text, const char* css = "");

/// A table of rows in pages, of which the first is open. The others are folded and open with a click, without a script.
/// A browser does not lay out a folded page. Rows beyond the last page are counted; CSV and JSON have them.
class HtmlTable {
 public:
  static constexpr std::size_t kRowsOfPage = 200;
  static constexpr std::size_t kMaxRows = 20'000;  ///< about 8 MB

  explicit HtmlTable(std::vector<HtmlColumn> columns) : columns_(std::move(columns)) {}

  /// Returns whether the last page has room for the next row. A row without room must be counted with skip().
  [[nodiscard]] bool has_room() const { return rows_ < kMaxRows; }
  /// Adds a row. Each of its `attributes` has a blank before it.
  void add(const std::string& cells, const std::string& attributes = {});
  void skip() { ++skipped_; }

  [[nodiscard]] std::string html() const;

 private:
  [[nodiscard]] std::string table(const std::string& rows) const;

  std::vector<HtmlColumn> columns_;
  std::vector<std::string> pages_;
  std::size_t rows_ = 0, skipped_ = 0;
};

/// Style sheet of the HTML report, for light and dark screens and for paper.
inline constexpr const char* kHtmlStyle = R"css(
:root { --ink: #20262e; --soft: #5f6873; --line: #dde1e6; --paper: #ffffff; --ground: #eef0f3; --alarm: #b2182b;
  --calm: #227854; --open: #a66e0c; --link: #1f5f99; }
* { box-sizing: border-box; }
body { margin: 0; background: var(--ground); color: var(--ink); font: 15px/1.5 "Segoe UI", "Helvetica Neue", Helvetica,
  Arial, "DejaVu Sans", sans-serif; }
main { max-width: 1120px; margin: 24px auto; background: var(--paper); padding: 36px 44px 44px; border-radius: 6px;
  box-shadow: 0 1px 4px rgba(20, 30, 40, .14); }
h1 { font-size: 26px; margin: 0 0 2px; overflow-wrap: anywhere; }
h2 { font-size: 19px; margin: 36px 0 10px; padding-bottom: 5px; border-bottom: 1px solid var(--line); }
p { margin: 6px 0; }
.soft { color: var(--soft); }
.banner { display: flex; align-items: center; gap: 22px; margin: 22px 0 10px; padding: 18px 24px; border-radius: 5px;
  color: #fff; }
.banner.gouges, .banner.material-left { background: var(--alarm); } .banner.clean { background: var(--calm); }
.banner.not-fully-checked, .banner.accepted-gouges { background: var(--open); }
.banner strong { font-size: 25px; line-height: 1.2; white-space: nowrap; }
.but { border-left: 4px solid var(--open); background: #fff6e0; padding: 8px 14px; margin: 10px 0; }
.promise { border-left: 4px solid var(--line); padding: 4px 14px; margin: 14px 0; color: var(--soft); }
.numbers { display: flex; flex-wrap: wrap; gap: 12px; margin: 18px 0 6px; }
.numbers div { flex: 1 1 100px; border: 1px solid var(--line); border-radius: 5px; padding: 9px 14px; }
.numbers b { display: block; font-size: 23px; line-height: 1.25; } .numbers span { color: var(--soft); font-size: 13px; }
.numbers .bad b { color: var(--alarm); } .numbers .open b { color: var(--open); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 14px; }
th { text-align: left; font-weight: 600; color: var(--soft); border-bottom: 2px solid var(--line); padding: 6px 12px 6px 0; }
td { border-bottom: 1px solid var(--line); padding: 5px 12px 5px 0; vertical-align: top; overflow-wrap: anywhere;
  min-width: 6.5em; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
td.n + td, th.n + th { padding-left: 10px; } td.k { white-space: nowrap; } td.n, td.k { min-width: 0; }
details { margin: 10px 0; } details:not([open]) { display: inline-block; margin: 4px 20px 4px 0; }
summary { cursor: pointer; color: var(--link); font-size: 14px; font-variant-numeric: tabular-nums; }
code { font-family: "DejaVu Sans Mono", Consolas, monospace; font-size: 13px; }
a { color: var(--link); text-decoration: none; } a:hover { text-decoration: underline; }
figure { margin: 16px 0 22px; } figure img { width: 100%; height: auto; border: 1px solid var(--line); border-radius: 4px;
  display: block; }
figcaption { color: var(--soft); font-size: 13.5px; padding-top: 5px; }
figure svg { width: 100%; height: auto; display: block; }
.axes text { font-size: 13px; fill: var(--soft); font-variant-numeric: tabular-nums; }
.axes .name { fill: var(--ink); font-weight: 600; font-size: 13.5px; }
.axes .grid, .axes .zero, .axes .frame { stroke: var(--line); fill: none; } .axes .zero { stroke: var(--soft); opacity: .6; }
.axes .tilted { fill: var(--ground); }
.axes .gap { fill: var(--link); opacity: .14; stroke: none; }
.axes .before, .axes .after { fill: none; stroke-width: 2; stroke-linejoin: round; }
.axes .before { stroke: var(--soft); stroke-dasharray: 7 4; } .axes .after { stroke: var(--link); stroke-width: 2.4; }
.state { display: inline-block; white-space: nowrap; padding: 0 8px; border-radius: 9px; color: #fff;
  font-size: 12.5px; background: var(--soft); }
.state.gouge, .state.buried { background: var(--alarm); } .state.not-checked, .state.not-certified { background: var(--open); }
.facts { display: flex; flex-wrap: wrap; gap: 4px 34px; margin: 14px 0 0; font-size: 14px; } .facts div { display: flex; gap: 9px; }
.facts dt { color: var(--soft); } .facts dd { margin: 0; overflow-wrap: anywhere; } .facts .command { flex: 1 1 100%; }
.facts .command dd { font: 13px/1.6 "DejaVu Sans Mono", Consolas, monospace; }
.sign { display: flex; flex-wrap: wrap; gap: 14px 34px; margin: 22px 0 6px; break-inside: avoid; }
.sign div { flex: 1 1 200px; } .sign b { font-weight: 600; }
.sign p { margin: 0; height: 32px; padding: 9px 0 0; border-bottom: 1px solid var(--soft); line-height: 22px; }
.sign span { color: var(--soft); font-size: 12.5px; }
.filters { display: flex; flex-wrap: wrap; gap: 8px 12px; align-items: center; margin: 8px 0; font-size: 14px; }
.filters select, .filters input, .filters button { font: inherit; padding: 3px 8px; border: 1px solid var(--line); border-radius: 4px;
  background: #fff; color: inherit; max-width: 22em; } .filters input { width: 7em; } .filters button { cursor: pointer; }
.findings th button { font: inherit; color: inherit; background: none; border: 0; padding: 0; cursor: pointer; }
.findings th button:hover { color: var(--link); } .findings th[aria-sort=ascending] button::after { content: " \25B2"; }
.findings th[aria-sort=descending] button::after { content: " \25BC"; }
.findings td { overflow-wrap: break-word; } .has-desk .findings tbody tr { cursor: pointer; } .has-desk .findings tbody tr:hover { background: #f3f7fb; }
@media screen { .findings tr.chosen, .has-desk .findings tr.chosen:hover { background: #e3eefa; } }
@media screen { .findings.long { max-height: 70vh; overflow: auto; } .findings.long thead { position: sticky; top: 0; background: var(--paper); z-index: 1; }
  .findings.long tr { height: 34px; } .findings.long td { white-space: nowrap; max-width: 24em; overflow: hidden; text-overflow: ellipsis; }
  .on-paper, .sign { display: none; } }
footer { margin-top: 36px; color: var(--soft); font-size: 13px; border-top: 1px solid var(--line); padding-top: 10px; }
@media print {
  @page { margin: 14mm; }
  body { background: #fff; font-size: 12px; } main { margin: 0; padding: 0 1px; box-shadow: none; max-width: none; }
  .banner, .state, .numbers div { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  .numbers b { font-size: 18px; white-space: nowrap; } td code { font-size: 8.5px; }
  figure { margin: 8px 0 12px; } figure img { width: auto; max-width: 100%; max-height: 104mm; }  /* two a page */
  figure, .banner, .numbers, tr { break-inside: avoid; } h2 { break-after: avoid; } a { color: inherit; }
  .filters { display: none; } .wide { overflow: visible; } td { min-width: 0; }
  .findings th button { display: contents; } table { font-size: 11px; } .findings table { font-size: 9.3px; }
  .wide table { font-size: 9.3px; } .wide td { overflow-wrap: break-word; }
  .findings td, .findings th, .wide td, .wide th { padding: 3px 5px 3px 0; } .findings .state { font-size: 9px; padding: 0 6px; }
}
@media (max-width: 640px) { main { margin: 0; padding: 20px 16px; border-radius: 0; } }
)css";

}  // namespace gouge
