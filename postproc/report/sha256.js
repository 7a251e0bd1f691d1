// SHA-256 of a text in UTF-8 (FIPS 180-4), as 64 digits. Browsers offer their own on secure pages alone.
const sha256 = text => {
  const first = n => Math.floor((n - Math.floor(n)) * 2 ** 32), primes = [];
  for (let n = 2; primes.length < 64; ++n) if (primes.every(p => n % p !== 0)) primes.push(n);
  const constants = primes.map(p => first(Math.cbrt(p))), state = primes.slice(0, 8).map(p => first(Math.sqrt(p)));
  const bytes = new TextEncoder().encode(text), size = (bytes.length + 9 + 63) & ~63, block = new Uint8Array(size);
  block.set(bytes);
  block[bytes.length] = 0x80;
  const view = new DataView(block.buffer), w = new Uint32Array(64);
  view.setUint32(size - 8, Math.floor(bytes.length / 2 ** 29));
  view.setUint32(size - 4, (bytes.length * 8) >>> 0);
  const turn = (x, n) => x >>> n | x << 32 - n;
  for (let at = 0; at < size; at += 64) {
    for (let i = 0; i < 16; ++i) w[i] = view.getUint32(at + 4 * i);
    for (let i = 16; i < 64; ++i) {
      const a = w[i - 15], b = w[i - 2];
      w[i] = w[i - 16] + (turn(a, 7) ^ turn(a, 18) ^ a >>> 3) + w[i - 7] + (turn(b, 17) ^ turn(b, 19) ^ b >>> 10);
    }
    let [a, b, c, d, e, f, g, h] = state;
    for (let i = 0; i < 64; ++i) {
      const one = h + (turn(e, 6) ^ turn(e, 11) ^ turn(e, 25)) + (e & f ^ ~e & g) + constants[i] + w[i] | 0;
      const two = (turn(a, 2) ^ turn(a, 13) ^ turn(a, 22)) + (a & b ^ a & c ^ b & c) | 0;
      [h, g, f, e, d, c, b, a] = [g, f, e, d + one | 0, c, b, a, one + two | 0];
    }
    [a, b, c, d, e, f, g, h].forEach((x, i) => { state[i] = state[i] + x | 0; });
  }
  return state.map(x => (x >>> 0).toString(16).padStart(8, "0")).join("");
};
