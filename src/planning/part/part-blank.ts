import type { Clamping } from "../../kernel/area/clamping.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import { axial, diameter, length, radius, roundedUpTo, toDiameter, toRadius } from "../../kernel/units.ts";
import { clampingOf, readClamping } from "../../program/clamping/read-clamping.ts";
import { clampingText } from "../../program/clamping/words.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import { cylinder, rotation } from "../../program/state/blank-form.ts";
import { anyNumber, readText } from "../../program/values/field.ts";
import { areaOf } from "../../kernel/area/area.ts";
import type { FinishedPart } from "./finished-part.ts";
import { partProblem, type PartProblem } from "./part-problem.ts";

/** Material around a part where no blank is stated, mm: on the ⌀, at a face that is sawn, and behind the part in the chuck. */
const ON_DIAMETER = 2,
  SAWN = 1,
  BEHIND = 30;

/**
 * The blank of a part. Fields that are empty are proposed from the box of the part; null while that is needed and
 * unknown.
 */
export function blankOfPart(
  { blank, partsOff, unmachinedBehind }: FinishedPart,
  box: Box | null,
  problems: PartProblem[],
): readonly Ring[] | null {
  if (blank && "outline" in blank) {
    const { contour, issues } = readRows(blank.outline),
      wrong = issues.find(({ issue }) => issue.severity === "error");
    const rings = wrong ? null : rotation(contour.segments);
    if (rings && areaOf(rings) > 0) return rings;
    problems.push(partProblem("blankWrong", {}, { side: "blank" }));
    return [];
  }
  const typed = (name: "outside" | "bore" | "length" | "allowance") => {
    const read = readText({ ...anyNumber, id: `blank.${name}` }, blank?.[name] ?? "");
    if (read.issue) problems.push(partProblem("wrong", { at: `blank.${name}` }));
    return read.value;
  };
  const needsPart =
    !blank || blank.outside.trim() === "" || blank.length.trim() === "" || blank.allowance.trim() === "";
  if (needsPart && !box) return null;
  const behind = partsOff || unmachinedBehind ? BEHIND : SAWN;
  const front = typed("allowance") ?? (box?.right ?? 0) + SAWN,
    outside = typed("outside") ?? roundedUpTo(1, toDiameter(radius(box?.high ?? 0)) + ON_DIAMETER),
    long = typed("length") ?? roundedUpTo(1, front - (box?.left ?? 0) + behind);
  const rings = cylinder({
    outside: toRadius(diameter(outside)),
    inside: toRadius(diameter(typed("bore") ?? 0)),
    length: length(long),
    front: axial(front),
  });
  if (rings) return rings;
  problems.push(partProblem("blankWrong", {}, { side: "blank" }));
  return [];
}

/** The clamping of a part; null without one, or where words of it are missing. */
export function clampingOfPart({ clamping }: FinishedPart, problems: PartProblem[]): Clamping | null {
  const read = clamping && readClamping(clampingText(clamping));
  if (!read) return null;
  const made = clampingOf(read, (n) => n);
  if ("kind" in made) return made;
  for (const word of made) problems.push(partProblem("missing", { at: `clamping.words.${word}` }));
  return null;
}
