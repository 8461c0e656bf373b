import { useRef } from "react";
import type { ToolFit } from "../../../program/tools/which-tool.ts";
import { startLines } from "../../../nc/program.ts";
import { useSession } from "../../../app/fields/blocks/session.ts";
import { useFitsOfLine } from "../../../app/calculation/use-tool-fits.ts";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { useFixesHeldBack } from "../../../app/findings/task-result.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { ToolChoice } from "./ToolChoice.tsx";
import "./operations.css";

interface Props {
  /** Purpose of the tool. */
  readonly title: string;
  /** The called tool, as the program writes it. */
  readonly taken: string | null;
  /** Index of the block that defines the cycle: its call is simulated with each tool. */
  readonly line: number;
  /** The tool is for finishing: finishing inserts come first. */
  readonly finishes?: boolean;
  readonly done: () => void;
  readonly onTake: (tool: number) => void;
}

const forFinishing = ({ tool: { TYPE } }: ToolFit): number => Number(TYPE !== "FINISH");

/** The tools of the table for an operation, suitable ones first. */
export function ToolDialog({ title, taken, line, finishes = false, done, onTake }: Props) {
  const t = useTexts().operations;
  const dialog = useRef<HTMLDialogElement>(null);
  const program = useSession((s) => s.reading.program);
  const isHeldBack = useFixesHeldBack();
  const found = useFitsOfLine(startLines(program)[line] ?? null);
  const fits = isHeldBack ? null : found;
  return (
    <ModalDialog ref={dialog} className="operation-dialog" title={t.toolTitle(title)} done={done}>
      <ToolChoice
        fits={finishes && fits ? fits.toSorted((a, b) => forFinishing(a) - forFinishing(b)) : fits}
        taken={taken}
        onTake={(tool) => {
          dialog.current?.close();
          onTake(tool);
        }}
      />
    </ModalDialog>
  );
}
