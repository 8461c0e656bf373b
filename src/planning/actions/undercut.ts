import { catalogue } from "../../cycles/index.ts";
import { noseRadius, tipDirection } from "../../kernel/cutter/insert.ts";
import { boxOf } from "../../kernel/area/box.ts";
import { part, type Segment } from "../../kernel/geometry/point.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { radius, rounded, roundedUp, toDiameter } from "../../kernel/units.ts";
import { compensatedCut } from "../../program/edits/undercut-operation.ts";
import { exampleJob } from "../../program/job/job.ts";
import { cylinderAround } from "../../program/job/requested-shape.ts";
import { positionAsTyped } from "../../program/values/typed-value.ts";
import { withCuttingValues } from "../values/cycle-values.ts";
import type { Action, ActionSource, Chain } from "../types.ts";
import { notDone, toolsOf } from "./candidates.ts";
import { finestOf } from "./finest.ts";
import { highest, outsideWork } from "./outside-work.ts";
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

/** Undercuts that finishing did not take, along their contour with tip radius compensation. */
export const undercut: ActionSource = {
  kind: "undercut",
  actions(state, request) {
    const { stock } = state;
    const { chain, pieces, rough } = outsideWork(state, request);
    const [cycle] = catalogue;
    const touches = ({ first, last }: UndercutSection) => pieces.some(({ borders: [a, b] }) => a <= last && b >= first);
    if (!cycle || rough.some(({ opensAhead }) => opensAhead)) return [];
    const actions = undercutsOf(chain)
      .filter(touches)
      .flatMap(({ name, section }) => {
        const { segments } = section;
        const box = boxOf(part.flattenedChain(segments, CHORD));
        const radii = segments.flatMap((s) => (s.kind === "arc" ? [part.radiusOf(s)] : []));
        const finest = finestOf(section);
        const largest = toDiameter(radius(box.high));
        const tools = toolsOf(request).filter(
          (tool) =>
            (tool.TYPE === "FINISH" || tool.TYPE === "ROUGH") &&
            tipDirection(tool.TO).v < 0 &&
            noseRadius(tool) < Math.min(...radii) - SAME,
        );
        return tools
          .toSorted((a, b) => typesFirst("FINISH", "ROUGH")(a, b) || noseRadius(b) - noseRadius(a))
          .slice(0, MOST)
          .map((tool): Action => {
            const main = valuesOf(
              tool,
              {
                operation: "finish",
                work: "finish",
                smallest: toDiameter(radius(box.low)),
                largest,
                stock,
                ...(finest !== undefined && { roughness: finest }),
              },
              request,
            );
            const z = box.right + CLEARANCE;
            const start = {
              x: positionAsTyped(roundedUp(toDiameter(radius(highest(stock, box.left, z + CLEARANCE) + CLEARANCE)))),
              z: positionAsTyped(rounded(z)),
            };
            const base = { ...exampleJob(cycle), tool: tool.T, start, blank: cylinderAround(stock) };
            const { job, values } = withCuttingValues(base, { params: {} }, { main });
            return {
              kind: "undercut",
              key: ["undercut", `T${tool.T}`, box.right.toFixed(2), box.left.toFixed(2)].join(" "),
              site: "outside",
              tool,
              cycle: null,
              job,
              cut: compensatedCut({ segments, start, name, feed: main.feed.value }),
              place: { front: box.right, rear: box.left, high: box.high, low: box.low },
              threads: [],
              values,
            };
          });
      });
    return notDone(actions, state);
  },
};
