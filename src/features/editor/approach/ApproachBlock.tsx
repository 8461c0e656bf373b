import { useCallback, useEffect, useMemo, useState } from "react";
import { withBlock } from "../../../nc/edit.ts";
import { startLines } from "../../../nc/program.ts";
import { approachContext } from "../../../program/edits/approach-context.ts";
import { parametersBefore } from "../../../app/fields/blocks/block-context.ts";
import { watchTyped } from "../../../app/fields/blocks/half-typed.ts";
import { editProgram, useSession } from "../../../app/fields/blocks/session.ts";
import { useShownOtherFile } from "../../../app/document/shown-file.ts";
import { useOutcome } from "../../../app/calculation/outcome.ts";
import type { FindingEntry } from "../../../app/findings/entry.ts";
import { openWordOf, useGuidedBlock } from "../../../app/place/open-call.ts";
import { useEditor } from "../../../app/document/store.ts";
import { ApproachDialog } from "./ApproachDialog.tsx";
import { isFresh, markFresh } from "../../../app/fields/blocks/fresh-block.ts";

/** The dialog of the open APPR or DEP block of the program. A new block starts with the choice of its form. */
export function ApproachBlock({ problems }: { readonly problems: readonly FindingEntry[] }) {
  const {
    reading: { program },
    index,
  } = useSession();
  const made = useOutcome((s) => s.newest?.run ?? null);
  // The approaches of a run are listed by the calling blocks of the program.
  const run = useShownOtherFile() === null ? made : null;
  const [fresh] = useState(() => isFresh(index));
  useEffect(() => markFresh(null), []);
  const context = useMemo(
    () => approachContext(program, index, run, parametersBefore(program, index)),
    [program, index, run],
  );
  const work = useEditor((s) => s.work);
  const line = startLines(program)[index] ?? 0;
  const [begins] = useState(() => openWordOf(work, line));
  const onOpen = useCallback(
    (word: string | null) => useGuidedBlock.setState({ block: { work, line, word } }),
    [work, line],
  );
  const statement = program.blocks[index]?.statement;
  if (statement?.kind !== "approach") return null;
  const newest = () => {
    const now = useSession.getState(),
      { statement: block } = now.reading.program.blocks[now.index] ?? {};
    return block?.kind === "approach" ? block : statement;
  };
  return (
    <ApproachDialog
      statement={statement}
      newest={newest}
      context={context}
      found={problems}
      choosing={fresh}
      begins={begins}
      onOpen={onOpen}
      onChange={(next, place) => {
        const now = useSession.getState();
        editProgram(
          withBlock(now.reading.program, now.index, next),
          place === null ? null : `block ${now.index} ${place}`,
        );
      }}
      onTyped={(isRead) => {
        const now = useSession.getState();
        watchTyped(now.reading.program, now.index, !isRead);
      }}
    />
  );
}
