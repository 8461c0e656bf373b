import { useEffect, useMemo, useRef, useState } from "react";
import { useOutcome } from "../../app/calculation/outcome.ts";
import { askForFiles } from "../../app/records/files/file-handle.ts";
import { missingFiles } from "../../app/calculation/missing-files.ts";
import { addFiles } from "../../app/fields/open/open-files.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { fileKey } from "../../program/state/program-files.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { changeProgram, useEditor } from "../../app/document/store.ts";
import { filesOf, withMain, withoutFile, type ProgramWork } from "../../app/document/work.ts";
import { sessionView } from "../../app/fields/blocks/session.ts";
import { showFile, useShownName } from "../../app/document/shown-file.ts";
import "./work-files.css";

const isProgramText = (text: string): boolean => /BEGIN[ \t]+PGM/i.test(text);

const add = async (name: string | null = null) => addFiles(await askForFiles(), name);

function List({ program, missing }: { readonly program: ProgramWork; readonly missing: readonly string[] }) {
  const t = useTexts().editor.files;
  const shown = useShownName();
  const files = filesOf(program);
  const programs = useMemo(() => new Set(files.filter(({ text }) => isProgramText(text))), [files]);
  const list = useRef<HTMLUListElement>(null);
  useEffect(() => {
    list.current?.querySelector("[aria-current]")?.scrollIntoView?.({ block: "nearest" });
  }, [shown]);
  useEffect(
    () => () => {
      if (document.activeElement === document.body) sessionView()?.focus();
    },
    [],
  );
  /** The clicked button disappears with its row: focus stays in the list. */
  const change = (next: (now: ProgramWork) => ProgramWork) => {
    list.current?.querySelector("button")?.focus();
    changeProgram(next);
  };
  const open = (name: string, runs: boolean) => (
    <button
      type="button"
      className="button plain work-file"
      aria-current={name === shown ? "true" : undefined}
      title={name}
      aria-label={t.show(name)}
      onClick={() => showFile(runs ? null : name)}
    >
      <span className="file-name number">{name}</span>
    </button>
  );
  return (
    <ul ref={list} aria-label={t.title}>
      <li>
        {open(program.name, true)}
        <span className="small soft work-file-note">{t.runs}</span>
      </li>
      {missing.map((name) => (
        <li key={fileKey(name)}>
          <span className="work-file missing" title={name}>
            <Icon name="warning" /> <span className="file-name number">{name}</span>
          </span>
          <span className="small soft work-file-note">{t.missing}</span>
          <button type="button" className="button small" aria-label={t.addOne(name)} onClick={() => void add(name)}>
            {t.addShort}
          </button>
        </li>
      ))}
      {files.map((file) => (
        <li key={fileKey(file.name)}>
          {open(file.name, false)}
          {programs.has(file) && (
            <button
              type="button"
              className="button small plain"
              aria-label={t.runLong(file.name)}
              title={t.runLong(file.name)}
              onClick={() => {
                change((now) => withMain(now, fileKey(file.name)));
                showFile(null);
              }}
            >
              {t.run}
            </button>
          )}
          <button
            type="button"
            className="button icon plain"
            aria-label={t.remove(file.name)}
            title={t.remove(file.name)}
            onClick={() => change((now) => withoutFile(now, fileKey(file.name)))}
          >
            <Icon name="close" />
          </button>
        </li>
      ))}
    </ul>
  );
}

/** The files of the open work, if there are more than its program: which one runs, is shown, or is missing. */
export function WorkFiles() {
  const t = useTexts().editor.files;
  const program = useEditor((s) => s.program);
  const work = useEditor((s) => s.work);
  const newest = useOutcome((s) => s.newest);
  const missing = useMemo(() => (program ? missingFiles(program, newest) : []), [program, newest]);
  const [last, keep] = useState({ work, isShown: false });
  const isAlone = !program || filesOf(program).length + missing.length === 0;
  // Only a new run tells whether a removed file is missing: until then the list stays as it is.
  const stays = newest ? (newest.files ?? []).length > 0 : last.isShown && last.work === work;
  const isShown = program !== null && (!isAlone || stays);
  if (last.work !== work || last.isShown !== isShown) keep({ work, isShown });
  if (!isShown) return null;
  return (
    <section className="work-files" aria-label={t.title}>
      <header>
        <h2>{t.title}</h2>
        <button type="button" className="button small plain" onClick={() => void add()}>
          <Icon name="add" /> {t.add}
        </button>
      </header>
      <List program={program} missing={missing} />
    </section>
  );
}
