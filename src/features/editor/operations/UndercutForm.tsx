import { useEffect, useMemo, useRef, useState } from "react";
import type { InsertTexts } from "../../../i18n/en/insert.ts";
import { diameter, rounded } from "../../../kernel/units.ts";
import { countsInches, typedForProgram, typedInMillimetres } from "../../../program/edits/program-unit.ts";
import {
  placeOf,
  reachingFirst,
  shouldersOf,
  undercutCut,
  undercutJob,
} from "../../../program/edits/undercut-operation.ts";
import type { Statement } from "../../../nc/statement.ts";
import type { SetJob, SpindleDraft } from "../../../program/job/job.ts";
import type { NamedUndercut, UndercutPlace } from "../../../program/job/undercut-name.ts";
import { standardUndercutTools } from "../../../program/iso-codes/standard-undercut-tools.ts";
import { anyNumber, readText, type Field } from "../../../program/values/field.ts";
import { Message } from "../../../app/base/Message.tsx";
import { useTextsOrNull } from "../../../app/base/settings/use-texts.ts";
import { useLengths } from "../../../app/calculation/lengths.ts";
import { useFitsOfWork } from "../../../app/calculation/use-tool-fits.ts";
import { useSession } from "../../../app/fields/blocks/session.ts";
import { UndercutNames } from "../../../app/fields/undercut/UndercutNames.tsx";
import { AskedNumber, isUsable } from "./AskedNumber.tsx";
import { addStandardTool, useStandardTools } from "./drills.ts";
import type { InsertedOperation } from "./OperationForm.tsx";
import { SpindleFields, isSpindleUsable } from "./PlaceFields.tsx";
import { StockPlace } from "./StockPlace.tsx";
import { OperationFrame } from "./OperationFrame.tsx";
import { TitleField } from "./TitleField.tsx";
import { ToolChoice } from "./ToolChoice.tsx";
import { spindleLike, type StateBefore } from "./stock-before.ts";

interface Props {
  readonly words: InsertTexts;
  readonly site: "outside" | "inside";
  /** Designation that was searched for; empty: none. */
  readonly typed: string;
  readonly before: StateBefore;
  readonly onBack: () => void;
  readonly onInsert: (made: InsertedOperation) => void;
  /** Path blocks instead of a cycle. */
  readonly onCut: (job: SetJob, cut: readonly Statement[], title: string) => void;
}

const ACROSS: Field = { ...anyNumber, id: "undercut.x", range: [0.001, 99_999.999], optional: false, decimals: 3 };
const ALONG: Field = { ...anyNumber, id: "undercut.z", range: [-99_999.999, 99_999.999], optional: false, decimals: 3 };

/** Asks for an undercut by its designation, its shoulder and its tool; the tools are tried on it. */
export function UndercutForm({ words, site, typed: begun, before, onBack, onInsert, onCut }: Props) {
  const names = useTextsOrNull("undercuts");
  const inches = useSession((s) => countsInches(s.reading.program));
  const unit = useLengths().words;
  const form = useRef<HTMLFormElement>(null);
  const { stock, operations } = before;
  const shoulders = useMemo(() => shouldersOf(stock, site), [stock, site]);
  const [picked, pick] = useState(0);
  const shoulder = shoulders[picked] ?? shoulders[0];
  const [typed, setTyped] = useState<{ readonly x?: string; readonly z?: string }>({});
  const [title, setTitle] = useState<string | null>(null);
  const [named, name] = useState<NamedUndercut | null>(null);
  const [spindle, setSpindle] = useState<SpindleDraft | null>(null);
  const [taken, take] = useState<number | null>(null);
  const proposed = (n: number | undefined) => (n === undefined ? "" : typedForProgram(String(rounded(n)), inches));
  const [x, z] = [typed.x ?? proposed(shoulder && placeOf(shoulder).diameter), typed.z ?? proposed(shoulder?.z)];
  const inMillimetres = (text: string) => readText(anyNumber, typedInMillimetres(text, inches)).value;
  const [across, along] = [inMillimetres(x), inMillimetres(z)];
  const place = useMemo<UndercutPlace | null>(
    () =>
      across === null
        ? null
        : { diameter: diameter(across), isInside: site === "inside", ...(along !== null && { z: along }) },
    [across, along, site],
  );
  const job = useMemo(
    () => (named && place && along !== null ? undercutJob(named, { place, z: along, stock }) : null),
    [named, place, along, stock],
  );
  const ofTable = useFitsOfWork(job);
  const standard = useStandardTools(standardUndercutTools);
  const isShort = ofTable !== null && named !== null && !reachingFirst(ofTable, named)[0]?.makesContour;
  const ofStandard = useFitsOfWork(isShort ? job : null, standard);
  const found = isShort ? ofStandard : ofTable;
  const fits = found && named && reachingFirst(found, named);
  const isStandard = isShort && fits?.[0]?.makesContour === true;
  const chosen = taken ?? fits?.find((fit) => fit.makesContour)?.tool.T ?? null;
  const turns = spindle ?? (job ? spindleLike(job.spindle, operations) : undefined);
  const usable = job !== null && turns !== undefined && isSpindleUsable(turns) && chosen !== null;
  const own = named?.name.toUpperCase().replace("×", "x") ?? words.hand.undercut.toUpperCase();
  const insert = () => {
    if (!usable) return;
    if (isStandard) addStandardTool(standardUndercutTools, chosen);
    const called = { ...job, spindle: turns, tool: chosen };
    const path = named && undercutCut(named, called);
    if (path) onCut({ ...called, start: path.start }, path.cut, title ?? own);
    else onInsert({ job: called, title: title ?? own, contour: undefined, sizes: {} });
  };
  const isHere = names !== null;
  useEffect(() => {
    if (isHere) form.current?.querySelector<HTMLElement>("[role=combobox]")?.focus();
  }, [isHere]);
  return (
    <OperationFrame form={form} isUsable={usable} onBack={onBack} onPut={insert}>
      <div className="operation-ask">
        {names && (
          <div className="wide">
            <UndercutNames
              words={names}
              label={words.hand.undercutName}
              place={place}
              present={named}
              begun={begun}
              onTake={(next) => {
                name(next);
                take(null);
              }}
            />
          </div>
        )}
        <TitleField title={title ?? own} onTitle={setTitle} />
        {shoulders.length === 0 && (
          <Message tone="info" className="wide">
            {stock.length === 0 ? words.noStock : words.hand.noShoulder}
          </Message>
        )}
        {shoulder && (
          <StockPlace
            words={words}
            stock={stock}
            surfaces={shoulders.map(({ surface }) => surface)}
            chosen={shoulder.surface}
            onChoose={(surface) => {
              pick(shoulders.findIndex((each) => each.surface === surface));
              setTyped({});
            }}
          />
        )}
        <AskedNumber
          name={words.hand.cylinder}
          unit={unit("mm")}
          field={ACROSS}
          text={x}
          onText={(text) => setTyped({ ...typed, x: text })}
        />
        <AskedNumber
          name={words.hand.shoulder}
          unit={unit("mm")}
          field={ALONG}
          text={z}
          onText={(text) => setTyped({ ...typed, z: text })}
        />
        {turns && <SpindleFields spindle={turns} onSpindle={setSpindle} />}
      </div>
      {named && isUsable(ACROSS, x) && isUsable(ALONG, z) && !job && (
        <Message tone="error">{words.hand.undercutUnfit}</Message>
      )}
      {isStandard && <Message tone="info">{words.hand.standard}</Message>}
      {isShort && ofStandard && !isStandard && <Message tone="warning">{words.noTool}</Message>}
      {job && (
        <ToolChoice
          fits={fits}
          {...(isStandard && { among: standard })}
          taken={chosen === null ? null : String(chosen)}
          folded={words.unsuitable}
          onTake={take}
        />
      )}
    </OperationFrame>
  );
}
