/** Measures how fast a browser draws points, with a number that a graphics processor draws in a moment. */

export const TRIAL_POINTS = 100_000;
const TRIES = 3;
const GOOD_MS = 5;
/** Points of a few pixels over the whole picture, positioned by their number. */
const VERTEX = `#version 300 es
void main() {
  float n = float(gl_VertexID);
  gl_Position = vec4(2.0 * fract(n * vec2(0.7548777, 0.5698403)) - 1.0, fract(n * 0.618034), 1.0);
  gl_PointSize = 3.0;
}`;
const FRAGMENT = `#version 300 es
precision mediump float;
out vec4 colour;
void main() { colour = vec4(gl_PointCoord, 0.5, 1.0); }`;

/** The best of a few attempts: a busy machine is slow sometimes, one without a graphics processor always. */
export function trial_ms(gl: WebGL2RenderingContext): number {
  const program = gl.createProgram();
  for (const [kind, source] of [
    [gl.VERTEX_SHADER, VERTEX],
    [gl.FRAGMENT_SHADER, FRAGMENT],
  ] as const) {
    const shader = gl.createShader(kind);
    if (!shader) return 0;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return 0;
  // biome-ignore lint/correctness/useHookAtTopLevel: it is of WebGL
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
  draw_ms(gl, 1); // without one-time preparation
  let best_ms = Infinity;
  for (let i = 0; i < TRIES && best_ms > GOOD_MS; i++) best_ms = Math.min(best_ms, draw_ms(gl, TRIAL_POINTS));
  return best_ms;
}

/** Waits for the complete picture, because reading a pixel does. */
function draw_ms(gl: WebGL2RenderingContext, points: number): number {
  const began = performance.now();
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.drawArrays(gl.POINTS, 0, points);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  return performance.now() - began;
}
