import { matrix, type Camera, type Size } from "./camera.ts";

const n = (v: number) => String(Math.round(v * 1e3) / 1e3 + 0);

/** A camera as the value of an SVG `transform`. */
export const transform = (camera: Camera): string =>
  `matrix(${matrix(camera)
    .map((v) => String(Math.round(v * 1e6) / 1e6 + 0))
    .join(" ")})`;

/** A display list as a picture of its own: one element a line, the role as its class, no colours. */
export function svgText(
  shapes: readonly { readonly role: string; readonly d: string }[],
  camera: Camera,
  size: Size,
): string {
  const paths = shapes.map((shape) => `    <path class="${shape.role}" d="${shape.d}"/>`);
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${n(size.width)} ${n(size.height)}">`,
    `  <g transform="${transform(camera)}">`,
    ...paths,
    "  </g>",
    "</svg>",
    "",
  ].join("\n");
}
