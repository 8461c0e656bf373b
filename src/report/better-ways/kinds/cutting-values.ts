import { cuttingWidth, isBar } from "../../../kernel/cutter/insert.ts";
import { roundedDownTo } from "../../../kernel/units.ts";
import { withBlock } from "../../../nc/edit.ts";
import { valueInProgram } from "../../../program/blocks/cycle-values.ts";
import { cuttingPower } from "../../advice/formulas.ts";
import { changeOf, changeOfBlocks, type Change } from "../change.ts";
import { withValues } from "../edits.ts";
import { borneFeed } from "../fits.ts";
import { calledNumber, writtenNumber, type ProgramSituation, type TurningUnit } from "../situation.ts";

/** A value counts as low below the value of the table divided by this: the factor of the advice (decision 0032). */
const FAR = 1.6;
/** Step of a feed, mm/rev. */
const FEED_STEP = 0.005;

const turns = ({ cycle, operation }: TurningUnit) =>
  (cycle.group === "longitudinal" || cycle.group === "transverse") &&
  !isBar(operation.tool) &&
  operation.feedUnit === "mm/rev";

const recesses = ({ cycle: { group }, operation: { tool, feedUnit } }: TurningUnit) =>
  (group === "recessTurning" || group === "recessing") && isBar(tool) && feedUnit === "mm/rev";

/** Width of the chip, mm: a blade that plunges takes its whole width. */
const chipOf = ({ cycle, operation: { tool, plan } }: TurningUnit): number =>
  cycle.group === "recessing" ? cuttingWidth(tool) : plan.infeed;

/** Power that roughing takes with other values, kW; 0 for finishing. */
function powerOf(of: TurningUnit, { material }: ProgramSituation, speed: number, feed: number): number {
  return of.work === "finish" ? 0 : cuttingPower(material, chipOf(of), feed, speed);
}

/** Cutting speed of a section of operations, far below that of the material. */
export const cuttingSpeed = (situation: ProgramSituation): readonly Change[] => {
  const { program, all, units, material, power } = situation;
  if (!situation.isStated || situation.run.program.unit === "inch") return [];
  return all.sections.flatMap((section, s): readonly Change[] => {
    const own = units.filter(({ unit }) => all.units[unit]?.section === s);
    const index = program.blocks.findIndex(
      ({ statement }, i) => statement.kind === "spin" && i >= section.from && i < section.to,
    );
    const spin = program.blocks[index]?.statement;
    const given = own[0]?.operation.spindle;
    if (spin?.kind !== "spin" || !spin.constantSurface || typeof spin.cuttingSpeed !== "number") return [];
    if (own.length !== section.units.length || !own.every(turns) || given?.kind !== "surface") return [];
    const to = Math.min(...own.map(({ work }) => (work === "finish" ? material.finishSpeed : material.roughSpeed)));
    const from = spin.cuttingSpeed;
    const tooMuch = own.some((of) => powerOf(of, situation, to, calledNumber(of, "roughingFeed") ?? 0) > power);
    if (from * FAR > to || tooMuch) return [];
    const seconds = own.reduce((sum, { operation }) => sum + operation.seconds, 0);
    const subject = {
      kind: "cuttingSpeed",
      units: own.map(({ unit }) => unit),
      value: { at: "VC", from, to },
    } as const;
    return [
      changeOf(subject, seconds * (1 - from / to), () => withBlock(program, index, { ...spin, cuttingSpeed: to })),
    ];
  });
};

/** A roughing feed far below that of the material, up to what the nose or the width of a blade takes. */
export const feed = (situation: ProgramSituation): readonly Change[] => {
  const { units, material, power, run } = situation;
  if (!situation.isStated) return [];
  return units
    .filter((of) => turns(of) || recesses(of))
    .flatMap((of): readonly Change[] => {
      const { operation, unit, work, cycle } = of;
      const written = writtenNumber(of, "roughingFeed");
      const [called, spindle] = [calledNumber(of, "roughingFeed"), operation.spindle];
      const param = written && cycle.params[written.q];
      if (work === "finish" || !written || !param || called === null || called <= 0 || !spindle) return [];
      const most = roundedDownTo(FEED_STEP, Math.min(material.roughFeed, borneFeed(operation.tool)));
      const speed = spindle.kind === "surface" ? spindle.cuttingSpeed : 0;
      if (called * FAR > most || powerOf(of, situation, speed, most) > power) return [];
      const to = valueInProgram(param, most, run.program.unit === "inch");
      const value = { at: written.q, from: written.value, to };
      return [
        changeOfBlocks(
          situation.program,
          { kind: "feed", units: [unit], tool: operation.tool.T, value },
          operation.seconds * (1 - called / most),
          [withValues(of, { [written.q]: to })],
        ),
      ];
    });
};
