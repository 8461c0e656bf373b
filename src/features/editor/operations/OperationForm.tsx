import { useEffect, useMemo, useRef, useState } from "react";
import type { Cycle } from "../../../cycles/define.ts";
import type { Site } from "../../../cycles/shape-request.ts";
import type { InsertTexts } from "../../../i18n/en/insert.ts";
import { diameter, toRadius } from "../../../kernel/units.ts";
import { ncLanguageOf } from "../../../i18n/languages.ts";
import { ncLabels } from "../../../i18n/nc-labels.ts";
import type { Label } from "../../../nc/words.ts";
import { contoursIn } from "../../../program/job/contour-of-text.ts";
import { readRows } from "../../../program/job/contour-rows.ts";
import type { ContourRow, SetJob, SpindleDraft } from "../../../program/job/job.ts";
import {
  contourInMillimetres,
  countsInches,
  draftForProgram,
  typedForProgram,
  typedInMillimetres,
} from "../../../program/edits/program-unit.ts";
import { proposedOperation, sitesOf, usualSurface } from "../../../program/job/proposed-operation.ts";
import { readDraft, type Draft } from "../../../program/job/read-draft.ts";
import { surfacesOf, type StockSurface } from "../../../program/job/stock-surface.ts";
import { useLengths } from "../../../app/calculation/lengths.ts";
import { useFitsOfWork } from "../../../app/calculation/use-tool-fits.ts";
import { lazyPart } from "../../../app/base/parts.ts";
import { Message } from "../../../app/base/Message.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { useSession } from "../../../app/fields/blocks/session.ts";
import { contourSlot } from "../../../app/fields/slots.ts";
import { OPEN_NUMBER } from "./AskedNumber.tsx";
import { SpindleFields, StartFields, arePlaceFieldsUsable } from "./PlaceFields.tsx";
import { addThreadTool } from "../../../app/fields/dialog/thread-blank.ts";
import { hasAngleOf } from "../../../program/tools/thread-tool.ts";
import type { ThreadFill } from "../../../cycles/thread-values.ts";
import type { NamedThread } from "../../../kernel/thread/named-thread.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { designationIn } from "../../../app/fields/dialog/thread-numbers.ts";
import { CrestNote } from "./CrestNote.tsx";
import { fillFor } from "./thread-rows.tsx";
import { StockPlace } from "./StockPlace.tsx";
import { OperationFrame } from "./OperationFrame.tsx";
import { TitleField } from "./TitleField.tsx";
import { ToolChoice } from "./ToolChoice.tsx";
import type { StateBefore } from "./stock-before.ts";
import { UNKNOWN_STOCK } from "./unknown-stock.ts";

const ContourTable = lazyPart(async () => ({ default: (await contourSlot.fetch()).ContourTable }));

/** The values of a job without the sizes of a surface that is not known. */
const emptied = ({ cycle, drafts }: SetJob, placed: Draft): SetJob["drafts"] => ({
  ...drafts,
  [cycle]: { ...drafts[cycle], ...Object.fromEntries(Object.keys(placed).map((q) => [q, ""])) },
});

const typedValues = ({ values }: ThreadFill): Draft =>
  Object.fromEntries(Object.entries(values).map(([q, value]) => [q, String(value)]));
const withValues = (drafts: SetJob["drafts"], cycle: number, values: Draft): SetJob["drafts"] => ({
  ...drafts,
  [cycle]: { ...drafts[cycle], ...values },
});
const withoutValues = (sizes: Draft, values: Draft): Draft =>
  Object.fromEntries(Object.entries(sizes).filter(([q]) => values[q] === undefined));

const listed = (sizes: Draft): string =>
  Object.entries(sizes)
    .map(([q, text]) => `${q} = ${text}`)
    .join(", ");

/** The first field that needs a value, or else the title. */
const firstField = (form: HTMLElement | null): HTMLElement | null | undefined =>
  form?.querySelector<HTMLElement>(OPEN_NUMBER) ?? form?.querySelector<HTMLElement>("input");

/** The surface on which a typed start lies. */
const surfaceAt = (surfaces: readonly StockSurface[], { x = "", z = "" }: TypedStart): StockSurface | undefined =>
  surfaces.find(({ site, from, to }) => {
    const [typed, high, low] =
      site === "face" ? [toRadius(diameter(Number(x))), from.r, to.r] : [Number(z), from.z, to.z];
    return (site === "face" ? x : z).trim() !== "" && typed <= high && typed >= low;
  });

const startForProgram = ({ x, z }: SetJob["start"], inches: boolean): SetJob["start"] => ({
  x: typedForProgram(x, inches),
  z: typedForProgram(z, inches),
});

/** What the form hands over. */
export interface InsertedOperation {
  readonly job: SetJob;
  readonly title: string;
  /** A contour of the program; undefined: the job's own contour is added. */
  readonly contour: Label | undefined;
  /** Sizes to suggest at the open prompts, in the unit of the program. */
  readonly sizes: Draft;
}

interface Props {
  readonly words: InsertTexts;
  readonly cycle: Cycle;
  /** The thread that was named, for a thread cycle. */
  readonly thread: NamedThread | null;
  readonly site: Site;
  readonly before: StateBefore;
  readonly onSite: (site: Site) => void;
  readonly onBack: () => void;
  readonly onInsert: (made: InsertedOperation) => void;
}

/** Start point in the unit of the program, as far as typed; the rest is proposed. */
type TypedStart = Readonly<{ x?: string; z?: string }>;
const UNTYPED: TypedStart = {};
const startInMillimetres = ({ x = "", z = "" }: TypedStart, inches: boolean): SetJob["start"] => ({
  x: typedInMillimetres(x, inches),
  z: typedInMillimetres(z, inches),
});
const NO_ROWS: readonly ContourRow[] = [];

/** Asks where an operation starts, for its contour, start point, spindle and tool. Sizes stay for its prompts. */
export function OperationForm({ words, cycle, thread, site, before, onSite, onBack, onInsert }: Props) {
  const { operations: t } = useTexts();
  const language = useSettings((s) => s.language);
  const program = useSession((s) => s.reading.program);
  const inches = countsInches(program);
  const unit = useLengths().words;
  const form = useRef<HTMLFormElement>(null);
  const [title, setTitle] = useState(
    () => thread?.name.toUpperCase().replace("×", "x") ?? ncLabels(ncLanguageOf(language)).cycleName(cycle.number),
  );
  const [picked, pick] = useState<StockSurface | null>(null);
  const [typed, setTyped] = useState(UNTYPED);
  const [spindle, setSpindle] = useState<SpindleDraft | null>(null);
  const [tool, setTool] = useState<number | null>(null);
  const [rows, setRows] = useState(NO_ROWS);
  const contours = useMemo(() => (cycle.contour === "free" ? contoursIn(program) : []), [cycle, program]);
  const [named, name] = useState<Label | null>(contours[0]?.label ?? null);
  const [waiting, wait] = useState(false);

  const start = useMemo(() => startInMillimetres(typed, inches), [typed, inches]);
  const isKnown = before.stock.length > 0;
  const stock = isKnown ? before.stock : UNKNOWN_STOCK;
  const surfaces = useMemo(() => surfacesOf(stock, site), [stock, site]);
  const surface = useMemo(() => {
    if (picked && surfaces.includes(picked)) return picked;
    const at = surfaceAt(surfaces, start);
    return at ?? usualSurface(cycle, surfaces);
  }, [picked, surfaces, start, cycle]);
  const contourRows = contours.find(({ label }) => label === named)?.rows ?? rows;
  const contour = useMemo(
    () => contourInMillimetres(readRows(contourRows).contour.segments, inches),
    [contourRows, inches],
  );
  const undrawn = cycle.contour === "free" && contour.length === 0;
  const made = useMemo(
    () => surface && proposedOperation(cycle, { stock, surface, before: before.operations, contour, start }),
    [cycle, stock, surface, before.operations, contour, start],
  );
  const fits = useFitsOfWork(made?.likely ?? null);
  const fill = thread && made && fillFor(thread, cycle, site, { ...made.placed, ...made.sizes });
  const ofThread = fill ? typedValues(fill) : {};
  const best = fits?.find((fit) => fit.makesContour && (!thread || hasAngleOf(thread, fit.tool)))?.tool.T ?? null;
  const chosen = tool ?? best;
  const job = made && {
    ...made.job,
    drafts: withValues(isKnown ? made.job.drafts : emptied(made.job, made.placed), cycle.number, ofThread),
    start: isKnown
      ? {
          ...made.job.start,
          ...(typed.x !== undefined && { x: start.x }),
          ...(typed.z !== undefined && { z: start.z }),
        }
      : start,
    spindle: spindle ?? made.job.spindle,
    contour: named === null ? rows : [],
  };
  const shown = job && { ...job, start: { ...startForProgram(job.start, inches), ...typed } };
  const open = (sizes: Draft | undefined) =>
    draftForProgram(cycle, isKnown ? withoutValues(sizes ?? {}, ofThread) : {}, inches);
  const [placed, sizes] = [open(made?.placed), open(made?.sizes)];
  const usable = job !== null && shown !== null && !undrawn && arePlaceFieldsUsable(shown);
  const openQs = made ? readDraft(cycle, job?.drafts[cycle.number] ?? {}).issues.flatMap(({ at }) => at ?? []) : [];
  const unknown = openQs.filter((q) => sizes[q] === undefined);

  const insert = () => {
    if (!usable || chosen === null) return;
    onInsert({ job: { ...job, tool: chosen }, title, contour: named ?? undefined, sizes });
  };
  // Enter may come before the tools are compared.
  useEffect(() => {
    if (waiting && fits) insert();
  });
  useEffect(() => firstField(form.current)?.focus(), []);
  const sites = sitesOf(cycle);

  return (
    <OperationFrame
      form={form}
      isUsable={usable && (fits === null || chosen !== null)}
      onBack={onBack}
      onPut={() => (chosen === null && !fits ? wait(true) : insert())}
    >
      <div className="operation-ask">
        <TitleField title={title} onTitle={setTitle} hint={t.titleHint} />
        {sites.length > 1 && (
          <label>
            <span>{words.site}</span>
            <select
              className="select"
              value={site}
              onChange={(event) => {
                const next = sites.find((each) => each === event.target.value);
                if (next) onSite(next);
              }}
            >
              {sites.map((each) => (
                <option key={each} value={each}>
                  {words.sites[each]}
                </option>
              ))}
            </select>
          </label>
        )}
        {!isKnown && (
          <Message tone="info" className="wide">
            {words.noStock}
          </Message>
        )}
        {isKnown && !surface && (
          <Message tone="warning" className="wide">
            {words.none[site]}
          </Message>
        )}
        {isKnown && surface && (
          <StockPlace
            words={words}
            stock={stock}
            surfaces={surfaces}
            chosen={surface}
            onChoose={(next) => {
              pick(next);
              setTyped(UNTYPED);
            }}
          />
        )}
        {contours.length > 0 && (
          <label>
            <span>{words.contour}</span>
            <select
              className="select"
              value={contours.findIndex(({ label }) => label === named)}
              onChange={(event) => name(contours[Number(event.target.value)]?.label ?? null)}
            >
              {contours.map(({ label }, i) => (
                <option key={i} value={i}>
                  {words.label(String(label))}
                </option>
              ))}
              <option value={-1}>{words.draw}</option>
            </select>
          </label>
        )}
        {shown && (
          <>
            <StartFields
              start={shown.start}
              unit={unit}
              onStart={(axis, text) => setTyped({ ...typed, [axis]: text })}
            />
            <SpindleFields spindle={shown.spindle} onSpindle={setSpindle} />
          </>
        )}
      </div>
      {cycle.contour === "free" && named === null && (
        <section aria-label={words.contour}>
          {undrawn && <p className="soft">{words.undrawn}</p>}
          <ContourTable rows={rows} onChange={setRows} language={language} inches={inches} />
        </section>
      )}
      {made && (
        <p className="small operation-sizes" role="status">
          {thread && fill && (
            <span>
              {words.fromThread(designationIn(language, thread.name), listed(draftForProgram(cycle, ofThread, inches)))}
            </span>
          )}
          {listed(placed) !== "" && <span>{words.fromSurface(listed(placed))}</span>}
          {listed(sizes) !== "" && <span>{words.fromStock(listed(sizes))}</span>}
          {unknown.length > 0 && <span className="soft">{words.open(unknown.join(", "))}</span>}
        </p>
      )}
      {thread && fill && surface && isKnown && <CrestNote words={words} fill={fill} surface={surface} />}
      {fits && best === null && (
        <Message tone="warning">
          {thread ? words.noThreadTool(formatNumber(language, thread.angle)) : words.noTool}
          {thread && fill && (
            <button type="button" className="button small" onClick={() => setTool(addThreadTool(thread, fill))}>
              {words.addThreadTool}
            </button>
          )}
        </Message>
      )}
      <ToolChoice
        fits={fits}
        taken={chosen === null ? null : String(chosen)}
        folded={words.unsuitable}
        onTake={setTool}
      />
    </OperationFrame>
  );
}
