import { Suspense, useLayoutEffect, useMemo, useRef, useState } from "react";
import { cycleByNumber } from "../../../cycles/index.ts";
import { ncLanguageOf } from "../../../i18n/languages.ts";
import { ncLabels } from "../../../i18n/nc-labels.ts";
import type { Cycle } from "../../../cycles/define.ts";
import { withOperation } from "../../../program/edits/added-operation.ts";
import type { SetJob } from "../../../program/job/job.ts";
import { operationsOf } from "../../../program/edits/operations.ts";
import { proposedOperation } from "../../../program/job/proposed-operation.ts";
import { SETUP_FIELDS as FIELDS } from "../../../program/job/setup-fields.ts";
import { startLines } from "../../../nc/program.ts";
import { CycleChooser } from "../../../app/fields/chooser/CycleChooser.tsx";
import { editProgram, useSession } from "../../../app/fields/blocks/session.ts";
import { useFitsOfWork } from "../../../app/calculation/use-tool-fits.ts";
import { useOutcome } from "../../../app/calculation/outcome.ts";
import { showFile } from "../../../app/document/shown-file.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { lazyPart } from "../../../app/base/parts.ts";
import { whichSlot } from "../../../app/document/which-slot.ts";
import { enterSection } from "../../../app/place/place.ts";
import { outputInUse } from "../../../app/document/output.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { contourAt } from "../../../app/document/region.ts";
import { AskedNumber, isUsable } from "./AskedNumber.tsx";
import { stopInserting } from "../../../app/document/inserting.ts";
import { openingBlock } from "../../../app/fields/blocks/operation-rows.ts";
import { ToolChoice } from "./ToolChoice.tsx";
import { cycleWords } from "../../../app/fields/blocks/words.ts";
import "./operations.css";

const WhichCycle = lazyPart(async () => ({ default: await whichSlot.fetch() }));

/** The proposed job for a new operation, from the blank and the operations before its place. */
function proposalFor(cycle: Cycle, behind: number | null): SetJob {
  const { newest } = useOutcome.getState();
  const { program } = useSession.getState().reading;
  const until = behind === null ? 0 : (operationsOf(program).units[behind]?.to ?? 0);
  const line = startLines(program)[until] ?? (behind === null ? 0 : Infinity);
  const before = newest?.run.operations.filter(({ definedLine }) => definedLine < line) ?? [];
  return proposedOperation(cycle, { blank: newest?.run.blank ?? [], before });
}

/** Writes all blocks of the operation, and opens its first prompt. */
function insertOperation(job: SetJob, title: string, behind: number | null): void {
  const ncLanguage = ncLanguageOf(useSettings.getState().language);
  showFile(null);
  const { program } = useSession.getState().reading;
  const next = withOperation(program, { ...job, ncLanguage, output: outputInUse() }, ncLabels(ncLanguage), {
    behind,
    title,
  });
  editProgram(next, null, openingBlock(next, behind === null ? 0 : behind + 1));
  enterSection("block");
}

/** Asks for cycle, tool, spindle and start point of an operation, then writes all of it. */
export function InsertOperation({ behind }: { readonly behind: number | null }) {
  const t = useTexts();
  const words = t.operations;
  const language = useSettings((s) => s.language);
  const dialog = useRef<HTMLDialogElement>(null);
  const [job, setJob] = useState<SetJob | null>(null);
  const [title, setTitle] = useState("");
  const [tool, setTool] = useState<number | null>(null);
  const [which, ask] = useState(false);
  const fits = useFitsOfWork(job);
  const best = useMemo(() => fits?.find((fit) => fit.makesContour)?.tool.T ?? null, [fits]);
  const chosen = tool ?? best ?? job?.tool ?? null;
  const asks = job === null;
  useLayoutEffect(() => dialog.current?.querySelector("input")?.focus(), [asks]);

  if (which) {
    const { newest } = useOutcome.getState();
    const region = newest ? contourAt(newest.run, newest.run.steps.length - 1, newest.simulation.final) : null;
    return (
      <Suspense>
        <WhichCycle done={stopInserting} region={region} />
      </Suspense>
    );
  }
  const choose = (number: number) => {
    const cycle = cycleByNumber(number);
    if (!cycle) return;
    setJob(proposalFor(cycle, behind));
    setTitle(ncLabels(ncLanguageOf(language)).cycleName(number));
    setTool(null);
  };
  const surface = job?.spindle.mode === "surface";
  const usable =
    job !== null &&
    isUsable(FIELDS.startX, job.start.x) &&
    isUsable(FIELDS.startZ, job.start.z) &&
    (surface
      ? isUsable(FIELDS.cuttingSpeed, job.spindle.cuttingSpeed) && isUsable(FIELDS.limit, job.spindle.limit)
      : isUsable(FIELDS.speed, job.spindle.speed));
  return (
    <ModalDialog
      ref={dialog}
      className="operation-dialog"
      first="input"
      title={words.insert}
      heading={job ? cycleWords(t, job.cycle) : words.insert}
      actions={
        !job && (
          <button type="button" className="button" onClick={() => ask(true)}>
            {words.which}
          </button>
        )
      }
      done={stopInserting}
    >
      {!job && (
        <div className="operation-body">
          <CycleChooser narrow ways={[{ name: words.choose, short: words.choose, go: choose }]} />
        </div>
      )}
      {job && (
        <form
          className="operation-form"
          onSubmit={(event) => {
            event.preventDefault();
            if (!usable || chosen === null) return;
            insertOperation({ ...job, tool: chosen }, title, behind);
            dialog.current?.close();
          }}
        >
          <div className="operation-body">
            <div className="operation-ask">
              <label className="wide">
                <span>{words.title}</span>
                <input
                  className="input"
                  type="text"
                  maxLength={60}
                  autoComplete="off"
                  value={title}
                  onFocus={(event) => event.currentTarget.select()}
                  onChange={(event) => setTitle(event.currentTarget.value)}
                />
                <span className="small soft">{words.titleHint}</span>
              </label>
              <AskedNumber
                name={t.setup.start.x}
                unit={t.setup.units.diameter}
                field={FIELDS.startX}
                text={job.start.x}
                onText={(x) => setJob({ ...job, start: { ...job.start, x } })}
              />
              <AskedNumber
                name={t.setup.start.z}
                unit={t.setup.units.mm}
                field={FIELDS.startZ}
                text={job.start.z}
                onText={(z) => setJob({ ...job, start: { ...job.start, z } })}
              />
              <label>
                <span>{words.spindle}</span>
                <select
                  className="select"
                  value={job.spindle.mode}
                  onChange={(event) =>
                    setJob({
                      ...job,
                      spindle: { ...job.spindle, mode: event.target.value === "constant" ? "constant" : "surface" },
                    })
                  }
                >
                  {(["surface", "constant"] as const).map((mode) => (
                    <option key={mode} value={mode}>
                      {t.setup.spindle[mode]}
                    </option>
                  ))}
                </select>
              </label>
              {surface ? (
                <>
                  <AskedNumber
                    name={t.setup.spindle.cuttingSpeed}
                    unit={t.setup.units.cuttingSpeed}
                    field={FIELDS.cuttingSpeed}
                    text={job.spindle.cuttingSpeed}
                    onText={(cuttingSpeed) => setJob({ ...job, spindle: { ...job.spindle, cuttingSpeed } })}
                  />
                  <AskedNumber
                    name={t.setup.spindle.limit}
                    unit={t.setup.units.rpm}
                    field={FIELDS.limit}
                    text={job.spindle.limit}
                    onText={(limit) => setJob({ ...job, spindle: { ...job.spindle, limit } })}
                  />
                </>
              ) : (
                <AskedNumber
                  name={t.setup.spindle.speed}
                  unit={t.setup.units.rpm}
                  field={FIELDS.speed}
                  text={job.spindle.speed}
                  onText={(speed) => setJob({ ...job, spindle: { ...job.spindle, speed } })}
                />
              )}
            </div>
            <ToolChoice fits={fits} taken={chosen === null ? null : String(chosen)} onTake={setTool} />
          </div>
          <footer className="operation-foot">
            <button type="button" className="button" onClick={() => setJob(null)}>
              <Icon name="back" /> {words.back}
            </button>
            <button type="submit" className="button primary" disabled={!usable}>
              {words.put}
            </button>
          </footer>
        </form>
      )}
    </ModalDialog>
  );
}
