// What stands over the picture: colours, triad, scale bar, the finding, and what is measured. In pixels of the page.
class Overlay {
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = canvas.getContext('2d');
    const scheme = matchMedia('(prefers-color-scheme: dark)');
    const dress = () => {
      this.isDark = scheme.matches;
      [this.ink, this.soft, this.halo, this.blue] = this.isDark ? ['#dfe4ea', '#a9b3be', 'rgba(24,29,35,.88)', '#7db6ea']
        : ['#20262e', '#404852', 'rgba(255,255,255,.88)', '#1f5f99'];
      this.onChange?.();
    };
    dress();
    scheme.addEventListener('change', dress);
  }

  begin(camera, ratio) {
    this.camera = camera;
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.pen.clearRect(0, 0, camera.width, camera.height);
    this.pen.lineCap = 'round';
    this.font(12);
  }

  font(size, weight = '') { this.pen.font = `${weight} ${size}px "Segoe UI", Helvetica, Arial, "DejaVu Sans", sans-serif`; }

  text(words, x, y, { align = 'left', colour = this.ink, halo = true } = {}) {
    const pen = this.pen;
    pen.textAlign = align;
    if (halo) {
      pen.strokeStyle = this.halo;
      pen.lineWidth = 3.5;
      pen.lineJoin = 'round';
      pen.strokeText(words, x, y);
    }
    pen.fillStyle = colour;
    pen.fillText(words, x, y);
  }

  line(points, colour, width = 1.5) {
    const pen = this.pen;
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.beginPath();
    points.forEach(([x, y], k) => k === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y));
    pen.stroke();
  }

  disc([x, y], radius, fill, stroke) {
    const pen = this.pen;
    pen.beginPath();
    pen.arc(x, y, radius, 0, 7);
    if (fill) { pen.fillStyle = fill; pen.fill(); }
    if (stroke) { pen.strokeStyle = stroke; pen.lineWidth = 2; pen.stroke(); }
  }

  triad() {
    const at = [48, this.camera.height - 48];
    const axes = [['X', this.isDark ? '#f2808d' : '#b2182b', [1, 0, 0]], ['Y', this.isDark ? '#5fbf93' : '#227854', [0, 1, 0]],
                  ['Z', this.blue, [0, 0, 1]]].map(
      ([name, colour, d]) => ({ name, colour, x: dot(d, this.camera.right), y: -dot(d, this.camera.up), z: dot(d, this.camera.toward) }));
    for (const { name, colour, x, y } of axes.sort((a, b) => a.z - b.z)) {
      this.line([at, [at[0] + 27 * x, at[1] + 27 * y]], colour, 2.4);
      this.font(12, '600');
      this.text(name, at[0] + 38 * x, at[1] + 38 * y + 4, { align: 'center', colour });
    }
  }

  // A round length in the path's unit.
  scaleBar(unit) {
    const wanted = 130 * this.camera.scale / unit.mm, power = 10 ** Math.floor(Math.log10(wanted));
    const size = power * [5, 2, 1].find(m => m * power <= wanted), pixels = size * unit.mm / this.camera.scale;
    const x = 100, y = this.camera.height - 26;
    this.line([[x, y - 5], [x, y], [x + pixels, y], [x + pixels, y - 5]], this.ink, 1.4);
    this.font(12);
    this.text(`${Number(size.toPrecision(3))} ${unit.name}`, x + pixels / 2, y - 6, { align: 'center' });
  }

  colours(scale, unit) {
    const height = Math.min(190, this.camera.height * 0.36), width = 14, x = this.camera.width - 78, y = 46, pen = this.pen;
    const fade = pen.createLinearGradient(0, y + height, 0, y), c = scale.ramp;
    c.forEach((one, k) => fade.addColorStop(scale.start + (1 - scale.start) * k / (c.length - 1), `rgb(${one})`));
    this.font(12, '600');
    this.text(`${scale.title}, ${unit.name}`, x + 64, y - 16, { align: 'right' });
    pen.fillStyle = fade;
    pen.fillRect(x, y, width, height);
    pen.fillStyle = '#c8ccd0';
    pen.fillRect(x, y + height * (1 - scale.start), width, height * scale.start);
    this.font(11.5);
    for (const [place, words] of scale.ticks) {
      const at = y + height * (1 - place);
      this.line([[x + width, at], [x + width + 4, at]], this.soft, 1);
      this.text(words, x + width + 8, at + 4, { colour: this.soft });
    }
  }

  // The evidence: the point, and where the tool must give way to.
  finding(point, normal) {
    const at = this.camera.project(point), tip = this.camera.project(add(point, times(normal, 34 * this.camera.scale)));
    const dx = tip[0] - at[0], dy = tip[1] - at[1], l = Math.hypot(dx, dy);
    if (l > 6) {
      this.line([at, tip], '#fff', 5);
      this.line([at, tip], '#20262e', 2);
      for (const side of [-1, 1]) {
        this.line([tip, [tip[0] - 8 * dx / l + side * 4 * dy / l, tip[1] - 8 * dy / l - side * 4 * dx / l]], '#20262e', 2);
      }
    }
    this.disc(at, 6.5, '#fff');
    this.disc(at, 4, '#20262e');
  }

  measure(points, words) {
    const at = points.map(p => this.camera.project(p));
    if (at.length === 2) {
      this.line(at, '#fff', 4.5);
      this.line(at, '#1f5f99', 2);
    }
    for (const one of at) this.disc(one, 4, '#1f5f99', '#fff');
    if (at.length < 2) return;
    this.font(13, '600');
    this.text(words, (at[0][0] + at[1][0]) / 2 + 8, (at[0][1] + at[1][1]) / 2 - 8, { colour: this.isDark ? '#a9d2f7' : '#14456f' });
  }
}
