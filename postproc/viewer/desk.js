// The scene, what is shown of it, and the instant of the path.
const kStates = ['clean', 'near', 'gouge', 'buried', 'not checked', 'not certified'];
const kKinds = ['feed', 'rapid', 'arc', 'cycle'];
const kStateColours = ['#1860ba', '#b8860b', '#b2182b', '#7a0c58', '#ce7608', '#ce7608', '#9aa4af'];
const kColoursInDark = ['#5b9fe8', '#d9ad3c', '#f0606f', '#d45fb0', '#f0a23c', '#f0a23c', '#8d98a4'];
const kViews = { first: kIso, top: [0, 0, 1], bottom: [0, 0, -1], front: [0, -1, 0], back: [0, 1, 0], right: [1, 0, 0],
                 left: [-1, 0, 0] };
const kMostSeenThrough = 200000;  // triangles of a closed mesh that are drawn on both sides
const kMostSmooth = 300000;  // triangles that a software renderer draws with smooth edges
const rgbOf = hex => [1, 3, 5].map(k => parseInt(hex.slice(k, k + 2), 16) / 255);

const directionsOf = ({ toward, right, up }) => ({ toward, right, up });

class Desk {
  constructor(canvas, over, scene) {
    const { json, planes } = scene;
    this.json = json;
    const triangles = json.surface.meshes.reduce((sum, one) => sum + one.triangles, 0);
    this.renderer = new Renderer(canvas, triangles <= kMostSmooth || !isDrawnInSoftware());
    this.over = new Overlay(over);
    const mesh = meshOf(planes, json.surface);
    this.values = json.surface.values.map(run => summedOf(planes, run));
    this.boxOfParts(mesh);
    mesh.from = sub(json.surface.origin, this.middle);
    this.surface = this.renderer.surface(mesh);
    this.renderer.ramp(json.scale.ramp);
    this.heads = json.heads && this.renderer.surface(meshOf(planes, json.heads));
    this.stock = json.stock && this.renderer.surface(meshOf(planes, json.stock));
    if (this.stock) this.stock.mesh.from = sub(json.stock.origin, this.middle);
    this.tools = json.tools.map(tool => tool.runs.length > 0 ? this.renderer.tool(toolMesh(tool.runs)) : null);
    this.paths = json.paths.map(one => this.preparePath(pathOf(planes, one)));
    this.shows = { part: true, fixtures: true, path: true, tool: true, stock: Boolean(json.stock?.shown) };
    this.camera = new Camera(kIso);
    this.measured = [];
    this.turn = 0;
    this.isAsked = true;  // nothing is drawn before begin()
    this.choosePath(0);
    this.over.onChange = () => this.redraw();
  }

  // Corners of the parts, else of all; the middle of it is where coordinates begin for the graphics card.
  boxOfParts(mesh) {
    this.ranges = [];
    let first = 0;
    for (const one of this.json.surface.meshes) {
      this.ranges.push({ first, count: 3 * one.triangles, isPart: one.part, isClosed: one.closed,
                         colour: times(this.json.greys[one.part ? 0 : 1], 1 / 255) });
      first += 3 * one.triangles;
    }
    const low = [1e9, 1e9, 1e9], high = [-1, -1, -1], hasPart = this.ranges.some(range => range.isPart);
    const { corners, places } = mesh;
    for (const range of this.ranges) {
      range.facing = range.isClosed && range.count > 3 * kMostSeenThrough ? facingOf(mesh, range) : 0;
      if (hasPart && !range.isPart) continue;
      for (let k = 0; k < 3; ++k) {
        let least = 1e9, most = -1;
        for (let i = range.first; i < range.first + range.count; ++i) {
          const place = places[4 * corners[i] + k];
          if (place < least) least = place;
          if (place > most) most = place;
        }
        low[k] = Math.min(low[k], least);
        high[k] = Math.max(high[k], most);
      }
    }
    const place = p => add(this.json.surface.origin, times(p, this.json.surface.step));
    this.middle = times(add(place(low), place(high)), 0.5);
    this.box = [sub(place(low), this.middle), sub(place(high), this.middle)];
  }

  preparePath(path) {
    const data = new Float32Array(4 * path.count);
    path.along = new Float64Array(path.count);  // length of the path to each station
    for (let i = 0; i < path.count; ++i) {
      const tip = sub(path.tip(i), this.middle), isClean = path.state(i) === 0 && path.kind(i) === 1;
      data.set([...tip, path.isStart(i) ? -1 : isClean ? 6 : path.state(i)], 4 * i);
      if (i > 0) path.along[i] = path.along[i - 1] + length(sub(tip, Array.from(data.subarray(4 * i - 4, 4 * i - 1))));
    }
    path.drawn = this.renderer.path(data);
    path.tips = data;
    return path;
  }

  choosePath(index) {
    this.chosen = index;
    this.path = this.paths[index];
    this.at = Math.min(this.at ?? 0, this.path.count - 1);
    this.surface.paint(this.values[index]);
    this.redraw();
  }

  // The instant at a place along the stations: {move, line, t, state, kind, tool, pose}.
  instant() {
    const path = this.path, next = Math.min(Math.ceil(this.at), path.count - 1), last = Math.max(next - 1, 0);
    const from = path.isStart(next) || path.move[last] !== path.move[next] ? 0 : path.t(last);
    const share = path.isStart(next) || next === 0 ? 1 : this.at - last;
    const pose = share >= 1 ? { tip: path.tip(next), axis: path.axis(next) }
      : { tip: mix(path.tip(last), path.tip(next), share), axis: between(path.axis(last), path.axis(next), share) };
    return { move: path.move[next], line: path.line[next], t: from + (path.t(next) - from) * share, state: path.state(next),
             kind: path.kind(next), tool: path.tool[next], pose };
  }

  // The place of an instant of a move, as near as the stations have it.
  placeOf(move, t) {
    const path = this.path;
    let low = 0, high = path.count - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (path.move[middle] < move) low = middle + 1; else high = middle;
    }
    while (low + 1 < path.count && path.move[low + 1] === move && path.t(low) < t) ++low;
    if (path.isStart(low) || low === 0) return low;
    const from = path.move[low - 1] === path.move[low] ? path.t(low - 1) : 0;
    return low - 1 + Math.min(1, Math.max(0, (t - from) / Math.max(path.t(low) - from, 1e-9)));
  }

  pose() {
    const exact = this.finding && this.finding.at === this.at && this.chosen === 0 ? this.finding : this.instant().pose;
    return { tip: sub(exact.tip, this.middle), axis: unit(exact.axis) };
  }

  // A plane through the tool axis that leaves what is behind it: through the finding's point, or facing the viewer.
  plane() {
    if (!this.isCut) return null;
    const { tip, axis } = this.pose(), toward = this.camera.toward;
    let normal = sub(this.cutToward, times(axis, dot(this.cutToward, axis)));
    normal = length(normal) > 1e-6 ? unit(normal) : squareTo(axis);
    normal = turned(normal, axis, this.turn);
    if (dot(normal, toward) < 0) normal = times(normal, -1);
    return { normal, at: tip, offset: dot(normal, tip) };
  }

  // The cut runs through the point of the finding where the tool is there, else across the present view.
  aimSection() {
    const f = this.finding, { axis } = this.pose();
    this.cutToward = this.camera.toward;
    if (!f || !f.point || f.at !== this.at) return;
    const square = cross(axis, sub(sub(f.point, this.middle), this.pose().tip));
    if (length(square) > 1e-6) this.cutToward = square;
  }

  // Cuts, and turns to face the cut; without a cut the view is again as before.
  setSection(isOn) {
    if (isOn && !this.isCut) this.uncut = this.camera.state();
    this.isCut = isOn;
    if (isOn) this.aimSection();
    else if (this.uncut) this.fly(camera => { Object.assign(camera, { ...camera.state(), ...directionsOf(this.uncut) }); });
    if (isOn) this.faceSection();
  }

  faceSection() {
    this.fly(camera => { camera.look(this.plane().normal); });
  }

  // Turns the cut about the tool axis; the view follows.
  turnSection(angle) {
    this.turn = angle;
    this.camera.look(this.plane().normal);
    this.redraw();
  }

  shownRanges() { return this.ranges.filter(range => range.isPart ? this.shows.part : this.shows.fixtures); }

  begin() {
    this.isAsked = false;
    this.draw();
  }

  redraw() {
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(() => { this.isAsked = false; this.draw(); });
  }

  resize() {
    const canvas = this.renderer.canvas, box = canvas.parentElement.getBoundingClientRect();
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    if (ratio === this.ratio && box.width === this.camera.width && box.height === this.camera.height) return false;
    this.ratio = ratio;
    this.camera.width = box.width;
    this.camera.height = box.height;
    for (const one of [canvas, this.over.canvas]) {
      one.width = Math.round(box.width * this.ratio);
      one.height = Math.round(box.height * this.ratio);
    }
    this.redraw();
    return true;
  }

  draw() {
    const { camera, json } = this, plane = this.plane(), tool = this.tools[this.toolIndex()];
    const reach = 4 * length(sub(this.box[1], this.box[0])) + 4 * length(camera.centre) + 1000;
    this.renderer.draw({
      camera, plane, depth: reach, start: json.scale.start, surface: this.surface, ranges: this.shownRanges(),
      path: this.shows.path ? this.path.drawn : null, tool: this.shows.tool ? tool : null,
      heads: this.shows.tool ? this.heads : null, pose: this.pose(), stock: this.shows.stock ? this.stock : null,
      colours: { bodies: json.bodies.map(c => times(c, 1 / 255)), stock: times(json.stock?.colour ?? [0, 0, 0], 1 / 255),
                 path: [...(this.over.isDark ? kColoursInDark : kStateColours).map((hex, k) => [...rgbOf(hex), k === 2 || k === 3 ? 1.25 : k === 6 ? 0.5 : 0.85]), [0, 0, 0, 0]] },
    });
    const over = this.over;
    over.begin(camera, this.ratio);
    if (this.values.some(one => one.length > 0)) over.colours(json.scale, json.unit);
    over.triad();
    over.scaleBar(json.unit);
    const f = this.finding;
    if (f && f.point && f.at === this.at && this.chosen === 0) over.finding(sub(f.point, this.middle), f.normal);
    if (this.measured.length > 0) over.measure(this.measured, this.measureText());
    this.onDraw?.();
  }

  toolIndex() { return this.instant().tool; }

  lengthText(mm) { return `${(mm / this.json.unit.mm).toFixed(this.json.unit.mm > 10 ? 4 : 3)} ${this.json.unit.name}`; }
  pointText(at) { return '(' + add(at, this.middle).map(x => (x / this.json.unit.mm).toFixed(2)).join(', ') + ')'; }

  measureText() {
    if (this.measured.length < 2) return '';
    return this.lengthText(length(sub(this.measured[1], this.measured[0])));
  }

  // The surface seen at a place of the page: {at, mm}, mm being 0 where it is untouched.
  surfaceAt(x, y) {
    const found = pickSurface(this.surface.mesh, this.values[this.chosen], this.shownRanges(), this.camera, x, y, this.plane());
    if (!found) return null;
    const { high, root } = this.json.scale;
    return { at: found.at, mm: high * (root ? found.value ** 2 : found.value) };
  }

  // Moves the camera there in a third of a second, at once where people asked for less motion.
  fly(change) {
    const from = this.camera.state();
    change(this.camera);
    const to = this.camera.state(), began = performance.now();
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.stopFlight();
    const flight = this.flight;
    const step = now => {
      if (flight !== this.flight) return;
      const t = still ? 1 : Math.min(1, Math.max(0, (now - began) / 330));
      if (t < 1) this.camera.blend(from, to, t); else Object.assign(this.camera, to);
      this.draw();
      this.isFlying = t < 1;
      if (this.isFlying) requestAnimationFrame(step);
    };
    this.isFlying = true;
    Object.assign(this.camera, from);
    requestAnimationFrame(step);
  }

  // Leaves the camera where it is.
  stopFlight() {
    this.flight = (this.flight ?? 0) + 1;
    this.isFlying = false;
  }

  view(name) {
    this.fly(camera => {
      if (name !== 'fit') camera.look(kViews[name]);
      camera.fit(this.box);
    });
  }

  // Length of the diagonal of the parts, and the largest diameter of a tool.
  size() { return length(sub(this.box[1], this.box[0])); }
  widthOfTool(tool) {
    const points = (this.json.tools[tool]?.runs ?? []).flatMap(run => run.points.filter((_, k) => k % 2 === 0));
    return 2 * points.reduce((most, r) => Math.max(most, r), 0);
  }

  // Shows a finding at an angle, or its cut, with the tool and its surroundings around it.
  showFinding(finding) {
    this.finding = finding;
    if (this.chosen !== 0) this.choosePath(0);
    finding.at = this.placeOf(finding.move, finding.t);
    this.at = finding.at;
    const point = sub(finding.point ?? finding.tip, this.middle), axis = unit(finding.axis);
    if (this.isCut) this.aimSection();
    this.fly(camera => {
      camera.look(this.isCut ? this.plane().normal : directionTo(this, point, axis, finding.normal, camera.toward));
      camera.centre = camera.pivot = point;
      const width = this.widthOfTool(finding.tool) || Infinity;
      const seen = Math.max(Math.min(this.size() * 0.35, 3 * width), 40 * (finding.depth || 0), 1e-3);
      camera.scale = seen / Math.min(camera.width, camera.height);
    });
  }
}
