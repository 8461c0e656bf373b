import type { ToolFit } from "../../../program/tools/which-tool.ts";
import { takePlace } from "../../document/setup-edits.ts";
import { FieldMessage } from "../number/FieldMessage.tsx";
import { Icon } from "../../base/Icon.tsx";
import { Message } from "../../base/Message.tsx";
import { InsertDrawing } from "../../pictures/lathe/InsertDrawing.tsx";
import { goToField } from "../../place/place.ts";
import { isAboutTool } from "../../findings/entry.ts";
import { useFindings } from "../../findings/use-findings.ts";
import type { JobReading } from "../../document/reading.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { showToolNumber } from "../../document/tool-row.ts";
import { useToolList } from "../../document/work-tools.ts";
import { ToolWords } from "./tool-words.tsx";

/** Edge length of the insert drawing, px. */
const DRAWING = 64;

/** The chosen tool, whether it suits the contour, and a suitable tool if not. */
export function ToolSummary({ read, fits }: { readonly read: JobReading; readonly fits: readonly ToolFit[] | null }) {
  const { setup } = useTexts();
  const t = setup.tool;
  const problems = useFindings().filter((p) => isAboutTool(p.at));
  const tool = useToolList().find((each) => each.T === read.job.tool);
  const own = fits?.find((f) => f.tool.T === read.job.tool);
  const best = fits?.find((f) => f.makesContour);
  return (
    <section className="setup-group" aria-label={t.title}>
      <h2>{t.title}</h2>
      {tool && (
        <div className="tool-chosen">
          <InsertDrawing tool={tool} width={DRAWING} height={DRAWING} />
          <ToolWords tool={tool} fit={own} />
        </div>
      )}
      {read.setup?.proposed.has("tool") && (
        <p className="field-hint small soft">
          <span>{setup.proposed}</span>
          <button
            type="button"
            className="button small"
            aria-label={setup.keepLong(t.title, String(read.job.tool))}
            onClick={() => takePlace("tool", String(read.job.tool))}
          >
            {setup.keep}
          </button>
        </p>
      )}
      <div role="status">
        {problems.map((problem, i) => (
          <FieldMessage key={i} problem={problem} decimals={3} />
        ))}
        {own && !own.makesContour && (
          <Message as="div" tone="warning">
            <p>{best ? t.better(best.tool.T, best.tool.NAME) : t.noneMakes}</p>
            {best && (
              <button type="button" className="button" onClick={() => takePlace("tool", String(best.tool.T))}>
                {t.take(best.tool.T)}
              </button>
            )}
          </Message>
        )}
      </div>
      <div className="tool-choices">
        <button type="button" className="button choose-tool" onClick={() => goToField("setup", "tool")}>
          {t.choose} <Icon name="down" />
        </button>
        <button type="button" className="button" onClick={() => showToolNumber(read.job.tool)}>
          <Icon name="insert" /> {t.edit}
        </button>
      </div>
    </section>
  );
}
