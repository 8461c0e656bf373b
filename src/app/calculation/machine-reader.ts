import { create } from "zustand";
import type { MachineData } from "../../program/machine/machine-data.ts";
import { rememberingLast } from "../base/once.ts";
import { retryImport } from "../base/parts.ts";

/** The reader of machine files, fetched for the first file: most devices have none. */
export const useMachineReader = create<{ readonly read: ((text: string) => MachineData | null) | null }>(() => ({
  read: null,
}));

async function fetchReader(): Promise<(text: string) => MachineData | null> {
  const { machineOf } = await retryImport(() => import("../../program/machine/machine-file.ts"));
  const read = rememberingLast(machineOf);
  useMachineReader.setState({ read });
  return read;
}

/**
 * The machine of a stored text, null for none; undefined while the reader is being fetched, which `useMachineReader`
 * reports.
 */
export function cachedMachine(text: string): MachineData | null | undefined {
  if (text === "") return null;
  const { read } = useMachineReader.getState();
  if (!read) void fetchReader();
  return read?.(text);
}

/** The same, after the reader is loaded. */
export const loadMachine = async (text: string): Promise<MachineData | null> =>
  text === "" ? null : (await fetchReader())(text);
