import { useMemo } from "react";
import type { SheetTexts } from "../../i18n/en/sheet.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Mill } from "../../program/tools/plane-types.ts";
import type { SetupData, SheetTool } from "../../report/sheet/setup-data.ts";
import { millPicture, toolPicture } from "../../view/sheet/tool-picture.ts";
import type { SheetWords } from "./sheet-words.ts";

/** The picture of a tool, mm on paper. */
const SIZE = { wide: 18, tall: 9 } as const;
/** Half the cross at the theoretical tip, mm on paper. */
const CROSS = 1;

function Picture({
  tool,
  mill,
  t,
}: {
  readonly tool: Tool | null;
  readonly mill: Mill | null;
  readonly t: SheetTexts["tool"];
}) {
  const picture = useMemo(() => (tool ? toolPicture(tool, SIZE) : mill ? millPicture(mill, SIZE) : null), [tool, mill]);
  if (!picture) return <span className="sheet-soft">–</span>;
  const { tip, scale } = picture;
  return (
    <span className="sheet-tool-picture">
      <svg
        viewBox={`0 0 ${SIZE.wide} ${SIZE.tall}`}
        aria-hidden="true"
        style={{ width: `${SIZE.wide}mm`, height: `${SIZE.tall}mm` }}
      >
        {picture.holder && <path className="sheet-holder" d={picture.holder} />}
        <path className="sheet-insert" d={picture.insert} />
        <path
          className="sheet-tip"
          d={`M${tip.x - CROSS} ${tip.y}h${CROSS + CROSS}M${tip.x} ${tip.y - CROSS}v${CROSS + CROSS}`}
        />
      </svg>
      <span className="sheet-small">{t.scale(scale.paper, scale.part)}</span>
    </span>
  );
}

const COLUMNS = [
  "TO",
  "RS",
  "T-ANGLE",
  "P-ANGLE",
  "CUTLENGTH",
  "CUTWIDTH",
  "ZL",
  "XL",
  "DZL",
  "DXL",
  "DYL",
  "DRS",
  "R",
  "PITCH",
] as const;
const MILL_COLUMNS = ["R", "DR", "T-ANGLE", "LCUTS", "PITCH"] as const;
/** Columns that print 0, too; the others print only other values. */
const ALWAYS: readonly string[] = ["TO", "RS", "R"];

function cells(tool: SheetTool, words: SheetWords): readonly string[] {
  const said = (name: string, value: unknown) =>
    typeof value === "number" && (value !== 0 || ALWAYS.includes(name)) ? [`${name} ${words.number(value)}`] : [];
  if (tool.tool) return COLUMNS.flatMap((name) => said(name, tool.tool?.[name]));
  if (tool.mill) return MILL_COLUMNS.flatMap((name) => said(name, tool.mill?.[name]));
  const { defined } = tool;
  return defined ? ["TOOL DEF", ...said("L", defined.length), ...said("R", defined.radius)] : [];
}

const functionsText = (all: readonly number[]): string => all.map((m) => `M${m}`).join(" ");

/** The tools in the order in which they are first called. */
export function SheetTools({
  data,
  t,
  words,
}: {
  readonly data: SetupData;
  readonly t: SheetTexts;
  readonly words: SheetWords;
}) {
  if (data.tools.length === 0) return <p className="sheet-soft">{t.noTools}</p>;
  const heads = t.tool;
  return (
    <>
      <table className="sheet-table sheet-tools">
        <thead>
          <tr>
            {(
              ["number", "picture", "name", "data", "holder", "overhang", "spindle", "operations", "place"] as const
            ).map((name) => (
              <th key={name} scope="col">
                {heads[name]}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {data.tools.map((each, index) => {
            const { tool, mill, called, spindle, coolant } = each,
              known = tool ?? mill;
            const used = data.operations.flatMap(({ tool: own }, i) => (own === index ? [i + 1] : []));
            return (
              <tr key={index}>
                <th scope="row" className="sheet-big">
                  {known ? words.number(known.T) : called}
                </th>
                <td>
                  <Picture tool={tool} mill={mill} t={heads} />
                </td>
                <td>
                  {known ? <b>{known.NAME || "–"}</b> : <b>{heads.unknown}</b>}
                  {known && <br />}
                  {tool ? t.types[tool.TYPE] : mill ? t.types[mill.TYPE ?? "mill"] : null}
                </td>
                <td className="sheet-cells">
                  {cells(each, words).map((cell) => (
                    <span key={cell}>{cell}</span>
                  ))}
                </td>
                <td>
                  {tool?.holder ? (
                    `${words.number(tool.holder.width)} × ${words.number(tool.holder.length)}`
                  ) : (
                    <i>{heads.unknown}</i>
                  )}
                </td>
                <td>
                  <span className="sheet-line" />
                </td>
                <td>{functionsText([...new Set([...spindle, ...coolant])]) || "–"}</td>
                <td>{used.join(", ")}</td>
                <td>
                  <span className="sheet-line" />
                </td>
              </tr>
            );
          })}
        </tbody>
      </table>
      <p className="sheet-small">{t.toolNote}</p>
    </>
  );
}
