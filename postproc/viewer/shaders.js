// Light and colours are those of the pictures (postproc/image/shade.cpp).
const kCamera = `
  uniform vec3 uRight, uUp, uToward, uCentre;
  uniform vec2 uScale;   // clip coordinates a millimetre
  uniform float uDepth;  // a millimetre of depth
  vec4 projected(vec3 p) {
    vec3 d = p - uCentre;
    return vec4(dot(d, uRight) * uScale.x, dot(d, uUp) * uScale.y, -dot(d, uToward) * uDepth, 1.0);
  }`;
const kLight = `
  uniform vec3 uRight, uUp, uToward;
  float light(vec3 normal) {
    vec3 n = vec3(dot(normal, uRight), dot(normal, uUp), dot(normal, uToward));
    if (n.z < 0.0) n = -n;
    return 0.44 + 0.50 * max(0.0, dot(n, normalize(vec3(-0.45, 0.75, 0.75)))) +
           0.16 * max(0.0, dot(n, normalize(vec3(0.8, 0.1, 0.6))));
  }`;
const kCut = `
  uniform vec4 uPlane;
  uniform bool uIsCut;
  bool isCutOff(vec3 p) { return uIsCut && dot(uPlane.xyz, p) > uPlane.w; }`;

const kShaders = {
  surface: [`
    layout(location = 0) in vec4 aPlace;   // and the place on the colour scale
    layout(location = 1) in vec2 aNormal;
    uniform vec3 uOrigin, uShift;
    uniform mat3 uTurn;
    uniform float uStep;
    out vec3 vAt, vNormal;
    out vec2 vValue;
    ${kCamera}
    void main() {
      vec2 o = aNormal / 127.0 - 1.0;
      vec3 n = vec3(o, 1.0 - abs(o.x) - abs(o.y));
      if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
      vNormal = uTurn * normalize(n);
      vAt = uTurn * (uOrigin + aPlace.xyz * uStep) + uShift;
      vValue = vec2(aPlace.w / 65535.0, aPlace.w > 0.0 ? 1.0 : 0.0);
      gl_Position = projected(vAt);
    }`, `
    in vec3 vAt, vNormal;
    in vec2 vValue;
    uniform sampler2D uRamp;
    uniform vec4 uColour;
    uniform float uStart;
    out vec4 outColour;
    ${kLight} ${kCut}
    void main() {
      if (isCutOff(vAt)) discard;
      float lit = light(normalize(vNormal));
      if (vValue.y < 0.5) {
        outColour = vec4(uColour.rgb * (0.12 + 0.97 * lit) * uColour.a, uColour.a);
        return;
      }
      float place = vValue.x / vValue.y, t = clamp((place - uStart) / (1.0 - uStart), 0.0, 1.0);
      outColour = vec4(texture(uRamp, vec2((0.5 + t * 255.0) / 256.0, 0.5)).rgb * (0.55 + 0.42 * lit), 1.0);
    }`],
  edges: [`
    layout(location = 0) in vec4 aPlace;
    uniform vec3 uOrigin;
    uniform float uStep;
    out vec3 vAt;
    ${kCamera}
    void main() {
      vAt = uOrigin + aPlace.xyz * uStep;
      gl_Position = projected(vAt) - vec4(0.0, 0.0, 4e-4, 0.0);
    }`, `
    in vec3 vAt;
    out vec4 outColour;
    ${kCut}
    void main() {
      if (isCutOff(vAt)) discard;
      outColour = vec4(0.157, 0.188, 0.227, 1.0) * 0.3;
    }`],
  tool: [`
    layout(location = 0) in vec3 aAt;
    layout(location = 1) in vec3 aNormal;
    layout(location = 2) in float aBody;
    uniform mat3 uTurn;
    uniform vec3 uShift;
    out vec3 vAt, vNormal;
    flat out int vBody;
    ${kCamera}
    void main() {
      vAt = uTurn * aAt + uShift;
      vNormal = uTurn * aNormal;
      vBody = int(aBody + 0.5);
      gl_Position = projected(vAt);
    }`, `
    in vec3 vAt, vNormal;
    flat in int vBody;
    uniform vec3 uBodies[4];
    uniform float uAlpha;
    out vec4 outColour;
    ${kLight} ${kCut}
    void main() {
      if (isCutOff(vAt)) discard;
      float lit = light(normalize(vNormal));
      outColour = vec4(min(mix(uBodies[vBody], vec3(1.0), 0.18) * (0.25 + 0.85 * lit), 1.0) * uAlpha, uAlpha);
    }`],
  path: [`
    layout(location = 0) in vec4 aFrom;  // and what is there: -1 where no motion leads
    layout(location = 1) in vec4 aTo;
    uniform vec2 uPixel;                 // clip coordinates a pixel
    uniform vec4 uColours[8];            // by state; 6: rapid
    uniform float uFade;
    out vec4 vColour;
    out vec3 vAt;
    ${kCamera}
    void main() {
      int kind = int(aTo.w + 0.5);
      vColour = uColours[max(kind, 0)];
      vec4 a = projected(aFrom.xyz), b = projected(aTo.xyz);
      vec2 along = (b.xy - a.xy) / uPixel;
      float l = length(along);
      along = l > 1e-6 ? along / l : vec2(1.0, 0.0);
      float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
      bool isEnd = (gl_VertexID & 2) != 0;
      float width = vColour.a * 2.0;
      vec4 at = isEnd ? b : a;
      at.xy += vec2(-along.y, along.x) * side * width * 0.5 * uPixel;
      at.z -= 6e-4;
      vAt = isEnd ? aTo.xyz : aFrom.xyz;
      vColour = vec4(vColour.rgb, 1.0) * min(vColour.a, 1.0) * uFade;
      gl_Position = aTo.w < -0.5 ? vec4(2.0, 2.0, 2.0, 1.0) : at;
    }`, `
    in vec4 vColour;
    in vec3 vAt;
    out vec4 outColour;
    ${kCut}
    void main() {
      if (isCutOff(vAt)) discard;
      outColour = vColour;
    }`],
  cap: [`
    uniform vec3 uAt, uAcross, uAlong;
    out vec2 vPlace;
    ${kCamera}
    void main() {
      vPlace = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? -1.0 : 1.0);
      gl_Position = projected(uAt + uAcross * vPlace.x + uAlong * vPlace.y);
    }`, `
    in vec2 vPlace;
    uniform vec4 uColour;
    uniform float uHatch;
    out vec4 outColour;
    void main() {
      float stripe = uHatch > 0.0 ? step(0.8, fract((gl_FragCoord.x + gl_FragCoord.y) / uHatch)) : 0.0;
      outColour = vec4(mix(uColour.rgb, uColour.rgb * 0.8, stripe) * uColour.a, uColour.a);
    }`],
};
