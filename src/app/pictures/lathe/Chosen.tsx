import { useMemo, useSyncExternalStore } from "react";
import type { Step } from "../../../kernel/time/step.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { segmentData, stretchData } from "../../../view/path.ts";
import { toolpath } from "../../../view/scene.ts";
import { useMarked } from "../selection.ts";

/** The choice, drawn over the path: moves in their own line style, and elements of the contour. */
export function ChosenPath({ run }: { readonly run: Run }) {
  const { stretches, contour } = useMarked(run);
  const shapes = useMemo(
    () => toolpath(stretches.flatMap(({ first, last }) => run.steps.slice(first, last + 1))),
    [stretches, run],
  );
  return (
    <>
      {shapes.length > 0 && (
        <g className="shape-marked">
          {shapes.map(({ role, d }) => (
            <path key={role} className={`shape-${role}`} d={d} />
          ))}
        </g>
      )}
      {contour.length > 0 && <path className="shape-marked-contour" d={segmentData(contour)} />}
    </>
  );
}

/** Store of the move under the pointer, which changes without rendering the view. */
export interface Hover {
  readonly get: () => number | null;
  readonly set: (step: number | null) => void;
  readonly subscribe: (listener: () => void) => () => void;
}

/** Creates one, over no move. */
export function createHover(): Hover {
  const listeners = new Set<() => void>();
  let over: number | null = null;
  return {
    get: () => over,
    set(step) {
      if (step === over) return;
      over = step;
      for (const listener of [...listeners]) listener();
    },
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}

/** The move that a click would choose. `dataOf`: path data of a move. */
export function Hovered<Move>({
  moves,
  hover,
  dataOf,
}: {
  readonly moves: readonly Move[];
  readonly hover: Hover;
  readonly dataOf: (move: Move) => string;
}) {
  const over = useSyncExternalStore(hover.subscribe, hover.get);
  const move = over === null ? undefined : moves[over];
  return move && <path className="shape-hovered" d={dataOf(move)} />;
}

/** Path data of a turned move. */
export const turnedMoveData = (step: Step): string => stretchData([step]);
