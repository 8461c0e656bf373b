import { useCallback, useMemo } from "react";
import type { ParamTextId } from "../../../cycles/index.ts";
import { blockNumbers, startLines } from "../../../nc/program.ts";
import type { CourseDrawingTexts } from "../../../i18n/en/course-drawing.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { measuredSegments, type MeasuredFeature } from "../../../view/drawing/measured-feature.ts";
import type { ListedSize } from "../../../view/drawing/print-sizes.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { useOutcome } from "../../../app/calculation/outcome.ts";
import { useReading } from "../../../app/document/reading.ts";
import { useSelection } from "../../../app/document/selected.ts";
import { showFile } from "../../../app/document/shown-file.ts";
import { useOpenBlock } from "../../../app/fields/blocks/open-block.ts";
import { openBlock, readWhole, useSession } from "../../../app/fields/blocks/session.ts";
import { useMarked } from "../../../app/pictures/selection.ts";
import { chooseElement } from "../../../app/place/contour-place.ts";
import { openPrompt, showPrompt, showSection, usePlace } from "../../../app/place/place.ts";
import { promptOfSize, rowOfSize, sourceOfSize, writtenMoves, type SizeSource } from "./size-source.ts";

/** Joins the sizes of a drawing with the open work. */
export interface SizeLinks {
  /** Indexes of the sizes that the open prompt, the chosen block or the chosen element makes. */
  readonly marked: ReadonlySet<number>;
  /** What makes a size, in words. */
  readonly say: (size: ListedSize) => string;
  /** Shows what makes a size; `enter`: also moves the focus there. */
  readonly show: (feature: MeasuredFeature, enter: boolean) => void;
}

const NO_RUN = { steps: [], stepBlocks: [], operations: [] } as unknown as Run;

/** The index of the block of a source in the open program. */
function indexOf({ at }: SizeSource): number {
  return "index" in at ? at.index : startLines(useSession.getState().reading.program).lastIndexOf(at.line);
}

/** Opens the block of a source, at its value; its path is marked as when it is chosen in the text. */
function openSource(source: SizeSource): void {
  showFile(null);
  readWhole();
  const index = indexOf(source);
  if (index < 0) return;
  openBlock(index, source.q);
  if (source.q !== null) showSection("block");
}

/** The links between the sizes of a drawing and what makes them in the open work. */
export function useSizeLinks(list: readonly ListedSize[], t: CourseDrawingTexts): SizeLinks {
  const { params: names } = useTexts();
  const job = useReading();
  const block = useOpenBlock().read;
  const prompt = usePlace((p) => p.prompt);
  const chosen = useSelection((s) => s.choice?.kind);
  const run = useOutcome((s) => s.pictured?.run) ?? NO_RUN;
  const { contour, stretches } = useMarked(run);
  const open = job ?? block;
  const marked = useMemo(() => {
    const written = chosen === "blocks" ? writtenMoves(run, stretches).map(({ segment }) => segment) : [];
    const isMarked = (feature: MeasuredFeature) =>
      measuredSegments(feature, [...contour, ...written]).length > 0 ||
      (open !== null && prompt !== null && promptOfSize(open.cycle.params, open.reading.partial, feature) === prompt);
    return new Set(list.flatMap(({ measures }, i) => (measures && isMarked(measures) ? [i] : [])));
  }, [list, run, contour, stretches, chosen, open, prompt]);

  /** What makes a feature: a prompt or a contour element of the open cycle, or a block of the open program. */
  const find = useCallback(
    (feature: MeasuredFeature) => {
      if (!job) return { source: sourceOfSize(run, feature) };
      const q = promptOfSize(job.cycle.params, job.reading.partial, feature);
      if (q !== null) return { q };
      const row = rowOfSize(job.job.contour, feature);
      return row ? { row } : { source: sourceOfSize(run, feature) };
    },
    [job, run],
  );
  const say = useCallback(
    ({ size: { text }, measures }: ListedSize): string => {
      if (!measures) return text;
      const { q = null, row = null, source = null } = find(measures);
      const param = q === null ? undefined : job?.cycle.params[q];
      if (param) return t.madeBy(text, `${q} ${names[param.text as ParamTextId].label}`);
      if (row) return t.madeBy(text, t.element(String(row.number)));
      if (!source) return t.madeByNothing(text);
      if (job) return t.madeBy(text, t.cycle(String(job.cycle.number)));
      const number = blockNumbers(useSession.getState().reading.program)[indexOf(source)];
      const place = t.block(String(number ?? ""));
      return t.madeBy(text, source.q === null ? place : `${place}, ${source.q}`);
    },
    [find, job, names, t],
  );
  const show = useCallback(
    (feature: MeasuredFeature, enter: boolean): void => {
      const { q = null, row = null, source = null } = find(feature);
      if (q !== null && job) (enter ? openPrompt : showPrompt)(q, job.draft[q] ?? "");
      else if (row) {
        showSection("contour");
        chooseElement(row.id);
      } else if (source && !job) openSource(source);
    },
    [find, job],
  );
  return { marked, say, show };
}
