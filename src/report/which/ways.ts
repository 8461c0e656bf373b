import type { Cycle, Group } from "../../cycles/define.ts";
import { catalogue } from "../../cycles/index.ts";
import type { Topic } from "../../cycles/params.ts";
import { useOf, worksAcross } from "../../cycles/use.ts";
import {
  canCutThread,
  canMakeAngle,
  canMakeChamfer,
  chamferOf,
  type ShapeRequest,
} from "../../cycles/shape-request.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { cuttingWidth, isBar, noseRadius } from "../../kernel/cutter/insert.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import type { SetJob } from "../../program/job/job.ts";
import { readDraft } from "../../program/job/read-draft.ts";
import { requestedBox } from "../../program/job/requested-shape.ts";
import { jobFor, tipAtCall, withValue } from "../../program/job/requested-job.ts";
import { hasAngleOf } from "../../program/tools/thread-tool.ts";
import { isUsualTool, rankTools } from "../../program/tools/which-tool.ts";

/** One option to make the wanted shape: a cycle with its values, and a tool. */
export interface Proposal {
  readonly id: string;
  readonly job: SetJob;
  readonly tool: Tool;
  /** The value in which it differs from another option with the same cycle. */
  readonly choice: { readonly q: string; readonly value: number } | null;
  /** Its tool suits the depth: a finishing insert does not rough. */
  readonly suitsDepth: boolean;
}

/** Most options to compare; more would be confusing. */
const MOST = 8;
/** Most cycles among them. */
const MOST_CYCLES = 4;

/** Choices of a cycle that change its path over the same contour. */
const COMPARED: ReadonlySet<Topic> = new Set<Topic>(["smoothing", "direction", "cuttingLines", "comb", "infeedType"]);

/** The order in which kinds of cycles are proposed. */
const ORDER: Readonly<Record<ShapeRequest["site"], readonly Group[]>> = {
  outside: ["longitudinal", "recessTurning", "recessing", "transverse", "thread"],
  inside: ["longitudinal", "recessTurning", "recessing", "transverse", "thread"],
  face: ["transverse", "recessTurning", "recessing", "longitudinal", "thread"],
};

/** Whether a cycle works from an open side of the shape. A step has two. */
function isOpenTo(cycle: Cycle, { site, shape }: ShapeRequest): boolean {
  if (shape === "thread") return site !== "face" || cycle.params["Q461"] !== undefined;
  const recess = cycle.group === "recessTurning" || cycle.group === "recessing";
  const either = !recess && (shape === "step" || shape === "free");
  return either || worksAcross(cycle) === (site === "face");
}

/** Cycles that make the wanted shape, the simplest of each kind, the likeliest first. */
export function cyclesFor(wanted: ShapeRequest): readonly Cycle[] {
  const able = catalogue.filter(
    (c) =>
      useOf(c).shapes.includes(wanted.shape) &&
      isOpenTo(c, wanted) &&
      canCutThread(c, wanted) &&
      canMakeAngle(c, wanted) &&
      canMakeChamfer(c, wanted) &&
      // The starting element of a transverse cycle is at the other edge.
      (chamferOf(wanted) === 0 || c.contour === "free" || !worksAcross(c)) &&
      // Contour-parallel passes are for a part that already has the shape.
      (wanted.allowance > 0 || useOf(c).preTurned !== true),
  );
  const kind = (c: Cycle) => `${c.group} ${c.contour} ${useOf(c).preTurned === true}`;
  const simplest = able.filter((c, i) => able.findIndex((other) => kind(other) === kind(c)) === i);
  const follows = (c: Cycle) => Number(wanted.allowance > 0 && useOf(c).preTurned === true);
  const place = (c: Cycle) => ORDER[wanted.site].indexOf(c.group);
  return simplest.toSorted((a, b) => follows(b) - follows(a) || place(a) - place(b)).slice(0, MOST_CYCLES);
}

/** Deepest cut that a finishing insert takes, mm per side. */
const FINISHING_DEPTH = 1;

/** Material above the shape, mm: its allowance, or the depth of its box. */
const depthOf = (wanted: ShapeRequest, across: boolean): number => {
  const { r1, r2, z1, z2 } = requestedBox(wanted);
  return wanted.allowance || Math.abs(across ? z1 - z2 : r1 - r2);
};

/** A finishing insert does not remove much material. */
const suits = (cycle: Cycle, wanted: ShapeRequest, { TYPE }: Tool): boolean =>
  TYPE !== "FINISH" || cycle.group === "thread" || depthOf(wanted, worksAcross(cycle)) <= FINISHING_DEPTH;

/** The size of an insert that determines its residual material. */
const sizeOf = (tool: Tool) => (isBar(tool) ? cuttingWidth(tool) : noseRadius(tool));

/**
 * The tool that fits the job best, and the next one with an insert of another size. Where none fits, the usual kind
 * shows the reason.
 */
function toolsFor(cycle: Cycle, job: SetJob, wanted: ShapeRequest, tools: readonly Tool[]): readonly Tool[] {
  const { values } = readDraft(cycle, job.drafts[job.cycle] ?? {});
  const start = tipAtCall(job);
  if (!values) return [];
  const given = { contour: cycle.contour === "free" ? readRows(job.contour).contour.segments : null, start };
  const setting = { start, feedUnit: "mm/rev", autoFeed: null, stock: null } as const;
  const { thread } = wanted;
  const angled = thread ? tools.filter((tool) => hasAngleOf(thread, tool)) : [];
  const fits = rankTools(cycle, values, given, setting, angled.length > 0 ? angled : tools);
  const stands = (tool: Tool) =>
    !cycle.plan(values, { ...setting, tool }, given).issues.some((i) => i.code === "toolUnfit");
  const usual = fits
    .filter(({ tool }) => isUsualTool(cycle.group, tool))
    .toSorted((a, b) => sizeOf(a.tool) - sizeOf(b.tool));
  // Among the usual inserts that rough, the largest nose radius is the strongest.
  const turns = cycle.group === "longitudinal" || cycle.group === "transverse";
  const able = fits.filter((f) => f.makesContour && suits(cycle, wanted, f.tool));
  const strong = able
    .filter(({ tool }) => turns && tool.TYPE === able[0]?.tool.TYPE)
    .toSorted((a, b) => noseRadius(b.tool) - noseRadius(a.tool))[0];
  const first = strong ?? able[0] ?? fits[0];
  const best = first?.makesContour ? first : (usual.find(({ tool }) => stands(tool)) ?? fits[0]);
  if (!best) return [];
  const other = fits.find((f) => f.makesContour && f.cuts && sizeOf(f.tool) !== sizeOf(best.tool));
  return other && best.makesContour ? [best.tool, other.tool] : [best.tool];
}

/** The choices of a cycle that are compared, each with another value than that of its example. */
const choicesOf = (cycle: Cycle) =>
  Object.entries(cycle.params).flatMap(([q, { shown, choices, example }]) => {
    const value = COMPARED.has(shown) ? choices?.find((c) => c !== example) : undefined;
    return value === undefined ? [] : [{ q, value, plain: example }];
  });

/**
 * The options to compare, without duplicates, at most eight: each cycle with the tool that fits best; then, from the
 * likeliest cycle on, its other choices and another tool.
 */
export function waysFor(
  wanted: ShapeRequest,
  stock: readonly Ring[] | null,
  tools: readonly Tool[],
): readonly Proposal[] {
  const made = cyclesFor(wanted).map((cycle) => {
    const job = jobFor(cycle, wanted, stock);
    return { cycle, job, tools: toolsFor(cycle, job, wanted, tools) };
  });
  const one = (cycle: Cycle, job: SetJob, tool: Tool, choice: Proposal["choice"]): Proposal => ({
    id: `${job.cycle} ${tool.T} ${choice ? `${choice.q}=${choice.value}` : ""}`,
    job: { ...(choice ? withValue(job, choice.q, choice.value) : job), tool: tool.T },
    tool,
    choice,
    suitsDepth: suits(cycle, wanted, tool),
  });
  const first = made.flatMap(({ cycle, job, tools: [best] }) => {
    const [choice] = choicesOf(cycle);
    return best ? [one(cycle, job, best, choice ? { q: choice.q, value: choice.plain } : null)] : [];
  });
  const more = made.flatMap(({ cycle, job, tools: [best, other] }) => {
    const choices = choicesOf(cycle);
    const [plain] = choices;
    return [
      ...(best ? choices.map(({ q, value }) => one(cycle, job, best, { q, value })) : []),
      ...(other ? [one(cycle, job, other, plain ? { q: plain.q, value: plain.plain } : null)] : []),
    ];
  });
  return [...first, ...more].slice(0, MOST);
}
