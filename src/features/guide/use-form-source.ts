import { useMemo } from "react";
import type { PlaneSegment } from "../../kernel/plane/plane.ts";
import { parse } from "../../nc/parse.ts";
import { startLines } from "../../nc/program.ts";
import type { ApproachForm } from "../../nc/words.ts";
import { approachContext } from "../../program/edits/approach-context.ts";
import { approachDraft, readApproach, type ApproachDraft } from "../../program/edits/approach-draft.ts";
import { shapeOf } from "../../program/motion/approach-fields.ts";
import {
  readyApproach,
  wordsOfPoint,
  type ApproachContext,
  type ReadyApproach,
} from "../../program/edits/approach-request.ts";
import { suggestedForms } from "../../view/approach/forms.ts";
import { parametersBefore } from "../../app/fields/blocks/block-context.ts";
import { useOutcome } from "../../app/calculation/outcome.ts";
import { shownFile, useShownOtherFile } from "../../app/document/shown-file.ts";
import { useEditor } from "../../app/document/store.ts";
import { useGuidedBlock } from "../../app/place/open-call.ts";

/** A sample corner and tool for the forms. */
const CORNER: readonly PlaneSegment[] = [
  { kind: "line", from: { x: 0, y: 60 }, to: { x: 0, y: 0 } },
  {
    kind: "line",
    from: { x: 0, y: 0 },
    to: { x: 60, y: 0 },
  },
];
const SAMPLE_RADIUS = 8;

/** The pole of the sample corner, for the polar forms. */
const POLE = { x: 40, y: 30 };
const SAMPLE: ApproachContext = {
  plane: "XY",
  before: null,
  contour: CORNER,
  side: "left",
  toolRadius: SAMPLE_RADIUS,
  tip: { x: 0, y: 0 },
  pole: POLE,
  feedBefore: "rapid",
  unit: 1,
  parameters: {},
};

/** The surroundings of a shown form. */
export interface FormSource extends ReadyApproach {
  readonly form: ApproachForm;
  readonly context: ApproachContext;
  /** The typed texts of its words. */
  readonly draft: ApproachDraft;
  /** The line of its open block; null for the sample corner. */
  readonly line: number | null;
  readonly rapidBefore: boolean;
}

/** A form at the sample corner. */
function sampleOf(form: ApproachForm, departing: boolean): FormSource | null {
  const { contour, side, toolRadius } = SAMPLE;
  const found = suggestedForms({ contour, side, toolRadius, outside: null }, departing).find(
    ({ shape }) => shape === shapeOf(form),
  );
  if (!found) return null;
  const { request } = found,
    context = { ...SAMPLE, before: departing ? null : request.outside };
  const named = departing ? request.outside : request.element.from;
  const draft = { ...(named && wordsOfPoint(form, named, context)), SIDE: "RL" };
  return { form, context, draft, request, contour, line: null, rapidBefore: !departing };
}

/** A form at the contour of the open block, if that is available, else at the sample corner. */
export function useFormSource(form: ApproachForm, departing: boolean): FormSource | null {
  const { program, work } = useEditor();
  const block = useGuidedBlock((s) => s.block);
  const newest = useOutcome((s) => s.newest?.run ?? null);
  const beside = useShownOtherFile();
  return useMemo(() => {
    if (program && block && block.work === work) {
      const read = parse(shownFile(program).text),
        index = startLines(read).indexOf(block.line),
        s = read.blocks[index]?.statement;
      if (s?.kind === "approach" && s.form === form && s.departing === departing) {
        const known = parametersBefore(read, index);
        const context = approachContext(read, index, beside === null ? newest : null, known);
        const draft = approachDraft(s);
        const ready = readyApproach(form, departing, readApproach(s, context.plane, draft, known), context);
        if (ready)
          return { ...ready, form, context, draft, line: block.line, rapidBefore: context.feedBefore === "rapid" };
      }
    }
    return sampleOf(form, departing);
  }, [program, work, block, newest, beside, form, departing]);
}
