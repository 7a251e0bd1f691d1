// Whether WebGL runs on the processor, where smooth edges cost three times the frame.
const isDrawnInSoftware = () => {
  const gl = document.createElement('canvas').getContext('webgl2'), facts = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = facts ? gl.getParameter(facts.UNMASKED_RENDERER_WEBGL) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|basic render/i.test(name);
};

// Draws a scene in parallel projection with WebGL2. Coordinates are millimetres from the middle of the surface.
class Renderer {
  constructor(canvas, isSmooth) {
    const gl = canvas.getContext('webgl2', { antialias: isSmooth, stencil: true, alpha: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error('no WebGL2');
    this.canvas = canvas;
    this.gl = gl;
    this.programs = {};
    for (const [name, sources] of Object.entries(kShaders)) this.programs[name] = this.program(sources);
    this.empty = gl.createVertexArray();
  }

  program(sources) {
    const gl = this.gl, program = gl.createProgram();
    sources.forEach((source, k) => {
      const shader = gl.createShader(k === 0 ? gl.VERTEX_SHADER : gl.FRAGMENT_SHADER);
      gl.shaderSource(shader, '#version 300 es\nprecision highp float;\nprecision highp int;\n' + source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    });
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    const places = {};
    return { use: () => gl.useProgram(program), at: name => places[name] ??= gl.getUniformLocation(program, name) };
  }

  buffer(target, data) {
    const gl = this.gl, buffer = gl.createBuffer();
    gl.bindBuffer(target, buffer);
    gl.bufferData(target, data, gl.STATIC_DRAW);
    return buffer;
  }

  // A mesh of unpack.js; `values` by vertex become its colours.
  surface(mesh) {
    const gl = this.gl, vertices = gl.createVertexArray();
    gl.bindVertexArray(vertices);
    const places = this.buffer(gl.ARRAY_BUFFER, mesh.places);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 4, gl.UNSIGNED_SHORT, false, 8, 0);
    this.buffer(gl.ARRAY_BUFFER, mesh.normals);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 2, gl.UNSIGNED_BYTE, false, 2, 0);
    this.buffer(gl.ELEMENT_ARRAY_BUFFER, mesh.corners);
    const lines = gl.createVertexArray();
    gl.bindVertexArray(lines);
    gl.bindBuffer(gl.ARRAY_BUFFER, places);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 4, gl.UNSIGNED_SHORT, false, 8, 0);
    this.buffer(gl.ELEMENT_ARRAY_BUFFER, mesh.edges);
    gl.bindVertexArray(null);
    const paint = values => {
      for (let i = 0; i < mesh.count; ++i) mesh.places[4 * i + 3] = values[i];
      gl.bindBuffer(gl.ARRAY_BUFFER, places);
      gl.bufferData(gl.ARRAY_BUFFER, mesh.places, gl.STATIC_DRAW);
    };
    return { vertices, lines, mesh, paint };
  }

  tool(mesh) {
    const gl = this.gl, vertices = gl.createVertexArray();
    gl.bindVertexArray(vertices);
    this.buffer(gl.ARRAY_BUFFER, mesh.data);
    [[3, 0], [3, 12], [1, 24]].forEach(([size, offset], k) => {
      gl.enableVertexAttribArray(k);
      gl.vertexAttribPointer(k, size, gl.FLOAT, false, 28, offset);
    });
    this.buffer(gl.ELEMENT_ARRAY_BUFFER, mesh.corners);
    gl.bindVertexArray(null);
    return { vertices, count: mesh.corners.length };
  }

  // `data`: x, y, z and the colour's index by station; -1 where no motion leads. Four vertices a line, each with both
  // ends of it: instances would say it in less, but software renderers draw each of them for itself.
  path(data) {
    const gl = this.gl, vertices = gl.createVertexArray(), count = Math.max(data.length / 4 - 1, 0);
    const ends = new Float32Array(32 * count), corners = new Uint32Array(6 * count);
    for (let i = 0; i < count; ++i) {
      for (let k = 0; k < 4; ++k) ends.set(data.subarray(4 * i, 4 * i + 8), 32 * i + 8 * k);
      corners.set([4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 2, 4 * i + 1, 4 * i + 3], 6 * i);
    }
    gl.bindVertexArray(vertices);
    this.buffer(gl.ARRAY_BUFFER, ends);
    for (let k = 0; k < 2; ++k) {
      gl.enableVertexAttribArray(k);
      gl.vertexAttribPointer(k, 4, gl.FLOAT, false, 32, 16 * k);
    }
    this.buffer(gl.ELEMENT_ARRAY_BUFFER, corners);
    gl.bindVertexArray(null);
    return { vertices, count: corners.length };
  }

  ramp(colours) {
    const gl = this.gl, texels = new Uint8Array(4 * 256);
    for (let i = 0; i < 256; ++i) {
      const at = i / 255 * (colours.length - 1), k = Math.min(Math.floor(at), colours.length - 2);
      const c = mix(colours[k], colours[k + 1], at - k);
      texels.set([Math.round(c[0]), Math.round(c[1]), Math.round(c[2]), 255], 4 * i);
    }
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, texels);
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.LINEAR);
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
  }

  // What a frame shows: {camera, surface, ranges, heads, tool, pose, path, stock, plane, start, colours, depth}.
  draw(frame) {
    const gl = this.gl;
    this.frame = frame;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.stencilMask(255);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.disable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    for (const range of frame.ranges) {
      // Of a closed mesh the faces turned away are hidden: half the work of a large one.
      const isHalf = range.facing && !frame.plane;
      if (isHalf) gl.enable(gl.CULL_FACE);
      gl.cullFace(range.facing < 0 ? gl.FRONT : gl.BACK);
      this.drawSurface(range);
      gl.disable(gl.CULL_FACE);
    }
    gl.enable(gl.BLEND);
    this.drawEdges(frame.surface);
    if (frame.plane) this.drawCaps();
    if (frame.path) this.drawPath();
    if (frame.tool) this.drawTool();
    if (frame.stock) this.drawStock();
  }

  setCamera(program, plane) {
    const gl = this.gl, c = this.frame.camera;
    program.use();
    gl.uniform3fv(program.at('uRight'), c.right);
    gl.uniform3fv(program.at('uUp'), c.up);
    gl.uniform3fv(program.at('uToward'), c.toward);
    gl.uniform3fv(program.at('uCentre'), c.centre);
    gl.uniform2f(program.at('uScale'), 2 / (c.scale * c.width), 2 / (c.scale * c.height));
    gl.uniform1f(program.at('uDepth'), 1 / this.frame.depth);
    gl.uniform1i(program.at('uIsCut'), plane ? 1 : 0);
    if (plane) gl.uniform4f(program.at('uPlane'), ...plane.normal, plane.offset);
  }

  setTurn(program, columns, shift) {
    this.gl.uniformMatrix3fv(program.at('uTurn'), false, columns.flat());
    this.gl.uniform3fv(program.at('uShift'), shift);
  }

  drawSurface({ first, count, colour, alpha = 1 }) {
    const gl = this.gl, program = this.programs.surface, { surface, start, plane } = this.frame;
    this.setCamera(program, plane);
    this.setTurn(program, [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0]);
    gl.uniform3fv(program.at('uOrigin'), surface.mesh.from);
    gl.uniform1f(program.at('uStep'), surface.mesh.step);
    gl.uniform4f(program.at('uColour'), ...colour, alpha);
    gl.uniform1f(program.at('uStart'), start);
    gl.bindVertexArray(surface.vertices);
    gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 4 * first);
  }

  drawEdges(surface) {
    const gl = this.gl, program = this.programs.edges, { plane } = this.frame;
    if (surface.mesh.edges.length === 0) return;
    this.setCamera(program, plane);
    gl.uniform3fv(program.at('uOrigin'), surface.mesh.from);
    gl.uniform1f(program.at('uStep'), surface.mesh.step);
    gl.bindVertexArray(surface.lines);
    gl.drawElements(gl.LINES, surface.mesh.edges.length, gl.UNSIGNED_INT, 0);
  }

  drawPath() {
    const gl = this.gl, program = this.programs.path, { path, plane, camera, colours } = this.frame;
    this.setCamera(program, plane);
    gl.uniform2f(program.at('uPixel'), 2 / camera.width, 2 / camera.height);
    gl.uniform4fv(program.at('uColours'), colours.path.flat());
    gl.bindVertexArray(path.vertices);
    gl.depthMask(false);
    for (const [test, fade] of [[gl.GREATER, 0.16], [gl.LEQUAL, 1]]) {  // what the part hides is faint
      gl.depthFunc(test);
      gl.uniform1f(program.at('uFade'), fade);
      gl.drawElements(gl.TRIANGLES, path.count, gl.UNSIGNED_INT, 0);
    }
    gl.depthMask(true);
    gl.depthFunc(gl.LEQUAL);
  }

  // Like glass: the nearest of it alone is seen, and what is behind shines through.
  drawTool() {
    const gl = this.gl, alpha = this.frame.plane ? 0.55 : 0.62;
    gl.colorMask(false, false, false, false);
    this.drawBodies(this.frame.plane, 1);
    gl.colorMask(true, true, true, true);
    this.drawBodies(this.frame.plane, alpha);
  }

  // The nearest of the material that is left, as a veil over all that is in it.
  drawStock() {
    const gl = this.gl, { stock, plane, colours } = this.frame, program = this.programs.surface;
    this.setCamera(program, plane);
    this.setTurn(program, [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0]);
    gl.uniform3fv(program.at('uOrigin'), stock.mesh.from);
    gl.uniform1f(program.at('uStep'), stock.mesh.step);
    gl.uniform4f(program.at('uColour'), ...colours.stock, 0.34);
    gl.bindVertexArray(stock.vertices);
    for (const isSeen of [false, true]) {
      gl.colorMask(isSeen, isSeen, isSeen, isSeen);
      gl.drawElements(gl.TRIANGLES, stock.mesh.corners.length, gl.UNSIGNED_INT, 0);
    }
    this.drawEdges(stock);
  }

  drawBodies(plane, alpha) {
    const gl = this.gl, { tool, heads, pose, colours } = this.frame, turn = frameOf(pose.axis);
    const program = this.programs.tool;
    this.setCamera(program, plane);
    this.setTurn(program, turn, pose.tip);
    gl.uniform3fv(program.at('uBodies'), colours.bodies.flat());
    gl.uniform1f(program.at('uAlpha'), alpha);
    gl.bindVertexArray(tool.vertices);
    gl.drawElements(gl.TRIANGLES, tool.count, gl.UNSIGNED_INT, 0);
    if (!heads) return;
    const other = this.programs.surface;
    this.setCamera(other, plane);
    this.setTurn(other, turn, pose.tip);
    gl.uniform3fv(other.at('uOrigin'), heads.mesh.origin);
    gl.uniform1f(other.at('uStep'), heads.mesh.step);
    gl.uniform4f(other.at('uColour'), ...colours.bodies[3], alpha * 0.6);
    gl.bindVertexArray(heads.vertices);
    gl.drawElements(gl.TRIANGLES, heads.mesh.corners.length, gl.UNSIGNED_INT, 0);
  }

  // Where the plane runs inside a solid an odd number of its faces lies behind: each kind of solid flips a bit.
  drawCaps() {
    const gl = this.gl, { plane, ranges, tool, colours } = this.frame;
    gl.enable(gl.STENCIL_TEST);
    gl.disable(gl.DEPTH_TEST);
    gl.colorMask(false, false, false, false);
    gl.stencilFunc(gl.ALWAYS, 0, 255);
    gl.stencilOp(gl.INVERT, gl.INVERT, gl.INVERT);
    for (const range of ranges) {
      if (!range.isClosed) continue;
      gl.stencilMask(range.isPart ? 1 : 2);
      this.drawSurface(range);
    }
    gl.stencilMask(4);
    if (tool) this.drawBodies(plane, 1);
    gl.stencilMask(0);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.KEEP);
    gl.enable(gl.DEPTH_TEST);
    gl.colorMask(true, true, true, true);
    const program = this.programs.cap;
    this.setCamera(program, null);
    const across = squareTo(plane.normal), along = cross(plane.normal, across), reach = this.frame.depth;
    gl.uniform3fv(program.at('uAt'), plane.at);
    gl.uniform3fv(program.at('uAcross'), times(across, reach));
    gl.uniform3fv(program.at('uAlong'), times(along, reach));
    gl.bindVertexArray(this.empty);
    const fill = (bits, mask, colour, alpha, hatch) => {
      gl.stencilFunc(gl.EQUAL, bits, mask);
      gl.uniform4f(program.at('uColour'), ...colour, alpha);
      gl.uniform1f(program.at('uHatch'), hatch);
      gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    };
    fill(1, 5, [0.86, 0.87, 0.88], 1, 9);
    fill(2, 7, [0.74, 0.80, 0.87], 1, 9);
    fill(4, 7, mix(colours.bodies[0], [1, 1, 1], 0.55), 0.9, 0);
    fill(5, 5, [0.70, 0.09, 0.17], 1, 0);
    fill(6, 7, [0.70, 0.09, 0.17], 1, 0);
    gl.disable(gl.STENCIL_TEST);
  }
}
