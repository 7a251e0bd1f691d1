#!/usr/bin/env python3
"""measure_page.py REPORT.html: how long a reader waits for a report, in headless Chromium with software rendering.

Prints, for three browsers and two visits each, milliseconds from the visit to the scene in memory and to its first
frame on the screen (pixels read back); then how the table of findings scrolls, from its first row to its last.
"""
import json
import sys
import time

from browser import Browser

FIRST_FRAME = """
window.times = {};
(function look() {
  if (window.desk) {
    const gl = desk.renderer.gl;
    window.times.scene ??= performance.now();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    window.times.frame = performance.now();
  } else requestAnimationFrame(look);
})();"""
SCROLL = """
window.frames_ms = [];
(() => {
  const box = document.querySelector('#findings').closest('.long') ?? document.scrollingElement;
  let last = performance.now(), step = 0;
  const scroll = () => {
    const now = performance.now();
    window.frames_ms.push(now - last);
    last = now;
    box.scrollTop = ++step * box.scrollHeight / 120;
    if (step < 120) requestAnimationFrame(scroll); else window.isAtEnd = true;
  };
  requestAnimationFrame(scroll);
})();"""


def main():
    for browser in range(3):
        page = Browser(1200, 1000)
        page.call("Page.enable")
        page.call("Page.addScriptToEvaluateOnNewDocument", source=FIRST_FRAME)
        for visit in range(2):
            page.open(sys.argv[1])
            page.wait("window.times && window.times.frame > 0")
            times = json.loads(page.evaluate("JSON.stringify(window.times)"))
            print(f"browser {browser + 1}, visit {visit + 1}: scene {times['scene']:.0f} ms, first frame {times['frame']:.0f} ms")
        if browser == 2:
            time.sleep(2)
            page.evaluate(SCROLL)
            page.wait("window.isAtEnd", 6000)
            frames = sorted(json.loads(page.evaluate("JSON.stringify(window.frames_ms)")))
            print(f"{page.evaluate('findings.count()')} findings scrolled in {len(frames)} frames: median "
                  f"{frames[len(frames) // 2]:.1f} ms, 95 % within {frames[len(frames) * 95 // 100]:.1f} ms, longest {frames[-1]:.1f} ms")
        page.close()


main()
