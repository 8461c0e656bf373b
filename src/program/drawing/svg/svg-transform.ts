import { after, shift, spin, stretch, UNPLACED, type Placing } from "../space.ts";
import { numbersOf } from "./svg-path.ts";

const radians = (degrees: number) => (degrees * Math.PI) / 180;
const matrix = (a: number, b: number, c: number, d: number, e: number, f: number): Placing => ({
  x: [a, b, 0],
  y: [c, d, 0],
  z: [0, 0, 1],
  origin: [e, f, 0],
});

/** One transform function; null for one that is not known or lacks numbers. */
function placingOf(name: string, n: readonly number[]): Placing | null {
  const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0] = n;
  switch (name) {
    case "matrix":
      return n.length === 6 ? matrix(a, b, c, d, e, f) : null;
    case "translate":
      return n.length > 0 ? shift([a, b, 0]) : null;
    case "scale":
      return n.length > 0 ? stretch(a, n.length > 1 ? b : a, 1) : null;
    case "rotate":
      if (n.length === 0) return null;
      return after(shift([b, c, 0]), after(spin(radians(a)), shift([-b, -c, 0])));
    case "skewX":
      return n.length === 1 ? matrix(1, 0, Math.tan(radians(a)), 1, 0, 0) : null;
    case "skewY":
      return n.length === 1 ? matrix(1, Math.tan(radians(a)), 0, 1, 0, 0) : null;
    default:
      return null;
  }
}

/** Placing of a transform attribute: the last function is applied first. One that is faulty is none at all. */
export function transformOf(text: string | undefined): Placing {
  let placing = UNPLACED;
  if (!text) return placing;
  for (const [, name = "", list = ""] of text.slice(0, 10_000).matchAll(/(?<![a-zA-Z])([a-zA-Z]+)\s*\(([^()]*)\)/g)) {
    const made = placingOf(name, numbersOf(list));
    if (!made) return UNPLACED;
    placing = after(placing, made);
  }
  return placing;
}
