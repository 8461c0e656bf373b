import * as fc from "fast-check";
import { newPart, type FinishedPart, type RowMark } from "../../src/planning/part/finished-part.ts";
import { newRow, type ContourRow } from "../../src/program/job/job.ts";

/*
 * Random parts of the trade's elements for laws: steps, tapers, arcs, chamfers, roundings, grooves in cylinders and
 * faces, undercuts, valleys, bores with tapers, arcs, recesses and undercuts, some wider behind a shoulder, threads with
 * their relief; from bar, tube and stepped blanks, some in a stated clamping or between centres. All of them are parts:
 * plannedPart finds no problem.
 */

const FEATURES = ["plain", "plain", "thread", "undercut", "groove", "valley", "taper", "convex", "concave"] as const;
/** Those that begin in the middle of their rise. */
const SLOPED: ReadonlySet<string> = new Set(["taper", "convex", "concave"]);
const BORE_FEATURES = [
  "plain",
  "plain",
  "groove",
  "thread",
  "bore taper",
  "bore arc",
  "bore undercut",
  "wider behind",
] as const;
/** Those that narrow along their whole length. */
const NARROWING: ReadonlySet<string> = new Set(["bore taper", "bore arc"]);

/** A step of a side: lengths in mm, `rise` in half millimetres of the radius, so that diameters are whole numbers. */
const stepOf = <F>(features: readonly F[]) =>
  fc.record({
    rise: fc.integer({ min: 4, max: 20 }),
    long: fc.integer({ min: 12, max: 40 }),
    corner: fc.constantFrom("none", "CHF", "RND"),
    feature: fc.constantFrom(...features),
    /** Size of the feature, share of its room. */
    share: fc.integer({ min: 0, max: 4 }),
    tolerance: fc.constantFrom(null, null, "h6", "+0.02/-0.01"),
    ra: fc.constantFrom(null, null, 0.8, 1.6),
  });
type Step<F> = {
  readonly rise: number;
  readonly long: number;
  readonly corner: "none" | "CHF" | "RND";
  readonly feature: F;
  readonly share: number;
  readonly tolerance: string | null;
  readonly ra: number | null;
};
type Outer = Step<(typeof FEATURES)[number]>;
type Inner = Step<(typeof BORE_FEATURES)[number]>;

const text = (n: number) => String(Number(n.toFixed(3)) || 0);
/** ⌀ of a radius in half millimetres. */
const across = (halves: number) => text(halves);
/** Least wall between bore and outside, half millimetres. */
const WALL = 8;
/** Least rise of a face with a groove, half millimetres. */
const FACE_ROOM = 14;
/** Half the point angle of a drill, radians. */
const DRILL_POINT = (59 * Math.PI) / 180;
const pitchFor = (diameter: number) => (diameter < 20 ? 1 : diameter < 50 ? 1.5 : 2);

/** Collects rows with their marks. */
function table(letter: string) {
  const rows: ContourRow[] = [],
    marks: Record<string, RowMark> = {};
  const row = (given: Partial<ContourRow>, mark: RowMark = {}) => {
    const id = `${letter}${rows.length + 1}`;
    rows.push(newRow(id, given));
    if (Object.keys(mark).length > 0) marks[id] = mark;
  };
  return { rows, marks, row };
}

/** An edge that is broken by no more than fits. */
const edge = ({ corner, share }: Outer | Inner, room: number): Partial<ContourRow> | null =>
  corner === "none" ? null : { kind: corner, r: text(Math.min(0.3 + 0.4 * share, room)) };

const markOf = ({ tolerance, ra }: Outer | Inner): RowMark => ({
  ...(tolerance !== null && { tolerance }),
  ...(ra !== null && { ra }),
});

/** The outside over a core that bore and features must not reach, in half millimetres. */
function outsideOf(steps: readonly Outer[], core: number, faceGroove: boolean) {
  const { rows, marks, row } = table("e");
  row({ x: "0", z: "0" });
  let [halves, z] = [core, 0];
  for (const [i, step] of steps.entries()) {
    const { rise, long, share } = step,
      next = steps[i + 1],
      before = halves,
      end = z - long;
    halves += rise;
    const r = halves / 2,
      room = (halves - before) / 2;
    if (SLOPED.has(step.feature)) {
      // From the middle of the rise to its top.
      const low = before + Math.floor(rise / 2);
      row({ x: across(low) });
      if (step.feature === "taper") row({ x: across(halves), z: text(end) }, markOf({ ...step, tolerance: null }));
      else {
        // A hill has its top at its end, or it would be higher than that.
        const up = (halves - low) / 2,
          chord = Math.hypot(long, up);
        const radius = step.feature === "convex" ? (chord ** 2 / (2 * up)) * (1 + 0.2 * share) : chord * (2 + share);
        const turn = step.feature === "convex" ? "ccw" : "cw";
        row({ kind: "CR", x: across(halves), z: text(end), r: text(radius), turn });
      }
    } else {
      row({ x: across(halves) });
      if (i === 0 && faceGroove && rise >= FACE_ROOM) {
        const words = { CENTER: across(before + rise / 2), BREADTH: "3", DEPTH: text(-1.5 - 0.5 * share) };
        row({ kind: "GRV", form: "AXIAL", words });
      }
      const broken = edge(step, Math.min(room * 0.25, long * 0.1));
      if (broken) row(broken);
      if (step.feature === "thread") row({ z: text(end) }, { thread: `M${across(halves)}x${text(pitchFor(halves))}` });
      else if (step.feature === "valley") {
        const deep = Math.min(0.4 + 0.4 * share, room * 0.8),
          lean = share % 2 === 0 ? deep / Math.tan(Math.PI / 6) : 0;
        const [from, to] = [z - long * 0.25, z - long * 0.85];
        row({ z: text(from) });
        row({ x: text(2 * (r - deep)), z: text(from - Math.min(lean, long * 0.3)) });
        row({ z: text(to) }, markOf({ ...step, tolerance: null }));
        row({ x: across(halves) });
        row({ z: text(end) });
      } else row({ z: text(end) }, markOf(step));
      if (step.feature === "groove") {
        const breadth = Math.min(3 + share, long * 0.4),
          words = {
            CENTER: text(z - long * 0.55),
            BREADTH: text(breadth),
            DEPTH: text(-Math.min(0.5 + 0.5 * share, room * 0.8)),
            ...(share % 2 === 1 && { ANGLE: "15" }),
            ...(share > 2 && { CHF: "0.2", FAR_CHF: "0.2" }),
          };
        row({ kind: "GRV", form: "RADIAL", words });
      }
      const isShoulder = next !== undefined && !SLOPED.has(next.feature) && next.rise >= 10;
      if (step.feature === "thread" && isShoulder) row({ kind: "UDC" }, { undercut: "DIN 76-A" });
      if (step.feature === "undercut" && isShoulder) row({ kind: "UDC", form: share % 2 === 0 ? "E" : "F" });
    }
    z = end;
  }
  const hasFaceGroove = rows.some(({ form }) => form === "AXIAL");
  return { rows, marks, length: -z, first: core + (steps[0]?.rise ?? 0), halves, hasFaceGroove };
}

/**
 * A bore from the front, wide to narrow; returns its widest and narrowest place, half millimetres. `flat`: a hole of the
 * blank goes on behind it.
 */
function insideOf(steps: readonly Inner[], length: number, through: boolean, flat: boolean) {
  const { rows, marks, row } = table("i");
  const first = steps.reduce((sum, { rise }) => sum + rise, 6);
  let [halves, z, widest] = [first, 0, first];
  const reach = steps.reduce((sum, { long }) => sum + long, 0),
    shrink = Math.min(1, (length - (through ? 0 : 24)) / reach);
  for (const [i, step] of steps.entries()) {
    const last = i === steps.length - 1,
      end = last && through ? -length : z - step.long * shrink,
      room = Math.min(0.5, (z - end) * 0.1);
    row({ x: across(halves), ...(i === 0 && { z: "0" }) });
    const broken = i === 0 || NARROWING.has(step.feature) ? null : edge(step, room);
    if (broken) row(broken);
    if (NARROWING.has(step.feature)) {
      // Down to the middle of the next step.
      const low = halves - Math.floor((last ? 4 : step.rise) / 2),
        down = (halves - low) / 2,
        // Widest at its beginning.
        radius = ((z - end) ** 2 + down ** 2) / (2 * down);
      if (step.feature === "bore taper") row({ x: across(low), z: text(end) }, markOf({ ...step, tolerance: null }));
      else row({ kind: "CR", x: across(low), z: text(end), r: text(radius * (1 + 0.2 * step.share)), turn: "ccw" });
      z = end;
      halves = last ? low : halves - step.rise;
      continue;
    }
    // Drawn at its nominal ⌀: the part has the core.
    const isThread = step.feature === "thread" && halves >= 12;
    if (step.feature === "wider behind") {
      // A shoulder that looks to the rear, across the axis or at 45°.
      const [wide, from] = [2 + 2 * step.share, z - (z - end) * 0.4],
        lean = step.share % 2 === 0 ? 0 : Math.min(wide / 2, (z - end) * 0.2);
      row({ z: text(from) }, markOf({ ...step, tolerance: null }));
      row({ x: across(halves + wide), z: text(from - lean) });
      widest = Math.max(widest, halves + wide);
    }
    row(
      { z: text(end) },
      isThread ? { thread: `M${across(halves)}x${text(pitchFor(halves))}` } : markOf({ ...step, tolerance: null }),
    );
    const next = steps[i + 1];
    if (next && !NARROWING.has(next.feature) && step.rise >= 10 && z - end > 8) {
      if (isThread) row({ kind: "UDC" }, { undercut: "DIN 76-C" });
      if (step.feature === "bore undercut") row({ kind: "UDC", form: step.share % 2 === 0 ? "E" : "F" });
    }
    if (step.feature === "groove" && z - end > 6)
      row({
        kind: "GRV",
        form: "RADIAL",
        words: {
          CENTER: text((z + end) / 2),
          BREADTH: text(Math.min(3, (z - end) * 0.3)),
          DEPTH: text(0.5 + 0.2 * step.share),
        },
      });
    z = end;
    if (!last) halves -= step.rise;
  }
  // The bottom that a drill leaves.
  if (!through && !flat) row({ x: "0", z: text(z - halves / 2 / Math.tan(DRILL_POINT)) });
  return { rows, marks, widest, narrowest: halves };
}

export interface ArbitraryPart {
  readonly part: FinishedPart;
  /** What it has, for the name of a case. */
  readonly features: readonly string[];
}

/** Length of a stated grip, mm. */
const GRIP = 20;

/** The rows of a blank that is near the first step of a part. */
function forgedRows(
  { first, halves }: { readonly first: number; readonly halves: number },
  long: number,
  { over, front, rear }: { readonly over: number; readonly front: number; readonly rear: number },
): readonly ContourRow[] {
  const at = (x: number, z: number, i: number) => newRow(`b${i + 1}`, { x: text(x), z: text(z) });
  const step = [
    [0, front],
    [first + over, front],
    [first + over, 1 - long],
    [halves + over, 1 - long],
    [halves + over, -rear],
    [0, -rear],
  ] as const;
  return step.map(([x, z], i) => at(x, z, i));
}

/** Finished parts with their blank: solid and hollow, from bar and as blanks, some with a clamping. */
export const arbitraryParts: fc.Arbitrary<ArbitraryPart> = fc
  .record({
    outside: fc.array(stepOf(FEATURES), { minLength: 1, maxLength: 5 }),
    inside: fc.array(stepOf(BORE_FEATURES), { maxLength: 3 }),
    through: fc.boolean(),
    drilled: fc.boolean(),
    over: fc.integer({ min: 1, max: 6 }),
    facing: fc.integer({ min: 0, max: 4 }),
    rear: fc.constantFrom("bar", "chuck", "sawn"),
    faceGroove: fc.boolean(),
    blank: fc.constantFrom("cylinder", "cylinder", "forged"),
    held: fc.constantFrom(null, null, "chuckOutside", "softJaws", "collet", "centres"),
    material: fc.constantFrom("c45", "42crmo4", "brass", "x5crni"),
  })
  .map(({ outside: outer, inside: inner, through, drilled, over, facing, rear, material, ...more }): ArbitraryPart => {
    const length = outer.reduce((sum, { long }) => sum + long, 0);
    const isThrough = inner.length > 0 && (through || length < 48);
    const bore = insideOf(inner, length, isThrough, drilled);
    const hole = !drilled ? 0 : inner.length > 0 ? bore.narrowest - 3 : 10 + 2 * over;
    const core = WALL + (inner.length > 0 ? bore.widest : hole);
    const outside = outsideOf(outer, core, more.faceGroove),
      isCentred = more.held === "centres" && inner.length === 0 && hole === 0,
      isKept = rear === "chuck" && !isThrough && !isCentred,
      behind = isCentred ? 0 : rear === "sawn" ? 1 : 35,
      front = isCentred ? 0 : facing / 2;
    const isForged = more.blank === "forged" && hole === 0 && !isCentred;
    const size = text(2 * (outside.halves + over));
    const held = {
      D: text(outside.halves + over),
      LENGTH: text(GRIP),
      FACE: text(GRIP - length - behind),
      SIZE: size,
    };
    const clamping = isCentred
      ? { kind: "centres" as const, words: { D: size, FACE: text(-length), QUILL: size, TIP: "-4", ANGLE: "60" } }
      : more.held === null || more.held === "centres" || behind < GRIP
        ? null
        : { kind: more.held, words: held };
    return {
      features: [
        ...[...outer, ...inner].map((step) => step.feature),
        ...(outside.hasFaceGroove ? ["face groove"] : []),
        ...(hole > 0 ? ["tube"] : []),
        ...(isForged ? ["forged"] : []),
        ...(clamping ? [clamping.kind] : []),
      ],
      part: {
        ...newPart("RANDOM"),
        material,
        outside: outside.rows,
        inside: inner.length > 0 ? bore.rows : [],
        marks: { ...outside.marks, ...(inner.length > 0 && bore.marks) },
        general: { tolerance: "ISO 2768-m", ra: 3.2 },
        blank: isForged
          ? { outline: forgedRows(outside, outer[0]?.long ?? 0, { over, front, rear: length + behind }) }
          : {
              outside: text(outside.halves + over),
              bore: hole > 0 ? across(hole) : "0",
              length: text(length + front + behind),
              allowance: text(front),
            },
        clamping,
        partsOff: rear !== "sawn" && !isKept && !isCentred,
        unmachinedBehind: isKept,
      },
    };
  });
