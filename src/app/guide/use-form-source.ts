import { useMemo } from "react";
import type { ApproachShape } from "../../kernel/approach.ts";
import type { PlaneSegment } from "../../kernel/plane.ts";
import { parse } from "../../nc/parse.ts";
import { startLines } from "../../nc/program.ts";
import { approachContext } from "../../program/approach-context.ts";
import { approachDraft, readApproach } from "../../program/approach-draft.ts";
import { shapeOf } from "../../program/approach-fields.ts";
import { readyApproach, type ApproachContext, type ReadyApproach } from "../../program/approach-request.ts";
import { suggestedForms } from "../../view/approach/forms.ts";
import { parametersBefore } from "../editor/block-context.ts";
import { useOutcome } from "../engine/outcome.ts";
import { shownFile, useShownBeside } from "../files/shown-file.ts";
import { useEditor } from "../store.ts";
import { useOpenApproach } from "./guide-place.ts";

/** A corner, and a tool, to show forms at. */
const CORNER: readonly PlaneSegment[] = [{ kind: "line", from: { x: 0, y: 60 }, to: { x: 0, y: 0 } }, {
  kind: "line",
  from: { x: 0, y: 0 },
  to: { x: 60, y: 0 },
}];
const SAMPLE_RADIUS = 8;

/** What a form is shown at. */
export interface FormSource extends ReadyApproach, Pick<ApproachContext, "plane" | "tip"> {
  /** The line of the open block that it is; null for the corner. */
  readonly line: number | null;
  readonly rapidBefore: boolean;
}

/** A form at the contour of the open block, where that has it, or else at a corner. */
export function useFormSource(shape: ApproachShape, departing: boolean): FormSource | null {
  const { program, work } = useEditor();
  const block = useOpenApproach((s) => s.block);
  const newest = useOutcome((s) => s.newest?.run ?? null);
  const beside = useShownBeside();
  return useMemo(() => {
    if (program && block && block.work === work) {
      const read = parse(shownFile(program).text), index = startLines(read).indexOf(block.line), s = read.blocks[index]?.statement;
      if (s?.kind === "approach" && shapeOf(s.form) === shape && s.departing === departing) {
        const known = parametersBefore(read, index);
        const context = approachContext(read, index, beside === null ? newest : null, known);
        const ready = readyApproach(s.form, departing, readApproach(s, context.plane, approachDraft(s), known), context);
        if (ready)
          return { ...ready, plane: context.plane, tip: context.tip, line: block.line, rapidBefore: context.feedBefore === "rapid" };
      }
    }
    const sample = suggestedForms({ contour: CORNER, side: "left", toolRadius: SAMPLE_RADIUS, outside: null }, departing);
    const found = sample.find((form) => form.shape === shape);
    return found
      ? { request: found.request, contour: CORNER, plane: "XY", tip: { x: 0, y: 0 }, line: null, rapidBefore: !departing }
      : null;
  }, [program, work, block, newest, beside, shape, departing]);
}
