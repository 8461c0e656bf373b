import { useState } from "react";
import { createPortal } from "react-dom";
import type { MachineTexts } from "../../../i18n/en/machine.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { ModalDialog } from "../../base/ModalDialog.tsx";
import { Icon } from "../../base/Icon.tsx";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts, useTextsOrNull } from "../../base/settings/use-texts.ts";
import { durationText } from "../../base/clock-text.ts";
import { timeCauses, timeContents } from "./time-contents.ts";
import "./time-parts.css";

/** The button from a machining time to its breakdown. */
export function TimeParts() {
  const t = useTextsOrNull("machine");
  const run = useOutcome((s) => s.pictured?.run);
  const [isOpen, open] = useState(false);
  if (!t || !run) return null;
  return (
    <>
      <button
        type="button"
        className="time-parts"
        aria-label={t.time.title}
        title={t.time.title}
        onClick={() => open(true)}
      >
        <Icon name="info" />
      </button>
      {isOpen && createPortal(<Opened t={t.time} run={run} done={() => open(false)} />, document.body)}
    </>
  );
}

function Opened({ t, run, done }: { readonly t: MachineTexts["time"]; readonly run: Run; readonly done: () => void }) {
  const { duration } = useTexts().page.effect;
  const language = useSettings((s) => s.language);
  const row = (name: string, seconds: number) => (
    <tr key={name}>
      <th scope="row">{name}</th>
      <td className="number">{durationText(duration, language, seconds)}</td>
    </tr>
  );
  return (
    <ModalDialog title={t.title} done={done}>
      <table className="time-table">
        <tbody>{timeCauses(t, run).map(([name, seconds]) => row(name, seconds))}</tbody>
        <tfoot>{row(t.total, run.seconds)}</tfoot>
      </table>
      {timeContents(t, run, language).map((line) => (
        <p key={line} className="small">
          {line}
        </p>
      ))}
      <p className="small soft">{t.hint}</p>
    </ModalDialog>
  );
}
