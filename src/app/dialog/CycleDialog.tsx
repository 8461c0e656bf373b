import { isRecalled } from "../../cycles/params.ts";
import { Icon } from "../Icon.tsx";
import { CycleInWork } from "../issue-text.ts";
import type { JobReading } from "../reading.ts";
import { useTexts } from "../settings/use-texts.ts";
import { DialogDone } from "./DialogDone.tsx";
import { PromptDialog } from "./PromptDialog.tsx";
import { useCycleSession, type PromptedBlock } from "./use-cycle-session.tsx";

/** The dialog of a cycle: of the job, or of a block of a program. */
export function CycleDialog({ read, block = null }: { readonly read: JobReading; readonly block?: PromptedBlock | null }) {
  const { dialog: t } = useTexts();
  const session = useCycleSession(read, block);
  return (
    <CycleInWork value={read.cycle.number}>
      <PromptDialog session={session} name={t.form} listName={t.list} hint={t.help}
        head={isRecalled(read.cycle) && (
          <p className="small soft recalled-list">
            <Icon name="info" /> {t.recalled}
          </p>
        )} done={<DialogDone session={session} inBlock={block !== null} />} />
    </CycleInWork>
  );
}
