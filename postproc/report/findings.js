// The table of findings: sorted by a click on a column, filtered, and quick with thousands of rows, of which only those
// in sight are in the page. Without this script they are pages that fold. `window.findings` is for the 3D view.
(() => {
  const place = document.getElementById("findings");
  const tables = [...place.querySelectorAll("table")], table = tables[0], body = table.tBodies[0];
  const all = tables.flatMap(one => [...one.tBodies[0].rows]);
  const kFew = 200, kRowHeight = 34;  // so many are shown as they are; of more every row is as high
  const isLong = all.length > kFew, wide = table.parentElement;
  for (const details of place.querySelectorAll("details")) details.remove();
  wide.classList.add("findings");
  if (isLong) wide.classList.add("long");
  const heads = [...table.tHead.rows[0].cells], column = title => heads.findIndex(head => head.textContent === title);
  const at = { line: column("Line"), operation: column("Operation"), moves: column("Moves") };
  const text = (row, k) => row.cells[k].textContent;
  for (const row of all) row.tabIndex = -1;

  const valueOf = (row, k) => {
    const title = heads[k].dataset.title;
    if (title === "Depth") return Number(row.dataset.depth);
    if (title === "Overcut") return Number(row.dataset.overcut);
    if (title === "No." || title === "Line" || title === "Moves") return parseInt(text(row, k), 10);
    return text(row, k);
  };
  let shown = all, chosen = null, sorted = { k: column("Depth"), isDown: true };

  const rowsOfPage = rows => {
    const before = document.createElement("tr"), after = document.createElement("tr");
    const first = Math.max(0, Math.floor(wide.scrollTop / kRowHeight) - 20);
    const last = Math.min(rows.length, first + Math.ceil((wide.clientHeight || 600) / kRowHeight) + 40);
    before.style.height = `${first * kRowHeight}px`;
    after.style.height = `${(rows.length - last) * kRowHeight}px`;
    return [before, ...rows.slice(first, last), after];
  };
  const render = () => body.replaceChildren(...(isLong ? rowsOfPage(shown) : shown));

  const bar = document.createElement("div");
  bar.className = "filters";
  const filters = [];
  const addChoice = (label, of, given) => {
    const names = given ?? [...new Set(all.map(of))].filter(name => name !== "");
    if (names.length < 2) return;
    const select = document.createElement("select");
    select.append(new Option(label, ""), ...names.map(name => new Option(name, name)));
    select.setAttribute("aria-label", label);
    select.dataset.filter = label;
    bar.append(select);
    filters.push({ control: select, keeps: row => select.value === "" || of(row) === select.value });
  };
  addChoice("any state", row => row.dataset.state);
  addChoice("accepted or not", row => row.dataset.accepted ?? "");
  if (document.getElementById("review-data")) addChoice("any review", row => row.dataset.review ?? "open", ["open", "to fix", "question", "accepted"]);
  addChoice("any tool", row => row.dataset.tool);
  addChoice("any body", row => row.dataset.body);
  if (at.operation >= 0) addChoice("any operation", row => text(row, at.operation));
  const least = document.createElement("input"), label = document.createElement("label"), counts = document.createElement("span");
  least.type = "number";
  least.min = "0";
  least.step = "any";
  least.dataset.filter = "depth";
  label.append("deeper than ", least);
  const reset = document.createElement("button");
  reset.textContent = "All";
  bar.append(label, reset, counts);
  counts.className = "soft";
  filters.push({ control: least, keeps: row => least.value === "" || Number(row.dataset.depth) > Number(least.value) });
  if (all.length > 1) wide.before(bar);

  const apply = () => {
    shown = all.filter(row => filters.every(one => one.keeps(row)));
    const { k, isDown } = sorted, by = new Map(shown.map((row, i) => [row, [valueOf(row, k), i]]));
    shown.sort((a, b) => {
      const [x, i] = by.get(a), [y, j] = by.get(b);
      return (x < y ? -1 : x > y ? 1 : 0) * (isDown ? -1 : 1) || i - j;
    });
    counts.textContent = `${shown.length} of ${all.length} findings`;
    wide.scrollTop = 0;
    render();
  };
  heads.forEach((head, k) => {
    head.dataset.title = head.textContent;
    if (head.textContent === "") return;
    const button = document.createElement("button");
    button.textContent = head.textContent;
    head.replaceChildren(button);
    button.addEventListener("click", () => {
      const isNumber = ["Depth", "Overcut"].includes(head.dataset.title);
      sorted = { k, isDown: sorted.k === k ? !sorted.isDown : isNumber };
      for (const other of heads) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", sorted.isDown ? "descending" : "ascending");
      apply();
    });
  });
  heads[sorted.k].setAttribute("aria-sort", "descending");
  bar.addEventListener("input", apply);
  reset.addEventListener("click", () => {
    for (const { control } of filters) control.value = "";
    apply();
  });
  if (isLong) {
    let isAsked = false;
    wide.addEventListener("scroll", () => {
      if (isAsked) return;
      isAsked = true;
      requestAnimationFrame(() => { isAsked = false; render(); });
    }, { passive: true });
  }

  const indexOf = row => Number(row.dataset.finding);
  const choose = row => {
    chosen?.classList.remove("chosen");
    chosen = row;
    row.classList.add("chosen");
    document.dispatchEvent(new CustomEvent("chosen", { detail: indexOf(row) }));
    const top = shown.indexOf(row) * kRowHeight;
    if (isLong && (top < wide.scrollTop || top > wide.scrollTop + wide.clientHeight - 3 * kRowHeight)) {
      wide.scrollTop = Math.max(0, top - wide.clientHeight / 2);
      render();
    }
  };
  body.addEventListener("click", event => {
    const row = event.target.closest("tr");
    if (!row?.dataset.finding || event.target.closest("a")) return;
    choose(row);
    document.dispatchEvent(new CustomEvent("finding", { detail: indexOf(row) }));
  });
  // On paper the first of them stand, and how many more there are.
  const rest = document.createElement("p");
  rest.className = "soft on-paper";
  wide.after(rest);
  window.addEventListener("beforeprint", () => {
    body.replaceChildren(...shown.slice(0, kFew));
    rest.textContent = shown.length > kFew ? `and ${shown.length - kFew} more; this page on a screen, result.json and moves.csv have them all` : "";
  });
  window.addEventListener("afterprint", () => { rest.textContent = ""; render(); });
  apply();

  window.findings = {
    first: () => shown.length > 0 ? indexOf(shown[0]) : undefined,
    count: () => shown.length,
    rows: () => all,
    choose: index => { const row = all.find(one => indexOf(one) === index); if (row) choose(row); },
    numberOf: index => shown.findIndex(row => indexOf(row) === index) + 1,
    // The next of those shown, from the one that was chosen last.
    step: by => {
      if (shown.length === 0) return undefined;
      const now = shown.indexOf(chosen);
      const row = shown[Math.max(0, Math.min(shown.length - 1, now < 0 ? 0 : now + by))];
      choose(row);
      return indexOf(row);
    },
  };
})();
