import { z } from "zod/mini";
import { storedData } from "../../app/base/storage.ts";

/** Ids of the commands that were used last on this device, newest first. */
const KEPT = storedData("recent-commands", z.array(z.string().check(z.maxLength(200))));
const MOST = 5;

export const recentCommands = (): readonly string[] => KEPT.get()?.slice(0, MOST) ?? [];
/** Notes that a command was used. A browser that refuses storage forgets it. */
export const noteCommand = (id: string): void =>
  void KEPT.set([id, ...recentCommands().filter((each) => each !== id)].slice(0, MOST));
