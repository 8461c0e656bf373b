import { Suspense, useEffect } from "react";
import type { ThreadSize } from "../../../cycles/thread-sizes.ts";
import { setPrompts } from "../../document/edits.ts";
import { useOpenCall } from "../../place/open-call.ts";
import { CycleInWork } from "../../calculation/issue-text.ts";
import { lazyPart } from "../../base/parts.ts";
import type { JobReading } from "../../document/reading.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { closeStep } from "../../document/steps.ts";
import { useEditor } from "../../document/store.ts";
import { DialogDone } from "./DialogDone.tsx";
import { PromptDialog } from "./PromptDialog.tsx";
import { useCycleSession, type PromptedBlock } from "./use-cycle-session.tsx";
import { Unverified } from "./Unverified.tsx";

const ThreadSizes = lazyPart(async () => ({ default: (await import("./ThreadSizes.tsx")).ThreadSizes }));

/** The dialog of a cycle: of the job, or of a block of a program. */
export function CycleDialog({
  read,
  block = null,
}: {
  readonly read: JobReading;
  readonly block?: PromptedBlock | null;
}) {
  const { dialog: t } = useTexts();
  const session = useCycleSession(read, block);
  const { thread, number: cycle } = read.cycle;
  const line = block?.line ?? null;
  const work = useEditor((s) => s.work);
  useEffect(() => {
    if (line !== null) useOpenCall.setState({ call: { work, cycle, line } });
  }, [work, cycle, line]);
  const fill = async (size: ThreadSize) => {
    if (!thread) return;
    const { valuesOf } = await import("../../../cycles/thread-sizes.ts");
    const typed = (q: string) => Number(read.reading.partial[q] ?? 0);
    const values = valuesOf(size, thread, typed(thread.position) === 1, typed(thread.flank));
    closeStep();
    (block?.setAll ?? setPrompts)(Object.fromEntries(Object.entries(values).map(([q, value]) => [q, String(value)])));
    closeStep();
  };
  const head = (
    <>
      {session.fields.length > 0 && <Unverified cycle={read.cycle} />}
      {thread && (
        <Suspense fallback={null}>
          <ThreadSizes line={line} take={(size) => void fill(size)} />
        </Suspense>
      )}
    </>
  );
  return (
    <CycleInWork value={cycle}>
      <PromptDialog
        session={session}
        name={t.form}
        listName={t.list}
        head={head}
        done={<DialogDone session={session} inBlock={block !== null} onInsert={block?.onInsert} />}
      />
    </CycleInWork>
  );
}
