import * as fc from "fast-check";
import type { drawnTask } from "../src/course/drawn-task.ts";

type Drawn = Parameters<typeof drawnTask>[0];
type Sizes = NonNullable<Drawn["sizes"]>;
type Threads = NonNullable<NonNullable<Drawn["part"]>["threads"]>;

/** A step of a generated part, in tenths of a millimetre before scaling; `feature`: a cut into its surface. */
interface Step {
  readonly rise: number;
  readonly long: number;
  readonly corner: "none" | "chamfer" | "round";
  readonly feature: "none" | "undercut" | "groove" | "thread" | "cone";
  readonly deviation: number;
}

const step = fc.record({
  rise: fc.integer({ min: 13, max: 170 }),
  long: fc.integer({ min: 51, max: 390 }),
  corner: fc.constantFrom<Step["corner"][]>("none", "chamfer", "round"),
  feature: fc.constantFrom<Step["feature"][]>("none", "none", "undercut", "groove", "thread", "cone"),
  deviation: fc.integer({ min: 0, max: 3 }),
});

const DEVIATIONS = [
  { upper: 0, lower: -0.021 },
  { upper: 0.05, lower: -0.05 },
  { upper: -0.007, lower: -0.028 },
] as const;

/** From a watch pin to a mill shaft. */
export const SCALES = [0.05, 0.21, 1, 4.3, 11] as const;

/**
 * A turned part of any size with steps, chamfers, roundings, undercuts, grooves, cones and threads, outside and inside.
 */
export const turnedParts = fc.record({
  scale: fc.constantFrom(...SCALES),
  long: fc.constantFrom(1, 1, 3.7),
  outside: fc.array(step, { minLength: 1, maxLength: 6 }),
  inside: fc.array(step, { maxLength: 3 }),
  rest: fc.boolean(),
});
export type TurnedPart = typeof turnedParts extends fc.Arbitrary<infer P> ? P : never;

/** The part in the form of a task. */
export function partOf({ scale, long, outside, inside, rest }: TurnedPart): Drawn {
  const round = (value: number): number => Math.round(value * scale * 1000) / 1000;
  const at = (x: number, z: number) => `L X${round(2 * x)} Z${round(z)}`;
  const sizes: Sizes[number][] = [],
    threads: Threads[number][] = [];
  const wall = 2,
    least = 1.2;
  const depthOf = (steps: readonly Step[]) => steps.reduce((sum, { rise }) => sum + rise / 20, 0);
  const mouth = inside.length > 0 ? least + depthOf(inside) : 0;

  const chain = (steps: readonly Step[], start: number, sign: 1 | -1) => {
    let r = start,
      z = 0;
    const lines: string[] = [];
    steps.forEach(({ rise, long: tenths, corner, feature, deviation }, i) => {
      const before = r,
        end = z - (tenths / 10) * long,
        deep = Math.min(rise / 20, 0.9) * 0.6;
      if (sign > 0 || i > 0) r += (sign * rise) / 20;
      const broken = Math.min(0.5, Math.abs(r - before) * 0.6, (z - end) * 0.1);
      const name =
        corner === "chamfer" ? `CHF ${Math.max(0.001, round(broken))}` : `RND R${Math.max(0.001, round(broken))}`;
      if (feature === "cone" && sign > 0) lines.push(at(before + (r - before) / 2, z), at(r, end));
      else {
        lines.push(at(r, z));
        if (corner !== "none" && broken > 0.05) lines.push(name);
        if (feature === "groove") {
          const [a, b] = [z + (end - z) * 0.4, z + (end - z) * 0.6];
          lines.push(at(r, a), at(r - sign * deep, a), at(r - sign * deep, b), at(r, b), at(r, end));
        } else if (feature === "undercut") {
          const wide = Math.min(2.5, (z - end) * 0.4);
          lines.push(at(r, end + wide), at(r - sign * deep, end + wide - deep), at(r - sign * deep, end));
        } else lines.push(at(r, end));
        if (feature === "thread") {
          const root = r - sign * deep;
          threads.push({
            from: round(z),
            to: round(end * 0.75 + z * 0.25),
            crest: round(2 * r),
            root: round(2 * root),
            name: `M${round(2 * Math.max(r, root))}×${round(deep * 1.6)}`,
          });
        }
        const given = DEVIATIONS[deviation];
        if (given && feature !== "thread")
          sizes.push({
            kind: sign > 0 ? "diameter" : "bore",
            at: round(z * 0.8 + end * 0.2),
            nominal: round(2 * r),
            ...given,
          });
      }
      z = end;
    });
    return { lines, r, z };
  };
  const bore = chain(inside, mouth, -1);
  const outer = chain(outside, mouth + (inside.length > 0 ? wall : 0), 1);
  const end = outer.r + 3,
    hole = Math.max(0.6, bore.r - 0.8);
  const length = Math.max(-outer.z, -bore.z) + (rest ? 30 * long : 0) + 1;
  return {
    part: {
      blank: [
        `BLK FORM CYLINDER Z D${round(2 * end)} L${round(length)} DIST+${round(1)}${inside.length > 0 ? ` DI${round(2 * hole)}` : ""}`,
      ],
      outside: [at(mouth, 0), ...outer.lines, at(end, outer.z)],
      ...(inside.length > 0 && { bore: [...bore.lines, at(hole, bore.z)] }),
      ...(threads.length > 0 && { threads }),
    },
    sizes,
    rules: { rz: [{ from: 0, to: round(outer.z), most: 6.3 }] },
  };
}
