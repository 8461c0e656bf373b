import { Suspense, useEffect } from "react";
import { setPrompts, type SetupSizes } from "../../document/edits.ts";
import { useOpenCall } from "../../place/open-call.ts";
import { CycleInWork } from "../../calculation/issue-text.ts";
import { lazyWithin } from "../../base/parts.ts";
import type { JobReading } from "../../document/reading.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { takePlace } from "../../document/setup-edits.ts";
import { closeStep } from "../../document/steps.ts";
import { useEditor } from "../../document/store.ts";
import { DialogDone } from "./DialogDone.tsx";
import { ComingDialog, PromptDialog } from "./PromptDialog.tsx";
import { useCycleSession, type PromptedBlock } from "./use-cycle-session.tsx";
import { Unverified } from "./Unverified.tsx";

const ThreadName = lazyWithin(async () => ({ default: (await import("./ThreadName.tsx")).ThreadName }));

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
  const fill = (texts: Readonly<Record<string, string>>, setup: SetupSizes) => {
    closeStep();
    if (block) block.setAll(texts);
    else setPrompts(texts, setup);
    closeStep();
  };
  const takeTool = block ? block.takeTool : (T: number) => takePlace("tool", String(T));
  const head = (
    <>
      {session.fields.length > 0 && <Unverified cycle={read.cycle} />}
      {thread && <ThreadName read={read} roles={thread} line={line} setAll={fill} takeTool={takeTool} />}
    </>
  );
  return (
    <CycleInWork value={cycle}>
      {/* All at once: what arrives above the prompts would push them away from under the pointer. */}
      <Suspense fallback={<ComingDialog />}>
        <PromptDialog
          session={session}
          name={t.form}
          listName={t.list}
          head={head}
          done={<DialogDone session={session} inBlock={block !== null} onInsert={block?.onInsert} />}
        />
      </Suspense>
    </CycleInWork>
  );
}
