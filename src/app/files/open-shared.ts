import { notice } from "../saving/keep.ts";
import { openText } from "./open-program.ts";

/** Opens the program that the page's address carries, once: the address is plain again afterwards. */
export async function openShared(): Promise<void> {
  const { hash } = location;
  if (!hash.startsWith("#p=")) return;
  history.replaceState(null, "", location.pathname + location.search);
  const { sharedProgram } = await import("../editor/share.ts");
  const text = sharedProgram(hash);
  if (text === null) notice("linkDamaged");
  else openText(text);
}
