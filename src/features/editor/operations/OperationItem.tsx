import { useMemo, useRef } from "react";
import { Drawing } from "../../../app/fields/chooser/Drawing.tsx";
import { PartPicture } from "../../../app/fields/kept/PartPicture.tsx";
import { menuCycle } from "../../../app/fields/chooser/menu.ts";
import { chooseOpenBlock } from "../../../app/fields/blocks/choose-block.ts";
import { firstLine } from "../../../app/fields/blocks/program-parts.ts";
import { openBlock, useSession } from "../../../app/fields/blocks/session.ts";
import { Icon, type IconName } from "../../../app/base/Icon.tsx";
import { LongList } from "../../../app/base/LongList.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { blockNumbers } from "../../../nc/program.ts";
import { InsertDrawing } from "../../../app/pictures/lathe/InsertDrawing.tsx";
import { useLengths } from "../../../app/calculation/lengths.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import type { OperationRow } from "../../../app/fields/blocks/operation-rows.ts";
import { cycleWords, doneWords, titleOf } from "../../../app/fields/blocks/words.ts";

export type OperationAct = "open" | "insert" | "duplicate" | "up" | "down" | "switch" | "retool" | "finish" | "remove";

/** Edge length of the drawing of a tool, px. */
const DRAWING = 32;

interface Props {
  readonly row: OperationRow;
  readonly last: boolean;
  /** The open block belongs to this operation. */
  readonly isCurrent: boolean;
  /** Its blocks and actions are unfolded. */
  readonly isOpen: boolean;
  readonly index: number;
  readonly onAct: (what: OperationAct) => void;
  /** It was dropped at the place of another one. */
  readonly onDrop: (to: number) => void;
}

/** The operation of an entry of the list. */
export const unitOf = (item: Element | null): number | null =>
  item instanceof HTMLElement ? Number(item.dataset["unit"]) : null;

/** Marks the drop place; none for null. */
function markPlace(list: Element | null, to: number | null): void {
  for (const item of list?.children ?? []) item.classList.toggle("is-target", unitOf(item) === to);
}

/** The operation under the pointer. */
function placeAt(list: Element | null, y: number): number {
  const items = [...(list?.children ?? [])];
  return unitOf(items.find((item) => y < item.getBoundingClientRect().bottom) ?? items.at(-1) ?? null) ?? 0;
}

/** The blocks of an operation; the open one is among those shown. */
function OperationBlocks({
  row: { from, to },
  title,
  index,
}: Pick<Props, "row" | "index"> & { readonly title: string }) {
  const words = useTexts().operations;
  const program = useSession((s) => s.reading.program);
  const all = useMemo(
    () => program.blocks.slice(from, to).flatMap((block, i) => (block.statement.kind === "empty" ? [] : [from + i])),
    [program, from, to],
  );
  return (
    <LongList
      className="operation-blocks"
      aria-label={words.blocksOf(title)}
      isOrdered
      all={all}
      around={all.indexOf(index)}
      more={words.more}
      earlier={words.earlier}
      row={(at) => (
        <li key={at}>
          <button
            type="button"
            className="number operation-block"
            aria-current={at === index ? "true" : undefined}
            onClick={() => {
              openBlock(at);
              chooseOpenBlock();
            }}
          >
            <span className="soft">{blockNumbers(program)[at]}</span>{" "}
            <span>{firstLine(program.blocks[at]?.raw ?? "")}</span>
          </button>
        </li>
      )}
    />
  );
}

/** One operation: its name, results, actions and blocks. */
export function OperationItem({ row, last, isCurrent, isOpen, index, onAct, onDrop }: Props) {
  const t = useTexts();
  const words = t.operations;
  const lengths = useLengths();
  const item = useRef<HTMLLIElement>(null);
  const title = titleOf(t, row);
  const cycle = row.cycles[0] === undefined ? undefined : menuCycle(row.cycles[0]);
  const tool = row.tool === null ? words.noTool : `${words.tool(row.tool)}${row.known ? ` ${row.known.NAME}` : ""}`;
  const ran = row.done ? doneWords(t, lengths, row.done) : "";
  const off = row.isOff ? words.off : "";
  const found = row.findings ? words.findings(row.findings.count) : "";
  const name = [words.name(row.unit + 1, title), tool, row.isOff ? off : ran, found]
    .filter((each) => each !== "")
    .join(", ");
  const button = (icon: IconName, what: OperationAct, text: string, disabled = false) => (
    <button type="button" className="button" disabled={disabled} onClick={() => onAct(what)}>
      <Icon name={icon} /> <span>{text}</span>
    </button>
  );
  const tied = row.tie !== null;
  const endDrag = () => {
    item.current?.classList.remove("is-dragged");
    markPlace(item.current?.parentElement ?? null, null);
  };
  return (
    <li
      ref={item}
      data-unit={row.unit}
      className={`operation${row.isOff ? " is-off" : ""}`}
      aria-current={isCurrent ? "step" : undefined}
    >
      <div className="operation-head">
        <button
          type="button"
          className="operation-open"
          aria-expanded={isOpen}
          aria-label={name}
          onClick={() => onAct("open")}
        >
          <span className="number operation-number">{row.unit + 1}</span>
          <span className="pictograms">
            {row.path ? (
              <PartPicture of={row.path} />
            ) : (
              <Drawing of={cycle?.pictograms[0]} id={`op${row.unit}`} turned={cycle?.group === "transverse"} />
            )}
          </span>
          <span className="operation-words">
            <b>{title}</b>
            {row.title !== null && row.cycles.length > 0 && (
              <span className="small soft">{row.cycles.map((each) => cycleWords(t, each)).join(" · ")}</span>
            )}
            <span className="small soft">
              {row.inherits && row.tool !== null ? `${tool} · ${words.inherits}` : tool}
            </span>
            {/* The line is there before its result: the operations below stay put. */}
            <span className="small operation-done">{off || ran}</span>
          </span>
          {row.findings && (
            <span className={`operation-findings ${row.findings.severity}`}>
              <Icon name={row.findings.severity} /> <span className="number">{row.findings.count}</span>
            </span>
          )}
          {row.known && !row.findings && <InsertDrawing tool={row.known} width={DRAWING} height={DRAWING} />}
        </button>
        {!tied && (
          <span
            className="operation-grip"
            aria-hidden="true"
            title={words.drag}
            onPointerDown={(event) => {
              event.currentTarget.setPointerCapture(event.pointerId);
              item.current?.classList.add("is-dragged");
            }}
            onPointerMove={(event) => {
              const list = item.current?.classList.contains("is-dragged") ? item.current.parentElement : null;
              if (list) markPlace(list, placeAt(list, event.clientY));
            }}
            onPointerUp={(event) => {
              if (!item.current?.classList.contains("is-dragged")) return;
              endDrag();
              onDrop(placeAt(item.current.parentElement, event.clientY));
            }}
            onPointerCancel={endDrag}
          >
            ⠿
          </span>
        )}
      </div>
      {isOpen && (
        <>
          <div className="operation-tools" role="group" aria-label={words.actions(title)}>
            <button
              type="button"
              className="button"
              aria-label={words.insertBehind(title)}
              onClick={() => onAct("insert")}
            >
              <Icon name="add" /> <span>{words.put}</span>
            </button>
            {button("copy", "duplicate", words.duplicate, tied)}
            {button("raise", "up", words.up, tied || row.unit === 0)}
            {button("lower", "down", words.down, tied || last)}
            {button(row.isOff ? "check" : "close", "switch", row.isOff ? words.switchOn : words.switchOff, tied)}
            {row.canBeFinished && button("check", "finish", words.finish, tied)}
            {button("insert", "retool", words.retool, row.tie === "label" || row.tie === "tool")}
            {button("remove", "remove", words.remove, tied)}
          </div>
          {row.tie && (
            <Message tone="info" className="small operation-tie">
              {words.ties[row.tie]}
            </Message>
          )}
          <OperationBlocks row={row} title={title} index={index} />
        </>
      )}
    </li>
  );
}
