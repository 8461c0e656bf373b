import { Suspense, useState } from "react";
import { Icon } from "../../Icon.tsx";
import { lazyPart } from "../../parts.ts";
import { printedText } from "../../printed.ts";
import { handOver, useEditor } from "../../store.ts";
import { useTeachTextsSoon } from "./use-teach-texts.ts";

const TeachDialog = lazyPart(async () => ({ default: (await import("./TeachDialog.tsx")).TeachDialog }));

/** The text of what is open, and its name. */
function open(): string {
  handOver();
  const { job, program } = useEditor.getState();
  if (program) return program.text;
  return job ? printedText(job) : "";
}

/** Leads to the form that makes a task of the open program. */
export function TeachButton() {
  const t = useTeachTextsSoon();
  const [text, make] = useState<string | null>(null);
  if (!t) return null;
  return (
    <>
      <button type="button" className="button plain" aria-haspopup="dialog" onClick={() => make(open())}>
        <Icon name="rename" /> {t.make}
      </button>
      {text !== null && (
        <Suspense>
          <TeachDialog text={text} done={() => make(null)} />
        </Suspense>
      )}
    </>
  );
}
