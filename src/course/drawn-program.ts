import { boxAround } from "../kernel/area/box.ts";
import { areaOf } from "../kernel/area/area.ts";
import { difference, intersection, offset, union } from "../kernel/area/clip.ts";
import { at, type Ring } from "../kernel/geometry/point.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import { diameter, toRadius } from "../kernel/units.ts";
import { machiningArea } from "../sim/finished.ts";
import { outlinesOf } from "../sim/outlines.ts";
import { regionsOf } from "../sim/region.ts";
import { sweptBy } from "../sim/sweep.ts";
import type { Answer } from "./judge/judgement.ts";
import { sizeOn } from "./judge/sizes.ts";
import { threadsOf, type ThreadDraft } from "./made/made-threads.ts";
import { contourSources } from "./made/contour-sources.ts";
import { outlineChains } from "./made/outline-text.ts";
import { traced } from "./made/traced.ts";
import { drawnThread, type DrawnTask, type DrawnThread } from "./drawn-task.ts";
import type { Task } from "./task.ts";

/** A piece that came off is the part if it has at least this share of all remaining material. */
const PIECE = 0.02;
/** Grooves are filled this much wider, mm, so that no chord slivers remain between them and the crest. */
const OVER = 4 * SLIVER;
/** A given size belongs to the part if it is this near, mm. */
const SAME_SIZE = 0.005;
/** Past every part, mm. */
const FAR = 10_000;

const ringOf = (left: number, right: number, low: number, high: number): Ring => [
  at(left, low),
  at(right, low),
  at(right, high),
  at(left, high),
];

/** The piece at the free end: a parted-off part is in front of the bar. */
function pieceOf(finished: readonly Ring[]): readonly Ring[] {
  const least = PIECE * areaOf(finished);
  const [first] = regionsOf(finished, least)
    .map((region) => ({ region, end: boxAround([region.outline]).right }))
    .sort((a, b) => b.end - a.end);
  return first ? [first.region.outline, ...first.region.holes] : [];
}

/**
 * The cuts of threads into surfaces that other operations made, up to the crest where that is known: a drawing does not
 * show grooves.
 */
function threadGrooves({ run, simulation }: Answer, threads: readonly ThreadDraft[]): readonly Ring[] {
  const isThread = (operation: number | null) =>
    operation !== null && run.operations[operation]?.plan.thread !== undefined;
  const cuts = simulation.steps.filter(({ operation, move }) => isThread(operation) && move.kind !== "rapid");
  if (cuts.length === 0) return [];
  const outlines = outlinesOf();
  const taken = offset(union(cuts.flatMap((step) => sweptBy(outlines(step.tool).insert, step).rings)), OVER);
  const left = difference(run.blank, machiningArea(run.operations.filter(({ plan }) => !plan.thread)));
  const over = threads.map(({ from, to, crest, root, pitch }) => {
    const [low, high] = [Math.min(from, to) - pitch - pitch, Math.max(from, to) + pitch + pitch],
      r = toRadius(diameter(crest));
    const far = root > crest ? 0 : FAR;
    return ringOf(low, high, Math.min(r, far), Math.max(r, far));
  });
  return difference(intersection(taken, left), over);
}

/** Threads without a single diameter, as on a cone, named by their pitch. */
function pitchesOf({ run }: Answer, threads: readonly ThreadDraft[]): readonly DrawnThread[] {
  const isNamed = (z: number) => threads.some(({ from, to }) => z < Math.max(from, to) && z > Math.min(from, to));
  return run.operations.flatMap(({ plan: { thread, contour } }): readonly DrawnThread[] => {
    const [from, to] = [contour[0]?.from, contour.at(-1)?.to];
    if (!thread || !from || !to || isNamed((from.z + to.z) / 2)) return [];
    return [{ from, to, ground: null, name: `P${Math.round(thread.pitch * 1000) / 1000}` }];
  });
}

/** Known facts of a part that its path does not show: sizes with deviations, and surface marks. */
export type KnownOfPart = Pick<Task, "sizes" | "rules">;

/**
 * The workshop drawing of a program: the part at the free end with the elements of its contours, threads by name and
 * crest. `finished`: the remaining material, nominal or actual. Null where nothing is turned.
 */
export function drawnProgram(
  answer: Answer,
  finished: readonly Ring[],
  known: KnownOfPart | null = null,
): DrawnTask | null {
  const { run } = answer,
    { blank } = run;
  const threads = threadsOf(answer);
  const filled = threadGrooves(answer, threads),
    whole = filled.length > 0 ? union([...finished, ...filled]) : finished;
  const rings = pieceOf(whole),
    chains = outlineChains(rings, blank);
  const sources = contourSources(answer);
  const [outside, bore] = [traced(chains.outside, sources), traced(chains.bore, sources)];
  const drawn = [...threads.map(drawnThread), ...pitchesOf(answer, threads)];
  if (outside.length === 0 && bore.length === 0 && drawn.length === 0) return null;
  return {
    blank,
    rings,
    solid: rings,
    outside,
    bore,
    issues: [],
    sizes: (known?.sizes ?? []).filter(
      ({ kind, at: place, nominal }) => Math.abs((sizeOn(rings, kind, place)?.value ?? Infinity) - nominal) < SAME_SIZE,
    ),
    threads: drawn,
    marks: known?.rules.rz ?? [],
  };
}
