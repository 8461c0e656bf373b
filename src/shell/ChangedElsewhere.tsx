import { Suspense, useEffect, useState } from "react";
import { lazyWithin } from "../app/base/parts.ts";
import { documentAt, hasOpenDialog, useDocumentInView } from "../app/document/history.ts";
import { useSteps, type HistoryStep } from "../app/document/steps.ts";

const ElsewhereChange = lazyWithin(async () => ({ default: (await import("./ElsewhereChange.tsx")).ElsewhereChange }));

/** Changes of documents that are not in view, each with its undo, for a while or until their document is shown. */
export function ChangedElsewhere() {
  const [steps, put] = useState<ReadonlyMap<string, HistoryStep>>(new Map());
  const inView = useDocumentInView();
  useEffect(
    () =>
      useSteps.subscribe(({ newest }, before) => {
        if (newest === null || newest === before.newest) return;
        // Texts of another language that are still fetched take the focus from the dialog that asked for them.
        if (newest.document === documentAt(document.activeElement) || hasOpenDialog(newest.document)) return;
        put((now) => new Map(now).set(newest.document, newest));
      }),
    [],
  );
  const dismiss = (of: string) => put((now) => new Map([...now].filter(([each]) => each !== of)));
  const shown = [...steps].filter(([of]) => of !== inView);
  if (inView !== null && steps.has(inView)) dismiss(inView);
  return (
    <div className="notices" role="status">
      <Suspense>
        {shown.map(([of, step]) => (
          <ElsewhereChange key={of} step={step} dismiss={() => dismiss(of)} />
        ))}
      </Suspense>
    </div>
  );
}
