import fc from "fast-check";
import { expect, test } from "vitest";
import { c810 } from "../../src/cycles/c810.ts";
import type { Draw } from "../../src/cycles/drawn-setup.ts";
import { contourFrom, type ContourElement } from "../../src/kernel/contour.ts";
import { at, part, type Pt } from "../../src/kernel/point.ts";
import { UNDERCUT_FORMS, type RecessWords, type UndercutForm } from "../../src/kernel/undercut.ts";
import { shippedTools } from "../../src/program/shipped-tools.ts";
import { areaOf, each, filled, grown, without, type Field, type Grid } from "../judge/field.ts";
import { insertOf, type P } from "../judge/insert.ts";
import { gridOver, judge, sumOf, THIN } from "../judge/judge.ts";
import type { Situation } from "./situation.ts";
import { planOf, stepsOf } from "./worked-plans.ts";

/*
 * What a tool leaves of a shaft or a bore against what is the least that it can leave. That least is found without any
 * strategy: the insert stands at every place along the axis as deep as the part lets it when it comes from the open side, and what no
 * such insert covers stays.
 */

/** Width of the columns, mm. What is thinner than one of them and shallower than THIN is not seen. */
const WIDTH = 0.04;
/** Columns behind the contour: as wide as an insert. */
const BEHIND = 500;
/** mm² that may stay over the least. */
const OVER = 0.05;

/** The side of an insert that faces the part, column by column from its first one; `out`: 1 over a shaft, −1 in a bore. */
function lowerSide(tool: Situation["tool"], out: 1 | -1): { readonly first: number; readonly low: readonly number[] } {
  const insert = insertOf(tool);
  const first = Math.ceil(Math.min(...insert.map((p) => p.z)) / WIDTH);
  const last = Math.floor(Math.max(...insert.map((p) => p.z)) / WIDTH);
  const lowAt = (z: number) =>
    Math.min(...insert.flatMap((a, i) => {
      const b = insert[(i + 1) % insert.length] as P;
      if (Math.min(a.z, b.z) > z || Math.max(a.z, b.z) < z || a.z === b.z) return [];
      return [out * (a.r + ((b.r - a.r) * (z - a.z)) / (b.z - a.z))];
    }));
  return { first, low: Array.from({ length: last - first + 1 }, (_, i) => lowAt((first + i) * WIDTH)) };
}

/** How high a part stands, column by column, and what stays over it at the least. */
function least(surface: readonly number[], { first, low }: ReturnType<typeof lowerSide>): number[] {
  const beside = low.length;
  const left = surface.map(() => Infinity);
  for (let tip = -beside; tip < surface.length + beside; tip += 1) {
    let depth = -Infinity;
    low.forEach((v, i) => {
      depth = Math.max(depth, (surface[tip + first + i] ?? -Infinity) - v);
    });
    low.forEach((v, i) => {
      const k = tip + first + i;
      if (k >= 0 && k < left.length) left[k] = Math.min(left[k] as number, depth + v);
    });
  }
  return left;
}

/** What one cut leaves over the least, and what it gouges, mm². */
function judged(points: readonly Pt[], s: Situation, out: 1 | -1) {
  const plan = planOf(c810, s);
  const errors = plan.issues.filter((i) => i.severity === "error").map((i) => i.code);
  const last = points.at(-1) as Pt;
  const deep = out > 0 ? -1 : Math.max(...(s.blank[0] ?? []).map((p) => p.r)) + 1;
  // The part goes on behind the contour.
  const ring: P[] = [...points, { z: last.z - 40, r: last.r }, { z: last.z - 40, r: deep }, { z: (points[0] as Pt).z, r: deep }];
  const grid = gridOver([points], "z", WIDTH);
  const wide: Grid = { ...grid, from: grid.from - BEHIND * WIDTH, count: grid.count + BEHIND };
  const surface = filled(wide, [ring]).map((spans) => (out > 0 ? spans.at(-1) ?? -Infinity : -(spans[0] ?? Infinity)));
  const stays = least(surface, lowerSide(s.tool, out)).slice(BEHIND).map(
    (v): number[] => (out > 0 ? [-1, Math.max(-1, v)] : [Math.min(-v, deep), deep])
  );
  const verdict = judge(s.blank, stepsOf([plan], s), [ring], grid);
  const over = (a: Field, b: Field) => areaOf(grid, each(a, grown(b, THIN), without));
  return { errors, over: over(verdict.final, stays), gouge: sumOf(verdict, "gouge"), rapid: sumOf(verdict, "rapid") };
}

interface Shaft {
  readonly name: string;
  readonly elements: readonly ContourElement[];
}

/** Where the contour of a shaft or bore goes: mm on along the axis and up out of the part, from its first point. */
const placeOn = (out: 1 | -1, r: number) => (on: number, up: number): Pt => at(-on, r + out * up);

const undercut = (form: UndercutForm, words: RecessWords): ContourElement => ({ kind: "undercut", form, words });
/** Each form with awkward measures. */
const FORMS: Readonly<Record<UndercutForm, RecessWords>> = {
  E: { R: 0.6, DEPTH: 0.35, BREADTH: 2.6, ANGLE: 15 },
  F: { R: 0.6, DEPTH: 0.3, BREADTH: 2.5, ANGLE: 15, FACEDEPTH: 0.2, FACEANGLE: 8 },
  H: { R: 0.7, BREADTH: 2.7, ANGLE: 15 },
  K: { R: 0.4, DEPTH: 0.9, ROT: 45, ANGLE: 40 },
  U: { R: 0.5, DEPTH: 0.8, BREADTH: 3.3 },
  THREAD: { PITCH: 1.5, R: 0.8, DEPTH: 1.15, BREADTH: 5.2, ANGLE: 30 },
};

/** Three to six features on and on: shoulders with an undercut or a corner, tapers, arcs, recesses. */
function drawn(draw: Draw, out: 1 | -1): Shaft {
  const mm = (least: number, most: number) => draw.whole(least * 20, most * 20) / 20;
  const place = placeOn(out, out > 0 ? 9 : 40);
  const elements: ContourElement[] = [{ kind: "line", to: place(0, 0) }];
  const names: string[] = [];
  let [on, up] = [mm(0.5, 1.5), mm(0.5, 1.5)];
  const line = () => elements.push({ kind: "line", to: place(on, up) });
  line();
  for (let count = draw.whole(3, 6); count > 0; count -= 1) {
    const feature = draw.one("shoulder", "undercut", "rise", "fall", "hill", "valley", "recess");
    on += feature === "recess" ? 9 : mm(5.5, 8);
    line();
    const corner = draw.one("round", "chamfer", "none");
    const round = () => corner !== "none" && elements.push({ kind: corner, size: mm(0.3, 1) });
    if (feature === "shoulder" || feature === "undercut") {
      const form = draw.one(...UNDERCUT_FORMS);
      if (feature === "undercut") elements.push(undercut(form, FORMS[form]));
      else round();
      names.push(feature === "undercut" ? `UDC ${form}` : feature);
      up += mm(2.5, 4);
      line();
    } else if (feature === "rise" || feature === "fall") {
      round();
      names.push(feature);
      on += mm(1.5, 6);
      up += (feature === "rise" ? 1 : -1) * mm(1, 3);
      line();
      round();
    } else if (feature === "recess") {
      const [middle, depth] = [place(on - 4.2, 0).z, mm(0.6, 1.6)];
      const words = { CENTER: middle, DEPTH: -out * depth, BREADTH: mm(5, 7), ANGLE: draw.one(90, 100, 110), R: 0.4 };
      names.push(`GRV ${words.BREADTH} x ${depth}`);
      elements.push({ kind: "groove", direction: "radial", words });
    } else {
      const size = mm(2.5, 5);
      names.push(`${feature} ${size}`);
      on += size;
      const turn = (feature === "hill") === (out > 0) ? "ccw" : "cw";
      elements.push({ kind: "radius", to: place(on, up), radius: size * draw.one(0.55, 0.8, 1.2), turn });
    }
  }
  on += 6;
  line();
  elements.push({ kind: "line", to: place(on, Math.max(up, 0) + 5) });
  return { name: names.join(", "), elements };
}

/** What is cut of a shaft or bore in one setting, roughed and finished. */
function worked(shaft: Shaft, T: number, out: 1 | -1, smoothing: number, operation = 0) {
  const built = contourFrom(shaft.elements);
  expect(built.issues.filter((i) => i.severity === "error"), shaft.name).toEqual([]);
  const points = part.flattenedChain(built.segments, 0.0005);
  const last = points.at(-1) as Pt;
  const top = (out > 0 ? Math.max : Math.min)(...points.map((p) => p.r));
  const far = out > 0 ? 0 : top + 60;
  const start = at(2, top + out);
  const s: Situation = {
    values: {
      Q215: operation,
      Q460: 2,
      Q499: 0,
      Q463: 1.7,
      Q478: 0.3,
      Q483: 0.4,
      Q484: 0.2,
      Q505: 0.2,
      Q487: 1,
      Q488: 0,
      Q479: 0,
      Q480: 0,
      Q482: 0,
      Q506: smoothing,
    },
    given: { contour: built.segments, start },
    tool: shippedTools.find((tool) => tool.T === T) as Situation["tool"],
    start,
    blank: [[at(0, top), at(last.z - 20, top), at(last.z - 20, far), at(0, far)]],
  };
  return judged(points, s, out);
}

/** All forms one after the other. */
function everyForm(out: 1 | -1): Shaft {
  const place = placeOn(out, out > 0 ? 8 : 40);
  const steps = UNDERCUT_FORMS.flatMap((form, i): ContourElement[] => {
    const [on, up] = [1 + 9 * (i + 1), 1 + 3.4 * i];
    return [{ kind: "line", to: place(on, up) }, undercut(form, FORMS[form]), { kind: "line", to: place(on, up + 3.4) }];
  });
  return { name: "every form", elements: [{ kind: "line", to: place(0, 0) }, { kind: "line", to: place(1, 1) }, ...steps] };
}

/** A valley in a valley, a ball, and a hollow that is as steep as a wall at its end. */
function valleys(out: 1 | -1): Shaft {
  const place = placeOn(out, out > 0 ? 12 : 40);
  const line = (on: number, up: number): ContourElement => ({ kind: "line", to: place(on, up) });
  const arc = (on: number, up: number, radius: number, isHill: boolean): ContourElement => ({
    kind: "radius",
    to: place(on, up),
    radius,
    turn: isHill === out > 0 ? "ccw" : "cw",
  });
  const round: ContourElement = { kind: "round", size: 0.7 };
  return {
    name: "valleys",
    elements: [
      line(0, 0),
      line(0.8, 0.8),
      line(7, 0.8),
      line(9, -1.2),
      line(13, -1.2),
      line(15, -2.7),
      round,
      line(20, -2.7),
      line(26, 3),
      line(30, 3),
      arc(35, 3, 2.6, true),
      line(39, 3),
      arc(43, 7, 4, false),
      line(43, 9),
    ],
  };
}

const CASES = Number(process.env["LAW_CASES"] ?? 6);
/** fast-check as dice of one seed: what was cut once is cut on every run. */
const shafts = (out: 1 | -1, seed: number): Shaft[] =>
  fc.sample(fc.gen().map((g) =>
    drawn({
      one: <T>(...of: readonly T[]) => of[g(fc.nat, { max: of.length - 1 })] as T,
      whole: (min, max) => g(fc.integer, { min, max }),
    }, out)
  ), { numRuns: CASES, seed });

test.each([{ T: 2, out: 1 }, { T: 3, out: 1 }, { T: 6, out: -1 }] as const)("810 with T$T leaves what cannot be taken", ({ T, out }) => {
  for (const [i, shaft] of [everyForm(out), valleys(out), ...shafts(out, T)].entries()) {
    const { errors, over, ...faults } = worked(shaft, T, out, i % 3);
    expect.soft({ errors, over: over > OVER ? over : 0, ...faults }, `${i}: ${shaft.name}`).toEqual({
      errors: [],
      over: 0,
      gouge: 0,
      rapid: 0,
    });
  }
});

test("what roughing alone leaves is more than that", () => {
  expect(worked(valleys(1), 2, 1, 0, 1).over).toBeGreaterThan(2);
});
