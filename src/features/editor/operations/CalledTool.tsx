import { useState } from "react";
import type { Statement, StatementOf } from "../../../nc/statement.ts";
import { definesCycle } from "../../../program/edits/operations.ts";
import { useSession } from "../../../app/fields/blocks/session.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { InsertDrawing } from "../../../app/pictures/lathe/InsertDrawing.tsx";
import { lazyPart } from "../../../app/base/parts.ts";
import { ToolWords } from "../../../app/fields/setup/tool-words.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { useToolList } from "../../../app/document/work-tools.ts";
import "./operations.css";

const ToolDialog = lazyPart(async () => ({ default: (await import("./ToolDialog.tsx")).ToolDialog }));

/** Edge length of the drawing, px. */
const DRAWING = 48;

interface Props {
  readonly statement: StatementOf<"toolCall">;
  readonly change: (next: Statement) => void;
}

/** The tool that a block calls, drawn and named, and the button to change it. */
export function CalledTool({ statement, change }: Props) {
  const t = useTexts();
  const [choosing, choose] = useState(false);
  const program = useSession((s) => s.reading.program);
  const index = useSession((s) => s.index);
  const tools = useToolList();
  if (statement.tool === null || typeof statement.tool === "object") return null;
  const said = String(statement.tool);
  const known = tools.find(({ T, NAME }) => String(T) === said || NAME === said);
  const cycle = program.blocks.findIndex(({ statement: s }, i) => i > index && definesCycle(s));
  return (
    <div className="called-tool">
      {known && <InsertDrawing tool={known} width={DRAWING} height={DRAWING} />}
      {known ? (
        <ToolWords tool={known} fit={undefined} />
      ) : (
        <span className="soft">{t.operations.unknownTool(said)}</span>
      )}
      <button type="button" className="button" onClick={() => choose(true)}>
        <Icon name="insert" /> {t.operations.chooseTool}
      </button>
      {choosing && (
        <ToolDialog
          title={t.editor.kinds.toolCall}
          taken={said}
          line={cycle}
          done={() => choose(false)}
          onTake={(tool) => change({ ...statement, tool })}
        />
      )}
    </div>
  );
}
