import { catalogue } from "../../cycles/index.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { noseRadius } from "../../kernel/cutter/insert.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { radius, radiusOf, rounded, roundedDown, roundedUp, toDiameter } from "../../kernel/units.ts";
import { compensatedCut } from "../../program/edits/undercut-operation.ts";
import { exampleJob } from "../../program/job/job.ts";
import { cylinderAround } from "../../program/job/requested-shape.ts";
import { positionAsTyped } from "../../program/values/typed-value.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { borderOf, type OpenRegion } from "../open-regions.ts";
import type { Action, ActionSource, Chain, PlanRequest, PlanState } from "../types.ts";
import { withCuttingValues } from "../values/cycle-values.ts";
import { barsOf, heldBar, startFor } from "./bars.ts";
import { clearRadius, insideRegions, thickRegions } from "./bore.ts";
import { notDone, outsideTools } from "./candidates.ts";
import { finestOf } from "./finest.ts";
import { highest, outsideWork } from "./outside-work.ts";
import { THICK } from "./rough-inside.ts";
import { typesFirst } from "./turned-contour.ts";
import { valuesOf } from "./values-of-job.ts";

/** Cylinder in front of an undercut and face above it that are cut with it, mm; clearance of the start point. */
const [BESIDE, CLEARANCE] = [1, 2];
/** Tools of each undercut. */
const MOST = 3;

/** An undercut of the chain with a piece of its cylinder and of its face. */
interface UndercutSection {
  readonly name: string;
  readonly first: number;
  readonly last: number;
  readonly section: Chain;
}

/** The last `by` mm of a line before its end, or the first behind its begin. */
function endOf(s: Segment | undefined, keep: "from" | "to", by: number): readonly Segment[] {
  if (s?.kind !== "line") return [];
  const far = keep === "to" ? s.from : s.to;
  const near = part.beyond(s[keep], part.unit(part.difference(far, s[keep])), Math.min(by, part.lengthOf(s)));
  return [keep === "to" ? part.line(near, s.to) : part.line(s.from, near)];
}

function undercutsOf({ segments, marks }: Chain): readonly UndercutSection[] {
  const found: UndercutSection[] = [];
  for (let first = 0; first < segments.length; first += 1) {
    const name = marks[first]?.undercut;
    if (name === undefined) continue;
    let last = first;
    while (marks[last + 1]?.undercut === name && marks[last + 1]?.row === marks[first]?.row) last += 1;
    const before = endOf(segments[first - 1], "to", BESIDE);
    const behind = endOf(segments[last + 1], "from", BESIDE);
    found.push({
      name,
      first,
      last,
      section: {
        segments: [...before, ...segments.slice(first, last + 1), ...behind],
        marks: marks.slice(first, last + 1),
      },
    });
    first = last;
  }
  return found;
}

/** Where an undercut is cut from, and what may cut it, the best first. */
interface UndercutWay {
  readonly start: Pt;
  readonly tools: readonly Tool[];
}

const best = (tools: readonly Tool[]) =>
  tools.toSorted((a, b) => typesFirst("FINISH", "ROUGH")(a, b) || noseRadius(b) - noseRadius(a));

/** Tools that turn along a contour and whose nose is smaller than its least arc. */
function turningTools({ segments }: Chain, tools: readonly Tool[]): readonly Tool[] {
  const least = Math.min(...segments.flatMap((s) => (s.kind === "arc" ? [part.radiusOf(s)] : [])));
  return tools.filter((tool) => (tool.TYPE === "FINISH" || tool.TYPE === "ROUGH") && noseRadius(tool) < least - SAME);
}

function wayOutside({ section }: UndercutSection, stock: readonly Ring[], request: PlanRequest): UndercutWay {
  const { left, right } = boxOf(part.flattenedChain(section.segments, CHORD));
  const z = right + CLEARANCE;
  return {
    start: at(z, highest(stock, left, z + CLEARANCE) + CLEARANCE),
    tools: best(turningTools(section, outsideTools(request))).slice(0, MOST),
  };
}

/** In a bore: of the bars that enter, the first of each shape, the operator's own and the usual ones that the table lacks. */
function wayInside({ section }: UndercutSection, stock: readonly Ring[], request: PlanRequest): UndercutWay {
  const { right, low } = boxOf(part.flattenedChain(section.segments, CHORD));
  const front = frontOf(stock);
  const clear = clearRadius(stock, right, front);
  const r = Math.max(0, low - CLEARANCE);
  const shapeOf = (tool: Tool) =>
    [tool["T-ANGLE"], tool["P-ANGLE"], request.usualTools?.includes(tool.T) ?? false].join();
  const bars = best(
    turningTools(
      section,
      barsOf(request, (tool) => startFor(tool, { z: front, clear, low: r }) === r),
    ),
  );
  return {
    start: at(front + CLEARANCE, r),
    tools: bars.filter((tool, i) => bars.findIndex((other) => shapeOf(other) === shapeOf(tool)) === i),
  };
}

function actionsFor(
  { name, section }: UndercutSection,
  site: "outside" | "inside",
  { stock }: PlanState,
  { start: from, tools }: UndercutWay,
  request: PlanRequest,
): readonly Action[] {
  const [cycle] = catalogue;
  const { segments } = section;
  const box = boxOf(part.flattenedChain(segments, CHORD));
  const finest = finestOf(section);
  return tools.flatMap((tool): readonly Action[] => {
    if (!cycle) return [];
    const main = valuesOf(
      tool,
      {
        operation: "finish",
        work: "finish",
        smallest: toDiameter(radius(box.low)),
        largest: toDiameter(radius(box.high)),
        stock,
        ...(finest !== undefined && { roughness: finest }),
        ...(site === "inside" && { bar: heldBar(tool, from.z - box.left) }),
      },
      request,
    );
    const x = toDiameter(radius(from.r));
    const start = {
      x: positionAsTyped(site === "inside" ? roundedDown(x) : roundedUp(x)),
      z: positionAsTyped(rounded(from.z)),
    };
    const base = { ...exampleJob(cycle), tool: tool.T, start, blank: cylinderAround(stock) };
    const { job, values } = withCuttingValues(base, { params: {} }, { main });
    return [
      {
        kind: "undercut",
        key: [
          "undercut",
          ...(site === "inside" ? [site] : []),
          `T${tool.T}`,
          box.right.toFixed(2),
          box.left.toFixed(2),
        ].join(" "),
        site,
        tool,
        cycle: null,
        job,
        cut: compensatedCut({ segments, start, name, feed: main.feed.value }),
        place: { front: box.right, rear: box.left, high: box.high, low: box.low },
        threads: [],
        values,
      },
    ];
  });
}

type Borders = readonly [first: number, last: number] | null;
const touchedBy =
  (borders: readonly Borders[]) =>
  ({ first, last }: UndercutSection): boolean =>
    borders.some((each) => each !== null && each[0] <= last && each[1] >= first);

function undercutsOutside(state: PlanState, request: PlanRequest): readonly Action[] {
  const { chain, pieces, rough } = outsideWork(state, request);
  if (rough.some(({ opensAhead }) => opensAhead)) return [];
  return undercutsOf(chain)
    .filter(touchedBy(pieces.map(({ borders }) => borders)))
    .flatMap((each) => actionsFor(each, "outside", state, wayOutside(each, state.stock, request), request));
}

/** Undercuts in a bore that is roughed up to them. */
function undercutsInside(state: PlanState, request: PlanRequest): readonly Action[] {
  const { inside } = request.part;
  const all = undercutsOf(inside);
  if (all.length === 0) return [];
  const bordered = (regions: readonly OpenRegion[]) => touchedBy(regions.map((region) => borderOf(inside, region)));
  const isRough = bordered(thickRegions(state.stock, request, THICK * radiusOf(request.rules.allowance.diameter)));
  return all
    .filter(bordered(insideRegions(state.stock, request.part)))
    .filter((each) => !isRough(each))
    .flatMap((each) => actionsFor(each, "inside", state, wayInside(each, state.stock, request), request));
}

/** Undercuts that finishing did not take, along their contour with tip radius compensation. */
export const undercut: ActionSource = {
  kind: "undercut",
  actions: (state, request) =>
    notDone([...undercutsOutside(state, request), ...undercutsInside(state, request)], state),
};
