"use strict";
// Sorts and filters the jobs, and leads from one report to the next. A cell whose text is not its sort key has the key
// in data-v.
const table = document.querySelector("table"), body = table.tBodies[0], rows = [...body.rows];
const value = (row, k) => { const c = row.cells[k], v = c.dataset.v ?? c.textContent; return v !== "" && !isNaN(v) ? +v : v; };
[...table.tHead.rows[0].cells].forEach((head, k) => head.querySelector("button")?.addEventListener("click", () => {
  const down = head.getAttribute("aria-sort") === "ascending";
  for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", down ? "descending" : "ascending");
  const sorted = [...rows].sort((a, b) => {
    const x = value(a, k), y = value(b, k);
    const by = typeof x === typeof y ? (x < y ? -1 : x > y ? 1 : 0) : typeof x === "number" ? -1 : 1;
    return down ? -by : by;
  });
  body.append(...sorted);
}));

const filter = document.getElementById("filter"), shown = document.getElementById("shown");
const apply = () => {
  const words = filter.value.toLowerCase().split(/\s+/);
  let count = 0;
  for (const row of rows) {
    const text = row.textContent.toLowerCase();
    row.hidden = !words.every(word => text.includes(word));
    count += row.hidden ? 0 : 1;
  }
  shown.textContent = count === rows.length ? "" : `${count} of ${rows.length} jobs`;
};
filter.addEventListener("input", apply);
apply();

// A report leads here with #before=NAME or #after=NAME: the reports follow one another as the rows do, the worst first.
const follow = () => {
  const found = location.hash.match(/^#(at|before|after)=(.*)$/);
  if (!found) return;
  const [, way, coded] = found, name = decodeURIComponent(coded), step = { at: 0, before: -1, after: 1 }[way];
  const all = rows.filter(row => row.dataset.report), here = all.findIndex(row => row.dataset.job === name);
  const next = here < 0 ? undefined : all[here + step];
  if (step !== 0 && next) return location.replace(next.dataset.report);
  for (const row of rows) row.classList.toggle("here", row.dataset.job === name);
  rows.find(row => row.dataset.job === name)?.scrollIntoView({ block: "center" });
  if (here >= 0 && step !== 0) shown.textContent = `${name} is the ${step > 0 ? "last" : "first"} report.`;
};
follow();
addEventListener("hashchange", follow);
