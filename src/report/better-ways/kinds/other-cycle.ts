import type { Cycle, Group } from "../../../cycles/define.ts";
import { firstValues } from "../../../cycles/first-values.ts";
import { cuttingCycles } from "../../../cycles/index.ts";
import type { Param, Params, Topic, Values } from "../../../cycles/params.ts";
import { useOf } from "../../../cycles/use.ts";
import { ncLabels } from "../../../i18n/nc-labels.ts";
import { cutLength, cuttingWidth, isBar } from "../../../kernel/cutter/insert.ts";
import { boxAround } from "../../../kernel/area/box.ts";
import { part, type Pt, type Segment } from "../../../kernel/geometry/point.ts";
import { CHORD } from "../../../kernel/tolerance.ts";
import { roundedDown, roundedDownTo, roundedUpTo } from "../../../kernel/units.ts";
import type { Plan } from "../../../kernel/plan/plan.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import { withBlock } from "../../../nc/edit.ts";
import type { CycleParameter } from "../../../nc/words.ts";
import { valueInProgram } from "../../../program/blocks/cycle-values.ts";
import { isRefused, retooledOperation, withoutOperation } from "../../../program/edits/operation-edits.ts";
import { SPEED_SHARE } from "../../../program/tools/cutting-work.ts";
import { checkTool } from "../../../program/tools/check-tool.ts";
import { fitOf, isUsualTool } from "../../../program/tools/which-tool.ts";
import { EDGE_USED } from "../../advice/formulas.ts";
import { changeOf, type Change, type ChangeSubject } from "../change.ts";
import { withSpeedShare } from "../edits.ts";
import { borneFeed, feedTurns } from "../fits.ts";
import { calledNumber, qOf, type ProgramSituation, type TurningUnit } from "../situation.ts";
import { cutsAir, stockBefore } from "../stock-before.ts";
import { WORTH } from "../measure.ts";
import { BOTH, isSameContour } from "./one-call.ts";

/** Most operations that are looked at, the longest first; most tools per cycle that are planned and that are tried. */
const MOST = { operations: 20, planned: 5, tried: 2 } as const;
/** A blade turns at most this share of its width deep (Ingersoll: 0.8), here with a margin. */
const BLADE_DEPTH = 0.5;
/** An insert in place of a blade takes this share of its edge: half of what advice allows. */
const INSERT_DEPTH = EDGE_USED / 2;
/** Step of a feed, mm/rev. */
const FEED_STEP = 0.005;
/** Feeds that a tool of the other family has to bear. */
const FEEDS: ReadonlySet<Topic> = new Set<Topic>(["roughingFeed", "plungingFeed"]);
/** Step of an allowance, mm. */
const STEP = 0.1;

type Numbers = Readonly<Record<string, number | "auto">>;

/** The values of another cycle with the contour, feeds and oversizes of an operation. */
function valuesFor(
  cycle: Cycle,
  of: TurningUnit,
  tool: Tool,
  situation: ProgramSituation,
  allowance: () => number,
): Numbers {
  const called = of.call.values as Numbers;
  const first = firstValues(cycle);
  const depth = qOf(cycle, "infeed");
  const isForeign = isBar(tool) !== isBar(of.operation.tool);
  const { material, isStated } = situation;
  return Object.fromEntries(
    Object.entries<Param>(cycle.params).map(([q, param]): readonly [string, number | "auto"] => {
      const own = of.cycle.params[q];
      const value = called[q];
      const isKept = own && own.shown === param.shown && own.kind === param.kind && value !== undefined;
      // Feeds of the other family: those of the material, as far as the tool bears them.
      if (isForeign && typeof value === "number" && FEEDS.has(param.shown)) {
        const usual = isStated ? material.roughFeed : value;
        return [q, roundedDownTo(FEED_STEP, Math.min(usual, borneFeed(tool)))];
      }
      if (isKept && !(isForeign && q === depth)) return [q, value];
      if (param.shown === "allowance") return [q, allowance()];
      if (q !== depth) return [q, first[q] ?? param.example];
      const infeed = calledNumber(of, "infeed") ?? first[q] ?? param.example;
      const most = isBar(tool) ? BLADE_DEPTH * cuttingWidth(tool) : INSERT_DEPTH * (cutLength(tool) ?? Infinity);
      return [q, roundedDown(isForeign && Number.isFinite(most) ? most : Math.min(infeed, most))];
    }),
  );
}

const isCalled = ({ call }: TurningUnit, q: string, value: unknown): boolean => (call.values as Numbers)[q] === value;

/** Q499 without and with a reversed contour; its third choice belongs to another tool. */
const DIRECTIONS = [0, 1];

/** Values, and the same with the contour read from its other end, as a cycle across reads what one along does. */
function inBothDirections(cycle: Cycle, values: Numbers): readonly Numbers[] {
  const q = qOf(cycle, "reverse");
  const from = q === null ? undefined : values[q];
  if (q === null || !DIRECTIONS.some((each) => each === from)) return [values];
  return [values, ...DIRECTIONS.filter((each) => each !== from).map((to) => ({ ...values, [q]: to }))];
}

const reversed = (contour: readonly Segment[]): readonly Segment[] => contour.map(part.reversed).reverse();

/** Facing and turning is for inserts, grooves are for blades; a valley is for both. */
const FAMILY: Readonly<Record<Group, "turning" | "grooving" | null>> = {
  longitudinal: "turning",
  transverse: "turning",
  recessTurning: "grooving",
  recessing: "grooving",
  thread: null,
  special: null,
};

/** How far a point lies out, along the way that the cycle comes in. */
const heightOf = (p: Pt, { openSide }: Plan): number => p.z * openSide.z + p.r * openSide.r;

/** Whether both ends of a contour lie further out than its middle. */
function isValley({ plan }: Pick<TurningUnit["operation"], "plan">): boolean {
  const points = plan.contour.flatMap((segment) => part.flattened(segment, CHORD)).map((p) => heightOf(p, plan));
  const ends = Math.min(points[0] ?? 0, points.at(-1) ?? 0);
  return points.some((height) => height < ends - STEP);
}

/** Whether a cycle may take the work of an operation: an insert that of a blade, and the reverse, in a valley only. */
const suits = (cycle: Cycle, { cycle: own, operation }: TurningUnit): boolean => {
  const [to, from] = [FAMILY[cycle.group], FAMILY[own.group]];
  return to === from || (to !== null && from !== null && own.contour === "free" && isValley(operation));
};

/** A valley goes to a tool of the cycle's own family: inserts turn, blades groove. */
const isOfFamily = (tool: Tool, { group }: Cycle, { cycle }: TurningUnit): boolean =>
  FAMILY[group] === FAMILY[cycle.group] || isBar(tool) === (FAMILY[group] === "grooving");

/** The cycles that could make the same contour; parallel passes only where the stock already has its shape. */
const others = (situation: ProgramSituation, of: TurningUnit): readonly Cycle[] =>
  cuttingCycles.filter(
    (each) =>
      each.number !== of.cycle.number &&
      suits(each, of) &&
      each.contour === of.cycle.contour &&
      (useOf(each).preTurned !== true || cutsAir(situation, of)),
  );

/** The thickness of the stock above the contour, mm, rounded up as it is typed. */
function allowanceOf(situation: ProgramSituation, of: TurningUnit): number {
  const { contour } = of.operation.plan;
  const chords = contour.flatMap((segment) => part.flattened(segment, CHORD));
  const from = (p: Pt) => Math.min(...chords.map((q, i) => (i === 0 ? Infinity : fromLine(p, chords[i - 1] ?? q, q))));
  const points = stockBefore(situation, of).inArea.flat();
  return roundedUpTo(
    STEP,
    points.reduce((most, p) => Math.max(most, from(p)), 0),
  );
}

/** The distance of a point from a straight line between two points. */
function fromLine(p: Pt, a: Pt, b: Pt): number {
  const [z, r] = [b.z - a.z, b.r - a.r];
  const long = z * z + r * r;
  const share = long > 0 ? Math.min(1, Math.max(0, ((p.z - a.z) * z + (p.r - a.r) * r) / long)) : 0;
  return Math.hypot(p.z - a.z - share * z, p.r - a.r - share * r);
}

/** Residual material of an operation, mm². */
const leftBy = ({ simulation: { proof } }: ProgramSituation, { index }: TurningUnit): number =>
  proof.residual.reduce((sum, each) => (each.operation === index && !each.isAsked ? sum + each.area : sum), 0);

/** Roughing behind an operation in its area, which another cycle may leave nothing to. */
function restOf({ units }: ProgramSituation, of: TurningUnit): readonly TurningUnit[] {
  const box = boxAround([of.operation.plan.area]);
  return units.filter(({ unit, work, operation }) => {
    if (unit <= of.unit || work === "finish" || operation.plan.area.length === 0) return false;
    const own = boxAround([operation.plan.area]);
    return own.left >= box.left - STEP && own.right <= box.right + STEP && own.low >= box.low - STEP;
  });
}

/** Another cycle for the same contour, with the tools that do it fastest. */
export function otherCycle(situation: ProgramSituation): readonly Change[] {
  const { program, run, tools, uses } = situation;
  const labels = ncLabels(situation.ncLanguage);
  const used = new Set(uses.tools);
  const inches = run.program.unit === "inch";
  const usable = tools
    .filter((tool) => checkTool(tool).length === 0)
    .toSorted((a, b) => Number(used.has(b.T)) - Number(used.has(a.T)));

  const statementOf = (cycle: Cycle, of: TurningUnit, values: Numbers) => ({
    ...of.statement,
    cycle: cycle.number,
    name: labels.cycleName(cycle.number),
    parameters: Object.entries<Param>(cycle.params).map(([q, param]): CycleParameter => {
      const written = of.statement.parameters.find((p) => p.q === q);
      const own = of.cycle.params[q];
      const value = values[q] ?? param.example;
      const keeps = written && own?.shown === param.shown && own.kind === param.kind && isCalled(of, q, value);
      return {
        q,
        value: keeps ? written.value : typeof value === "number" ? valueInProgram(param, value, inches) : value,
        label: labels.label(param.text),
      };
    }),
  });

  const longest = situation.units
    .toSorted((a, b) => b.operation.seconds - a.operation.seconds)
    .slice(0, MOST.operations);
  return longest.flatMap((of): readonly Change[] => {
    const { operation, call, unit, definition } = of;
    if (of.cycle.group === "thread" || of.cycle.contour === "none" || of.work === "finish") return [];
    const { feedUnit, plan, seconds } = operation;
    const rest = restOf(situation, of);
    const ofRest = rest.reduce((sum, each) => sum + each.operation.seconds, 0);
    const ofResidual = WORTH.residual * leftBy(situation, of);
    const turns = feedTurns(plan, call.start);
    let known: number | null = null;
    const allowance = () => (known ??= allowanceOf(situation, of));
    const makesSame = (cycle: Cycle, values: Values<Params>): boolean => {
      const { contour } = cycle.outline(values, call.given);
      return isSameContour(contour, plan.contour) || isSameContour(reversed(contour), plan.contour);
    };
    return others(situation, of).flatMap((cycle) => {
      const planned = usable
        .filter((tool) => isUsualTool(cycle.group, tool) && isOfFamily(tool, cycle, of))
        .slice(0, MOST.planned)
        .flatMap((tool) =>
          inBothDirections(cycle, valuesFor(cycle, of, tool, situation, allowance)).map((values) => ({ tool, values })),
        )
        .flatMap(({ tool, values }) => {
          const read = values as Values<Params>;
          if (!makesSame(cycle, read)) return [];
          const setting = { tool, start: call.start, feedUnit, autoFeed: call.autoFeed, stock: null };
          const made = cycle.plan(read, setting, call.given);
          if (!fitOf(tool, made).makesContour || turns <= 0) return [];
          return [{ tool, values, saved: seconds * (1 - feedTurns(made, call.start) / turns) }];
        })
        .filter(({ saved }) => saved + ofRest + ofResidual > 0)
        .toSorted((a, b) => b.saved - a.saved)
        .slice(0, MOST.tried);
      return planned.flatMap(({ tool, values, saved }): readonly Change[] => {
        const edit = (given: Numbers) => {
          const swapped = withBlock(program, definition, statementOf(cycle, of, given));
          if (tool.T === operation.tool.T) return swapped;
          const made = retooledOperation(swapped, unit, tool.T);
          // A blade takes less speed than an insert.
          const slower = isBar(tool) && !isBar(operation.tool);
          return slower && !isRefused(made) ? withSpeedShare(made, unit, SPEED_SHARE.recess) : made;
        };
        const subject: ChangeSubject = {
          kind: "otherCycle",
          units: [unit],
          cycle: cycle.number,
          tool: tool.T,
          instead: operation.tool.T,
        };
        const alone = saved + ofResidual > 0 ? [changeOf(subject, saved + ofResidual, () => edit(values))] : [];
        if (rest.length === 0) return alone;
        // What the rest finished is finished now. From the last one: the others keep their places.
        const work = qOf(cycle, "operation");
        const whole = work !== null && rest.some((each) => each.work === "both") ? { ...values, [work]: BOTH } : values;
        const withoutRest = () =>
          rest.reduceRight((made: ReturnType<Change["edit"]>, each) => {
            return made === null || isRefused(made) ? made : withoutOperation(made, each.unit);
          }, edit(whole));
        const gone = rest.map((each) => each.unit);
        const both: ChangeSubject = {
          kind: "both",
          units: [unit, ...gone],
          parts: [subject, { kind: "noCut", units: gone }],
        };
        return [...alone, changeOf(both, saved + ofRest, withoutRest)];
      });
    });
  });
}
