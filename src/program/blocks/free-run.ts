import { at as pointAt, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { planePoint } from "../../kernel/plane/plane.ts";
import { radius, toDiameter, toRadius, diameter } from "../../kernel/units.ts";
import type { StatementOf } from "../../nc/statement.ts";
import { datumShiftOf } from "../motion/datum.ts";
import { isFreeElement, solveFree, type FreeRun } from "../state/free-contour.ts";
import { collectFree, sayChosen, sayUnsolved } from "./free-words.ts";
import type { Machine } from "../state/machine.ts";
import { path } from "../motion/motion.ts";
import { wordReader } from "../motion/path-block.ts";
import { pointIn } from "../state/path.ts";

type Free = StatementOf<"free">;

/** One block of a free contour: solved with those that follow, it runs as the line or arc that it is. */
export function runFree(machine: Machine, s: Free, index: number): void {
  if (s.form === "FPOL") machine.change({ freePole: s });
  if (!isFreeElement(s)) return;
  const { freeRun } = machine.run;
  const run = freeRun?.expected === index ? freeRun : solved(machine, index);
  const after = [...run.blocks.keys()].find((i) => i > index) ?? null;
  machine.change({ freeRun: { ...run, expected: after } });
  const made = run.blocks.get(index);
  if (made) {
    if (made.isChosen) sayChosen(machine, index);
    return path(machine, made.path, index);
  }
  machine.losePosition();
  sayUnsolved(machine, s, index);
}

function solved(machine: Machine, index: number): FreeRun {
  const { run, indices } = collectFree(machine, index);
  const { turning, mill } = machine.now;
  // With mirrored, rotated or scaled coordinates, or an unknown datum, the given values count in other coordinates than
  // the position.
  const elsewhere =
    wordReader(machine, index).frame || [datumShiftOf(machine, "X"), datumShiftOf(machine, "Z")].includes("unknown");
  if (elsewhere || (!turning && mill.otherAxis)) return { blocks: new Map(), expected: null };
  const { at, sure, last, mill: centre } = machine.place;
  const from = turning ? (sure.x && sure.z ? pointIn("lathe", at) : null) : pointIn("XY", centre);
  const { freePole } = machine.run;
  const blocks = solveFree(freePole && run[0]?.s.form !== "FPOL" ? [{ s: freePole, block: -1 }, ...run] : run, {
    plane: turning ? "lathe" : "XY",
    from: from && planePoint(counted(machine, from)),
    before: last && moved(machine, last),
    number: (value) => machine.number(value, index),
  });
  return { blocks: new Map(indices.map((i, k) => [i, blocks[k] ?? null])), expected: null };
}

/** A point of the workpiece in the unit of the program, from its datum. */
function counted(machine: Machine, p: Pt): Pt {
  const { turning } = machine.now;
  const unit = machine.length(1);
  const shift = (axis: "X" | "Y" | "Z") => Number(datumShiftOf(machine, axis) ?? 0);
  if (!turning) return pointAt((p.z - shift("X")) / unit, (p.r - shift("Y")) / unit);
  const across = toRadius(diameter(toDiameter(radius(p.r)) - shift("X")));
  return pointAt((p.z - shift("Z")) / unit, across / unit);
}

function moved(machine: Machine, s: Segment): Segment {
  const [from, to] = [counted(machine, s.from), counted(machine, s.to)];
  return s.kind === "line" ? { kind: "line", from, to } : { ...s, from, to, centre: counted(machine, s.centre) };
}
