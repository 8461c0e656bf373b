import { inScreenWriting } from "../../../i18n/number.ts";
import { useMemo } from "react";
import type { SetupPlace } from "../../../program/job/setup-places.ts";
import { otherProposal } from "../../../program/job/setup.ts";
import { useEditor } from "../../document/store.ts";
import { useToolList } from "../../document/work-tools.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useDeferredUntilPaint } from "../../base/typing.ts";

interface Props {
  readonly place: SetupPlace;
  readonly take: (text: string) => void;
}

/** A value that is proposed now in place of a set one, with a button that takes it. */
export function OtherProposal({ place, take }: Props) {
  const { setup: t, dialog } = useTexts();
  const language = useSettings((s) => s.language);
  const tools = useToolList();
  const job = useDeferredUntilPaint(useEditor((s) => s.job));
  const proposal = useMemo(() => job && otherProposal(job, place, tools), [job, place, tools]);
  if (proposal === null) return null;
  const isTool = place === "tool";
  const shown = inScreenWriting(language, proposal);
  const name = isTool ? (tools.find(({ T }) => String(T) === proposal)?.NAME ?? "") : "";
  return (
    <>
      <span className="small" role="status">
        {t.proposed}: <span className="number">{`${shown} ${name}`.trim()}</span>
      </span>
      <button type="button" className="button small" onClick={() => take(proposal)}>
        {isTool ? t.tool.take(Number(proposal)) : dialog.takeNearest(shown)}
      </button>
    </>
  );
}
