import { Suspense, useState } from "react";
import { INCH } from "../../../kernel/units.ts";
import { clampingIn, proposedClamping, withClamping } from "../../../program/clamping/draft.ts";
import type { ClampingDraft } from "../../../program/clamping/words.ts";
import { boundsOf } from "../../../view/bounds.ts";
import { editProgram, useSession } from "../blocks/session.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { ModalDialog } from "../../base/ModalDialog.tsx";
import { ClampingFields } from "../setup/ClampingFields.tsx";
import { MaterialGroup } from "../said/MaterialField.tsx";
import { useTexts, useTextsOrNull } from "../../base/settings/use-texts.ts";
import "../setup/clamping.css";

/** Assumed size of an unknown blank, mm. */
const SOME_BLANK = { left: -80, right: 0, high: 30 };

/** Material and clamping of the open program; the clamping is written as a comment after its blank. */
export function ClampingDialog({ done }: { readonly done: () => void }) {
  const t = useTextsOrNull("clamping");
  const { page } = useTexts();
  const [draft, keep] = useState(() => clampingIn(useSession.getState().reading.program)?.draft ?? null);
  const run = useOutcome((s) => s.shown?.run),
    inch = run?.program.unit === "inch";
  if (!t) return null;
  const set = (next: ClampingDraft | null, place: string | null) => {
    keep(next);
    editProgram(withClamping(useSession.getState().reading.program, next), place);
  };
  return (
    <ModalDialog title={page.text.clamping} done={done}>
      <div className="setup clamping-fields">
        <Suspense>
          <MaterialGroup />
        </Suspense>
        <fieldset className="setup-group">
          <legend>{t.title}</legend>
          <p className="small soft">{t.inProgram}</p>
          <ClampingFields
            draft={draft}
            set={set}
            inch={inch}
            propose={() => proposedClamping(boundsOf(run?.blank.flat() ?? []) ?? SOME_BLANK, inch ? INCH : 1)}
          />
        </fieldset>
      </div>
    </ModalDialog>
  );
}
