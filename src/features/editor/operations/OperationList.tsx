import { useEffect, useMemo, useRef, useState, type KeyboardEvent, type ReactNode } from "react";
import type { Refusal } from "../../../program/edits/operation-edits.ts";
import { openBlock, useSession } from "../../../app/fields/blocks/session.ts";
import { chooseOpenBlock } from "../../../app/fields/blocks/choose-block.ts";
import { isUpToDate } from "../../../app/fields/blocks/up-to-date.ts";
import { useOutcome } from "../../../app/calculation/outcome.ts";
import { useShownOtherFile } from "../../../app/document/shown-file.ts";
import { findingsHere } from "../../../app/document/shown-findings.ts";
import { useListed } from "../../../app/findings/use-findings.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { LongList } from "../../../app/base/LongList.tsx";
import { lazyPart } from "../../../app/base/parts.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { useToolList } from "../../../app/document/work-tools.ts";
import {
  duplicateOperation,
  moveOperation,
  finishOperation,
  removeOperation,
  retoolOperation,
  switchOperation,
} from "./change-operation.ts";
import { askForOperation } from "../../../app/document/inserting.ts";
import { operationRows, type OperationRow } from "../../../app/fields/blocks/operation-rows.ts";
import { OperationItem, unitOf, type OperationAct } from "./OperationItem.tsx";
import { titleOf } from "../../../app/fields/blocks/words.ts";
import "./operations.css";

const ToolDialog = lazyPart(async () => ({ default: (await import("./ToolDialog.tsx")).ToolDialog }));

const isSame = (a: OperationRow, b: OperationRow): boolean =>
  a.title === b.title && a.tool === b.tool && String(a.cycles) === String(b.cycles);

/** The rows with the results known last, while those of the present text are calculated: the list keeps its height. */
function useLastResults(rows: readonly OperationRow[], isCalculated: boolean): readonly OperationRow[] {
  const [last, keep] = useState(rows);
  if (isCalculated && last !== rows) keep(rows);
  return useMemo(
    () =>
      isCalculated ? rows : rows.map((row) => ({ ...row, done: last.find((each) => isSame(each, row))?.done ?? null })),
    [rows, last, isCalculated],
  );
}

/** The operations of the shown text, each with its actions. */
export function OperationList({ filter }: { readonly filter: ReactNode }) {
  const t = useTexts();
  const words = t.operations;
  const program = useSession((s) => s.reading.program);
  const index = useSession((s) => s.index);
  const newest = useOutcome((s) => s.newest);
  const outcome = isUpToDate(newest) ? newest : null;
  const file = useShownOtherFile();
  const listed = useListed();
  const tools = useToolList();
  const read = useMemo(
    () => operationRows(program, { outcome, file, entries: findingsHere(listed, file), tools }),
    [program, outcome, file, listed, tools],
  );
  const rows = useLastResults(read, outcome !== null);
  const [folded, fold] = useState(false);
  const [refused, refuse] = useState<Refusal | null>(null);
  const [retooled, retool] = useState<{ readonly row: OperationRow; readonly finishes: boolean } | null>(null);
  const list = useRef<HTMLDivElement>(null);
  const goTo = useRef<number | null>(null);
  const current = rows.findLast(({ from, to }) => index >= from && index < to)?.unit ?? -1;

  const head = (unit: number) => list.current?.querySelector<HTMLElement>(`[data-unit="${unit}"] .operation-open`);
  useEffect(() => {
    if (goTo.current === null) return;
    head(Math.min(goTo.current, rows.length - 1))?.focus();
    goTo.current = null;
  }, [rows]);

  const tell = (found: Refusal | null, focus: number) => {
    refuse(found);
    if (!found) goTo.current = focus;
  };
  const act = (row: OperationRow, what: OperationAct) => {
    const { unit } = row;
    switch (what) {
      case "open":
        if (unit === current) fold(!folded);
        else {
          fold(false);
          openBlock(row.opens);
          chooseOpenBlock();
        }
        return;
      case "insert":
        return askForOperation(unit);
      case "duplicate":
        return tell(duplicateOperation(unit), unit + 1);
      case "up":
      case "down": {
        const to = unit + (what === "up" ? -1 : 1);
        return to < 0 || to >= rows.length ? undefined : tell(moveOperation(unit, to), to);
      }
      case "switch":
        return tell(switchOperation(unit), unit);
      case "retool":
      case "finish":
        return retool({ row, finishes: what === "finish" });
      case "remove":
        return tell(removeOperation(unit), unit);
    }
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const row = rows[unitOf((event.target as HTMLElement).closest("[data-unit]")) ?? -1];
    if (!row || event.ctrlKey || event.metaKey || !(event.target as HTMLElement).matches(".operation-open")) return;
    const way = event.key === "ArrowUp" ? -1 : event.key === "ArrowDown" ? 1 : 0;
    if (way === 0 && event.key !== "Delete") return;
    event.preventDefault();
    if (event.key === "Delete") act(row, "remove");
    else if (event.altKey) act(row, way < 0 ? "up" : "down");
    else head(row.unit + way)?.focus();
  };

  const why =
    refused &&
    (refused.refused === "parameter"
      ? words.refused.parameter(refused.unit + 1, refused.parameter ?? "")
      : words.refused[refused.refused](refused.unit + 1));
  return (
    <div className="operations">
      <div className="operations-top">
        {filter}
        <button
          type="button"
          className={`button${rows.length === 0 ? " primary" : ""}`}
          aria-label={words.insert}
          onClick={() => askForOperation(rows.length === 0 ? null : current >= 0 ? current : rows.length - 1)}
        >
          <Icon name="add" /> {rows.length === 0 ? words.insert : t.editor.insert}
        </button>
      </div>
      <p role="status" className="operations-status small">
        {why !== null && (
          <>
            <Icon name="warning" /> {why}
          </>
        )}
      </p>
      {rows.length === 0 && <p className="soft structure-empty">{words.none}</p>}
      <div ref={list} className="operations-list">
        <LongList
          aria-label={words.list}
          aria-busy={outcome === null}
          onKeyDown={onKeyDown}
          isOrdered
          all={rows}
          around={current}
          more={words.more}
          earlier={words.earlier}
          row={(row) => (
            <OperationItem
              key={row.unit}
              row={row}
              last={row.unit === rows.length - 1}
              isCurrent={row.unit === current}
              isOpen={row.unit === current && !folded}
              index={index}
              onAct={(what) => act(row, what)}
              onDrop={(to) => to !== row.unit && tell(moveOperation(row.unit, to), to)}
            />
          )}
        />
      </div>
      {retooled && (
        <ToolDialog
          title={titleOf(t, retooled.row)}
          taken={retooled.finishes ? null : retooled.row.tool}
          line={retooled.row.opens}
          finishes={retooled.finishes}
          done={() => retool(null)}
          onTake={(tool) => {
            const { unit } = retooled.row;
            if (retooled.finishes) tell(finishOperation(unit, tool), unit + 1);
            else tell(retoolOperation(unit, tool), unit);
          }}
        />
      )}
    </div>
  );
}
