import { useTexts } from "../../base/settings/use-texts.ts";
import type { ToolKind } from "../../place/place.ts";

/** The tables of this device: two kinds of tools, and the operator's own cycles. */
export function TableTabs({
  open,
  onTools,
  onOwn,
}: {
  readonly open: ToolKind | "own";
  readonly onTools: (kind: ToolKind) => void;
  readonly onOwn: () => void;
}) {
  const { tools: t } = useTexts("tables");
  const { page } = useTexts();
  return (
    <div className="tool-kinds" role="group" aria-label={t.kinds.name}>
      {(["turning", "milling"] as const).map((each) => (
        <button key={each} type="button" className="button" aria-pressed={each === open} onClick={() => onTools(each)}>
          {t.kinds[each]}
        </button>
      ))}
      <button type="button" className="button" aria-pressed={open === "own"} onClick={onOwn}>
        {page.own.title}
      </button>
    </div>
  );
}
