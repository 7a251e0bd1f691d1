// Mouse, touch and keys over the picture.
const listenToPicture = (desk, canvas, onClick) => {
  const fingers = new Map();
  let moved = 0, pinch = 0;
  const place = event => { const box = canvas.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top]; };
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return { middle: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], apart: Math.hypot(a[0] - b[0], a[1] - b[1]) };
  };
  canvas.addEventListener('pointerdown', event => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, place(event));
    if (fingers.size === 1) moved = 0;
    if (fingers.size === 2) pinch = spread();
    desk.stopFlight();
  });
  canvas.addEventListener('pointermove', event => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const now = place(event), dx = now[0] - before[0], dy = now[1] - before[1];
    fingers.set(event.pointerId, now);
    moved += Math.hypot(dx, dy);
    if (fingers.size === 2) {
      const next = spread();
      desk.camera.pan(next.middle[0] - pinch.middle[0], next.middle[1] - pinch.middle[1]);
      desk.camera.zoom(pinch.apart / Math.max(next.apart, 1), ...next.middle);
      pinch = next;
    } else if (event.shiftKey || event.buttons === 2 || event.buttons === 4) {
      desk.camera.pan(dx, dy);
    } else {
      desk.camera.turn(dx, dy);
    }
    desk.redraw();
  });
  const lift = event => {
    const was = fingers.delete(event.pointerId);
    if (was && event.type === 'pointerup' && moved < 5 && event.button === 0) onClick(...place(event));
  };
  canvas.addEventListener('pointerup', lift);
  canvas.addEventListener('pointercancel', lift);
  canvas.addEventListener('contextmenu', event => event.preventDefault());
  canvas.addEventListener('wheel', event => {
    event.preventDefault();
    desk.stopFlight();
    desk.camera.zoom(Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * 0.003), ...place(event));
    desk.redraw();
  }, { passive: false });
  canvas.addEventListener('dblclick', event => {
    const found = desk.surfaceAt(...place(event));
    if (found) desk.fly(camera => { camera.centre = camera.pivot = found.at; });
  });
  canvas.addEventListener('keydown', event => {
    const turns = { ArrowLeft: [-40, 0], ArrowRight: [40, 0], ArrowUp: [0, -40], ArrowDown: [0, 40] };
    if (turns[event.key]) desk.camera.turn(...turns[event.key]);
    else if (event.key === '+' || event.key === '-') desk.camera.zoom(event.key === '+' ? 0.8 : 1.25);
    else return;
    event.preventDefault();
    desk.redraw();
  });
};

const listenToKeys = actions => document.addEventListener('keydown', event => {
  if (event.ctrlKey || event.altKey || event.metaKey || /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName) &&
      event.target.type !== 'range') return;
  const action = actions[event.key];
  if (!action) return;
  event.preventDefault();
  action();
});
