import { useState } from "react";
import { approachDraft, approachStatement, readApproach, type ApproachDraft, type ApproachReading, type ApproachStatement } from "../../program/approach-draft.ts";
import type { ApproachContext } from "../../program/approach-request.ts";

/** What is typed into the prompts of one block. */
export interface TypedApproach {
  readonly draft: ApproachDraft;
  readonly reading: ApproachReading;
  readonly set: (words: ApproachDraft) => void;
}

const same = (a: ApproachStatement, b: ApproachStatement) =>
  a.form === b.form && a.departing === b.departing && JSON.stringify(approachDraft(a)) === JSON.stringify(approachDraft(b));

/**
 * Typed text of a block. What can be read goes into the block at once; what can not stays in its prompt. A block that was
 * changed elsewhere (undo, its text) takes the place of what was typed.
 */
export function useTypedApproach(statement: ApproachStatement, context: ApproachContext, onChange: (next: ApproachStatement, place: string | null) => void): TypedApproach {
  const { plane, parameters } = context;
  const [draft, setDraft] = useState(() => approachDraft(statement));
  const [known, setKnown] = useState(statement);
  let shown = draft;
  if (known !== statement) {
    setKnown(statement);
    if (!same(approachStatement(statement, plane, draft, parameters), statement)) {
      shown = approachDraft(statement);
      setDraft(shown);
    }
  }
  return {
    draft: shown,
    reading: readApproach(statement, plane, shown, parameters),
    set(words) {
      const next = { ...shown, ...words };
      setDraft(next);
      const written = approachStatement(statement, plane, next, parameters);
      if (!same(written, statement)) onChange(written, Object.keys(words).join(" "));
    },
  };
}
