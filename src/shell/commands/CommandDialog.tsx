import { useMemo, useState } from "react";
import { flushSync } from "react-dom";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { offeredCycles } from "../../app/fields/chooser/menu.ts";
import { findCycles } from "../../app/fields/chooser/search.ts";
import { useMenuWords } from "../../app/fields/chooser/use-menu-words.ts";
import { ComboboxInput, optionOf, useCombobox } from "../../app/fields/find/Combobox.tsx";
import { KeyCombination } from "../../app/fields/keys/KeyCombination.tsx";
import { findCommands, groupedCommands, type Command } from "./find-commands.ts";
import { noteCommand, recentCommands } from "./recent-commands.ts";
import { useCommands } from "./use-commands.ts";
import "./commands.css";

/** The command palette: every action, page, program, cycle, lesson and setting, found by typing. */
export function CommandDialog({ done }: { readonly done: () => void }) {
  const t = useTexts("commands");
  const { names } = useTexts("keys");
  const all = useCommands();
  const box = useCombobox();
  const { typed } = box;
  const [recent] = useState(recentCommands);
  const languages = useMenuWords(typed !== "");
  const sought = typed.trim();
  const groups = useMemo(() => {
    if (sought === "") return groupedCommands(all, recent);
    const cycles = findCycles(offeredCycles(true), sought, languages).map(({ number }) => `cycle ${number}`);
    return [{ group: null, commands: findCommands(all, sought, recent, cycles) }];
  }, [all, sought, recent, languages]);
  const shown = groups.flatMap(({ commands }) => commands);

  const run = (command: Command | undefined) => {
    if (!command) return;
    noteCommand(command.id);
    // The dialog gives the focus back before the command moves it.
    flushSync(done);
    command.run();
  };
  return (
    <ModalDialog title={t.title} done={done} className="modal commands" first="input">
      <ComboboxInput box={box} count={shown.length} label={t.search} take={(at) => run(shown[at])} className="input" />
      <p className="unseen" role="status">
        {sought === "" ? "" : t.count(shown.length)}
      </p>
      <div id={box.id} role="listbox" aria-label={t.title} className="command-list">
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
                  {...optionOf(box, first + i, shown.length)}
                  className="command"
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
