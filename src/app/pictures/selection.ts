import { useMemo } from "react";
import { part, type Segment } from "../../kernel/geometry/point.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { markedBy, type Marked, type MoveSpan, type PathChoice } from "../../program/run/path-index.ts";
import { milledBy, planeBegin } from "../../program/run/plane-index.ts";
import type { ApproachRun } from "../../program/tools/plane-types.ts";
import type { Run } from "../../program/state/run-types.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { showChoice } from "./plane/shown-view.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import { chooseElement, useContourPlace } from "../place/contour-place.ts";
import { playback } from "../calculation/playback.ts";
import { NOTHING_SELECTED, useSelection, type Selection } from "../document/selected.ts";
import { useEditor } from "../document/store.ts";

const select = (chosen: Partial<Selection>): void => useSelection.setState({ ...NOTHING_SELECTED, ...chosen });

/** Moves the tool to a moment of the run and pauses. */
function goTo(position: PlayPosition): void {
  playback.dispatch({ do: "pause" });
  playback.dispatch({ do: "seek", position });
}

/** Marks a choice in the picture that shows it, and moves the tool to its start. */
export function choosePath(run: Run | null, choice: PathChoice): void {
  select({ choice });
  const isMilled = run !== null && showChoice(run, playback, choice) && choice.kind === "blocks";
  const begin = isMilled ? planeBegin(run, choice.span.from) : run && markedBy(run, choice).begin;
  if (begin !== null) goTo({ step: begin, fraction: 0 });
}

/** Chooses a line in the program of a job: the path of its block is marked. */
export function chooseLine(run: Run | null, choice: PathChoice, line: Selection["line"]): void {
  choosePath(run, choice);
  useSelection.setState({ line });
}

/** Chooses what makes a clicked move, and the contour element under it, and moves the tool to that moment. */
export function chooseMove(choice: PathChoice | null, position: PlayPosition, element: string | null = null): void {
  select({ choice });
  if (element !== null) chooseElement(element);
  goTo(position);
}

/** The segments that a row of a job's contour table makes. */
function choiceOfElement(rows: readonly ContourRow[], id: string): PathChoice {
  const row = rows.findIndex((each) => each.id === id);
  return {
    kind: "segments",
    segments: readRows(rows).rowOfSegment.flatMap((of, segment) => (of === row ? [segment] : [])),
  };
}

/** The row of a job's contour table whose element is nearest to a place of the picture within `reach`, by its id. */
export function elementNear(rows: readonly ContourRow[], place: Segment["from"], reach: number): string | null {
  const {
    rowOfSegment,
    contour: { segments },
  } = readRows(rows);
  const far = segments.map((segment) => part.distanceTo(segment, place));
  const nearest = Math.min(Infinity, ...far);
  return nearest > reach ? null : (rows[rowOfSegment[far.indexOf(nearest)] ?? -1]?.id ?? null);
}

/** The approaches and departures of the chosen blocks. */
export function useChosenApproaches(approaches: readonly ApproachRun[]): readonly ApproachRun[] {
  const choice = useSelection((s) => s.choice);
  return useMemo(
    () =>
      choice?.kind === "blocks"
        ? approaches.filter(({ index }) => index >= choice.span.from && index <= choice.span.to)
        : [],
    [choice, approaches],
  );
}

const NO_MOTIONS: readonly MoveSpan[] = [];

/** The milled motions that are marked in the working plane of a run. */
export function useMilledMarks(run: Run): readonly MoveSpan[] {
  const choice = useSelection((s) => s.choice);
  return useMemo(() => (choice?.kind === "blocks" ? milledBy(run, choice.span) : NO_MOTIONS), [run, choice]);
}

const NOTHING: Marked = { stretches: [], contour: [], begin: null };

/** The marks in the picture of a run. */
export function useMarked(run: Run): Marked {
  const choice = useSelection((s) => s.choice);
  const element = useContourPlace((p) => p.chosen);
  const rows = useEditor((s) => s.job?.contour ?? null);
  return useMemo(() => {
    const path = choice ? markedBy(run, choice) : NOTHING;
    if (element === null || !rows) return path;
    const drawn = markedBy(run, choiceOfElement(rows, element));
    return choice ? { ...path, contour: drawn.contour } : drawn;
  }, [run, choice, element, rows]);
}
