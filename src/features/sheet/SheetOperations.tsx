import type { SheetTexts } from "../../i18n/en/sheet.ts";
import type { SetupData } from "../../report/sheet/setup-data.ts";
import { titleOf } from "../../app/fields/blocks/words.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import type { SheetWords } from "./sheet-words.ts";

const NAMES = ["number", "name", "block", "tool", "start", "speed", "feed", "passes", "time"] as const;

/** The operations in order, with their times. */
export function SheetOperations({
  data,
  t,
  words,
}: {
  readonly data: SetupData;
  readonly t: SheetTexts;
  readonly words: SheetWords;
}) {
  const texts = useTexts();
  if (data.operations.length === 0) return <p className="sheet-soft">{t.noOperations}</p>;
  return (
    <table className="sheet-table sheet-operations">
      <thead>
        <tr>
          {NAMES.map((name) => (
            <th key={name} scope="col">
              {t.operation[name]}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {data.operations.map((each, i) => {
          const tool = each.tool === null ? undefined : data.tools[each.tool];
          const called = tool?.tool ?? tool?.mill;
          return (
            <tr key={i} className={each.isOff ? "sheet-off" : undefined}>
              <th scope="row">{i + 1}</th>
              <td>
                <b>{titleOf(texts, each)}</b>
                {each.title !== null && each.cycles.length > 0 && `\u00a0· ${each.cycles.join(", ")}`}
                {each.isOff && <i>({t.off})</i>}
              </td>
              <td>{each.block ?? "–"}</td>
              <td>{tool ? `T${called ? words.number(called.T) : tool.called}` : "–"}</td>
              <td className="sheet-start">{each.start ? words.start(each.start) : "–"}</td>
              <td>{words.spindle(each.spindle) || "–"}</td>
              <td>{words.feeds(each.feeds) || "–"}</td>
              <td>{each.passes > 0 ? each.passes : "–"}</td>
              <td>{each.seconds > 0 ? words.time(each.seconds) : "–"}</td>
            </tr>
          );
        })}
      </tbody>
      <tbody className="sheet-total">
        <tr>
          <th scope="row" colSpan={7}>
            {t.total} <span className="sheet-small">({t.totalNote})</span>
          </th>
          <td>{data.operations.reduce((sum, { passes }) => sum + passes, 0) || "–"}</td>
          <td>{data.seconds > 0 ? words.time(data.seconds) : "–"}</td>
        </tr>
      </tbody>
    </table>
  );
}
