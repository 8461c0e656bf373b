import { useMemo, useRef, useState } from "react";
import type { Cycle } from "../../../cycles/define.ts";
import { cycleByNumber } from "../../../cycles/index.ts";
import type { Site } from "../../../cycles/shape-request.ts";
import type { InsertTexts } from "../../../i18n/en/insert.ts";
import { ncLanguageOf } from "../../../i18n/languages.ts";
import { ncLabels } from "../../../i18n/nc-labels.ts";
import type { NamedThread } from "../../../kernel/thread/named-thread.ts";
import { startLines } from "../../../nc/program.ts";
import { withHandOperation, withOperation } from "../../../program/edits/added-operation.ts";
import { sitesOf } from "../../../program/job/proposed-operation.ts";
import { CycleChooser } from "../../../app/fields/chooser/CycleChooser.tsx";
import { suggestSizes } from "../../../app/fields/blocks/suggested-sizes.ts";
import { openFirstOpenPrompt } from "../../../app/fields/blocks/open-block.ts";
import { editProgram, useSession } from "../../../app/fields/blocks/session.ts";
import { useOutcome } from "../../../app/calculation/outcome.ts";
import { showFile } from "../../../app/document/shown-file.ts";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { lazyPart } from "../../../app/base/parts.ts";
import { whichSlot } from "../../../app/document/which-slot.ts";
import { outputInUse } from "../../../app/document/output.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts, useTextsOrNull } from "../../../app/base/settings/use-texts.ts";
import { stopInserting } from "../../../app/document/inserting.ts";
import { openingBlock } from "../../../app/fields/blocks/operation-rows.ts";
import { cycleWords } from "../../../app/fields/blocks/words.ts";
import { showSection } from "../../../app/place/place.ts";
import { useGuidedBlock } from "../../../app/place/open-call.ts";
import { useEditor } from "../../../app/document/store.ts";
import { fieldsOf } from "../../../app/fields/blocks/block-fields.ts";
import { HandForm, type HandOperation } from "./HandForm.tsx";
import { handOffer, nameOf, type HandWork } from "./hand-offer.tsx";
import { OperationForm, type InsertedOperation } from "./OperationForm.tsx";
import { stateBefore, type StateBefore } from "./stock-before.ts";
import "./operations.css";

const WhichCycle = lazyPart(async () => ({ default: await whichSlot.fetch() }));

const UndercutForm = lazyPart(async () => ({ default: (await import("./UndercutForm.tsx")).UndercutForm }));

const SITES: readonly Site[] = ["outside", "inside", "face"];
const NOTHING: StateBefore = { stock: [], operations: [] };

/** Writes all blocks of the operation, and opens its first prompt without a value. */
function insertOperation({ job, title, contour, sizes }: InsertedOperation, behind: number | null): void {
  const ncLanguage = ncLanguageOf(useSettings.getState().language);
  showFile(null);
  const { program } = useSession.getState().reading;
  const next = withOperation(program, { ...job, ncLanguage, output: outputInUse() }, ncLabels(ncLanguage), {
    behind,
    title,
    ...(contour !== undefined && { contour }),
  });
  const index = openingBlock(next, behind === null ? 0 : behind + 1);
  editProgram(next, null, index);
  if (index === null) return;
  suggestSizes(index, job.cycle, sizes);
  openFirstOpenPrompt();
}

/** Writes the blocks of operations without a turning cycle, and opens the first of them with a word to type. */
function insertHandOperations(made: readonly HandOperation[], behind: number | null) {
  showFile(null);
  const first = behind === null ? 0 : behind + 1;
  const next = made.reduce(
    (program, { job, cut, title }, i) =>
      withHandOperation(program, { ...job, output: outputInUse() }, cut, {
        behind: i === 0 ? behind : first + i - 1,
        title,
      }),
    useSession.getState().reading.program,
  );
  const index = openingBlock(next, first);
  const s = next.blocks[index ?? -1]?.statement;
  const open = s?.kind === "cycle" ? s.parameters.find(({ value }) => value === null)?.q : undefined;
  const word = open ?? (s && fieldsOf(s)[0]?.id) ?? null;
  const { work } = useEditor.getState();
  if (index !== null) useGuidedBlock.setState({ block: { work, line: startLines(next)[index] ?? 1, word } });
  editProgram(next, null, index);
  showSection("block");
}

/** Asks for site and cycle of an operation, then where it starts and its tool, and writes all of it. */
export function InsertOperation({ behind }: { readonly behind: number | null }) {
  const words = useTextsOrNull("insert");
  return words && <Opened words={words} behind={behind} />;
}

function Opened({ words, behind }: { readonly words: InsertTexts; readonly behind: number | null }) {
  const t = useTexts();
  const { insert, which: whichName, choose } = t.operations;
  const language = useSettings((s) => s.language);
  const dialog = useRef<HTMLDialogElement>(null);
  const newest = useOutcome((s) => s.newest);
  const program = useSession((s) => s.reading.program);
  const [cycle, setCycle] = useState<Cycle | null>(null);
  const [site, setSite] = useState<Site>("outside");
  const [work, setWork] = useState<HandWork | null>(null);
  const [thread, nameThread] = useState<NamedThread | null>(null);
  const [undercut, nameUndercut] = useState("");
  const [which, ask] = useState(false);
  const before = useMemo(() => (newest ? stateBefore(newest, program, behind) : NOTHING), [newest, program, behind]);

  if (which) {
    // The question is new: it starts from the stock that is there, not from the contour of another operation.
    const { stock } = before;
    const initialStock = stock.length > 0 ? "now" : "solid";
    return (
      <WhichCycle
        done={stopInserting}
        region={{ contour: [], first: 0, last: -1, site, stock, initialStock }}
        behind={behind}
      />
    );
  }
  const sitesOfCycle = (number: number): readonly Site[] => {
    const found = cycleByNumber(number);
    return found ? sitesOf(found) : [];
  };
  const back = () => {
    setCycle(null);
    setWork(null);
    nameThread(null);
  };
  const take = (number: number) => {
    const found = cycleByNumber(number);
    if (!found) return;
    const sites = sitesOf(found);
    setSite(sites.includes(site) ? site : (sites[0] ?? site));
    setCycle(found);
  };
  return (
    <ModalDialog
      ref={dialog}
      className="operation-dialog"
      first=".cycle-search-field"
      title={insert}
      heading={cycle ? cycleWords(t, cycle.number) : work ? nameOf(words.hand, work) : insert}
      actions={
        !cycle &&
        !work && (
          <button type="button" className="button" onClick={() => ask(true)}>
            {whichName}
          </button>
        )
      }
      done={stopInserting}
    >
      {!cycle && !work && (
        <div className="operation-body">
          <fieldset className="operation-sites">
            <legend>{words.site}</legend>
            {SITES.map((each) => (
              <label key={each}>
                <input type="radio" name="site" checked={site === each} onChange={() => setSite(each)} />
                <span>{words.sites[each]}</span>
              </label>
            ))}
          </fieldset>
          <CycleChooser
            narrow
            among={(number) => sitesOfCycle(number).includes(site)}
            more={handOffer(
              words,
              site,
              (taken, typed = "") => {
                nameUndercut(typed);
                if (taken === "undercut" && site === "face") setSite("outside");
                setWork(taken);
              },
              {
                language,
                onThread: (named, way) => {
                  nameThread(named);
                  if (way === "tap") return setWork("tap");
                  setSite(way.site);
                  setCycle(way.cycle);
                },
              },
            )}
            ways={[{ name: choose, short: choose, go: take }]}
          />
        </div>
      )}
      {work === "undercut" && site !== "face" && (
        <UndercutForm
          words={words}
          site={site}
          typed={undercut}
          before={before}
          onBack={back}
          onInsert={(made) => {
            insertOperation(made, behind);
            dialog.current?.close();
          }}
          onCut={(job, cut, title) => {
            insertHandOperations([{ job, cut, title }], behind);
            dialog.current?.close();
          }}
        />
      )}
      {work && work !== "undercut" && (
        <HandForm
          words={words}
          work={work}
          thread={thread}
          site={site}
          before={before}
          onBack={back}
          onInsert={(made) => {
            insertHandOperations(made, behind);
            dialog.current?.close();
          }}
        />
      )}
      {cycle && (
        <OperationForm
          key={site}
          words={words}
          cycle={cycle}
          thread={cycle.thread ? thread : null}
          site={site}
          before={before}
          onSite={setSite}
          onBack={back}
          onInsert={(made) => {
            insertOperation(made, behind);
            dialog.current?.close();
          }}
        />
      )}
    </ModalDialog>
  );
}
