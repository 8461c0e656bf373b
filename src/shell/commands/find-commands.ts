import { withoutAccents } from "../../app/fields/chooser/search.ts";

export const COMMAND_GROUPS = ["action", "page", "program", "cycle", "lesson", "example", "setting"] as const;
export type CommandGroup = (typeof COMMAND_GROUPS)[number];

/** One entry of the command palette. */
export interface Command {
  readonly id: string;
  readonly group: CommandGroup;
  readonly name: string;
  /** Further words that find it. */
  readonly words?: readonly string[];
  /** Its shortcut. */
  readonly keys?: string;
  readonly run: () => void;
}

/** How well a word matches: the start of the name, of a word in it, inside, or another word; null if not at all. */
function rankOf({ name, words = [] }: Command, word: string): number | null {
  const text = withoutAccents(name);
  if (text.startsWith(word)) return 0;
  if (text.split(/[\s,:(–-]+/).some((part) => part.startsWith(word))) return 1;
  if (text.includes(word)) return 2;
  return words.some((each) => withoutAccents(each).includes(word)) ? 3 : null;
}

/**
 * Commands that match all typed words, best first, and the last used ones first among equals. `cycles`: ids of the
 * cycles that the search of the chooser finds for it, which knows shop terms and numbers.
 */
export function findCommands(
  all: readonly Command[],
  typed: string,
  recent: readonly string[],
  cycles: readonly string[],
): readonly Command[] {
  const words = withoutAccents(typed)
    .split(/\s+/)
    .filter((word) => word !== "");
  const age = (id: string) => (recent.includes(id) ? recent.indexOf(id) : recent.length);
  return all
    .flatMap((command) => {
      const ranks = words.map((word) => rankOf(command, word));
      const found = command.group === "cycle" ? cycles.indexOf(command.id) : -1;
      if (found >= 0) return [{ command, rank: found === 0 ? 0.5 : 1.5 }];
      return command.group === "cycle" || ranks.includes(null)
        ? []
        : [{ command, rank: Math.max(0, ...ranks.map(Number)) }];
    })
    .sort((a, b) => a.rank - b.rank || age(a.command.id) - age(b.command.id))
    .map(({ command }) => command);
}

/** All commands before anything is typed: the last used ones, then the others by group. */
export function groupedCommands(
  all: readonly Command[],
  recent: readonly string[],
): readonly { readonly group: CommandGroup | "recent"; readonly commands: readonly Command[] }[] {
  const last = recent.flatMap((id) => all.find((command) => command.id === id) ?? []);
  const groups = COMMAND_GROUPS.map((group) => ({
    group,
    commands: all.filter((command) => command.group === group && !last.includes(command)),
  }));
  return [{ group: "recent" as const, commands: last }, ...groups].filter(({ commands }) => commands.length > 0);
}
