// Builds the view, and joins it with the table of findings (postproc/report/findings.js).
const byId = id => document.getElementById(id);

const startDesk = async () => {
  const section = byId('desk-view'), data = byId('desk-data');
  if (!section || !data) return;
  const canvas = byId('desk-scene');
  section.hidden = false;
  document.body.classList.add('has-desk');
  let desk;
  try {
    if (typeof DecompressionStream === 'undefined') throw new Error('no DecompressionStream');
    desk = new Desk(canvas, byId('desk-over'), await unpackScene(data.textContent.trim()));
  } catch (error) {  // then the pictures stand
    section.hidden = true;
    document.body.classList.remove('has-desk');
    byId('desk-missing').hidden = false;
    document.dispatchEvent(new Event('no-desk'));
    console.info('no 3D view: ' + error.message);
    return;
  }
  const along = byId('desk-along'), instant = byId('desk-t'), where = byId('desk-where'), strip = byId('desk-strip');
  const status = byId('desk-status'), cut = byId('desk-turn'), button = name => section.querySelector(`[data-do="${name}"]`);
  let isPlaying = false, isMeasuring = false;

  const drawStrip = () => {
    const width = strip.width = Math.max(1, Math.round(strip.clientWidth * desk.ratio)), path = desk.path;
    const height = strip.height = 26 * desk.ratio, pen = strip.getContext('2d'), worst = new Uint32Array(width).fill(0xffffffff);
    const rank = [1, 2, 5, 6, 3, 4];
    const depth = new Uint32Array(width);
    for (let i = 0; i < path.count; ++i) {
      const x = Math.min(width - 1, Math.floor(i / path.count * width)), to = Math.floor((i + 1) / path.count * width);
      for (let k = x; k <= Math.min(Math.max(x, to - 1), width - 1); ++k) {
        if (worst[k] === 0xffffffff || rank[path.state(i)] > rank[worst[k]]) worst[k] = path.state(i);
        depth[k] = Math.max(depth[k], path.depth[i]);
      }
    }
    for (let x = 0; x < width; ++x) {
      const state = worst[x] === 0xffffffff ? 0 : worst[x], isLow = state === 0;
      const bar = isLow ? 0.14 : state === 2 ? 0.2 + 0.8 * depth[x] / 65535 : 1;
      pen.fillStyle = kStateColours[state];
      pen.globalAlpha = isLow ? 0.4 : 1;
      pen.fillRect(x, height * (1 - bar), 1, height * bar);
    }
  };
  const say = () => {
    const now = desk.instant(), tool = desk.json.tools[now.tool];
    along.value = desk.at;
    instant.value = now.t;
    where.textContent = `move ${now.move} of ${desk.path.moveCount - 1}, line ${now.line}, t = ${now.t.toFixed(3)}, ` +
      `${kKinds[now.kind]}, ${tool ? tool.label : 'no tool'}: ${kStates[now.state]}`;
  };
  const go = at => {
    desk.at = Math.max(0, Math.min(at, desk.path.count - 1));
    say();
    desk.redraw();
  };
  const play = isOn => {
    isPlaying = isOn;
    button('play').textContent = isOn ? '\u275a\u275a' : '\u25b6';
    let last = performance.now();
    const step = now => {
      if (!isPlaying) return;
      let rest = Math.max(0, now - last) / 1000 * 160 * desk.camera.scale;  // as fast on the screen at any zoom
      last = now;
      const path = desk.path;
      let at = desk.at;
      while (rest > 0 && at < path.count - 1) {
        const k = Math.floor(at), size = path.isStart(k + 1) ? 0 : path.along[k + 1] - path.along[k], left = size * (k + 1 - at);
        if (left > rest) { at += rest / size; rest = 0; } else { at = k + 1; rest -= left; rest = size === 0 ? rest * 0.97 : rest; }
      }
      go(at);
      if (at >= path.count - 1) return play(false);
      requestAnimationFrame(step);
    };
    if (!isOn) return;
    if (desk.at >= desk.path.count - 1) go(0);
    requestAnimationFrame(step);
  };
  const fill = isOn => {
    section.classList.toggle('full', isOn);
    document.body.classList.toggle('is-filled', isOn);
    button('fill').setAttribute('aria-pressed', isOn);
    button('fill').textContent = isOn ? 'Leave full screen' : 'Full screen';
    if (isOn) section.requestFullscreen?.().catch(() => {});  // without it the view fills the window
    else if (document.fullscreenElement) document.exitFullscreen();
  };
  document.addEventListener('fullscreenchange', () => { if (!document.fullscreenElement) fill(false); });
  const section_ = isOn => {
    button('section').setAttribute('aria-pressed', isOn);
    cut.hidden = !isOn;
    desk.setSection(isOn);
  };
  const measure = isOn => {
    isMeasuring = isOn;
    button('measure').setAttribute('aria-pressed', isOn);
    desk.measured = [];
    canvas.style.cursor = isOn ? 'crosshair' : '';
    status.textContent = isOn ? 'Click two points of the surface.' : '';
    desk.redraw();
  };
  const showFinding = index => {
    const finding = desk.json.findings[index];
    if (!finding) return;
    play(false);
    desk.showFinding(finding);
    choosePath(0);
    writeFinding(finding, window.findings?.numberOf(index));
    say();
  };
  const choosePath = index => {
    if (desk.chosen !== index) desk.choosePath(index);
    for (const one of byId('desk-paths').children) one.setAttribute('aria-pressed', Number(one.dataset.path) === index);
    along.max = desk.path.count - 1;
    drawStrip();
    say();
  };
  const step = by => {
    const next = window.findings?.step(by);
    if (next !== undefined) showFinding(next);
  };

  listenToPicture(desk, canvas, (x, y) => {
    const found = desk.surfaceAt(x, y);
    if (isMeasuring && found) {
      desk.measured = desk.measured.length > 1 ? [found.at] : [...desk.measured, found.at];
      const [a, b] = desk.measured;
      status.textContent = !b ? `From ${desk.pointText(a)}; click the second point.`
        : `${desk.measureText()}; dx, dy, dz = ${sub(b, a).map(d => (d / desk.json.unit.mm).toFixed(3)).join(', ')}`;
      desk.redraw();
    } else if (!isMeasuring) {
      status.textContent = !found ? '' : `${desk.pointText(found.at)}: ` +
        (found.mm > 0 ? `${desk.json.scale.title.toLowerCase()} about ${desk.lengthText(found.mm)}` : 'untouched');
    }
  });
  listenToKeys({
    j: () => step(1), k: () => step(-1), ' ': () => play(!isPlaying), f: () => desk.view('fit'), s: () => section_(!desk.isCut),
    m: () => measure(!isMeasuring), F: () => fill(!section.classList.contains('full')),
    Escape: () => { play(false); measure(false); fill(false); }, 0: () => desk.view('first'),
    1: () => desk.view('front'), 2: () => desk.view('back'), 3: () => desk.view('right'), 4: () => desk.view('left'),
    5: () => desk.view('first'), 7: () => desk.view('top'), 8: () => desk.view('bottom'),
  });
  const actions = { previous: () => step(-1), next: () => step(1), play: () => play(!isPlaying),
                    section: () => section_(!desk.isCut), measure: () => measure(!isMeasuring),
                    fill: () => fill(!section.classList.contains('full')) };
  section.addEventListener('click', event => {
    const one = event.target.closest('button');
    if (!one) return;
    if (one.dataset.view) desk.view(one.dataset.view);
    if (one.dataset.do) actions[one.dataset.do]();
    if (one.dataset.path) choosePath(Number(one.dataset.path));
    if (one.dataset.show) {
      const isOn = desk.shows[one.dataset.show] = !desk.shows[one.dataset.show];
      one.setAttribute('aria-pressed', isOn);
      desk.redraw();
    }
  });
  along.addEventListener('input', () => { play(false); go(Number(along.value)); });
  instant.addEventListener('input', () => { play(false); go(desk.placeOf(desk.instant().move, Number(instant.value))); });
  cut.addEventListener('input', () => desk.turnSection(Number(cut.value) * Math.PI / 180));
  document.addEventListener('finding', event => {
    section.scrollIntoView({ block: 'nearest' });
    showFinding(event.detail);
  });
  if (!desk.ranges.some(range => !range.isPart)) section.querySelector('[data-show="fixtures"]').hidden = true;
  const stock = section.querySelector('[data-show="stock"]');
  stock.hidden = !desk.stock;
  stock.setAttribute('aria-pressed', desk.shows.stock);
  if (desk.paths.length > 1) {
    byId('desk-paths').hidden = false;
    desk.paths.forEach((path, k) => {
      const one = document.createElement('button');
      one.dataset.path = k;
      one.textContent = path.name;
      one.setAttribute('aria-pressed', k === 0);
      byId('desk-paths').prepend(one);
    });
  }
  desk.resize();
  desk.camera.fit(desk.box);
  choosePath(0);
  const first = window.findings?.first();
  if (first !== undefined && desk.json.findings[first]) {
    const finding = desk.json.findings[first];
    finding.at = desk.at = desk.placeOf(finding.move, finding.t);
    desk.finding = finding;
    writeFinding(finding, 1);
    window.findings.choose(first);
  } else {
    byId('desk-title').textContent = 'No finding';
  }
  say();
  new ResizeObserver(() => { if (desk.resize()) drawStrip(); }).observe(canvas.parentElement);
  desk.begin();
  window.desk = desk;
};

const element = (name, text, css) => {
  const one = document.createElement(name);
  if (text !== undefined) one.textContent = text;
  if (css) one.className = css;
  return one;
};

// The numbers of a finding and the lines of the file around its statement.
const writeFinding = (finding, number) => {
  byId('desk-title').textContent = (number ? `Finding ${number} of ${window.findings.count()}` : 'Finding') + `: ${finding.state}`;
  const facts = byId('desk-facts'), list = element('dl');
  for (const [name, value] of finding.rows) {
    const row = element('div');
    row.append(element('dt', name), element('dd', value));
    list.append(row);
  }
  facts.replaceChildren(list);
  if (!finding.quote) return;
  const quote = element('pre');
  finding.quote.lines.forEach((line, k) => {
    const number = finding.quote.first + k, isIt = number === finding.quote.line;
    const row = element('span', undefined, isIt ? 'it' : '');
    row.append(element('i', String(number)), line);
    quote.append(row, '\n');
  });
  facts.append(quote);
};

startDesk();
