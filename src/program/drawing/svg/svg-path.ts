import { add, minus, times, type Curve3, type V3 } from "../space.ts";
import { splineOf } from "../splines.ts";

/** Parameters of each command of a path; in small letters relative to the point before. */
const COUNTS: Readonly<Record<string, number>> = { m: 2, l: 2, h: 1, v: 1, c: 6, s: 4, q: 4, t: 2, a: 7, z: 0 };
const NUMBER = /[\s,]*([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?)/y;
/** Flags of an arc may stand without anything between them. */
const FLAG = /[\s,]*([01])/y;
const COMMAND = /[\s,]*([a-zA-Z])/y;
/** The coordinates of a drawing are below this. */
const FAR = 1e7;

/** A path as lines, arcs of ellipses and splines; `complete` is false where it ends in a fault, as browsers draw it. */
export interface PathCurves {
  readonly curves: readonly Curve3[];
  readonly complete: boolean;
}

const line = (from: V3, to: V3): Curve3 => ({ kind: "line", from, to });
const bezier = (...points: readonly V3[]): readonly Curve3[] => splineOf(points.length - 1, [], points, []) ?? [];

/** Elliptical arc between two points (SVG 2, appendix B.2.4): its centre from its radii, the tilt in degrees. */
export function ellipticalArc(
  from: V3,
  to: V3,
  radii: readonly [number, number],
  tilt: number,
  flags: { readonly large: boolean; readonly sweep: boolean },
): Curve3 | null {
  const [dx, dy] = [(from[0] - to[0]) / 2, (from[1] - to[1]) / 2];
  if (dx === 0 && dy === 0) return null;
  let [rx, ry] = [Math.abs(radii[0]), Math.abs(radii[1])];
  if (rx === 0 || ry === 0) return line(from, to);
  const angle = (tilt * Math.PI) / 180,
    [cos, sin] = [Math.cos(angle), Math.sin(angle)],
    [x, y] = [cos * dx + sin * dy, -sin * dx + cos * dy];
  // Radii that are too small grow until the arc reaches its end.
  const over = (x / rx) ** 2 + (y / ry) ** 2;
  if (over > 1) [rx, ry] = [rx * Math.sqrt(over), ry * Math.sqrt(over)];
  const inside = (rx * ry) ** 2 / ((rx * y) ** 2 + (ry * x) ** 2) - 1,
    k = Math.sqrt(Math.max(inside, 0)) * (flags.large === flags.sweep ? -1 : 1),
    [cx, cy] = [(k * rx * y) / ry, (-k * ry * x) / rx];
  const middle = times(add(from, to), 0.5),
    centre = add(middle, [cos * cx - sin * cy, sin * cx + cos * cy, 0]);
  const start = Math.atan2((y - cy) / ry, (x - cx) / rx),
    end = Math.atan2((-y - cy) / ry, (-x - cx) / rx),
    turn = 2 * Math.PI,
    round = flags.sweep ? (((end - start) % turn) + turn) % turn : -((((start - end) % turn) + turn) % turn);
  const u: V3 = [cos * rx, sin * rx, 0],
    v: V3 = [-sin * ry, cos * ry, 0];
  return round >= 0
    ? { kind: "conic", centre, u, v, start, end: start + round }
    : // The same curve in its own direction: with v turned about, angles grow.
      { kind: "conic", centre, u, v: times(v, -1), start: -start, end: -start - round };
}

/** The last control point of a curve, which a smooth one of the same kind mirrors. */
interface Control {
  readonly kind: "c" | "q";
  readonly point: V3;
}

class Numbers {
  readonly text: string;
  at = 0;

  constructor(text: string) {
    this.text = text;
  }

  private next(form: RegExp): string | null {
    form.lastIndex = this.at;
    const found = form.exec(this.text);
    if (!found) return null;
    this.at += found[0].length;
    return found[1] ?? null;
  }

  command = () => this.next(COMMAND);

  number(): number | null {
    const found = this.next(NUMBER),
      n = found === null ? NaN : Number(found);
    return Math.abs(n) < FAR ? n : null;
  }

  /** Parameters of one command; null where one is missing. */
  take(command: string): number[] | null {
    const out: number[] = [];
    for (let i = 0; i < (COUNTS[command] ?? 0); i += 1) {
      const isFlag = command === "a" && (i === 3 || i === 4),
        n = isFlag ? this.next(FLAG) : this.number();
      if (n === null) return null;
      out.push(Number(n));
    }
    return out;
  }

  atEnd = () => /^[\s,]*$/.test(this.text.slice(this.at, this.at + 100));
}

/** Numbers of a list such as `points`, up to the first that is none. */
export function numbersOf(list: string): number[] {
  const read = new Numbers(list),
    out: number[] = [];
  for (let n = read.number(); n !== null; n = read.number()) out.push(n);
  return out;
}

/** Reads path data (the attribute d) up to its first fault; coordinates as written, y downwards, z 0. */
export function pathCurves(data: string): PathCurves {
  const read = new Numbers(data),
    curves: Curve3[] = [];
  let at: V3 = [0, 0, 0],
    start = at,
    control: Control | null = null,
    name: string | null = null;
  const to = (p: V3) => {
    curves.push(line(at, p));
    at = p;
  };
  // A path begins with a move.
  if (!/^\s*[mM]/.test(data.slice(0, 1000))) return { curves, complete: read.atEnd() };
  while (!read.atEnd()) {
    const written: string | null = read.command();
    // Without a letter the one before goes on; a move goes on as lines.
    if (written) name = written;
    else if (name === null || name.toLowerCase() === "z") return { curves, complete: false };
    else if (name === "m") name = "l";
    else if (name === "M") name = "L";
    const command = name.toLowerCase(),
      n = command in COUNTS ? read.take(command) : null;
    if (!n) return { curves, complete: false };
    const base: V3 = name === command ? at : [0, 0, 0];
    const point = (i: number): V3 => add(base, [n[i] ?? 0, n[i + 1] ?? 0, 0]);
    const mirrored = (kind: "c" | "q") => (control?.kind === kind ? minus(times(at, 2), control.point) : at);
    let next: Control | null = null;
    switch (command) {
      case "m":
        start = at = point(0);
        break;
      case "l":
        to(point(0));
        break;
      case "h":
        to([base[0] + (n[0] ?? 0), at[1], 0]);
        break;
      case "v":
        to([at[0], base[1] + (n[0] ?? 0), 0]);
        break;
      case "c":
      case "s": {
        const [first, second, end] =
          command === "c" ? [point(0), point(2), point(4)] : [mirrored("c"), point(0), point(2)];
        curves.push(...bezier(at, first, second, end));
        next = { kind: "c", point: second };
        at = end;
        break;
      }
      case "q":
      case "t": {
        const [middle, end] = command === "q" ? [point(0), point(2)] : [mirrored("q"), point(0)];
        curves.push(...bezier(at, middle, end));
        next = { kind: "q", point: middle };
        at = end;
        break;
      }
      case "a": {
        const end = point(5),
          arc = ellipticalArc(at, end, [n[0] ?? 0, n[1] ?? 0], n[2] ?? 0, { large: n[3] === 1, sweep: n[4] === 1 });
        if (arc) curves.push(arc);
        at = end;
        break;
      }
      default:
        if (at[0] !== start[0] || at[1] !== start[1]) curves.push(line(at, start));
        at = start;
    }
    control = next;
  }
  return { curves, complete: true };
}
