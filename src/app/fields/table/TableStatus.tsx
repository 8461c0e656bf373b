import { useMemo } from "react";
import { documentInView, undoStep } from "../../document/history.ts";
import { lastStep, useIsLastStep } from "../../document/steps.ts";
import { Icon } from "../../base/Icon.tsx";
import { Message } from "../../base/Message.tsx";
import "./table-status.css";

/** Result of an import or a change: sentences, and whether the table changed. */
export interface TableMessage {
  readonly sentences: readonly string[];
  readonly failed: boolean;
  readonly changed: boolean;
}

/** Status of a table change, with an undo button. */
export function TableStatus({
  said,
  undo,
  done,
}: {
  readonly said: TableMessage | null;
  /** Text of the undo button. Its accessible name says what is undone, since the top line has an undo button too. */
  readonly undo: string;
  /** Called after the undo. */
  readonly done: () => void;
}) {
  const step = useMemo(() => (said?.changed ? lastStep(documentInView()) : null), [said]);
  const isLast = useIsLastStep(step);
  return (
    <div className="tool-status" role="status">
      {said && (
        <Message tone={said.failed ? "error" : "info"}>
          <span>{said.sentences.join(" ")}</span>
          {isLast && (
            <button
              type="button"
              className="button"
              aria-label={`${undo} – ${said.sentences.join(" ")}`}
              onClick={() => {
                undoStep();
                done();
              }}
            >
              <Icon name="undo" /> {undo}
            </button>
          )}
        </Message>
      )}
    </div>
  );
}
