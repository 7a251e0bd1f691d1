"""The review of findings, its export, and the page of a batch in headless Chromium: review_test.py GOUGECHECK MAKE_SAMPLES
FOLDER."""

import json
import os
import shutil
import subprocess
import urllib.parse

from browser import Browser
from page_test import report_of, run_on_samples

FILL = """(([name, value]) => { const c = document.querySelector(`.review-form [data-review=${name}]`); c.value = value;
  c.dispatchEvent(new Event('input', {bubbles: true})); })"""
CELL = "document.querySelectorAll('#findings tbody td.review')[{}].textContent"
LINE = "document.getElementById('review-line').textContent"
OPTIONS = ["--part", "part.stl", "--fixture", "clamp.stl", "--tools", "tools.json"]


def fill(browser, name, value):
    browser.evaluate(f"{FILL}({json.dumps([name, value])})")


def choose(browser, row):
    browser.evaluate(f"document.querySelectorAll('#findings tbody tr')[{row}].click()")


def open_report(browser, report, has_desk=True):
    browser.open(os.path.join(report, "report.html"))
    browser.wait("!!window.desk" if has_desk else "!!window.review")


def check_review(browser, report, found):
    open_report(browser, report)
    found.check(browser.evaluate("!!document.querySelector('#desk-side .review-form:not([hidden])')"), "the form is beside the view")
    # The width that a vertical scroll bar leaves of the panel.
    browser.evaluate("document.getElementById('desk-side').style.flexBasis = '284px'")
    found.check(browser.evaluate("(s => s.scrollWidth <= s.clientWidth)(document.getElementById('desk-side'))"),
                "the form fits its panel beside a scroll bar")
    found.check(browser.evaluate("document.querySelector('.banner ul').textContent").startswith("Finding 1, line 143: gouge: 2.000 mm"),
                "the banner names what is open")
    found.check(browser.evaluate("document.querySelector('.review-bar button').disabled"), "there is nothing to export")
    choose(browser, 0)
    fill(browser, "status", "to fix")
    fill(browser, "assignee", "E. Galois")
    choose(browser, 1)
    fill(browser, "status", "accepted")
    found.check("needs its reason" in browser.evaluate("document.querySelector('.review-form p').textContent"), "an acceptance needs a reason")
    fill(browser, "comment", 'a "soft" clamp </script> \u00e4\u2028\n\u0001 end')
    found.check(browser.evaluate(CELL.format(0)) == "to fix E. Galois", "the table shows status and assignee")
    found.check(browser.evaluate(LINE).startswith("Review in this browser: 1 open, 1 to fix, 1 accepted."), "and the head counts them")
    open_report(browser, report)
    found.check(browser.evaluate(CELL.format(0)) == "to fix E. Galois", "the browser keeps the review")
    browser.evaluate("(() => { const s = document.querySelector('[data-filter=\"any review\"]'); s.value = 'to fix'; "
                     "s.dispatchEvent(new Event('input', {bubbles: true})); })()")
    found.check(browser.evaluate("document.querySelectorAll('#findings tbody tr').length") == 1, "a filter by status")
    browser.evaluate("document.querySelector('.filters:not(.review-bar) button').click()")


def check_export(browser, gougecheck, folder, found):
    """The exported file is one that --baseline accepts, and its acceptance is applied."""
    made = browser.evaluate("review.accepted()")
    found.check(made["made"] == 1 and made["left"] == [], "one finding is exported")
    with open(os.path.join(folder, "accepted.json"), "w", encoding="utf-8") as out:
        out.write(made["text"])
    done = subprocess.run([gougecheck, "check", "pocket.apt", *OPTIONS, "--baseline", "accepted.json", "--report", "b",
                           "--json", "b.json"], cwd=folder, capture_output=True, text=True, check=False)
    found.check("1 applied, 0 with nothing left to accept, 0 void" in done.stdout, "and --baseline applies it: " + done.stderr)
    entry = json.loads(made["text"])["accepted"][0]
    told = subprocess.run([gougecheck, "accept", "r/result.json", "--finding", "2", "--reason", entry["reason"], "--by", entry["by"],
                           "--date", entry["date"], "-o", "same.json"], cwd=folder, capture_output=True, text=True, check=False)
    with open(os.path.join(folder, "same.json"), encoding="utf-8") as source:
        found.check(json.load(source)["accepted"] == [entry], "it is the entry that accept writes " + told.stderr)
    open_report(browser, os.path.join(folder, "b"))
    head = browser.evaluate("[...document.querySelectorAll('#findings th')].map(h => h.textContent)")
    place = head.index("Acceptance")
    reason = browser.evaluate(f"[...document.querySelectorAll('#findings tbody tr')].map(r => r.cells[{place}].textContent)")
    found.check(any("accepted by A. Noether on" in text and "a \"soft\" clamp" in text for text in reason), "the reason has its column")
    found.check("Finding 2" not in browser.evaluate("document.querySelector('.banner ul').textContent"), "the banner leaves it out")
    choose(browser, 0)
    fill(browser, "status", "accepted")
    fill(browser, "comment", "it is ground afterwards")
    found.check(browser.evaluate("review.accepted().left.length") == 1, "an acceptance needs a reviewer")
    browser.evaluate("(() => { const r = document.querySelector('[data-review=reviewer]'); r.value = 'R. Miller'; "
                     "r.dispatchEvent(new Event('input', {bubbles: true})); })()")
    made = browser.evaluate("review.accepted()")
    found.check(made["made"] == 1 and len(json.loads(made["text"])["accepted"]) == 2, "a second export keeps the first entry")
    with open(os.path.join(folder, "accepted.json"), "w", encoding="utf-8") as out:
        out.write(made["text"])
    done = subprocess.run([gougecheck, "check", "pocket.apt", *OPTIONS, "--baseline", "accepted.json"],
                          cwd=folder, capture_output=True, text=True, check=False)
    found.check("2 applied, 0 with nothing left to accept, 0 void" in done.stdout, "and both apply: " + done.stderr)


def check_batch(browser, gougecheck, folder, found):
    for name in ("rough", "finish one"):
        os.makedirs(os.path.join(folder, "ops", name), exist_ok=True)
        shutil.copy(os.path.join(folder, "pocket.apt"), os.path.join(folder, "ops", name, "op10.apt"))
    shutil.copy(os.path.join(folder, "pocket.apt"), os.path.join(folder, "ops", "op20.apt"))
    done = subprocess.run([gougecheck, "batch", "ops", *OPTIONS, "--project", "Impeller 7", "--reviewer", "A. Noether", "-o", "night"],
                          cwd=folder, capture_output=True, text=True, check=False)
    page = os.path.join(folder, "night", "index.html")
    found.check(done.returncode == 1 and os.path.exists(page), "a folder is a batch: " + done.stderr)
    browser.open(page)
    names = browser.evaluate("[...document.querySelectorAll('tbody tr')].map(r => r.dataset.job)")
    found.check(sorted(names) == ["finish one-op10", "op20", "rough-op10"], f"toolpaths of one name have names of their own: {names}")
    head = browser.evaluate("document.querySelector('.facts').textContent")
    found.check(all(word in head for word in ("Impeller 7", "A. Noether", "gougecheck batch ops --part=part.stl")), "the page has its head")
    size = browser.evaluate("(() => { const b = document.querySelector('td.picture a').getBoundingClientRect(); return [b.width, b.height]; })()")
    found.check(size[0] >= 180 and size[1] >= 160, f"thumbnails can be read: {size}")
    browser.call("Emulation.setEmulatedMedia", media="print")
    found.check(browser.evaluate("getComputedStyle(document.querySelector('.sign')).display") != "none", "paper has lines to sign")
    browser.call("Emulation.setEmulatedMedia", media="")
    place = "decodeURIComponent(location.pathname.split('/').at(-2))"
    browser.evaluate("document.querySelector('tbody tr td:nth-child(2) a').click()")
    browser.wait("!!document.querySelector('nav')")
    for way, wanted in ((2, names[1]), (2, names[2]), (1, names[1])):
        browser.evaluate(f"document.querySelectorAll('nav a')[{way}].click()")
        browser.wait(f"{place} === {json.dumps(wanted)} && document.readyState === 'complete'")
        found.check(True, f"a report leads to {wanted}")
    browser.evaluate("document.querySelectorAll('nav a')[0].click()")
    browser.wait("location.pathname.endsWith('index.html') && document.readyState === 'complete'")
    found.check(browser.evaluate("document.querySelector('tr.here').dataset.job") == names[1], "and back to its row")
    browser.call("Page.navigate", url="file://" + page + "#after=" + urllib.parse.quote(names[2]))
    browser.wait("document.getElementById('shown').textContent.includes('last report')")
    found.check(True, "the last report says so")


def check_all(gougecheck, folder, found):
    sample = os.path.join(os.path.abspath(folder), "pocket")
    report = report_of(gougecheck, sample)
    browser = Browser(1200, 1000)
    try:
        check_review(browser, report, found)
        check_export(browser, gougecheck, sample, found)
        check_batch(browser, gougecheck, sample, found)
        found.check(browser.errors == [], "the console has no error " + "; ".join(browser.errors))
    finally:
        browser.close()
    plain = Browser(1200, 1000, ["--disable-3d-apis"])
    try:
        open_report(plain, report, has_desk=False)
        choose(plain, 0)
        found.check(plain.evaluate("document.querySelector('.review-form').getBoundingClientRect().height") > 50, "without WebGL the form is above the table")
    finally:
        plain.close()


if __name__ == "__main__":
    run_on_samples(check_all)
