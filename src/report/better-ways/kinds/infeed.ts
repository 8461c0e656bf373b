import { cutLength, isBar, tipDirection } from "../../../kernel/cutter/insert.ts";
import { IN_MM, rounded, roundedDown, roundedDownTo, roundedUpTo, toDiameter } from "../../../kernel/units.ts";
import { valueInProgram } from "../../../program/blocks/cycle-values.ts";
import { powerAt } from "../../../program/machine/machine-data.ts";
import { depthForPower, EDGE_USED } from "../../advice/formulas.ts";
import { changeOf, type Change } from "../change.ts";
import { withValues } from "../edits.ts";
import { calledNumber, writtenNumber, type ProgramSituation, type TurningUnit } from "../situation.ts";

/**
 * Share of the depth that advice allows for an edge: chip breaker and overhang are unknown, so that an offer stays well
 * below the limit.
 */
const SHARE = 0.5;
/** Deepest cut of a finishing insert, mm. */
const FINISHING_DEPTH = 1;
/** Step of an offered infeed, mm. */
const STEP = 0.1;

/** The greatest infeed to offer, mm: by the edge and the power; null for bars, bores and tools without CUTLENGTH. */
function greatest(of: TurningUnit, { power, material, run: { timing } }: ProgramSituation): number | null {
  const { tool, spindle, feedUnit, start } = of.operation;
  const edge = cutLength(tool);
  const feed = calledNumber(of, "roughingFeed");
  if (edge === undefined || isBar(tool) || tipDirection(tool.TO).v > 0 || feedUnit !== "mm/rev" || !feed) return null;
  if (!spindle) return null;
  const around = (Math.PI * Math.max(1, toDiameter(start.r))) / 1000;
  const [speed, rpm] =
    spindle.kind === "surface"
      ? [spindle.cuttingSpeed, Math.min(spindle.cuttingSpeed / around, spindle.limit || Infinity)]
      : [spindle.speed * around, spindle.speed];
  const given = (timing.turning && powerAt(timing.turning, rpm)) ?? power;
  const byEdge = tool.TYPE === "FINISH" ? FINISHING_DEPTH : edge * EDGE_USED * SHARE;
  return roundedDownTo(STEP, Math.min(byEdge, depthForPower(material, given, feed, speed)));
}

/** A greater infeed with fewer passes, within what edge and spindle take. */
export const infeed = (situation: ProgramSituation): readonly Change[] =>
  situation.units.flatMap((of): readonly Change[] => {
    const { cycle, operation, unit, work } = of;
    const written = writtenNumber(of, "infeed");
    if ((cycle.group !== "longitudinal" && cycle.group !== "transverse") || work === "finish" || !written) return [];
    const { passes, infeed: depth } = operation.plan;
    const most = greatest(of, situation);
    if (most === null || passes < 2 || depth >= most) return [];
    const fewest = Math.ceil(rounded((passes * depth) / most));
    const to = Math.min(most, roundedUpTo(STEP, (passes * depth) / fewest));
    const param = cycle.params[written.q];
    const { unit: length } = situation.run.program;
    if (!param || fewest >= passes || to > param.range[1]) return [];
    const inProgram = (mm: number) => valueInProgram(param, mm, length === "inch");
    const value = {
      at: written.q,
      from: written.value,
      to: inProgram(to),
      most: roundedDown(most / IN_MM[length]),
    };
    if (value.to <= value.from) return [];
    const expected = (operation.seconds * (passes - fewest)) / passes;
    return [
      changeOf({ kind: "infeed", units: [unit], tool: operation.tool.T, value }, expected, () =>
        withValues(situation, of, { [written.q]: value.to }),
      ),
    ];
  });
