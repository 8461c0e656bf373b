import { Suspense, useState, type ReactNode } from "react";
import type { Assignment } from "../../program/tool-sheets/assignment.ts";
import { lazyWithin } from "../../app/base/parts.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import type { NamedSheet } from "./sheet-files.ts";
import { columnsFor, importOfSheet } from "./sheet-import.ts";
import type { ToolImport } from "./tool-files.ts";

const SheetDialog = lazyWithin(() => import("./SheetDialog.tsx").then((m) => ({ default: m.SheetDialog })));

interface Asking {
  readonly named: NamedSheet;
  readonly first: Assignment;
  readonly answer: (assignment: Assignment | null) => void;
}

/** Assigning the columns of sheets: the dialog, shown while it is asked, and the tools once it is answered. */
export function useSheetColumns(): {
  readonly dialog: ReactNode;
  /** Columns that were assigned before are taken; `again`: they are asked for all the same. Null: given up. */
  readonly assign: (named: NamedSheet, again?: boolean) => Promise<ToolImport | null>;
} {
  const w = useTexts("tool-sheets");
  const [asking, ask] = useState<Asking | null>(null);
  const assign = async (named: NamedSheet, again = false): Promise<ToolImport | null> => {
    const { assignment, day } = columnsFor(named);
    if (day !== null && !again) return importOfSheet(named, assignment, day, w);
    const chosen = await new Promise<Assignment | null>((answer) => ask({ named, first: assignment, answer }));
    ask(null);
    return chosen && importOfSheet(named, chosen, null, w);
  };
  const dialog = asking && (
    <Suspense fallback={null}>
      <SheetDialog named={asking.named} first={asking.first} done={asking.answer} />
    </Suspense>
  );
  return { dialog, assign };
}
