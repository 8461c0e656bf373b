import { notice } from "../saving/keep.ts";
import { openText } from "./open-program.ts";

/** Opens the program that the page's address carries, once: the address is plain again afterwards. What was open stays. */
export async function openShared(): Promise<void> {
  const { hash } = location;
  if (!hash.startsWith("#p=")) return;
  history.replaceState(null, "", location.pathname + location.search);
  const { sharedProgram } = await import("../editor/share.ts");
  const shared = sharedProgram(hash);
  if (shared.kind === "program") openText(shared.text);
  else notice(shared.kind === "tooLarge" ? "linkTooLarge" : "linkDamaged");
}
