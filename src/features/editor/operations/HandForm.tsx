import { useEffect, useMemo, useRef, useState } from "react";
import { catalogue } from "../../../cycles/index.ts";
import type { Site } from "../../../cycles/shape-request.ts";
import type { InsertTexts } from "../../../i18n/en/insert.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import { length } from "../../../kernel/units.ts";
import type { Statement } from "../../../nc/statement.ts";
import {
  canDo,
  handCut,
  isOnAxis,
  sizesOf,
  speedOnAxis,
  wallOf,
  type HandSize,
  type HandWork,
} from "../../../program/edits/hand-operation.ts";
import { exampleJob, type SetJob, type SpindleDraft } from "../../../program/job/job.ts";
import { cylinderAround } from "../../../program/job/requested-shape.ts";
import { hasFreeEdge, longestOf, boreOf, surfacesOf, type StockSurface } from "../../../program/job/stock-surface.ts";
import { countsInches, typedInMillimetres } from "../../../program/edits/program-unit.ts";
import { anyNumber, readText, type Field } from "../../../program/values/field.ts";
import { Message } from "../../../app/base/Message.tsx";
import { useLengths } from "../../../app/calculation/lengths.ts";
import { useSession } from "../../../app/fields/blocks/session.ts";
import { useToolList } from "../../../app/document/work-tools.ts";
import { showTools } from "../../../app/place/place.ts";
import { centreNamed } from "../../../kernel/cutter/centre-drill.ts";
import { hasTap, isTapOf } from "../../../program/tools/tap-of-thread.ts";
import type { NamedThread } from "../../../kernel/thread/named-thread.ts";
import { readThread } from "../../../kernel/thread/threads.ts";
import { TapField } from "./TapField.tsx";
import { CentreField, proposedCentre } from "./CentreField.tsx";
import { AskedNumber, isUsable, OPEN_NUMBER } from "./AskedNumber.tsx";
import { SpindleFields, isSpindleUsable } from "./PlaceFields.tsx";
import { addStandardDrill, coreDrill, useDrills } from "./drills.ts";
import { StockPlace } from "./StockPlace.tsx";
import { OperationFrame } from "./OperationFrame.tsx";
import { TitleField } from "./TitleField.tsx";
import { ToolChoice } from "./ToolChoice.tsx";
import { spindleLike, type StateBefore } from "./stock-before.ts";

interface Props {
  readonly words: InsertTexts;
  readonly work: HandWork;
  /** The thread that was named, for a tap. */
  readonly thread: NamedThread | null;
  readonly site: Site;
  readonly before: StateBefore;
  readonly onBack: () => void;
  readonly onInsert: (made: readonly HandOperation[]) => void;
}

/** An operation without a turning cycle, as it is written. */
export interface HandOperation {
  readonly job: SetJob;
  readonly cut: readonly Statement[];
  readonly title: string;
}

const FIELDS: Readonly<Record<HandSize, Field>> = {
  size: { ...anyNumber, id: "hand.size", range: [Number.MIN_VALUE, 99.999], optional: false, decimals: 3 },
  z: { ...anyNumber, id: "hand.z", range: [-99_999.999, 99_999.999], optional: false, decimals: 3 },
};
const UNTYPED: Readonly<Record<HandSize, string>> = { size: "", z: "" };

/** A job that only carries tool, spindle and blank. */
const BASE = catalogue.find(({ group, contour }) => group === "longitudinal" && contour === "own");

/** Asks for the sizes, spindle and tool of an operation without a turning cycle. */
export function HandForm({ words, work, thread: given, site, before, onBack, onInsert }: Props) {
  const inches = useSession((s) => countsInches(s.reading.program));
  const unit = useLengths().words;
  const form = useRef<HTMLFormElement>(null);
  const [titled, setTitle] = useState<string | null>(null);
  const [picked, pick] = useState<StockSurface | null>(null);
  const [typed, type] = useState(UNTYPED);
  const [centre, nameCentre] = useState<string | null>(null);
  const [spindle, setSpindle] = useState<SpindleDraft | null>(null);
  const [taken, take] = useState<number | null>(null);
  const { stock, operations } = before;
  const surfaces = useMemo(() => {
    if (work !== "chamfer") return surfacesOf(stock, isOnAxis(work) ? "face" : "outside");
    const edges = surfacesOf(stock, site === "inside" ? "inside" : "outside");
    return edges.filter((each) => hasFreeEdge(each, stock));
  }, [stock, work, site]);
  const surface = picked ?? (work === "chamfer" ? (surfaces[0] ?? null) : longestOf(surfaces));
  const named = centre ?? proposedCentre(stock);
  const hole = work === "centre" ? centreNamed(named) : null;
  const [threadText, nameThread] = useState(given?.name ?? "");
  const read = useMemo(() => (work === "tap" ? readThread(threadText) : null), [work, threadText]);
  const thread = read && hasTap(read) ? read : null;
  const name = hole ? named : thread ? words.hand.tapOf(thread.name).replace("×", "x") : words.hand.of[work];
  const title = titled ?? name.toUpperCase();
  const bore = useMemo(() => (work === "tap" ? boreOf(stock) : null), [work, stock]);
  const needed = { isInside: surface?.site === "inside", depth: surface ? wallOf(stock, surface) : 0, hole };
  const turning = useToolList();
  const drills = useDrills(thread);
  const onAxis = isOnAxis(work);
  const able = (among: readonly Tool[]) =>
    among.filter((tool) => canDo(work, tool, needed) && (!thread || isTapOf(tool, thread)));
  const ofTable = able(onAxis ? drills.own : turning);
  const isStandard = onAxis && ofTable.length === 0;
  const tools = isStandard ? able(drills.standard) : ofTable;
  const tool = tools.find(({ T }) => T === taken) ?? tools[0];
  const core = thread && bore === null ? coreDrill(drills, thread) : null;
  const [isDrilled, drillBefore] = useState(true);
  const asked = sizesOf(work);
  const base = BASE && exampleJob(BASE);
  const usual: SpindleDraft | undefined =
    base &&
    (isOnAxis(work)
      ? { ...base.spindle, mode: "constant", speed: tool ? String(speedOnAxis(work, tool)) : base.spindle.speed }
      : spindleLike(base.spindle, operations));
  const turns = spindle ?? usual;
  const usable =
    tool !== undefined &&
    turns !== undefined &&
    isSpindleUsable(turns) &&
    asked.every((s) => isUsable(FIELDS[s], typed[s]));

  const insert = () => {
    if (!usable || !base || !surface) return;
    const value = (s: HandSize) => length(readText(anyNumber, typedInMillimetres(typed[s], inches)).value ?? 0);
    const { start, cut } = handCut(work, { stock, surface, tool, sizes: { size: value("size"), z: value("z") } });
    if (isStandard) addStandardDrill(tool.T, thread);
    const blank = cylinderAround(stock);
    const own = { job: { ...base, tool: tool.T, spindle: turns, start, blank }, cut, title };
    if (!core || !isDrilled) return onInsert([own]);
    if (core.isStandard) addStandardDrill(core.tool.T, thread);
    const speed = String(speedOnAxis("drill", core.tool));
    const drilled = handCut("drill", { stock, surface, tool: core.tool, sizes: { size: length(0), z: length(0) } });
    const spindleOfDrill: SpindleDraft = { ...base.spindle, mode: "constant", speed };
    const job = { ...base, tool: core.tool.T, spindle: spindleOfDrill, start: drilled.start, blank };
    onInsert([{ job, cut: drilled.cut, title: words.hand.of.drill.toUpperCase() }, own]);
  };
  useEffect(
    () =>
      (
        form.current?.querySelector<HTMLElement>(OPEN_NUMBER) ??
        form.current?.querySelector<HTMLElement>("input, button")
      )?.focus(),
    [],
  );
  return (
    <OperationFrame form={form} isUsable={usable && surface !== null} onBack={onBack} onPut={insert}>
      <div className="operation-ask">
        {work === "centre" && <CentreField words={words.hand.hole} text={named} hole={hole} onText={nameCentre} />}
        {work === "tap" && (
          <TapField
            words={words}
            text={threadText}
            thread={thread}
            bore={bore}
            drill={core?.tool ?? null}
            isDrilled={isDrilled}
            onText={nameThread}
            onDrilled={drillBefore}
          />
        )}
        <TitleField title={title} onTitle={setTitle} />
        {stock.length === 0 || !surface ? (
          <Message tone="warning" className="wide">
            {stock.length === 0 ? words.noStock : words.none[site]}
          </Message>
        ) : (
          !isOnAxis(work) && (
            <StockPlace words={words} stock={stock} surfaces={surfaces} chosen={surface} onChoose={pick} />
          )
        )}
        {asked.map((size) => (
          <AskedNumber
            key={size}
            name={words.hand.sizes[size]}
            unit={unit("mm")}
            field={FIELDS[size]}
            text={typed[size]}
            onText={(text) => type({ ...typed, [size]: text })}
          />
        ))}
        {turns && <SpindleFields spindle={turns} onSpindle={setSpindle} />}
      </div>
      {isStandard && <Message tone="info">{words.hand.standard}</Message>}
      {work === "centre" && !hole ? null : tools.length > 0 ? (
        <ToolChoice
          fits={null}
          among={tools}
          taken={tool ? String(tool.T) : null}
          {...(onAxis && { heading: words.hand.drills })}
          onTake={take}
        />
      ) : (
        <>
          <Message tone="warning">{words.hand.noTool}</Message>
          <button type="button" className="button" onClick={() => showTools()}>
            {words.hand.tools}
          </button>
        </>
      )}
    </OperationFrame>
  );
}
