import { cycleByNumber } from "../../cycles/index.ts";
import { estimateWork, type PartialInput, type EstimatedWork } from "../values/estimated-work.ts";
import type { Cycle, Given } from "../../cycles/define.ts";
import type { Params, Values } from "../../cycles/params.ts";
import { beginsAtTip } from "../../cycles/shape-request.ts";
import { at, type Pt } from "../../kernel/geometry/point.ts";
import { METRIC } from "../../kernel/contour/metric-thread.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { diameter, radius, rounded, toDiameter, toRadius } from "../../kernel/units.ts";
import { checkTool } from "../tools/check-tool.ts";
import { readRows } from "./contour-rows.ts";
import { readText, type Field } from "../values/field.ts";
import { knownParameters } from "./job-parameters.ts";
import type { BlankDraft, Job, SetJob } from "./job.ts";
import { SETUP_PLACES, type SetupPlace } from "./setup-places.ts";
import { readDraft } from "./read-draft.ts";
import { SETUP_FIELDS as FIELDS } from "./setup-fields.ts";
import { typedAt, withPlace } from "./setup-place.ts";
import { positionAsTyped } from "../values/typed-value.ts";
import { fitOf, isUsualTool, usualFirst } from "../tools/which-tool.ts";

/** Set-up of a job: set values, the rest proposed. */
export interface Setup {
  readonly tool: number;
  readonly blank: BlankDraft;
  readonly start: { readonly x: string; readonly z: string };
  /** Fields that are not set. */
  readonly proposed: ReadonlySet<SetupPlace>;
  /** Estimate from the typed values; null for an unknown cycle. */
  readonly work: EstimatedWork | null;
  /** Proposal for blank and start if unset, the other fields as they are. */
  readonly proposal: Pick<SetJob, "blank" | "start">;
}

/**
 * Material around a shape, mm: beside a bore or a groove in a face, on a turned cylinder, and behind it for the chuck.
 */
const ROUND_IT = 10;
const ON_CYLINDER = 2;
const BEHIND = 30;
/** Clearance of the tip at the call, mm; for a cut that begins at the tip; for a thread. */
const CLEARANCE = 2;
const AT_TIP = 1;
const RUN_UP = 5;
/** Longest contour, in elements, that is planned to find a tool. */
const MOST_ELEMENTS = 60;
/** Most tools that are tried; then the first usual one is taken. */
const MOST_TRIED = 8;
/** Finishing only: one pass along the contour is enough to test a tool. */
const FINISHING = 2;

const isGroove = ({ group }: Cycle) => group === "recessTurning" || group === "recessing";
const text = (r: number) => positionAsTyped(toDiameter(radius(r)));
const half = (d: number | null) => (d === null ? null : toRadius(diameter(d)));

/** Blank for a part: covers the contour, is clamped behind it, and its face is at the start of the values. */
function blankOf(
  { box, from, to, across, inside, shape, pitch, ringed }: EstimatedWork,
  isGroove: boolean,
): BlankDraft {
  const core = shape === "thread" ? from.r - METRIC.inside * pitch : box.low;
  const beside = inside || (across && isGroove);
  const outside = beside
    ? Math.ceil(rounded(toDiameter(radius(box.high + ROUND_IT))))
    : toDiameter(radius(box.high + (ringed ? ON_CYLINDER : 0)));
  // Away from the chuck nothing is cut without stated material: the usual end counts there.
  const away = shape !== "free" && to.z > from.z;
  const begins = across || shape === "step" ? (away ? from.z : box.right) : Math.max(away ? from.z : box.right, 0);
  const back = away ? from.z - (to.z - from.z) : box.left;
  return {
    outside: positionAsTyped(outside),
    bore: inside && core > 0 ? text(core) : "0",
    length: positionAsTyped(Math.ceil(rounded(begins - back + BEHIND))),
    allowance: positionAsTyped(begins),
  };
}

/** The clamped cylinder, mm. */
interface Cylinder {
  readonly outside: number;
  readonly bore: number;
  readonly front: number;
}

/** Tip at the call: clear of blank and contour, on the working side of the cycle. */
function startOf(cycle: Cycle, { box, from, to, across, inside, shape }: EstimatedWork, blank: Cylinder): Pt {
  const [out, along] = [inside ? -1 : 1, from.z < to.z && (shape !== "free" || !across) ? -1 : 1];
  const clear = beginsAtTip(cycle) ? AT_TIP : CLEARANCE;
  const beside = (by: number) =>
    inside ? Math.max(0, Math.min(from.r, blank.bore) - by) : Math.max(from.r, blank.outside) + by;
  const before = (z: number, by: number) => (along > 0 ? Math.max(z, blank.front) + by : z - by);
  if (shape === "thread") return at(from.z + along * RUN_UP, beside(RUN_UP));
  if (isGroove(cycle)) return across ? at(before(box.right, clear), from.r) : at(from.z, beside(clear));
  if (cycle.contour === "free") {
    const side = inside ? Math.min(box.low, blank.bore) : Math.max(box.high, blank.outside);
    const falls = (side - from.r) * out <= 0 && !across;
    return at(before(along > 0 ? box.right : box.left, CLEARANCE), Math.max(0, falls ? side + out * CLEARANCE : side));
  }
  if (across) return at(Math.max(from.z, blank.front), beside(CLEARANCE));
  return at(before(from.z, CLEARANCE), beside(shape === "plunge" ? CLEARANCE : 0));
}

/**
 * Tool of the table that a turner would use: of the usual kind, oriented towards the work, able to machine the contour.
 * The preferred one is tried first.
 */
function toolOf(
  cycle: Cycle,
  work: EstimatedWork,
  given: Given,
  tools: readonly Tool[],
  preferred: number = cycle.setup.tool,
): number {
  const operation = Object.entries(cycle.params).find(([, p]) => p.text === "operation")?.[0];
  const values = { ...work.values, ...(operation === undefined ? {} : { [operation]: FINISHING }) } as Values<Params>;
  const rank = (tool: Tool) => Number(tool.T !== preferred);
  const usual = usualFirst(
    cycle.group,
    tools.filter((tool) => isUsualTool(cycle.group, tool) && checkTool(tool).length === 0),
  ).toSorted((a, b) => rank(a) - rank(b));
  const short = (given.contour?.length ?? 0) <= MOST_ELEMENTS;
  const start = given.start ?? work.from;
  const tried =
    short && (cycle.contour === "own" || given.contour)
      ? usual.map((tool) => ({
          tool,
          fit: () =>
            fitOf(tool, cycle.plan(values, { tool, start, feedUnit: "mm/rev", autoFeed: null, stock: null }, given)),
        }))
      : [];
  let cuts: number | null = null;
  for (const { tool, fit } of tried.slice(0, MOST_TRIED)) {
    const found = fit();
    if (found.makesContour) return tool.T;
    if (found.cuts) cuts ??= tool.T;
  }
  return cuts ?? usual[0]?.T ?? preferred;
}

/**
 * Set-up of a job: set fields as they are, empty ones proposed from the values typed so far. `preferred`: the tool that
 * is tried first, by default that of the printed example.
 */
export function setupOf(job: Job, tools: readonly Tool[], preferred?: number): Setup {
  const cycle = cycleByNumber(job.cycle);
  const known = knownParameters(job);
  const read = (field: Field, typed: string) => readText(field, typed, known).value;
  const set = { ...job.blank, ...job.start };
  const isSet = (typed: string) => typed.trim() !== "";
  const proposed = new Set(SETUP_PLACES.filter((place) => !isSet(typedAt(job, place))));
  if (!cycle)
    return {
      tool: job.tool ?? 0,
      blank: job.blank,
      start: job.start,
      proposed,
      work: null,
      proposal: { blank: job.blank, start: job.start },
    };
  const rows = cycle.contour === "free" ? readRows(job.contour).contour.segments : [];
  const contour = rows.length > 0 ? rows : null;
  const given: PartialInput = {
    typed: readDraft(cycle, job.drafts[job.cycle] ?? {}, known).partial,
    contour,
    tip: { z: read(FIELDS.startZ, set.z), r: half(read(FIELDS.startX, set.x)) },
    blank: {
      outside: half(read(FIELDS.outside, set.outside)),
      bore: half(read(FIELDS.bore, set.bore)),
      front: read(FIELDS.allowance, set.allowance),
    },
  };
  const work = estimateWork(cycle, given);
  const made = blankOf(work, isGroove(cycle));
  const or = (typed: string, otherwise: string) => (isSet(typed) ? typed : otherwise);
  const blank: BlankDraft = {
    outside: or(set.outside, made.outside),
    bore: or(set.bore, made.bore),
    length: or(set.length, made.length),
    allowance: or(set.allowance, made.allowance),
  };
  const tip = startOf(cycle, work, {
    outside: half(read(FIELDS.outside, blank.outside)) ?? work.box.high,
    bore: half(read(FIELDS.bore, blank.bore)) ?? work.box.low,
    front: read(FIELDS.allowance, blank.allowance) ?? work.box.right,
  });
  const point = { x: text(tip.r), z: positionAsTyped(tip.z) };
  const start = { x: or(set.x, point.x), z: or(set.z, point.z) };
  const [x, z] = [half(read(FIELDS.startX, start.x)), read(FIELDS.startZ, start.z)];
  const tool =
    job.tool ?? toolOf(cycle, work, { contour, start: x === null || z === null ? null : at(z, x) }, tools, preferred);
  return { tool, blank, start, proposed, work, proposal: { blank: made, start: point } };
}

/** What would be proposed for one field if it were empty. A set tool that suits the contour stays the proposed one. */
export function proposalAt(job: Job, place: SetupPlace, tools: readonly Tool[]): string {
  const without = withPlace(job, place, "");
  // Only the proposal for a tool tries tools.
  const asked = place === "tool" ? without : { ...without, tool: job.tool ?? 0 };
  return typedAt(setupOf(asked, tools, job.tool ?? undefined), place);
}

const isSame = (a: string, b: string) => a === b || Number(a) === Number(b);

/**
 * Another value that is proposed for a set field: the proposal has changed since it was set. Null if there is none. A
 * tool is compared with the contour, whenever it was set.
 */
export function otherProposal(job: Job, place: SetupPlace, tools: readonly Tool[]): string | null {
  const [typed, then] = [typedAt(job, place), job.proposals?.[place]];
  if (typed.trim() === "" || (place !== "tool" && then === undefined)) return null;
  const now = proposalAt(job, place, tools);
  return isSame(now, typed) || (place !== "tool" && isSame(now, then ?? "")) ? null : now;
}

/** The job as printed, drawn and run: with a complete set-up. */
export const withSetup = (job: Job, { tool, blank, start }: Pick<Setup, "tool" | "blank" | "start">): SetJob => ({
  ...job,
  tool,
  blank,
  start,
});
