import { useRef } from "react";
import { Drawing } from "../../../app/fields/chooser/Drawing.tsx";
import { PartPicture } from "../../../app/fields/kept/PartPicture.tsx";
import { menuCycle } from "../../../app/fields/chooser/menu.ts";
import { chooseOpenBlock } from "../../../app/fields/blocks/choose-block.ts";
import { openBlock } from "../../../app/fields/blocks/session.ts";
import { Icon, type IconName } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
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

/** Marks the drop place; none for null. */
function markPlace(list: Element | null, to: number | null): void {
  [...(list?.children ?? [])].forEach((item, i) => item.classList.toggle("is-target", i === to));
}

/** Index of the place under the pointer. */
function placeAt(list: Element | null, y: number): number {
  const items = [...(list?.children ?? [])];
  const found = items.findIndex((item) => y < item.getBoundingClientRect().bottom);
  return found < 0 ? items.length - 1 : found;
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
    <li ref={item} className={`operation${row.isOff ? " is-off" : ""}`} aria-current={isCurrent ? "step" : undefined}>
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
          <ol className="operation-blocks" aria-label={words.blocksOf(title)}>
            {row.blocks.map((block) => (
              <li key={block.index}>
                <button
                  type="button"
                  className="number operation-block"
                  aria-current={block.index === index ? "true" : undefined}
                  onClick={() => {
                    openBlock(block.index);
                    chooseOpenBlock();
                  }}
                >
                  <span className="soft">{block.number}</span> <span>{block.text}</span>
                </button>
              </li>
            ))}
          </ol>
        </>
      )}
    </li>
  );
}
