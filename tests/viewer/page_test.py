"""The page of a report in headless Chromium: page_test.py GOUGECHECK MAKE_SAMPLES FOLDER."""

import os
import shutil
import subprocess
import sys

from browser import Browser, find_chromium, read_png

DRAWN = "(() => { desk.draw(); desk.renderer.gl.finish(); return true; })()"
# Until the camera has arrived, and what follows a flight is drawn.
STILL = """new Promise(done => { const look = () => desk.isFlying ? setTimeout(look, 30) : setTimeout(done, 200); setTimeout(look, 100); })"""


class Failures:
    def __init__(self):
        self.count = 0

    def check(self, is_right, words):
        print(("ok    " if is_right else "WRONG ") + words, flush=True)
        self.count += 0 if is_right else 1


def report_of(gougecheck, folder, path="pocket.apt", more=("--fixture", "clamp.stl", "--reviewer", "A. Noether")):
    done = subprocess.run([gougecheck, "check", path, "--part", "part.stl", "--tools", "tools.json", "--report", "r", *more],
                          cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 1:
        raise RuntimeError(done.stderr)
    return os.path.join(folder, "r")


def ramp_place(page, pixel):
    """Where on the colour scale a pixel is, whatever its light; None for grey."""
    if max(pixel) - min(pixel) < 24:
        return None
    best = min(range(33), key=lambda k: min(
        sum((light * c - p) ** 2 for c, p in zip(page["ramp"][k], pixel)) for light in (0.8, 0.86, 0.92, 0.97, 1.03, 1.1)))
    return best / 32


def check_colours(browser, picture, found):
    """Ten points of the surface, seen in the same direction in the view and in the heat map."""
    browser.evaluate("desk.shows.path = desk.shows.tool = false; desk.camera.look(desk.json.view); desk.camera.fit(desk.box);")
    browser.evaluate(DRAWN)
    page = browser.evaluate("""(() => {
      const c = desk.camera, mesh = desk.surface.mesh, values = desk.values[0], seen = [], box = [1e9, -1e9, 1e9, -1e9];
      const place = i => [0, 1, 2].map(k => mesh.from[k] + mesh.places[4 * i + k] * mesh.step);
      for (const range of desk.ranges.filter(one => one.isPart)) for (let i = range.first; i < range.first + range.count; ++i) {
        const [x, y] = c.project(place(mesh.corners[i]));
        box[0] = Math.min(box[0], x); box[1] = Math.max(box[1], x); box[2] = Math.min(box[2], y); box[3] = Math.max(box[3], y);
      }
      const gouged = [...values.keys()].filter(i => values[i] > 0), every = Math.max(1, Math.floor(gouged.length / 120));
      for (let k = 0; k < gouged.length; k += every) {
        const i = gouged[k], [x, y] = c.project(place(i)), at = desk.surfaceAt(x, y);
        if (at && Math.abs(at.mm - desk.json.scale.high * (values[i] / 65535) ** (desk.json.scale.root ? 2 : 1)) < 1e-3) seen.push([x, y]);
      }
      return { box, seen, ramp: desk.json.scale.ramp, width: c.width, height: c.height };
    })()""")
    pixels = browser.evaluate("""(points => { const g = desk.renderer.gl, out = [], p = new Uint8Array(4);
      for (const [x, y] of points) { g.readPixels(Math.floor(x * desk.ratio), desk.renderer.canvas.height - 1 - Math.floor(y * desk.ratio), 1, 1,
        g.RGBA, g.UNSIGNED_BYTE, p); out.push([p[0], p[1], p[2]]); } return out; })(""" + str(page["seen"]) + ")")
    width, height, rows = read_png(picture)
    scale = width / 1600
    left, right, top, bottom = (int(v * scale) for v in (36, 804, 118, 886))  # the heat map's first view
    dark = [(x, y) for y in range(top, bottom) for x in range(left, right)
            if max(rows[y][x]) < 235 and (x > 150 * scale or y < bottom - 90 * scale)]
    low_x, high_x = min(x for x, _ in dark), max(x for x, _ in dark)
    low_y = min(y for _, y in dark)
    ratio = (high_x + 1 - low_x) / (page["box"][1] - page["box"][0])
    compared, worst = 0, 0.0
    for (x, y), pixel in zip(page["seen"], pixels):
        px, py = low_x + (x - page["box"][0]) * ratio, low_y + (y - page["box"][2]) * ratio
        here = ramp_place(page, pixel)
        if here is None or not (left < px < right and top < py < bottom):
            continue
        # On a border between two colours half a pixel decides: those are left out.
        near = [ramp_place(page, rows[int(py) + dy][int(px) + dx]) for dy in (-3, 0, 3) for dx in (-3, 0, 3)]
        if None in near or max(near) - min(near) > 0.12:
            continue
        compared += 1
        worst = max(worst, min(abs(one - here) for one in near))
    found.check(compared >= 10, f"{compared} points of the surface compared with the heat map")
    found.check(worst <= 0.08, f"the colours differ by {worst:.3f} of the scale at most")
    browser.evaluate("desk.shows.path = desk.shows.tool = true; desk.redraw();")


def check_page(browser, report, found):
    browser.open(os.path.join(report, "report.html"))
    browser.wait("!!window.desk")
    found.check(browser.evaluate("!document.getElementById('desk-view').hidden"), "the 3D view is shown")
    found.check(browser.evaluate("getComputedStyle(document.getElementById('heat_map')).display") == "none",
                "the heat map makes room for it")
    check_colours(browser, os.path.join(report, "heat_map.png"), found)
    title = "document.getElementById('desk-title').textContent"
    found.check(browser.evaluate(title) == "Finding 1 of 3: gouge", "the worst finding is shown first")
    before = str(browser.evaluate("desk.camera.centre"))
    browser.evaluate("document.querySelectorAll('#findings tbody tr')[1].click()")
    browser.evaluate(STILL)
    found.check(browser.evaluate(title) == "Finding 2 of 3: gouge", "a click on a finding shows it")
    browser.wait(f"String(desk.camera.centre) !== String({before})")
    found.check(True, "and flies there")
    found.check("1.000 mm" in browser.evaluate("document.getElementById('desk-facts').textContent"), "with its numbers")
    found.check(browser.evaluate("document.querySelector('#desk-facts pre .it i').textContent") == "151" and
                browser.evaluate("document.querySelectorAll('#desk-facts pre span').length") == 7, "and the lines around its statement")
    found.check(browser.evaluate("document.getElementById('desk-where').textContent").startswith("move 136 of 137, line 151, t = 0.42"),
                "and the instant")
    browser.evaluate("document.activeElement?.blur()")
    browser.key("j", "KeyJ")
    browser.evaluate(STILL)
    found.check(browser.evaluate(title) == "Finding 3 of 3: gouge", "j goes on")
    browser.key("k", "KeyK")
    browser.evaluate(STILL)
    found.check(browser.evaluate(title) == "Finding 2 of 3: gouge", "k goes back")
    browser.key("f", "KeyF")
    browser.wait("desk.camera.centre.every(x => Math.abs(x) < 20) && Math.abs(desk.camera.pivot[0]) < 1e-9")
    found.check(True, "f fits")
    browser.evaluate("(() => { const s = document.getElementById('desk-along'); s.value = 10; s.dispatchEvent(new Event('input', {bubbles: true})); })()")
    found.check(browser.evaluate("document.getElementById('desk-where').textContent").startswith("move 10 of 137"), "the slider along the path")
    browser.evaluate("(() => { const s = document.getElementById('desk-t'); s.value = 0.5; s.dispatchEvent(new Event('input', {bubbles: true})); })()")
    found.check("t = 0.500" in browser.evaluate("document.getElementById('desk-where').textContent"), "the slider along the move")
    at = browser.evaluate("desk.at")
    browser.key(" ", "Space")
    browser.wait(f"desk.at > {at}")
    browser.key(" ", "Space")
    found.check(True, "space runs the tool")
    browser.evaluate("document.querySelector('[data-do=section]').click()")
    browser.evaluate(DRAWN)
    found.check(browser.evaluate("!!desk.plane()") and browser.evaluate("document.getElementById('desk-turn').hidden") is False, "a section is cut")
    browser.evaluate("document.querySelector('[data-do=section]').click(); document.querySelector('[data-do=measure]').click(); desk.view('top')")
    browser.wait("desk.camera.toward[2] > 1 - 1e-12")
    browser.evaluate(STILL)
    browser.evaluate("document.getElementById('desk-view').scrollIntoView()")
    box = browser.evaluate("(() => { const b = desk.renderer.canvas.getBoundingClientRect(); return [b.x, b.y]; })()")
    for corner in ("[desk.box[0][0] + 5, desk.box[0][1] + 5, 0]", "[desk.box[1][0] - 5, desk.box[0][1] + 5, 0]"):
        x, y, _ = browser.evaluate(f"desk.camera.project({corner})")
        browser.click(box[0] + x, box[1] + y)
    wanted = browser.evaluate("desk.box[1][0] - desk.box[0][0] - 10")
    told = browser.evaluate("document.getElementById('desk-status').textContent")
    found.check(abs(float(told.split(" mm")[0] or 0) - wanted) < 1.5 if " mm" in told else False, "two points are measured: " + told)
    rows = "document.querySelectorAll('#findings tbody tr').length"
    browser.evaluate("(() => { const s = document.querySelector('[data-filter=depth]'); s.value = 0.5; s.dispatchEvent(new Event('input', {bubbles: true})); })()")
    found.check(browser.evaluate(rows) == 2, "a filter by depth")
    browser.evaluate("document.querySelector('.filters:not(.review-bar) button').click()")
    browser.evaluate("[...document.querySelectorAll('#findings th button')].find(b => b.textContent === 'Line').click()")
    found.check(browser.evaluate("[...document.querySelectorAll('#findings tbody tr')].map(r => parseInt(r.cells[2].textContent))") == [136, 143, 151],
                "a click on a column sorts")


def check_large(browser, found):
    """What leaves out the back of a large closed mesh shows the same of a small one."""
    browser.evaluate("desk.camera.look(desk.json.view); desk.camera.fit(desk.box)")
    outward, inward = browser.evaluate("""(() => {
      const seen = facing => { for (const range of desk.ranges) range.facing = facing; desk.draw();
        const g = desk.renderer.gl, c = desk.renderer.canvas, p = new Uint8Array(4 * c.width * c.height);
        g.readPixels(0, 0, c.width, c.height, g.RGBA, g.UNSIGNED_BYTE, p); return p; };
      const both = seen(0);
      return [1, -1].map(facing => seen(facing).reduce((n, v, i) => n + (i % 4 === 0 && Math.abs(v - both[i]) > 16 ? 1 : 0), 0)
        / (both.length / 4)); })()""")
    found.check(outward < 1e-3 < 0.05 < inward, f"faces turned away are left out unseen ({outward:.5f}; the others: {inward:.3f})")
    browser.evaluate("for (const range of desk.ranges) range.facing = 0; desk.redraw();")


def check_stock(browser, report, found):
    """The stock that is left is a veil over the part, and the button Stock takes it away."""
    browser.open(os.path.join(report, "report.html"))
    browser.wait("!!window.desk")
    found.check(browser.evaluate("desk.shows.stock && desk.stock.mesh.corners.length > 1000"), "a finding in stock shows the stock")
    size = browser.evaluate("[0, 1, 2].map(k => desk.stock.mesh.places.filter((_, i) => i % 4 === k)"
                            ".reduce((most, v) => Math.max(most, v), 0) * desk.stock.mesh.step)")
    found.check(90 <= size[0] < 90.5, f"the stock is 5 mm larger than the part ({size[0]:.3f} mm long)")
    changed = browser.evaluate("""(() => {
      const seen = isShown => { desk.shows.stock = isShown; desk.draw();
        const g = desk.renderer.gl, c = desk.renderer.canvas, p = new Uint8Array(4 * c.width * c.height);
        g.readPixels(0, 0, c.width, c.height, g.RGBA, g.UNSIGNED_BYTE, p); return p; };
      const without = seen(false), veiled = seen(true);
      return veiled.reduce((n, v, i) => n + (i % 4 === 2 && without[i] !== v ? 1 : 0), 0) / (veiled.length / 4); })()""")
    found.check(0.1 < changed < 0.9, f"it veils {changed:.2f} of the picture")
    browser.evaluate("document.querySelector('[data-show=\"stock\"]').click()")
    found.check(browser.evaluate("!desk.shows.stock"), "the button takes it away")


def check_paper(browser, report, found):
    browser.open(os.path.join(report, "report.html"))
    browser.wait("!!window.desk")
    browser.call("Emulation.setEmulatedMedia", media="print")
    shown = "getComputedStyle(document.querySelector('{}')).display"
    found.check(browser.evaluate(shown.format("#desk-view")) == "none" and browser.evaluate(shown.format("#heat_map")) != "none",
                "on paper the heat map stands for the view")
    found.check(browser.evaluate(shown.format(".sign")) != "none" and browser.evaluate(shown.format(".filters")) == "none",
                "with lines to sign and no boxes")
    # A button in the head of a table keeps Chromium from repeating the head on every page.
    found.check(browser.evaluate(shown.format("#findings th button")) == "contents", "heads of columns are plain text")
    browser.call("Emulation.setEmulatedMedia", media="")


def check_phone(browser, report, found):
    browser.call("Emulation.setDeviceMetricsOverride", width=390, height=844, deviceScaleFactor=2, mobile=True)
    browser.open(os.path.join(report, "report.html"))
    browser.wait("!!window.desk")
    found.check(browser.evaluate("document.documentElement.scrollWidth") == 390, "on a phone the page is no wider than the screen")
    found.check(browser.evaluate("desk.renderer.canvas.getBoundingClientRect().height") > 300, "and the view has room")


def check_without_script(browser, report, found):
    browser.call("Emulation.setScriptExecutionDisabled", value=True)
    browser.call("Page.navigate", url="file://" + os.path.abspath(os.path.join(report, "report.html")))
    browser.wait("!!document.querySelector('footer')")
    shown = "getComputedStyle(document.querySelector('{}')).display"
    found.check(browser.evaluate(shown.format("#heat_map")) != "none" and browser.evaluate(shown.format("#desk-view")) == "none",
                "without scripts the pictures stand")
    found.check(browser.evaluate("document.querySelectorAll('#findings tbody tr').length") == 3, "and every finding")
    found.check("pictures" in browser.evaluate("document.querySelector('noscript')?.textContent ?? ''"), "and the page says so")


def run_on_samples(check_all):
    """Makes the samples in the folder of the command line, and ends the test: 77 without a browser, 1 if a check fails."""
    gougecheck, make_samples, folder = sys.argv[1:4]
    if find_chromium() is None:
        print("skipped: chromium is not installed (Debian 12: apt-get install chromium)")
        sys.exit(77)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    subprocess.run([make_samples, folder], check=True, stdout=subprocess.DEVNULL)
    found = Failures()
    check_all(gougecheck, folder, found)
    sys.exit(1 if found.count else 0)


def check_all(gougecheck, folder, found):
    report = report_of(gougecheck, os.path.join(folder, "pocket"))
    browser = Browser(1200, 1000)
    try:
        check_page(browser, report, found)
        check_large(browser, found)
        found.check(browser.evaluate("document.querySelector('[data-show=\"stock\"]').hidden"), "without --stock there is no button")
        stock = report_of(gougecheck, os.path.join(folder, "rapid_stock"), "rapid_stock.apt", ("--stock", "part+5"))
        check_stock(browser, stock, found)
        check_paper(browser, report, found)
        check_phone(browser, report, found)
        found.check(browser.errors == [], "the console has no error " + "; ".join(browser.errors))
    finally:
        browser.close()
    plain = Browser(1200, 1000, ["--disable-3d-apis"])
    try:
        plain.open(os.path.join(report, "report.html"))
        plain.wait("document.getElementById('desk-view').hidden")
        found.check(plain.evaluate("getComputedStyle(document.getElementById('heat_map')).display") != "none",
                    "without WebGL the pictures stand")
        found.check(plain.evaluate("!document.getElementById('desk-missing').hidden"), "and the page says why")
        check_without_script(plain, report, found)
    finally:
        plain.close()


if __name__ == "__main__":
    run_on_samples(check_all)
