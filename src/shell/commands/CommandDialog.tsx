import { useEffect, useId, useMemo, useRef, useState, type KeyboardEvent } from "react";
import { flushSync } from "react-dom";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { offeredCycles } from "../../app/fields/chooser/menu.ts";
import { findCycles } from "../../app/fields/chooser/search.ts";
import { useMenuWords } from "../../app/fields/chooser/use-menu-words.ts";
import { KeyCombination } from "../../app/fields/keys/KeyCombination.tsx";
import { findCommands, groupedCommands, type Command } from "./find-commands.ts";
import { noteCommand, recentCommands } from "./recent-commands.ts";
import { useCommands } from "./use-commands.ts";
import "./commands.css";

/** Rows that Page up and Page down go by. */
const PAGE = 8;

const STEPS: Readonly<Record<string, number>> = { ArrowDown: 1, ArrowUp: -1, PageDown: PAGE, PageUp: -PAGE };

/** The command palette: every action, page, program, cycle, lesson and setting, found by typing. */
export function CommandDialog({ done }: { readonly done: () => void }) {
  const t = useTexts("commands");
  const { names } = useTexts("keys");
  const all = useCommands();
  const id = useId();
  const [typed, type] = useState("");
  const [chosen, choose] = useState(0);
  const [recent] = useState(recentCommands);
  const list = useRef<HTMLDivElement>(null);
  const languages = useMenuWords(typed !== "");
  const sought = typed.trim();
  const groups = useMemo(() => {
    if (sought === "") return groupedCommands(all, recent);
    const cycles = findCycles(offeredCycles(true), sought, languages).map(({ number }) => `cycle ${number}`);
    return [{ group: null, commands: findCommands(all, sought, recent, cycles) }];
  }, [all, sought, recent, languages]);
  const shown = groups.flatMap(({ commands }) => commands);
  const at = Math.min(chosen, shown.length - 1);
  useEffect(() => {
    list.current?.querySelector("[aria-selected=true]")?.scrollIntoView({ block: "nearest" });
  }, [at, shown]);

  const run = (command: Command | undefined) => {
    if (!command) return;
    noteCommand(command.id);
    // The dialog gives the focus back before the command moves it.
    flushSync(done);
    command.run();
  };
  const onKey = (event: KeyboardEvent) => {
    const step = STEPS[event.key];
    if (event.key === "Enter") {
      event.preventDefault();
      run(shown[at]);
    } else if (step !== undefined && shown.length > 0) {
      event.preventDefault();
      // One step goes around the ends, a page stops there.
      const next = at + step;
      choose(
        Math.abs(step) === 1 ? (next + shown.length) % shown.length : Math.max(0, Math.min(shown.length - 1, next)),
      );
    }
  };
  return (
    <ModalDialog title={t.title} done={done} className="modal commands" first="input">
      <input
        type="text"
        className="input"
        role="combobox"
        aria-label={t.search}
        placeholder={t.search}
        aria-expanded={shown.length > 0}
        aria-controls={id}
        aria-autocomplete="list"
        aria-activedescendant={shown[at] ? `${id}${at}` : undefined}
        enterKeyHint="go"
        autoComplete="off"
        spellCheck={false}
        value={typed}
        onKeyDown={onKey}
        onChange={(event) => {
          type(event.currentTarget.value);
          choose(0);
        }}
      />
      <p className="unseen" role="status">
        {sought === "" ? "" : t.count(shown.length)}
      </p>
      <div ref={list} id={id} role="listbox" aria-label={t.title} className="command-list">
        {groups.map(({ group, commands }, g) => {
          const first = groups.slice(0, g).reduce((n, before) => n + before.commands.length, 0);
          return (
            <div key={group ?? "found"} role="group" {...(group && { "aria-label": t.groups[group] })}>
              {group && (
                <p className="panel-title" role="presentation">
                  {t.groups[group]}
                </p>
              )}
              {commands.map((command, i) => (
                <div
                  key={command.id}
                  id={`${id}${first + i}`}
                  role="option"
                  aria-selected={first + i === at}
                  className="command"
                  onPointerDown={(event) => event.preventDefault()}
                  onClick={() => run(command)}
                >
                  <span className="command-name">{command.name}</span>
                  {command.keys && <KeyCombination keys={command.keys} names={names} />}
                  {(group === null || group === "recent") && (
                    <span className="small soft">{t.kinds[command.group]}</span>
                  )}
                </div>
              ))}
            </div>
          );
        })}
        {shown.length === 0 && <p className="soft command-none">{t.none}</p>}
      </div>
    </ModalDialog>
  );
}
