import { useEffect, useRef, useState, type MouseEvent } from "react";
import { goHome } from "../app/document/go-home.ts";
import { useActions } from "../app/base/actions.ts";
import { Icon } from "../app/base/Icon.tsx";
import type { MenuItem } from "../app/base/Menu.tsx";
import { shownPage, showCommands, showTools, usePlace } from "../app/place/place.ts";
import { useMedia } from "../app/base/use-media.ts";
import { useTexts } from "../app/base/settings/use-texts.ts";
import { useDocumentInView } from "../app/document/history.ts";
import { lazyPart } from "../app/base/parts.ts";
import { useEditor } from "../app/document/store.ts";
import { HelpMenu } from "./HelpMenu.tsx";
import { CreateProgram } from "../features/start/first.ts";
import { UndoButtons } from "./UndoButtons.tsx";

/** Fetched when it is first opened. */
const SettingsDialog = lazyPart(async () => ({ default: (await import("./SettingsDialog.tsx")).SettingsDialog }));

/**
 * The page was opened by "New program" on the home screen (scripts/offline.ts). Read once: the address changes as soon
 * as the page follows it.
 */
const ASKED_NEW = location.hash === "#/new";

/** Focuses the prompts by script: the address names the place, so a link to an anchor cannot be used. */
function toPrompts(event: MouseEvent): void {
  event.preventDefault();
  document.getElementById("prompts")?.querySelector<HTMLElement>("button, input, [tabindex]")?.focus();
}

/** The header: name of the open work, undo and redo, new program, settings. */
export function Header() {
  const t = useTexts("first");
  const job = useEditor((s) => s.job);
  const section = usePlace((p) => p.section);
  const [settings, showSettings] = useState(false);
  const [creating, create] = useState(ASKED_NEW);
  const program = useEditor((s) => s.program);
  const inView = useDocumentInView();
  const page = usePlace((p) => shownPage(p).page);
  const own = page === "own";
  const tools = page === "tools" || own;
  const toTools = useRef<HTMLButtonElement>(null);
  const wereTools = useRef(false);
  const words = job && t.menu.of[job.cycle];
  const folds = useMedia("folded");
  const offersNew = !tools && Boolean(words ?? program);

  /** On a phone the name of the open work needs the room. */
  const folded: readonly MenuItem[] = [
    ...(tools ? [] : [{ name: t.page.tools.openLong, icon: "insert", go: () => showTools() } as const]),
    ...(offersNew ? [{ name: t.page.newProgram, icon: "add", opens: "dialog", go: () => create(true) } as const] : []),
    { name: t.page.settings, icon: "settings", opens: "dialog", go: () => showSettings(true) },
  ];

  useActions([
    { id: "do.newProgram", name: t.page.newProgram, run: () => create(true) },
    { id: "do.settings", name: t.page.settings, run: () => showSettings(true) },
  ]);

  useEffect(() => {
    if (wereTools.current && !tools) toTools.current?.focus();
    wereTools.current = tools;
  }, [tools]);

  return (
    <header className="top" aria-label={t.page.header}>
      {words && section === "prompts" && page === "work" && (
        <a className="skip" href="#prompts" onClick={toPrompts}>
          {t.page.skipToPrompts}
        </a>
      )}
      <a
        className="brand"
        href="#/"
        aria-label={t.page.home}
        title={t.page.home}
        onClick={(event) => {
          if (event.ctrlKey || event.metaKey || event.shiftKey) return;
          event.preventDefault();
          goHome();
        }}
      >
        <Icon name="home" /> <b>{t.page.product}</b>
      </a>
      {tools && <h1 className="open-cycle">{own ? t.page.own.title : t.page.tools.title}</h1>}
      {!tools && words && (
        <h1 className="open-cycle">
          <span className="number">{job.cycle}</span> {words.name}
        </h1>
      )}
      {!tools && !words && !program && page === "works" && <h1 className="open-cycle">{t.page.works.title}</h1>}
      {!tools && program && <h1 className="open-cycle">{program.name}</h1>}
      <div className="top-buttons">
        <UndoButtons document={inView} />
        {!folds && !tools && (
          <button
            ref={toTools}
            type="button"
            className="button plain new-program"
            aria-label={t.page.tools.openLong}
            title={t.page.tools.openLong}
            onClick={() => showTools()}
          >
            <Icon name="insert" /> <span>{t.page.tools.open}</span>
          </button>
        )}
        {!folds && offersNew && (
          <button
            type="button"
            className="button plain new-program"
            aria-label={t.page.newProgram}
            title={t.page.newProgram}
            onClick={() => create(true)}
          >
            <Icon name="add" /> <span>{t.page.newProgram}</span>
          </button>
        )}
        {!folds && <HelpMenu />}
        <button
          type="button"
          className="button icon plain"
          aria-label={t.page.commands}
          title={`${t.page.commands} (Ctrl+K)`}
          aria-haspopup="dialog"
          onClick={showCommands}
        >
          <Icon name="search" />
        </button>
        {folds ? (
          <HelpMenu folded={folded} />
        ) : (
          <button
            type="button"
            className="button icon plain"
            aria-label={t.page.settings}
            title={t.page.settings}
            onClick={() => showSettings(true)}
          >
            <Icon name="settings" />
          </button>
        )}
      </div>
      {creating && <CreateProgram done={() => create(false)} />}
      {settings && <SettingsDialog onClose={() => showSettings(false)} />}
    </header>
  );
}
