import type { AnyIssue } from "../../i18n/message-texts.ts";
import { at } from "../../kernel/curve.ts";
import { diameter, toRadius } from "../../kernel/units.ts";
import type { Run } from "../../program/run-types.ts";
import type { LookAt } from "../lathe/places.ts";

/** Findings of the check of approach and departure that have a place in the Z/X plane, numbered on from `before`. */
export function turnCutPlaces(
  run: Run, before: number, say: (issue: AnyIssue) => string, line: (block: string, sentence: string) => string,
): readonly LookAt[] {
  return run.issues.flatMap(({ issue, block }) => {
    if (issue.code !== "approachCutsContour" && issue.code !== "approachValueCutsContour" && issue.code !== "approachBlocked") return [];
    const { x, z } = issue.data;
    return z === undefined ? [] : [{ issue, block, place: at(z, toRadius(diameter(x))) }];
  }).map(({ issue, block, place }, i): LookAt => {
    const lead = run.approaches.find((a) => a.block === block && a.plane === "ZX");
    const step = lead ? run.stepBlocks.indexOf(lead.index) : -1;
    return {
      id: `a${i}`, kind: "finding", mark: String(before + i + 1), place, line: line(String(block ?? ""), say(issue)),
      position: { step: Math.max(0, step), fraction: 0.5 },
    };
  });
}
