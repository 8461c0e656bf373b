import type { Group } from "../../../cycles/define.ts";
import { cutLength, cuttingWidth, isBar, tipDirection } from "../../../kernel/cutter/insert.ts";
import { IN_MM, rounded, roundedDown, roundedDownTo, roundedUpTo, toDiameter } from "../../../kernel/units.ts";
import { valueInProgram } from "../../../program/blocks/cycle-values.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import { DEPTH_OF_WIDTH } from "../../../program/tools/cutting-work.ts";
import { powerAt } from "../../../program/machine/machine-data.ts";
import { depthForPower, EDGE_USED } from "../../advice/formulas.ts";
import { depthByWorkpiece } from "../bending.ts";
import { changeOfBlocks, type Change } from "../change.ts";
import { withValues } from "../edits.ts";
import { calledNumber, writtenNumber, type ProgramSituation, type TurningUnit } from "../situation.ts";

/**
 * Share of the depth that advice allows for an edge: chip breaker and overhang are unknown, so that an offer stays well
 * below the limit.
 */
const SHARE = 0.5;
/** The same in a bore, whose bar may be long and slender. */
const SHARE_INSIDE = 0.25;
/** Deepest cut of a finishing insert, mm. */
const FINISHING_DEPTH = 1;
/** Step of an offered infeed, mm. */
const STEP = 0.1;
/** Cycles whose passes are one above the other. */
const SIDEWAYS: ReadonlySet<Group> = new Set<Group>(["longitudinal", "transverse", "recessTurning"]);

/** The greatest infeed that an edge bears, mm; null for a tool without CUTLENGTH, and for a blade without a width. */
function byEdge(tool: Tool): number | null {
  if (isBar(tool)) return cuttingWidth(tool) > 0 ? DEPTH_OF_WIDTH * cuttingWidth(tool) : null;
  const edge = cutLength(tool);
  if (edge === undefined) return null;
  const most = edge * EDGE_USED * (tipDirection(tool.TO).v > 0 ? SHARE_INSIDE : SHARE);
  return tool.TYPE === "FINISH" ? Math.min(FINISHING_DEPTH, most) : most;
}

/** The greatest infeed to offer, mm: by edge, power and workpiece; null where the edge is unknown. */
function greatest(of: TurningUnit, situation: ProgramSituation): number | null {
  const {
    power,
    material,
    run: { timing },
  } = situation;
  const { tool, spindle, feedUnit, start } = of.operation;
  const edge = byEdge(tool);
  const feed = calledNumber(of, "roughingFeed");
  if (edge === null || feedUnit !== "mm/rev" || !feed) return null;
  if (!spindle) return null;
  const around = (Math.PI * Math.max(1, toDiameter(start.r))) / 1000;
  const [speed, rpm] =
    spindle.kind === "surface"
      ? [spindle.cuttingSpeed, Math.min(spindle.cuttingSpeed / around, spindle.limit || Infinity)]
      : [spindle.speed * around, spindle.speed];
  const given = (timing.turning && powerAt(timing.turning, rpm)) ?? power;
  const strong = depthForPower(material, given, feed, speed);
  return roundedDownTo(STEP, Math.min(edge, strong, depthByWorkpiece(situation, material, of.operation)));
}

/** A greater infeed with fewer passes, within what edge and spindle take. */
export const infeed = (situation: ProgramSituation): readonly Change[] =>
  situation.units.flatMap((of): readonly Change[] => {
    const { cycle, operation, unit, work } = of;
    const written = writtenNumber(of, "infeed");
    if (!SIDEWAYS.has(cycle.group) || work === "finish" || !written) return [];
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
      changeOfBlocks(situation.program, { kind: "infeed", units: [unit], tool: operation.tool.T, value }, expected, [
        withValues(of, { [written.q]: value.to }),
      ]),
    ];
  });
