"""Views, full screen, dark screens and long names of a report in headless Chromium: look_test.py GOUGECHECK MAKE_SAMPLES
FOLDER."""

import os
import shutil
import subprocess

from browser import Browser
from page_test import STILL, report_of, run_on_samples

LARGEST_COSINE = "Math.max(...desk.camera.toward.map(Math.abs))"
CLICK = "document.querySelector('[data-{}={}]').click()"
IS_SEEN = """(() => { const p = desk.finding.point.map((x, k) => x - desk.middle[k]), [x, y] = desk.camera.project(p), hit = desk.surfaceAt(x, y);
  return !hit || Math.hypot(...hit.at.map((c, k) => c - p[k])) < 1; })()"""
LONG = "x".join(["OP40_finish_blade_suction_side_revision_C"] * 3)


def check_views(browser, report, found):
    browser.open(os.path.join(report, "report.html"))
    browser.wait("!!window.desk")
    toward, x = browser.evaluate("[desk.camera.toward, desk.camera.right[0]]")
    found.check(all(abs(abs(c) - 3 ** -0.5) < 1e-9 for c in toward), f"the first view is isometric: {toward}")
    found.check(x > 0.5 and toward[2] > 0, "with X to the right, from above")
    for view in ("top", "front", "right", "bottom"):
        browser.evaluate(CLICK.format("view", view))
        browser.evaluate(STILL)
        for row in range(3):
            browser.evaluate(f"document.querySelectorAll('#findings tbody tr')[{row}].click()")
            browser.evaluate(STILL)
            found.check(browser.evaluate(LARGEST_COSINE) < 0.95, f"from {view}, finding {row + 1} is seen at an angle")
            found.check(browser.evaluate(IS_SEEN), "and not hidden")
    browser.evaluate("document.querySelectorAll('#findings tbody tr')[0].click()")
    browser.evaluate(STILL)
    before = browser.evaluate("desk.camera.toward")
    browser.evaluate(CLICK.format("do", "section"))
    browser.evaluate(STILL)
    faced = "desk.camera.toward.reduce((sum, c, k) => sum + c * desk.plane().normal[k], 0)"
    found.check(browser.evaluate(faced) > 1 - 1e-9, "the view faces the section")
    browser.evaluate("(() => { const s = document.getElementById('desk-turn'); s.value = 50; s.dispatchEvent(new Event('input', {bubbles: true})); })()")
    found.check(browser.evaluate(faced) > 1 - 1e-9, "and follows it when it turns")
    browser.evaluate("document.querySelectorAll('#findings tbody tr')[1].click()")
    browser.evaluate(STILL)
    found.check(browser.evaluate(faced) > 1 - 1e-9, "and at the next finding")
    browser.evaluate(CLICK.format("do", "section"))
    browser.evaluate(STILL)
    after = browser.evaluate("desk.camera.toward")
    found.check(sum(a * b for a, b in zip(before, after)) > 1 - 1e-6, "without the section the view is as before")


def check_full_screen(browser, found):
    height = "desk.renderer.canvas.getBoundingClientRect().height"
    small = browser.evaluate(height)
    browser.evaluate("document.getElementById('desk-view').requestFullscreen = undefined")  # as on phones
    browser.evaluate(CLICK.format("do", "fill"))
    browser.evaluate(STILL)
    box = browser.evaluate("(() => { const b = document.getElementById('desk-view').getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()")
    found.check(box == [0, 0, 1200, 1000], f"the view fills the window: {box}")
    found.check(browser.evaluate(height) > small + 100, "and the picture grows")
    browser.key("Escape")
    browser.evaluate(STILL)
    found.check(browser.evaluate(height) == small, "Esc leaves")


def check_dark(browser, report, found):
    light = "(c => c.match(/[0-9.]+/g).slice(0, 3).reduce((a, b) => a + Number(b), 0) / 765)"
    ground = light + "(getComputedStyle(document.querySelector('main')).backgroundColor)"
    ink = light + "(getComputedStyle(document.querySelector('#findings td')).color)"
    for scheme, is_dark in (("dark", True), ("light", False)):
        browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        browser.open(os.path.join(report, "report.html"))
        browser.wait("!!window.desk")
        found.check((browser.evaluate(ground) < 0.25) == is_dark and (browser.evaluate(ink) > 0.75) == is_dark, f"a {scheme} page")
        found.check(browser.evaluate("desk.over.isDark") == is_dark, f"and a {scheme} view")
    browser.call("Emulation.setEmulatedMedia", media="print", features=[{"name": "prefers-color-scheme", "value": "dark"}])
    found.check(browser.evaluate(ground) > 0.95 and browser.evaluate(ink) < 0.25, "paper is light")
    browser.call("Emulation.setEmulatedMedia", media="", features=[])


def check_long_names(browser, gougecheck, folder, found):
    with open(os.path.join(folder, "blade.cls"), encoding="ascii") as source:
        path = source.read().replace("TOOL PATH/BLADE_SPIRAL", "TOOL PATH/" + LONG)
    with open(os.path.join(folder, LONG + ".cls"), "w", encoding="ascii") as out:
        out.write(path)
    shutil.copy(os.path.join(folder, "blade.stl"), os.path.join(folder, LONG + ".stl"))
    subprocess.run([gougecheck, "check", LONG + ".cls", "--part", LONG + ".stl", "--tools", "tools.json", "--report", "r"],
                   cwd=folder, capture_output=True, check=False)
    for width in (1280, 390):
        browser.call("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=width < 500)
        browser.open(os.path.join(folder, "r", "report.html"))
        browser.wait("!!window.desk")
        found.check(browser.evaluate("document.documentElement.scrollWidth") == width, f"long names make no page wider than {width}")
        if width == 1280:
            out = browser.evaluate("[...document.querySelectorAll('.wide')].filter(w => w.scrollWidth > w.clientWidth + 1).length")
            found.check(out == 0, f"and push no column out of its table ({out})")


def check_all(gougecheck, folder, found):
    report = report_of(gougecheck, os.path.join(folder, "pocket"))
    browser = Browser(1200, 1000)
    try:
        check_views(browser, report, found)
        check_full_screen(browser, found)
        check_dark(browser, report, found)
        check_long_names(browser, gougecheck, os.path.join(folder, "blade"), found)
        found.check(browser.errors == [], "the console has no error " + "; ".join(browser.errors))
    finally:
        browser.close()


if __name__ == "__main__":
    run_on_samples(check_all)
