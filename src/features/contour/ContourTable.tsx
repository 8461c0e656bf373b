import { KeysButton } from "../../app/fields/keys/KeysButton.tsx";
import {
  memo,
  useCallback,
  useEffect,
  useEffectEvent,
  useLayoutEffect,
  useRef,
  useState,
  type CSSProperties,
} from "react";
import { pageLength } from "../../app/base/unit.ts";
import { useSize } from "../../app/pictures/help/use-size.ts";
import { texts } from "../../app/base/settings/loaded-texts.ts";
import type { Language } from "../../i18n/languages.ts";
import type { RowIssue } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { undercutPlace } from "../../program/job/undercut-place.ts";
import { useLengths } from "../../app/calculation/lengths.ts";
import { useReading } from "./begun-field.ts";
import { ContourDrawing } from "./ContourDrawing.tsx";
import { ContourLine } from "./ContourLine.tsx";
import { BLOCK, RowBlock } from "./RowBlock.tsx";
import { RowTools } from "./RowTools.tsx";
import { chooseElement, useChosenRow, useContourPlace } from "../../app/place/contour-place.ts";
import { offerTarget, type ContourTarget } from "../../app/document/drawing-request.ts";
import { FIRST_FOCUS } from "../../app/base/focus-guard.ts";
import { cornerOf, cornerRowOf, undercutBehind, type CornerKind } from "./drawing-edits.ts";
import { FaultList } from "./FaultList.tsx";
import { OpenDrawing } from "./OpenDrawing.tsx";
import { changed, withDuplicatedRow, withRow, withRowMoved, withoutRow, type Edited } from "./row-edits.ts";
import { useRowFocus, useTableKeys, type RowActions } from "./use-table-keys.ts";
import "./contour.css";

interface Props {
  readonly rows: readonly ContourRow[];
  /** `place` names the field, so that typing is one step of undo; null for a separate step. */
  readonly onChange: (rows: readonly ContourRow[], place: string | null) => void;
  readonly language: Language;
  /** The drawing is on the large canvas, not here. */
  readonly isDrawingElsewhere?: boolean;
  /** The numbers are inches. */
  readonly inches?: boolean;
}

/** A start point and two elements have a corner; from then on the table itself shows how a contour is written. */
const FIRST_CORNER = 3;
/** From this many elements on, drawing and table get a digit after it is painted. */
const LONG = 100;
/** Until it is measured. */
const NO_BAR = { width: 0, height: 0 };
const NO_ISSUES: readonly RowIssue[] = [];

/** The contour subprogram as a table, with its drawing unless that is on the large canvas. */
export const ContourTable = memo(Table);

function Table({ rows, onChange, language, isDrawingElsewhere = false, inches = false }: Props) {
  const t = texts(language).contour;
  const table = useRef<HTMLTableElement>(null),
    bar = useRef<HTMLDivElement>(null),
    { height: barHeight } = useSize(bar, NO_BAR);
  const active = useChosenRow(rows),
    activeId = active === null ? null : (rows[active]?.id ?? null);
  const asked = useContourPlace((p) => p.keyboard);
  const [fresh, setFresh] = useState<string | null>(null);
  const [said, setSaid] = useState({ text: "", times: 0 });
  /** Announces an edit, also if the same one is repeated. */
  const say = (text: string) => setSaid((old) => ({ text, times: old.times + 1 }));
  const reading = useReading(rows),
    { per } = useLengths();
  const focusRow = useRowFocus(table);
  /** The newest rows: a digit just typed is not rendered yet. */
  const now = useRef({ rows, onChange });
  useLayoutEffect(() => {
    now.current = { rows, onChange };
  }, [rows, onChange]);
  const changeRow = useCallback((id: string, change: Partial<ContourRow>, place: string | null) => {
    const next = changed(now.current.rows, id, change);
    now.current = { ...now.current, rows: next };
    now.current.onChange(next, place);
  }, []);
  const issues = new Map<number, RowIssue[]>();
  for (const found of reading.issues) issues.set(found.row, [...(issues.get(found.row) ?? []), found]);
  const uses = rows.some((r) => r.angle !== "" || r.length !== "" || r.tangent);
  const [wanted, setWanted] = useState(uses);
  const details = wanted || uses;

  const edit = (edited: Edited, done: string, field?: string) => {
    if (edited.rows === rows) return;
    focusRow(edited.focus, field);
    if (edited.focus !== null) chooseElement(edited.focus);
    say(done);
    onChange(edited.rows, null);
  };
  /** An edit in the drawing leaves focus where it is: focusing a field would scroll the drawing away. */
  const drawn = (edited: Edited) => {
    chooseElement(edited.focus);
    say(t.done.added);
    onChange(edited.rows, null);
  };
  const actions: RowActions = {
    add: () => edit(withRow(rows, rows.length), t.done.added),
    insert: () => edit(withRow(rows, active ?? rows.length), t.done.added),
    duplicate: () => active !== null && edit(withDuplicatedRow(rows, active), t.done.duplicated),
    remove: () => active !== null && edit(withoutRow(rows, active), t.done.removed),
    move: (by) => active !== null && edit(withRowMoved(rows, active, by), t.done.moved, fieldInUse(table.current)),
  };
  const target = (): ContourTarget => ({
    count: now.current.rows.length,
    inches,
    take: (taken) => edit({ rows: taken, focus: taken[0]?.id ?? null }, t.done.taken(taken.length)),
  });
  const offered = useEffectEvent(target);
  useEffect(() => offerTarget(() => offered()), []);
  const cornerRow = cornerRowOf(rows, active);
  const corner = (kind: CornerKind) => {
    const edited = cornerOf(now.current.rows, active, kind);
    if (edited) edit(edited, t.done.added, "r");
  };
  const undercut = () => {
    const made = cornerRow === null ? null : undercutBehind(now.current.rows, cornerRow);
    if (!made) return;
    setFresh(made.focus);
    if (made.rows === rows) focusRow(made.focus, "undercut");
    else edit(made, t.done.added, "form");
  };
  const onKeyDown = useTableKeys(table, { ...actions, corner });
  const pick = (row: number) => {
    const id = rows[row]?.id;
    if (id === undefined) return;
    focusRow(id);
    chooseElement(id);
    say("");
  };
  const called = useEffectEvent(() => {
    focusRow(activeId);
    setSaid((old) => ({ ...old, text: "" }));
  });
  const answered = useRef(asked);
  useEffect(() => {
    if (asked === answered.current) return;
    answered.current = asked;
    called();
  }, [asked]);
  useEffect(() => {
    table.current?.querySelector("tr.active")?.scrollIntoView?.({ block: "nearest" });
  }, [activeId, rows.length]);

  const blocks = Array.from({ length: Math.ceil(rows.length / BLOCK) }, (_, k) => k * BLOCK);
  const lineOf = (row: ContourRow, i: number) => (
    <ContourLine
      key={row.id}
      row={row}
      number={i + 1}
      reading={reading.rows[i]}
      undercut={row.kind === "UDC" ? undercutPlace(reading.rows, i, per) : null}
      isNew={row.id === fresh}
      issues={issues.get(i) ?? NO_ISSUES}
      active={row.id === activeId}
      details={details}
      language={language}
      isLong={rows.length > LONG}
      onChange={changeRow}
    />
  );

  return (
    <section className="contour-editor" aria-label={t.title}>
      <div className="contour-layout">
        {!isDrawingElsewhere && (
          <div className="contour-side">
            <ContourDrawing
              rows={rows}
              reading={reading}
              active={active}
              language={language}
              onPick={(row) => chooseElement(rows[row]?.id ?? null)}
              onRows={onChange}
              onEdited={drawn}
            />
            <FaultList issues={reading.issues} language={language} onPick={pick} />
          </div>
        )}
        <div
          className="contour-fields"
          style={{ "--contour-bar": pageLength(barHeight) } as CSSProperties}
          {...{ [FIRST_FOCUS]: "" }}
        >
          <RowTools
            bar={bar}
            number={active === null ? null : active + 1}
            count={rows.length}
            actions={actions}
            language={language}
            details={details}
            corner={cornerRow === null ? null : cornerRow + 1}
            onCorner={corner}
            onUndercut={undercut}
            onDetails={() => setWanted(!details)}
          >
            <OpenDrawing />
            <KeysButton place="contourTable" />
          </RowTools>
          {details && <p className="small soft">{t.detailsAbout}</p>}
          {rows.length === 0 ? (
            <p className="soft">{t.empty}</p>
          ) : (
            <table
              role="table"
              ref={table}
              aria-label={t.table}
              aria-rowcount={rows.length + 1}
              className="contour-table"
              data-keys="contourTable"
              onKeyDown={onKeyDown}
            >
              <thead role="rowgroup">
                <tr role="row">
                  <th role="columnheader" scope="col">
                    {t.head.number}
                  </th>
                  <th role="columnheader" scope="col">
                    {t.head.element}
                  </th>
                  <th role="columnheader" scope="col">
                    {t.head.x}
                  </th>
                  <th role="columnheader" scope="col">
                    {t.head.z}
                  </th>
                  <th role="columnheader" scope="col" className="wide">
                    {t.head.size}
                  </th>
                  <th role="columnheader" scope="col" className="wide">
                    {t.head.turn}
                  </th>
                </tr>
              </thead>
              {blocks.map((from) => (
                <RowBlock
                  key={from}
                  count={Math.min(BLOCK, rows.length - from)}
                  inUse={(active ?? 0) >= from - 1 && (active ?? 0) <= from + BLOCK}
                  rows={() => rows.slice(from, from + BLOCK).map((row, k) => lineOf(row, from + k))}
                />
              ))}
            </table>
          )}
          {rows.length < FIRST_CORNER && <p className="small soft">{t.intro}</p>}
          <p role="status" className="unseen">
            <span key={said.times}>{said.text}</span>
          </p>
        </div>
      </div>
    </section>
  );
}

/** The focused field, so that focus follows its row when the row moves. */
function fieldInUse(table: HTMLElement | null): string | undefined {
  const at = document.activeElement;
  return at instanceof HTMLElement && table?.contains(at) ? at.dataset["field"] : undefined;
}
