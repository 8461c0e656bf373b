import { undoStep } from "../../document/history.ts";
import { Icon } from "../../base/Icon.tsx";
import { Message } from "../../base/Message.tsx";

/** What came of a file, or of a change: sentences, and whether the table was changed. */
export interface TableSaid {
  readonly sentences: readonly string[];
  readonly failed: boolean;
  readonly changed: boolean;
}

/** What a change of a table of the device came to, with a way back. */
export function TableStatus({
  said,
  undo,
  done,
}: {
  readonly said: TableSaid | null;
  /**
   * The word on the button that takes it back; its name says what, as the top line has a button of that word as well.
   */
  readonly undo: string;
  /** It was taken back. */
  readonly done: () => void;
}) {
  return (
    <div className="tool-status" role="status">
      {said && (
        <Message tone={said.failed ? "error" : "info"}>
          <span>{said.sentences.join(" ")}</span>
          {said.changed && (
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
