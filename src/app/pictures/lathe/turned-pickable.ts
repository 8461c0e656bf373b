import { choiceOf } from "../../../program/run/path-index.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { moveAt, positionNear } from "../../../view/pick.ts";
import { useEditor } from "../../document/store.ts";
import { chooseMove, elementNear } from "../selection.ts";
import { useTaskMarks } from "./task-marks.ts";
import type { Pickable } from "./use-picking.ts";

/** The turned moves of a run, and the contour elements of its job. `shown`: the visible moves. */
export const turnedPickable = (run: Run, shown: (step: number) => boolean): Pickable => ({
  find(place, reach) {
    const step = moveAt(run.steps, place, reach, shown);
    return step === null ? null : positionNear(run.steps, step, place);
  },
  choose(position, place, reach = 0) {
    const rows = place && useEditor.getState().job?.contour;
    chooseMove(choiceOf(run, position.step), position, rows ? elementNear(rows, place, reach) : null);
  },
  point(place) {
    const onPoint = useTaskMarks.getState().told?.onPoint;
    onPoint?.(place);
    return onPoint !== undefined;
  },
});
