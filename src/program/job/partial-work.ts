import type { Cycle, Given } from "../../cycles/define.ts";
import { knownOutline, type KnownOutline } from "../../cycles/known-outline.ts";
import type { Pt, Ring } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { axial, diameter, radius, toRadius } from "../../kernel/units.ts";
import { cylinder } from "../state/blank-form.ts";
import { readRows } from "./contour-rows.ts";
import { readText } from "../values/field.ts";
import { knownParameters } from "./job-parameters.ts";
import type { Job } from "./job.ts";
import type { DraftReading } from "./read-draft.ts";
import { SETUP_FIELDS } from "./setup-fields.ts";

/** Drawable data of a job before it has a path. */
export interface PartialWork {
  readonly blank: readonly Ring[];
  readonly start: Pt | null;
  readonly tool: Tool | null;
  readonly outline: KnownOutline;
  /** Its known corners; of a programmed contour the ends of its elements. */
  readonly points: readonly Pt[];
}

/** Half section of the typed blank; empty while its dimensions are invalid. */
export function blankOf(job: Job): readonly Ring[] {
  const known = knownParameters(job);
  const typed = (field: "outside" | "bore" | "length" | "allowance") =>
    readText(SETUP_FIELDS[field], job.blank[field], known);
  const [outside, length] = [typed("outside").value, typed("length").value];
  const [bore, front] = [typed("bore").value ?? 0, typed("allowance").value ?? 0];
  if (outside === null || length === null) return [];
  return (
    cylinder({
      outside: toRadius(diameter(outside)),
      inside: bore > 0 ? toRadius(diameter(bore)) : radius(0),
      length,
      front,
    }) ?? []
  );
}

/** Known end points of the contour table. */
const endsOf = (job: Job) => readRows(job.contour).rows.flatMap(({ end }) => end ?? []);

/** Known data of a job: its set-up, and the part of its contour that the typed values determine. */
export function partialWork(
  cycle: Cycle,
  job: Job,
  { partial }: DraftReading,
  given: Given,
  tools: readonly Tool[],
): PartialWork {
  const outline = knownOutline(cycle, partial, given);
  return {
    blank: blankOf(job),
    start: given.start,
    tool: tools.find((tool) => tool.T === job.tool) ?? null,
    outline,
    points: (cycle.contour === "free" ? endsOf(job) : outline.corners).map(({ x, z }) => ({
      z: axial(z),
      r: toRadius(diameter(x)),
    })),
  };
}
