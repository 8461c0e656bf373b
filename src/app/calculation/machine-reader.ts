import { create } from "zustand";
import type { MachineData } from "../../program/machine/machine-data.ts";
import { rememberingLast } from "../base/once.ts";
import { untilHere } from "../base/parts.ts";

/** What reads machine files, fetched for the first one: most devices have none. */
export const useMachineReader = create<{ readonly read: ((text: string) => MachineData | null) | null }>(() => ({
  read: null,
}));

async function fetchReader(): Promise<(text: string) => MachineData | null> {
  const { machineOf } = await untilHere(() => import("../../program/machine/machine-file.ts"));
  const read = rememberingLast(machineOf);
  useMachineReader.setState({ read });
  return read;
}

/**
 * The machine of a kept text, null for none; undefined while what reads it is on its way, which `useMachineReader`
 * tells.
 */
export function machineAtHand(text: string): MachineData | null | undefined {
  if (text === "") return null;
  const { read } = useMachineReader.getState();
  if (!read) void fetchReader();
  return read?.(text);
}

/** The same, once it can be read. */
export const machineRead = async (text: string): Promise<MachineData | null> =>
  text === "" ? null : (await fetchReader())(text);
