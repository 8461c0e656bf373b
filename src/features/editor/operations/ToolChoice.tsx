import type { Tool } from "../../../kernel/plan/tool.ts";
import type { ToolFit } from "../../../program/tools/which-tool.ts";
import { InsertDrawing } from "../../../app/pictures/lathe/InsertDrawing.tsx";
import { ToolWords, useToolDetails, useToolVerdict } from "../../../app/fields/setup/tool-words.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { useToolList } from "../../../app/document/work-tools.ts";

/** Edge length of an insert drawing, px. */
const DRAWING = 40;

interface Props {
  /** The suitability of each tool; null while unknown. */
  readonly fits: readonly ToolFit[] | null;
  /** The present tool, by number or name. */
  readonly taken: string | null;
  readonly onTake: (tool: number) => void;
  /** Only these tools; absent: all of the table. */
  readonly among?: readonly Tool[];
  /** Heading of the list where suitability is unknown; absent: turning tools. */
  readonly heading?: string;
  /** Folds the unsuitable tools under this heading; absent: they are listed. */
  readonly folded?: (tools: number) => string;
}

/** All tools as buttons, drawn and named: suitable ones first, the others with the residual material they leave. */
export function ToolChoice({ fits, taken, onTake, among, heading, folded }: Props) {
  const t = useTexts();
  const all = useToolList();
  const tools = among ?? all;
  const details = useToolDetails();
  const verdict = useToolVerdict();
  const ranked = fits ? fits.map(({ tool }) => tool) : tools;
  const fitOf = (tool: Tool) => fits?.find((fit) => fit.tool.T === tool.T);
  const able = ranked.filter((tool) => fitOf(tool)?.makesContour);
  const others = ranked.filter((tool) => !fitOf(tool)?.makesContour);
  const list = (name: string, own: readonly Tool[]) =>
    own.length > 0 && (
      <section aria-label={name}>
        <h3 className="panel-title">{name}</h3>
        <ul className="tool-choice">
          {own.map((tool) => {
            const fit = fitOf(tool);
            const isTaken = taken === String(tool.T) || taken === tool.NAME;
            return (
              <li key={tool.T}>
                <button
                  type="button"
                  className="tool-row"
                  aria-pressed={isTaken}
                  aria-label={`${t.setup.tool.name(tool.T, tool.NAME)}, ${details(tool)}${fit ? `, ${verdict(fit)}` : ""}`}
                  onClick={() => onTake(tool.T)}
                >
                  <InsertDrawing tool={tool} width={DRAWING} height={DRAWING} />
                  <ToolWords tool={tool} fit={fit} />
                </button>
              </li>
            );
          })}
        </ul>
      </section>
    );
  return (
    <div className="tool-choices-list">
      {list(t.operations.able, able)}
      {folded && fits && others.length > 0 ? (
        <details>
          <summary>{folded(others.length)}</summary>
          {list(t.operations.others, others)}
        </details>
      ) : (
        list(able.length > 0 ? t.operations.others : (heading ?? t.setup.tool.list), others)
      )}
    </div>
  );
}
