import { useMemo, type ReactNode } from "react";
import { SCREEN_LANGUAGES } from "../../i18n/languages.ts";
import type { SheetTexts } from "../../i18n/en/sheet.ts";
import { useListed, useVerdict } from "../../app/findings/use-findings.ts";
import { toneOf, type ShownVerdict } from "../../app/findings/verdict.ts";
import { verdictReasons, verdictTitle } from "../../app/findings/verdict-words.ts";
import { useOutcome } from "../../app/calculation/outcome.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { issueText, placeInFile } from "../../app/calculation/issue-text.ts";
import { lengthsOf, useLengths } from "../../app/calculation/lengths.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { useEditor } from "../../app/document/store.ts";
import { PartSheet } from "./PartSheet.tsx";
import { SheetFacts } from "./SheetFacts.tsx";
import { SheetMeasured, useSheetMeasured } from "./SheetMeasured.tsx";
import { SheetOperations } from "./SheetOperations.tsx";
import { SheetProgram } from "./SheetProgram.tsx";
import { SheetTime } from "./SheetTime.tsx";
import { SheetTools } from "./SheetTools.tsx";
import { sheetWords } from "./sheet-words.ts";
import { Unbroken } from "../../app/base/Unbroken.tsx";
import type { SheetSource } from "./use-sheet.ts";

/** Most findings and reasons listed on the sheet. */
const MOST = { findings: 10, reasons: 8 } as const;

type Stamp = Exclude<keyof SheetTexts["stamp"], "noneWhy" | "dryRun" | "calculating">;

function stampOf(verdict: ShownVerdict, hasOutcome: boolean): Stamp {
  if (verdict.state === "faults") return "faults";
  if (!hasOutcome || verdict.state === "none") return "none";
  if (verdict.state === "incomplete") return "incomplete";
  const tone = toneOf(verdict);
  return tone === "good" || tone === "plain" ? tone : "doubt";
}

function Verdict({
  t,
  hasOutcome,
  isCalculated,
  date,
}: {
  readonly t: SheetTexts;
  readonly hasOutcome: boolean;
  readonly isCalculated: boolean;
  readonly date: string;
}) {
  const texts = useTexts().findings.verdict;
  const lengths = useLengths();
  const verdict = useVerdict();
  const stamp = stampOf(verdict, hasOutcome);
  const reasons = hasOutcome
    ? verdictReasons(texts, verdict).slice(0, MOST.reasons)
    : [isCalculated ? t.stamp.calculating : t.stamp.noneWhy];
  const grave = stamp === "faults" || stamp === "incomplete" || stamp === "none";
  return (
    <section className={`sheet-verdict${grave ? " sheet-grave" : ""}`}>
      <h2>
        {stamp !== "good" && <Icon name={stamp === "faults" ? "error" : "warning"} />} {t.stamp[stamp]}
      </h2>
      {hasOutcome && stamp !== "good" && <p>{verdictTitle(texts, lengths, verdict)}</p>}
      {reasons.map((reason) => (
        <p key={reason}>{reason}</p>
      ))}
      <p className="sheet-small">
        {t.stamp.dryRun} {date}, Turnwise {import.meta.env["VITE_VERSION"]}
      </p>
    </section>
  );
}

function FindingLines({ t, source }: { readonly t: SheetTexts; readonly source: SheetSource }) {
  const texts = useTexts();
  const lengths = useLengths(source.outcome?.run);
  const listed = useListed();
  const job = useEditor((s) => s.job);
  const run = source.outcome?.run;
  if (listed.length === 0) return null;
  return (
    <section className="sheet-findings">
      <h2>{t.findings}</h2>
      <ul>
        {listed.slice(0, MOST.findings).map((entry) => {
          const cycle =
            (entry.operation === null ? undefined : run?.operations[entry.operation]?.cycle) ?? job?.cycle ?? null;
          const where = entry.inFile
            ? placeInFile(texts, entry.inFile)
            : entry.block === null
              ? ""
              : texts.findings.inBlock(String(entry.block));
          return (
            <li key={entry.id}>
              <Icon name={entry.issue.severity} /> <Unbroken text={issueText(texts, lengths, entry.issue, cycle)} />{" "}
              {where && `(${where})`}
            </li>
          );
        })}
      </ul>
      {listed.length > MOST.findings && <p className="sheet-small">{t.more(listed.length - MOST.findings)}</p>}
    </section>
  );
}

/** The printed sheet: the set-up for the setter, then the program. */
export function SetupSheet({
  source,
  t,
  date,
}: {
  readonly source: SheetSource;
  readonly t: SheetTexts;
  readonly date: string;
}) {
  const texts = useTexts();
  const { language, paper, sheetProgram } = useSettings();
  const work = useEditor((s) => s.program);
  const isCalculated = useIsCalculated(source);
  const { unit } = source.data,
    lengths = useMemo(() => lengthsOf(language, unit), [language, unit]);
  const words = useMemo(() => sheetWords(texts, t, lengths), [texts, t, lengths]);
  const { data, outcome, program, control, file, remarks } = source;
  const name = data.name || file,
    measured = useSheetMeasured(outcome);
  const { comma } = SCREEN_LANGUAGES[language];
  const head: readonly (readonly [string, ReactNode])[] = [
    [t.head.file, file],
    [t.head.control, control],
    [t.head.unit, unit === "inch" ? t.inch : "mm"],
    [t.head.time, outcome && data.seconds > 0 ? <SheetTime run={outcome.run} t={t} words={words} /> : "–"],
    [t.head.date, date],
  ];
  return (
    <article className="setup-sheet paper" data-paper={paper} lang={language} aria-label={t.preview}>
      <header className="sheet-head">
        <div>
          <p>{t.title}</p>
          <h1>{name}</h1>
        </div>
        <dl>
          {head.map(([label, value]) => (
            <div key={label}>
              <dt>{label}</dt>
              <dd>{value}</dd>
            </div>
          ))}
        </dl>
      </header>
      <Verdict t={t} hasOutcome={outcome !== null} isCalculated={isCalculated} date={date} />
      <section>
        <h2>{t.drawing}</h2>
        <div className="sheet-setup">
          <PartSheet outcome={outcome} measured={measured} name={name} t={t} words={words} />
          <SheetFacts source={source} work={work} t={t.facts} words={words} comma={comma} />
        </div>
      </section>
      <SheetMeasured measured={measured} run={outcome?.run} t={t} />
      <section className="sheet-wide" tabIndex={0} aria-label={t.tools}>
        <h2>{t.tools}</h2>
        <SheetTools data={data} t={t} words={words} />
      </section>
      <section className="sheet-wide" tabIndex={0} aria-label={t.operations}>
        <h2>{t.operations}</h2>
        <SheetOperations data={data} t={t} words={words} />
      </section>
      <div className="sheet-last">
        <section className="sheet-remarks">
          <h2>{t.remarks}</h2>
          {remarks.trim() === "" ? [0, 1].map((line) => <span key={line} className="sheet-line" />) : <p>{remarks}</p>}
        </section>
        <FindingLines t={t} source={source} />
      </div>
      <div className="sheet-signatures">
        <p>{t.signature}</p>
        <p>{t.released}</p>
      </div>
      {sheetProgram && <SheetProgram program={program} iso={source.iso} name={`${t.program} ${name}`} />}
    </article>
  );
}

/** Whether a result is pending. */
function useIsCalculated({ outcome }: SheetSource): boolean {
  const stage = useOutcome((s) => s.stage);
  return outcome === null && stage !== null;
}
