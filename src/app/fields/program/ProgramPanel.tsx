import { useCallback, useRef, useState } from "react";
import { SCREEN_LANGUAGES } from "../../../i18n/languages.ts";
import { NC_LANGUAGES } from "../../../nc/nc-languages.ts";
import { hasOwnWords } from "../../../i18n/nc-labels.ts";
import { JOB_LAYOUTS } from "../../../program/machine/nc-output.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { playback } from "../../calculation/playback.ts";
import { setLayout, setName, setNcLanguage } from "../../document/edits.ts";
import { openText } from "../open/open-program.ts";
import { Icon } from "../../base/Icon.tsx";
import { Message } from "../../base/Message.tsx";
import { DeferredUntilPaint } from "../../base/typing.ts";
import { CopyStatus } from "../leaving/CopyStatus.tsx";
import { confirmExport } from "../leaving/confirm-export.ts";
import { fileOfJob, exportedText, printedBlocks, printedText } from "../../document/printed.ts";
import type { JobReading } from "../../document/reading.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { closeStep } from "../../document/steps.ts";
import { chooseJobLine, useChosenLine } from "./choose-line.ts";
import { CopyButton } from "./CopyButton.tsx";
import { useReadPlayback } from "../../pictures/lathe/use-playback.ts";
import { downloadText } from "../../base/download.ts";
import { FileNote } from "./FileNote.tsx";
import { useFileKind, useShownText } from "../../document/output.ts";
import { lazyPart } from "../../base/parts.ts";
import type { PrintedSearchState } from "../find/found-text.tsx";
import type { TextBar } from "../find/text-bar.ts";
import type { Match } from "../find/text-search.ts";
import { ProgramMenus } from "./ProgramMenus.tsx";
import { ProgramText } from "./ProgramText.tsx";

const fetchSearch = () => import("../find/PrintedSearch.tsx");
const FindButton = lazyPart(async () => ({ default: (await fetchSearch()).FindButton }));
const PrintedSearch = lazyPart(async () => ({ default: (await fetchSearch()).PrintedSearch }));

/** Block number at the playback position; null before and after the run. */
function useRunningBlock(): number | null {
  const shown = useOutcome((s) => s.pictured);
  return useReadPlayback(playback, (store) => {
    const { position } = store.get();
    if (position.step === 0 && position.fraction === 0) return null;
    return shown?.run.steps[position.step]?.block ?? null;
  });
}

/** The program as the control writes it: to read, copy and export. */
export function ProgramPanel({
  read,
  foldable,
  bar,
}: {
  readonly read: JobReading;
  readonly foldable: boolean;
  /** The bar that finds in the text. */
  readonly bar: TextBar;
}) {
  const {
    page: { text: t, programs: open },
  } = useTexts();
  const { job } = read;
  const { text, iso } = useShownText(job);
  const file = fileOfJob(job);
  const kind = useFileKind();
  const running = useRunningBlock();
  const chosen = useChosenLine(read);
  const panel = useRef<HTMLElement>(null);
  const [search, mark] = useState<PrintedSearchState>({ sought: "", shown: null });
  const showFound = useCallback((sought: string, shown: Match | null) => mark({ sought, shown }), []);
  const focusText = useCallback(() => panel.current?.querySelector<HTMLElement>(".program-text")?.focus(), []);
  const download = async () => {
    const leaving = await exportedText(job);
    if (await confirmExport("download")) downloadText(leaving, file);
  };

  return (
    <section ref={panel} className="program" aria-label={t.title}>
      <header>
        <h2 className="panel-title">{t.title}</h2>
        <FindButton bar={bar} />
        {foldable && (
          <button
            type="button"
            className="button icon plain"
            aria-label={t.fold}
            title={t.fold}
            onClick={() => changeSettings({ programFolded: true })}
          >
            <Icon name="fold" />
          </button>
        )}
      </header>
      <div className="program-options">
        <label className="program-name">
          <span>{t.name}</span>
          <input
            className="input"
            type="text"
            value={job.name}
            maxLength={32}
            spellCheck={false}
            autoComplete="off"
            onChange={(e) => setName(e.currentTarget.value)}
            onBlur={closeStep}
          />
        </label>
        <label>
          <span>{t.layout}</span>
          <select
            className="select"
            value={job.layout}
            onChange={(e) => setLayout(JOB_LAYOUTS.find((layout) => layout === e.target.value) ?? "tnc640")}
          >
            {JOB_LAYOUTS.map((layout) => (
              <option key={layout} value={layout}>
                {t.layouts[layout]}
              </option>
            ))}
          </select>
        </label>
        <label>
          <span>{t.language}</span>
          <select
            className="select"
            aria-label={t.languageLong}
            value={job.ncLanguage}
            onChange={(e) => setNcLanguage(NC_LANGUAGES.find((language) => language === e.target.value) ?? "en")}
          >
            {NC_LANGUAGES.map((language) => (
              <option key={language} value={language} lang={language}>
                {SCREEN_LANGUAGES[language].name}
              </option>
            ))}
          </select>
        </label>
        {!hasOwnWords(job.ncLanguage) && <p className="small soft program-note">{t.noChinese}</p>}
      </div>
      {!read.reading.values && <Message tone="warning">{t.incomplete}</Message>}
      {bar.mode !== null && (
        <PrintedSearch
          bar={bar}
          text={printedBlocks(text)
            .flatMap(({ lines }) => lines)
            .join("\n")}
          mark={showFound}
          focus={focusText}
        />
      )}
      <DeferredUntilPaint>
        <ProgramText
          text={text}
          running={running}
          chosen={chosen}
          choose={(line) => void chooseJobLine(read, line)}
          search={search}
        />
      </DeferredUntilPaint>
      <FileNote
        {...(job.layout === "manual"
          ? { text: t.manualView, warns: true, cure: { name: t.showFile, go: () => setLayout("tnc640") } }
          : {
              text: iso
                ? `${t.files.iso}. ${t.isoKept(iso.kept.map((n) => `N${n}`).join(", "))} ${t.isoUnverified}`
                : t.files[kind],
            })}
      />
      <div className="program-foot">
        <div className="program-buttons">
          <CopyButton main />
          <ProgramMenus
            showBlock={(_, __, number) => void chooseJobLine(read, { block: number, q: null })}
            files={[{ name: t.download(file), icon: "download", hint: t.files[kind], go: () => void download() }]}
            changes={[
              { name: open.fromJob, icon: "blocks", hint: open.fromJobLong, go: () => openText(printedText(job), job) },
            ]}
          />
        </div>
      </div>
      <CopyStatus />
    </section>
  );
}
