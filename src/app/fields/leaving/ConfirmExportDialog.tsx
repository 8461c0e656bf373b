import { useEffect, useId, useRef } from "react";
import type { FindingsHost } from "../../findings/host.ts";
import { lazyPart } from "../../base/parts.ts";
import { useExportRequest } from "./confirm-export.ts";

/** Loaded on demand, since it is rarely needed. */
const LeavingQuestion = lazyPart(async () => ({
  default: (await import("./ConfirmExportQuestion.tsx")).ConfirmExportQuestion,
}));

/** Asks before a program with faults is exported; closing the dialog cancels the export. */
export function ConfirmExportDialog({ cycleOf }: Pick<FindingsHost, "cycleOf">) {
  const id = useId();
  const asking = useExportRequest((l) => l.asking);
  const dialog = useRef<HTMLDialogElement>(null);

  useEffect(() => {
    if (asking && !dialog.current?.open) dialog.current?.showModal();
    if (!asking) dialog.current?.close();
  }, [asking]);
  useEffect(() => () => useExportRequest.getState().asking?.answer(false), []);

  return (
    <dialog
      ref={dialog}
      className="leaving"
      role="alertdialog"
      aria-labelledby={`${id}-title`}
      aria-describedby={`${id}-what`}
      onClose={() => asking?.answer(false)}
    >
      {asking && <LeavingQuestion asking={asking} id={id} cycleOf={cycleOf} />}
    </dialog>
  );
}
