// The review of findings: status, assignee and comment, kept by the browser for this result alone. Accepted findings are
// exported in the format that --baseline reads (docs/formats/accepted.md).
(() => {
  const data = document.getElementById("review-data"), place = document.getElementById("findings");
  if (!data) return;
  const { key, reviewer, program, entries, kept, command } = JSON.parse(data.textContent);
  const kStatuses = ["open", "to fix", "question", "accepted"];
  const element = (name, text, css) => {
    const one = document.createElement(name);
    if (text !== undefined) one.textContent = text;
    if (css) one.className = css;
    return one;
  };

  // What the browser keeps. Where it keeps nothing, the review lasts as long as the page.
  let review = { reviewer, findings: {} }, isKept = true;
  try {
    const text = localStorage.getItem(key);
    if (text) review = { ...review, ...JSON.parse(text) };
  } catch (error) { isKept = false; }
  const keep = () => {
    try { localStorage.setItem(key, JSON.stringify(review)); isKept = true; } catch (error) { isKept = false; }
  };

  const rows = window.findings.rows(), numberOf = row => parseInt(row.cells[0].textContent, 10);
  const rowOf = new Map(rows.map(row => [Number(row.dataset.finding), row]));
  const noteOf = row => review.findings[numberOf(row)] ?? {};
  const isInBaseline = row => row.dataset.accepted === "accepted";
  const statusOf = row => isInBaseline(row) ? "accepted" : noteOf(row).status ?? "open";
  const showRow = row => {
    const { assignee = "", comment = "" } = noteOf(row), status = statusOf(row), cell = row.querySelector("td.review");
    row.dataset.review = status;
    const chip = element("span", status, "chip " + status.replace(" ", "-"));
    cell.replaceChildren(...(status === "open" && !assignee && !comment ? [] : [chip]));
    if (assignee) cell.append(" ", element("b", assignee));
    if (comment) cell.append(element("div", comment, "soft"));
  };

  const bar = element("div", undefined, "filters review-bar"), tally = element("span", undefined, "soft");
  const byWhom = element("input"), byLabel = element("label", "Reviewer "), save = element("button", "Export accepted.json");
  const said = element("p", undefined, "soft review-note");
  byWhom.value = review.reviewer ?? "";
  byWhom.dataset.review = "reviewer";
  save.type = "button";
  byLabel.append(byWhom);
  bar.append(element("b", "Review"), tally, byLabel, save);
  said.setAttribute("role", "status");
  const banner = element("p", undefined, "soft");
  banner.id = "review-line";
  document.querySelector(".banner").after(banner);

  const toExport = () => rows.filter(row => statusOf(row) === "accepted" && !isInBaseline(row));
  const count = () => {
    const counts = kStatuses.map(status => [rows.filter(row => statusOf(row) === status).length, status]);
    const text = counts.filter(([n]) => n > 0).map(([n, status]) => `${n} ${status}`).join(", ");
    tally.textContent = text + (isKept ? "" : "; this browser keeps no notes: they last until the page is closed");
    save.disabled = toExport().length === 0;
    const isBegun = Object.keys(review.findings).length > 0;
    banner.textContent = isBegun ? `Review in this browser: ${text}. The verdict stays until a check with --baseline.` : "";
    banner.hidden = !isBegun;
  };

  // The form for the chosen finding; beside the 3D view where there is one.
  const form = element("form", undefined, "review-form"), title = element("b"), hint = element("p", undefined, "soft");
  const status = element("select"), assignee = element("input"), comment = element("textarea"), names = element("datalist");
  for (const name of kStatuses) status.append(new Option(name, name));
  names.id = "review-names";
  assignee.setAttribute("list", names.id);
  comment.rows = 3;
  for (const [label, control] of [["Status", status], ["Assignee", assignee], ["Comment", comment]]) {
    const one = element("label", undefined);
    control.dataset.review = label.toLowerCase();
    one.append(element("span", label), control);
    form.append(one);
  }
  form.prepend(title);
  form.append(names, hint);
  form.hidden = true;
  let row = null;
  const fill = () => {
    if (!row) return;
    const note = noteOf(row), entry = entries[numberOf(row)];
    title.textContent = `Review of finding ${numberOf(row)}`;
    status.value = statusOf(row);
    status.disabled = isInBaseline(row);
    assignee.value = note.assignee ?? "";
    comment.value = note.comment ?? "";
    names.replaceChildren(...[...new Set(Object.values(review.findings).map(one => one.assignee))].filter(Boolean).map(name => new Option(name)));
    tell(entry);
  };
  const tell = entry => {
    hint.textContent = isInBaseline(row) ? "Accepted by the file of --baseline. To withdraw it, remove its entry there."
      : status.value !== "accepted" ? ""
      : !entry ? `This page cannot export it. Use: ${command} --finding ${numberOf(row)}`
      : entry.no ? `It cannot be accepted: ${entry.no}.`
      : comment.value.trim() === "" ? "An acceptance needs its reason as the comment."
      : byWhom.value.trim() === "" ? "An acceptance needs the name of the reviewer, above the table." : "";
  };
  const take = () => {
    if (!row) return;
    const note = { status: status.value, assignee: assignee.value.trim(), comment: comment.value.trim() };
    if (isInBaseline(row)) delete note.status;
    if ((note.status ?? "open") === "open" && !note.assignee && !note.comment) delete review.findings[numberOf(row)];
    else review.findings[numberOf(row)] = note;
    keep();
    showRow(row);
    count();
    tell(entries[numberOf(row)]);
  };
  form.addEventListener("input", take);
  form.addEventListener("submit", event => event.preventDefault());
  byWhom.addEventListener("input", () => {
    review.reviewer = byWhom.value.trim();
    keep();
    fill();
    count();
  });
  document.addEventListener("chosen", event => {
    row = rowOf.get(event.detail) ?? null;
    form.hidden = !row;
    fill();
  });

  // A sealed entry as gougecheck writes it: its text is cut where the three words of the reviewer belong.
  const sealed = (entry, by, date, reason) => {
    const text = entry[0] + JSON.stringify(by) + entry[1] + JSON.stringify(date) + entry[2] + JSON.stringify(reason) + entry[3];
    return `${text.slice(0, -1)},"seal":"sha256:${sha256(text)}"}`;
  };
  const accepted = () => {
    const by = byWhom.value.trim(), date = new Date().toISOString().slice(0, 10), texts = new Set(kept), left = [];
    for (const one of toExport()) {
      const entry = entries[numberOf(one)], reason = (noteOf(one).comment ?? "").trim();
      if (!entry || entry.no || reason === "" || by === "") left.push(numberOf(one));
      else texts.add(sealed(entry, by, date, reason));
    }
    return { left, made: texts.size - kept.length,
             text: `{\n "format": "gougecheck-accepted",\n "format_version": 1,\n "program": ${JSON.stringify(program)},\n` +
                   ` "accepted": [\n  ${[...texts].join(",\n  ")}\n ]\n}\n` };
  };
  save.addEventListener("click", () => {
    const { left, made, text } = accepted();
    const open = left.length > 0 ? ` Not exported: finding ${left.join(", ")}, without a reason, a reviewer or a depth to compare.` : "";
    if (made === 0) { said.textContent = "Nothing was exported." + open; return; }
    const link = element("a");
    link.href = URL.createObjectURL(new Blob([text], { type: "application/json" }));
    link.download = "accepted.json";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    said.textContent = `accepted.json has ${made} new of ${made + kept.length} entries. Check again with --baseline accepted.json.` + open;
  });

  place.before(bar, said);
  (document.getElementById("desk-side") ?? document.createElement("i")).append(form);
  if (!form.isConnected) bar.after(form);
  // The 3D view may be missing although its place is there.
  document.addEventListener("no-desk", () => bar.after(form));
  rows.forEach(showRow);
  count();
  window.review = { accepted };
})();
