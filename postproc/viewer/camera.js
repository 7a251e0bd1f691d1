// A parallel view: unit directions, the point in the middle, and millimetres a pixel of the page.
class Camera {
  constructor(toward) {
    this.centre = [0, 0, 0];
    this.pivot = [0, 0, 0];
    this.scale = 1;
    this.width = this.height = 1;
    this.look(toward);
  }

  look(toward) {
    this.toward = unit(toward);
    const hint = Math.abs(this.toward[2]) > 0.9999 ? [0, 1, 0] : [0, 0, 1];
    this.right = unit(cross(hint, this.toward));
    this.up = cross(this.toward, this.right);
  }

  // Where a point is seen, in pixels of the page, and how near.
  project(p) {
    const d = sub(p, this.centre);
    return [this.width / 2 + dot(d, this.right) / this.scale, this.height / 2 - dot(d, this.up) / this.scale,
            dot(d, this.toward)];
  }
  // The point of the middle plane that is seen there.
  unproject(x, y) {
    return add(add(this.centre, times(this.right, (x - this.width / 2) * this.scale)),
               times(this.up, (this.height / 2 - y) * this.scale));
  }

  // All corners of a box are seen, with some room around them.
  fit(box, room = 0.86) {
    let least = [1e30, 1e30], most = [-1e30, -1e30];
    for (let k = 0; k < 8; ++k) {
      const p = [0, 1, 2].map(axis => box[k >> axis & 1][axis]), at = [dot(p, this.right), dot(p, this.up)];
      least = [Math.min(least[0], at[0]), Math.min(least[1], at[1])];
      most = [Math.max(most[0], at[0]), Math.max(most[1], at[1])];
    }
    const middle = times(add(box[0], box[1]), 0.5);
    const off = [(least[0] + most[0]) / 2 - dot(middle, this.right), (least[1] + most[1]) / 2 - dot(middle, this.up)];
    this.centre = add(add(middle, times(this.right, off[0])), times(this.up, off[1]));
    this.pivot = middle;
    this.scale = Math.max((most[0] - least[0]) / this.width, (most[1] - least[1]) / this.height, 1e-6) / room;
  }

  // Turns what is seen by pixels of the page, about the pivot.
  turn(dx, dy) {
    const yaw = -dx * 0.008, pitch = -dy * 0.008, vertical = [0, 0, 1];
    const turnAll = (axis, angle) => {
      for (const name of ['right', 'up', 'toward']) this[name] = unit(turned(this[name], axis, angle));
      this.centre = add(this.pivot, turned(sub(this.centre, this.pivot), axis, angle));
    };
    const isFlat = Math.abs(this.up[2]) < 0.05;
    turnAll(isFlat ? this.up : vertical, isFlat || this.up[2] > 0 ? yaw : -yaw);
    turnAll(this.right, pitch);
  }

  pan(dx, dy) {
    this.centre = sub(this.centre, sub(times(this.right, dx * this.scale), times(this.up, dy * this.scale)));
  }

  zoom(factor, x = this.width / 2, y = this.height / 2) {
    const before = this.unproject(x, y);
    this.scale *= factor;
    this.centre = add(this.centre, sub(before, this.unproject(x, y)));
  }

  state() { return { centre: this.centre, toward: this.toward, right: this.right, up: this.up, scale: this.scale }; }

  // Part of the way from one state to another.
  blend(a, b, t) {
    const ease = t * t * (3 - 2 * t);
    this.toward = between(a.toward, b.toward, ease);
    const up = mix(a.up, b.up, ease);
    this.right = unit(cross(length(cross(up, this.toward)) > 1e-6 ? up : b.up, this.toward));
    this.up = cross(this.toward, this.right);
    this.centre = mix(a.centre, b.centre, ease);
    this.scale = Math.exp(Math.log(a.scale) + (Math.log(b.scale) - Math.log(a.scale)) * ease);
  }
}
