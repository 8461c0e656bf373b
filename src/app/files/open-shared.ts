import { notice } from "../saving/keep.ts";
import { openProgram, openText } from "./open-program.ts";

/** Opens the program that the page's address carries, once: the address is plain again afterwards. What was open stays. */
export async function openShared(): Promise<void> {
  const { hash } = location;
  if (!/^#[pw]=/.test(hash)) return;
  history.replaceState(null, "", location.pathname + location.search);
  const { sharedProgram } = await import("../editor/share.ts");
  const shared = sharedProgram(hash);
  if (shared.kind === "text") openText(shared.text);
  else if (shared.kind === "work") openProgram(shared.program);
  else notice(shared.kind === "tooLarge" ? "linkTooLarge" : "linkDamaged");
}
